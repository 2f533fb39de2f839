//! The pleated hyperbolic paraboloid.

use std::f64::consts::{FRAC_PI_2, PI};

use super::builder::{SheetBuilder, at_least, between, positive, room};
use crate::error::Error;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;

/// Concentric squares, alternately mountain and valley, and the two diagonals, each piece lettered as the square at its
/// inner end. Flat trapezoids cannot fold so at all (Demaine, Demaine, Hart, Price and Tachi, (Non)existence of pleated
/// folds, 2011); here each is split by a diagonal, and the sheet folds with strain. With diagonals that alternate, as
/// theirs do, it takes the shape that it is named after; with diagonals that all turn the same way its corners stay in one
/// plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hypar {
    /// Squares, the border among them. Default 8.
    pub rings: usize,
    /// Side of the sheet. Default 2.
    pub size: f64,
    /// How far the creases fold, above 0 and at most pi. Default pi/2.
    pub angle: f64,
    /// Whether the diagonals of the trapezoids are hinges without a spring (`U`) and not facet creases (`F`).
    /// Default false.
    pub free_facets: bool,
    /// Whether diagonals run the other way from each trapezoid to the next, around a square and from square to square.
    /// Default true.
    pub alternating: bool,
}

impl Default for Hypar {
    fn default() -> Self {
        Self { rings: 8, size: 2.0, angle: FRAC_PI_2, free_facets: false, alternating: true }
    }
}

impl Hypar {
    /// The pattern, in triangles; vertex 0 is the middle, vertices 4k - 3 to 4k the corners of square k.
    ///
    /// # Errors
    /// If there is no ring, the size is not positive, the angle not above 0 and at most pi, or the sheet too large.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("rings", self.rings, 1)?;
        positive("size", self.size)?;
        between("angle", self.angle, 0.0, PI.next_up())?;
        room("rings", [self.rings, 2], 1)?;

        let mut sheet = SheetBuilder::default();
        let middle = sheet.at(0.0, 0.0);
        let mut inner = [middle; 4];
        for k in 1..=self.rings {
            let half = self.size / 2.0 * k as f64 / self.rings as f64;
            let outer = [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(x, y)| sheet.at(x, y));
            let sign = if k % 2 == 1 { 1.0 } else { -1.0 };
            for side in 0..4 {
                let next = (side + 1) % 4;
                let [a, b, c, d] = [outer[side], outer[next], inner[next], inner[side]];
                let turned = self.alternating && (side + k) % 2 == 0;
                self.facet(&mut sheet, [a, b, c, d], turned);
                sheet.crease(a, b, sign * self.angle);
                sheet.crease(a, d, -sign * self.angle);
            }
            inner = outer;
        }
        Ok(sheet.finish())
    }

    /// A trapezoid, or, in the middle, a triangle. Its diagonal begins at `a`, or, `turned`, at `b`.
    fn facet(&self, sheet: &mut SheetBuilder, [a, b, c, d]: [VertexId; 4], turned: bool) {
        if c == d {
            sheet.face(&[a, b, c]);
            return;
        }
        let (faces, diagonal) =
            if turned { ([[a, b, d], [b, c, d]], [b, d]) } else { ([[a, b, c], [a, c, d]], [a, c]) };
        faces.iter().for_each(|face| sheet.face(face));
        if self.free_facets {
            sheet.free(diagonal[0], diagonal[1]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;
    use crate::pattern::Assignment;

    #[test]
    fn corners_satisfy_maekawa_and_kawasaki() {
        let mut pattern = Hypar { rings: 5, ..Hypar::default() }.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        // Not so the middle, where four creases of one letter meet: leave it out.
        for edge in pattern.edges.iter_mut().filter(|e| e.vertices.iter().any(|v| v.index() == 0)) {
            assert_eq!(edge.assignment, Assignment::Mountain);
        }
        for edge in &mut pattern.edges {
            if edge.vertices.iter().any(|v| v.index() == 0) {
                edge.assignment = Assignment::Boundary;
            }
        }
        assert_eq!(check::flat_foldable_vertices(&pattern), 4 * 3);
    }

    #[test]
    fn squares_alternate() {
        let pattern = Hypar { rings: 4, ..Hypar::default() }.pattern().unwrap();
        for edge in &pattern.edges {
            let [a, b] = edge.vertices.map(|v| pattern.vertices[v.index()]);
            let square = (a.abs().max_element() * 4.0).round();
            if (a.x == b.x || a.y == b.y) && square < 4.0 {
                let expected = if square % 2.0 == 1.0 { Assignment::Valley } else { Assignment::Mountain };
                assert_eq!(edge.assignment, expected);
            }
        }
    }

    /// Every corner of a square has diagonals to both sides of it, or none: inwards and outwards alike.
    #[test]
    fn diagonals_alternate() {
        let ends = |alternating: bool| {
            let pattern = Hypar { rings: 6, alternating, ..Hypar::default() }.pattern().unwrap();
            check::sound_and_flat(&pattern, 1);
            let mut ends = vec![0; pattern.vertices.len()];
            let flat = pattern.edges.iter().filter(|edge| edge.assignment == Assignment::Flat);
            flat.for_each(|edge| edge.vertices.iter().for_each(|v| ends[v.index()] += 1));
            ends
        };
        // Corners of squares 2 to 5: next to the middle and at the border there is nothing on one side.
        assert!(ends(false)[5..21].iter().all(|count| *count == 2), "{:?}", ends(false));
        let alternating = ends(true);
        for (place, count) in alternating.iter().enumerate().skip(5).take(16) {
            let [square, corner] = [(place - 1) / 4 + 1, (place - 1) % 4];
            assert_eq!(*count, if (square + corner) % 2 == 1 { 4 } else { 0 }, "corner {corner} of square {square}");
        }
    }

    #[test]
    fn facets_may_be_free() {
        let count = |free_facets: bool, letter: Assignment| {
            let pattern = Hypar { rings: 3, free_facets, ..Hypar::default() }.pattern().unwrap();
            check::sound_and_flat(&pattern, 1);
            pattern.edges.iter().filter(|e| e.assignment == letter).count()
        };
        assert_eq!([count(false, Assignment::Flat), count(false, Assignment::Unassigned)], [8, 0]);
        assert_eq!([count(true, Assignment::Flat), count(true, Assignment::Unassigned)], [0, 8]);
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |h: Hypar| h.pattern().unwrap_err().to_string();
        assert!(message(Hypar { rings: 0, ..Hypar::default() }).starts_with("parameter rings: is 0;"));
        assert!(message(Hypar { angle: -1.0, ..Hypar::default() }).starts_with("parameter angle"));
    }
}
