//! The bird base.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, FRAC_PI_8, PI};

use glam::{DAffine2, DVec2};

use super::builder::{between, positive};
use super::flat_fold::{FlatFold, FoldLine};
use crate::error::Error;
use crate::pattern::CreasePattern;

/// The traditional bird base: a square with two flaps folded up (petal folds) and two hanging down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BirdBase {
    /// Side of the square. Default 1.
    pub size: f64,
    /// How far every crease folds, above 0 and at most pi. Default pi.
    pub angle: f64,
    /// Whether the outer edges of the two legs are folded to their middle, as a crane begins. Default false.
    pub narrowed: bool,
}

impl Default for BirdBase {
    fn default() -> Self {
        Self { size: 1.0, angle: PI, narrowed: false }
    }
}

impl BirdBase {
    /// The pattern, coloured side up.
    ///
    /// # Errors
    /// If the size is not positive, or the angle not above 0 and at most pi.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        positive("size", self.size)?;
        between("angle", self.angle, 0.0, PI.next_up())?;
        let mut paper = bird_base();
        if self.narrowed {
            narrow_legs(&mut paper);
        }
        let mut pattern = paper.pattern(upright(self.size));
        for angle in pattern.edges.iter_mut().filter_map(|edge| edge.fold_angle.as_mut()) {
            *angle = self.angle.copysign(*angle) * f64::from(*angle != 0.0);
        }
        Ok(pattern)
    }
}

/// Corner of the wing in front, of the left leg, of the wing behind and of the right leg.
pub(super) const CORNERS: [usize; 4] = [1, 2, 3, 4];
/// The petal points: where the creases that halve the corners at 1 and 2, 2 and 3, .. meet.
pub(super) const PETALS: [usize; 4] = [5, 6, 7, 8];
/// Half the diagonal of the sheet, whose sides are 1.
pub(super) const HALF_DIAGONAL: f64 = FRAC_1_SQRT_2;

/// The bird base of a square of side 1 that stands on a corner, folded flat. The middle (point 0) is the origin, in the
/// sheet and folded; the legs point down, and the facet in front lies where it is on the sheet.
pub(super) fn bird_base() -> FlatFold {
    // The creases from the corners stand at 22.5 degrees to the diagonals, and so meet the midlines here.
    let petal = (1.0 - FRAC_PI_8.tan()) / 2.0;
    let mut points = vec![DVec2::ZERO];
    let towards = |eighths: f64, distance: f64| DVec2::from_angle(-2.0 * FRAC_PI_4 - eighths * FRAC_PI_4) * distance;
    points.extend([0.0, 2.0, 4.0, 6.0].map(|eighths| towards(eighths, HALF_DIAGONAL)));
    points.extend([1.0, 3.0, 5.0, 7.0].map(|eighths| towards(eighths, petal)));

    let (mut facets, mut folds) = (Vec::new(), Vec::new());
    for k in 0..4 {
        // Clockwise around the sheet: the petal before corner a, the corner, the petal and the corner after it.
        let [before, a, petal, b] = [PETALS[(k + 3) % 4], CORNERS[k], PETALS[k], CORNERS[(k + 1) % 4]];
        if k % 2 == 0 {
            facets.extend([vec![0, before, petal], vec![a, petal, before]]);
            folds.push(([before, petal], PI));
        } else {
            facets.extend([vec![0, before, a], vec![0, a, petal]]);
            folds.push(([0, a], PI));
        }
        facets.push(vec![a, b, petal]);
        folds.extend([([0, petal], -PI), ([a, petal], -PI), ([b, petal], -PI)]);
    }
    for facet in &mut facets {
        // The corners were counted clockwise.
        let [p, q, r] = [facet[0], facet[1], facet[2]].map(|v| points[v]);
        if (q - p).perp_dot(r - p) < 0.0 {
            facet.reverse();
        }
    }
    FlatFold::new(points, facets, &folds)
}

/// Folds the legs' outer edges to the middle, in front and behind.
pub(super) fn narrow_legs(paper: &mut FlatFold) {
    let tips = DVec2::new(0.0, -HALF_DIAGONAL);
    for (petal, left) in PETALS.into_iter().zip([true, true, false, false]) {
        let slant = FRAC_PI_8 / 2.0;
        let direction = DVec2::from_angle(FRAC_PI_2 + if left { slant } else { -slant });
        let line = FoldLine::new(tips, direction, paper.folded(petal));
        paper.fold(petal, line, PI, in_front);
    }
}

/// 1 for points of the sheet that the bird base has in front, -1 for those behind.
pub(super) fn in_front(place: DVec2) -> f64 {
    if place.y < 0.0 { 1.0 } else { -1.0 }
}

/// From the square of side 1 on its corner to one of the given side on its edge.
pub(super) fn upright(size: f64) -> DAffine2 {
    DAffine2::from_scale_angle_translation(DVec2::splat(size), FRAC_PI_4, DVec2::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;
    use crate::pattern::Assignment;

    #[test]
    fn folds_flat() {
        let pattern = BirdBase { size: 2.0, ..BirdBase::default() }.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        assert_eq!(check::flat_foldable_vertices(&pattern), 5);
        let folded = check::folds_flat(&pattern);
        let [middle, front, left, behind, right] = [0, 1, 2, 3, 4].map(|v| folded[v]);
        let close = |p: DVec2, q: DVec2| assert!(p.distance(q) < 1e-12, "{p} {q}");
        close(left, right);
        close(front, behind);
        // A flap is as long as half the side.
        assert!((left.distance(middle) - 2f64.sqrt()).abs() < 1e-12);
        assert!((front.distance(left) - 2.0).abs() < 1e-12, "both flaps begin at the petal line");
        let count = |letter| pattern.edges.iter().filter(|e| e.assignment == letter).count();
        assert_eq!([count(Assignment::Mountain), count(Assignment::Valley), count(Assignment::Flat)], [12, 4, 0]);
    }

    /// The whole leg is half as wide, and as long as before.
    #[test]
    fn a_narrowed_one_folds_flat_too() {
        let pattern = BirdBase { narrowed: true, ..BirdBase::default() }.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        let folded = check::folds_flat(&pattern);
        let [middle, front, left, _, right] = [0, 1, 2, 3, 4].map(|v| folded[v]);
        assert!(left.distance(right) < 1e-12 && (left.distance(middle) - 0.5f64.sqrt()).abs() < 1e-12);
        let along = (left - middle).normalize();
        for petal in PETALS.map(|v| folded[v] - left) {
            assert!(petal.perp_dot(along).abs() < 1e-12, "folded to the middle: {petal}");
        }
        assert!((front.distance(left) - 1.0).abs() < 1e-12, "the wings as they were");
    }

    #[test]
    fn stands_on_its_edge() {
        let pattern = BirdBase { size: 3.0, angle: 1.0, narrowed: false }.pattern().unwrap();
        for v in CORNERS {
            assert!((pattern.vertices[v].abs().truncate() - DVec2::splat(1.5)).length() < 1e-12);
        }
        assert!(pattern.edges.iter().filter_map(|e| e.fold_angle).all(|angle| angle.abs() == 1.0));
    }

    #[test]
    fn bad_parameters_are_named() {
        assert!(BirdBase { size: 0.0, ..BirdBase::default() }.pattern().is_err());
        assert!(BirdBase { angle: 0.0, ..BirdBase::default() }.pattern().is_err());
    }
}
