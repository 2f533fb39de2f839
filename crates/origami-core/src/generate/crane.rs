//! The traditional crane, folded step by step from the bird base.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec2;

use super::bird_base::{CORNERS, bird_base, in_front, narrow_legs, upright};
use super::builder::{between, positive, share};
use super::flat_fold::{FlatFold, FoldLine};
use crate::error::Error;
use crate::pattern::CreasePattern;

/// The traditional crane: a bird base whose legs are narrowed and reverse-folded into neck and tail, with a
/// reverse-folded head and the wings folded down. All creases fold by pi but the wings' two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crane {
    /// Side of the square. Default 1.
    pub size: f64,
    /// Angle between the neck and straight up, above 0 and at most 90 degrees. Default 30 degrees.
    pub neck: f64,
    /// Angle between the tail and straight up, above 0 and at most 90 degrees. Default 40 degrees.
    pub tail: f64,
    /// Length of the head as a share of the neck's, 0.1 to 0.8. Default 0.3.
    pub head_length: f64,
    /// Angle between head and neck, above 0 and at most 120 degrees. Default 70 degrees.
    pub head: f64,
    /// The part of a wing beyond its fold, as a share of the flap, 0.1 to 0.9. Default 0.6.
    pub wing_length: f64,
    /// How far the wings fold down, above 0 and at most pi. Default pi/2.
    pub wing: f64,
}

impl Default for Crane {
    fn default() -> Self {
        let [neck, tail, head] = [30f64, 40.0, 70.0].map(f64::to_radians);
        Self { size: 1.0, neck, tail, head_length: 0.3, head, wing_length: 0.6, wing: FRAC_PI_2 }
    }
}

/// Length of a flap of the bird base of a square of side 1, wing or leg.
const FLAP: f64 = 0.5;

impl Crane {
    /// The pattern, coloured side up.
    ///
    /// # Errors
    /// If a parameter is out of its range.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        positive("size", self.size)?;
        let right_angle = FRAC_PI_2.next_up();
        between("neck", self.neck, 0.0, right_angle)?;
        between("tail", self.tail, 0.0, right_angle)?;
        between("head", self.head, 0.0, 120f64.to_radians().next_up())?;
        between("wing", self.wing, 0.0, PI.next_up())?;
        share("head_length", self.head_length, 0.1, 0.8)?;
        share("wing_length", self.wing_length, 0.1, 0.9)?;

        let mut paper = bird_base();
        let [front, left, behind, right] = CORNERS;
        narrow_legs(&mut paper);
        let neck = Flap { tip: left, spine: -DVec2::Y, open: -DVec2::X };
        let neck = neck.reverse_fold(&mut paper, FLAP, self.neck);
        neck.reverse_fold(&mut paper, FLAP * self.head_length, self.head);
        Flap { tip: right, spine: -DVec2::Y, open: DVec2::X }.reverse_fold(&mut paper, FLAP, self.tail);
        for wing in [front, behind] {
            let tip = paper.folded(wing);
            let line = FoldLine::new(tip - DVec2::Y * FLAP * self.wing_length, DVec2::X, tip);
            paper.fold(wing, line, self.wing, in_front);
        }
        Ok(paper.pattern(upright(self.size)))
    }
}

/// A flap whose two halves, one in front and one behind, hang together along its spine.
struct Flap {
    tip: usize,
    /// Direction of the spine, towards the tip.
    spine: DVec2,
    /// Direction across the flap, from the spine to its open side.
    open: DVec2,
}

impl Flap {
    /// Reverse-folds the last `length` of the flap inside, so that it points back along the flap but for `angle`
    /// towards the open side.
    fn reverse_fold(&self, paper: &mut FlatFold, length: f64, angle: f64) -> Self {
        let tip = paper.folded(self.tip);
        let (sin, cos) = (angle / 2.0).sin_cos();
        let line = FoldLine::new(tip - self.spine * length, self.open * cos + self.spine * sin, tip);
        // The half in front turns away from the viewer, and the one behind towards him: both go inside.
        paper.fold(self.tip, line, PI, |place| -in_front(place));
        Self { tip: self.tip, spine: line.reflected(self.spine), open: line.reflected(self.open) }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::generate::bird_base::HALF_DIAGONAL;
    use crate::generate::check;

    fn folds_flat(crane: Crane) -> CreasePattern {
        let pattern = crane.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        assert!(check::flat_foldable_vertices(&pattern) > 20);
        check::folds_flat(&pattern);
        pattern
    }

    #[test]
    fn points_go_where_they_should() {
        let crane = Crane::default();
        let pattern = folds_flat(crane);
        let folded = check::folds_flat(&pattern);
        let [middle, front, left, behind, right] = [0, 1, 2, 3, 4].map(|v| folded[v]);
        assert!(front.distance(behind) < 1e-12);
        // With the wings folded all the way their tips hang straight below the middle.
        let down = (front - middle).normalize();
        let slit = middle + down * (HALF_DIAGONAL - FLAP);
        let (tail, neck) = (right - slit, left - slit);
        assert!((tail.length() - FLAP).abs() < 1e-12);
        assert!((tail.dot(-down) - FLAP * crane.tail.cos()).abs() < 1e-12);
        assert!(down.perp_dot(tail) * down.perp_dot(neck) < 0.0, "head and tail on the same side");
        // Head, neck and the way from the neck's root to the tip of the head make a triangle.
        let head = FLAP * crane.head_length;
        let stem = FLAP - head;
        let across = (stem * stem + head * head - 2.0 * stem * head * crane.head.cos()).sqrt();
        assert!((neck.length() - across).abs() < 1e-12);
    }

    #[test]
    fn wings_fold_less_than_the_rest() {
        let pattern = folds_flat(Crane { wing: 1.0, ..Crane::default() });
        let folds: Vec<f64> = pattern.edges.iter().filter_map(|e| e.fold_angle).collect();
        assert!(folds.iter().all(|angle| angle.abs() == 1.0 || angle.abs() == PI), "nothing is left flat");
        // Three layers in front, three behind.
        assert_eq!(folds.iter().filter(|angle| angle.abs() == 1.0).count(), 6);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn any_crane_folds_flat(
            size in 0.1..20.0, neck in 0.02..FRAC_PI_2, tail in 0.02..FRAC_PI_2, head in 0.02..2.09,
            head_length in 0.1..0.8, wing_length in 0.1..0.9, wing in 0.1..PI,
        ) {
            folds_flat(Crane { size, neck, tail, head_length, head, wing_length, wing });
        }
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |c: Crane| c.pattern().unwrap_err().to_string();
        let good = Crane::default();
        assert!(message(Crane { neck: 0.0, ..good }).starts_with("parameter neck: is 0 degrees"));
        assert!(message(Crane { head: 2.2, ..good }).starts_with("parameter head: is"));
        assert!(message(Crane { head_length: 0.9, ..good }).starts_with("parameter head_length: is 0.9;"));
        assert!(message(Crane { wing: f64::NAN, ..good }).starts_with("parameter wing: is NaN"));
    }
}
