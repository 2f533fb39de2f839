//! Square twists.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec2;

use super::builder::{SheetBuilder, at_least, between, positive, room};
use crate::error::Error;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;

/// Squares that turn as their pleats close, in a grid whose cells mirror each other so that pleats meet; the outer
/// pleats run to the border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquareTwist {
    /// Squares along x. Default 1.
    pub columns: usize,
    /// Squares along y. Default 1.
    pub rows: usize,
    /// Side of a twisted square. Default 1.
    pub side: f64,
    /// Angle between a square's sides and its pleats, in 0..pi/2; a square turns by twice as much. Default 45 degrees.
    pub pleat: f64,
    /// Side of the square of paper that belongs to each twist; must hold the twisted square. Default 4.
    pub cell: f64,
    /// How far the creases fold, above 0 and at most pi. Default pi.
    pub angle: f64,
}

impl Default for SquareTwist {
    fn default() -> Self {
        Self { columns: 1, rows: 1, side: 1.0, pleat: 45f64.to_radians(), cell: 4.0, angle: PI }
    }
}

impl SquareTwist {
    /// The pattern.
    ///
    /// # Errors
    /// If a count is 0, a length not positive, an angle out of its range, the cell too small, or the sheet too large.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("columns", self.columns, 1)?;
        at_least("rows", self.rows, 1)?;
        positive("side", self.side)?;
        between("pleat", self.pleat, 0.0, FRAC_PI_2)?;
        positive("cell", self.cell)?;
        between("angle", self.angle, 0.0, PI.next_up())?;
        room("columns, rows", [self.columns, self.rows], 4)?;
        let reach = self.corner(true, true).abs().max_element();
        if 2.0 * reach >= self.cell {
            return Err(Error::invalid(
                "parameter cell",
                format!("is {}", self.cell),
                format!("more than {}, what the twisted square takes", 2.0 * reach),
            ));
        }
        let mut grid = Grid { twist: self, sheet: SheetBuilder::default(), corners: Vec::new() };
        grid.place();
        grid.join();
        Ok(grid.sheet.finish())
    }

    /// A corner of the square around the origin: of its four, the one between the pleats to the right (or left) and
    /// to the top (or bottom).
    fn corner(&self, right: bool, top: bool) -> DVec2 {
        // The corner between the pleats along +x and +y; pleats make the angle `pleat` with the sides.
        let first = DVec2::from_angle(self.pleat - PI / 4.0) * (self.side / 2f64.sqrt());
        match (right, top) {
            (true, true) => first,
            (false, true) => first.perp(),
            (false, false) => -first,
            (true, false) => -first.perp(),
        }
    }
}

/// The corners of all twists, and around them a frame of cells whose corners lie on the border.
struct Grid<'a> {
    twist: &'a SquareTwist,
    sheet: SheetBuilder,
    /// Per cell, row after row, frame included: the corners left and right of the bottom, then of the top.
    corners: Vec<[VertexId; 4]>,
}

impl Grid<'_> {
    /// Makes the vertices.
    fn place(&mut self) {
        for j in 0..self.twist.rows + 2 {
            for i in 0..self.twist.columns + 2 {
                let mut made: [Option<(DVec2, VertexId)>; 4] = [None; 4];
                let corners = [(false, false), (true, false), (false, true), (true, true)].map(|(right, top)| {
                    let position = self.position(i, j, right, top);
                    // The corners of a frame cell fall together in twos, those of the sheet's corners all.
                    let known = made.iter().flatten().find(|(place, _)| *place == position).map(|(_, vertex)| *vertex);
                    let vertex = known.unwrap_or_else(|| self.sheet.at(position.x, position.y));
                    made[usize::from(right) + 2 * usize::from(top)] = Some((position, vertex));
                    vertex
                });
                self.corners.push(corners);
            }
        }
    }

    /// Where the corner of cell (i, j) lies; the frame's cells are on the border, level with their neighbours' corners.
    fn position(&self, i: usize, j: usize, right: bool, top: bool) -> DVec2 {
        let (columns, rows) = (self.twist.columns, self.twist.rows);
        let (near_i, near_j) = (i.clamp(1, columns), j.clamp(1, rows));
        // Towards the frame a corner is that of its neighbour which looks at it.
        let right = if near_i == i { right } else { near_i < i };
        let top = if near_j == j { top } else { near_j < j };
        let [mirror_x, mirror_y] = [near_i, near_j].map(|place| place % 2 == 0);
        let corner = self.twist.corner(right != mirror_x, top != mirror_y);
        let middle = DVec2::new(near_i as f64 - 0.5, near_j as f64 - 0.5) * self.twist.cell;
        let mirror = |mirrored: bool, value: f64| if mirrored { -value } else { value };
        let mut position = middle + DVec2::new(mirror(mirror_x, corner.x), mirror(mirror_y, corner.y));
        if near_i != i {
            position.x = if right { columns as f64 * self.twist.cell } else { 0.0 };
        }
        if near_j != j {
            position.y = if top { rows as f64 * self.twist.cell } else { 0.0 };
        }
        position
    }

    fn at(&self, i: usize, j: usize) -> [VertexId; 4] {
        self.corners[j * (self.twist.columns + 2) + i]
    }

    /// Makes faces and creases.
    fn join(&mut self) {
        let (columns, rows) = (self.twist.columns, self.twist.rows);
        let angle = self.twist.angle;
        for j in 0..=rows {
            for i in 0..=columns {
                // The plain paper between four cells.
                let [[.., a], [_, _, b, _], [c, ..], [_, d, ..]] =
                    [self.at(i, j), self.at(i + 1, j), self.at(i + 1, j + 1), self.at(i, j + 1)];
                self.sheet.face(&[a, b, c, d]);
                let odd = (i + j) % 2 == 1;
                if j > 0 {
                    // The pleat between two cells of a row.
                    let ([_, low, _, high], [low_next, _, high_next, _]) = (self.at(i, j), self.at(i + 1, j));
                    self.sheet.face(&[low, low_next, high_next, high]);
                    let fold = if odd { -angle } else { angle };
                    self.sheet.crease(low, low_next, fold);
                    self.sheet.crease(high, high_next, -fold);
                }
                if i > 0 {
                    let ([_, _, left, right], [left_next, right_next, ..]) = (self.at(i, j), self.at(i, j + 1));
                    self.sheet.face(&[left, right, right_next, left_next]);
                    let fold = if odd { -angle } else { angle };
                    self.sheet.crease(right, right_next, fold);
                    self.sheet.crease(left, left_next, -fold);
                }
                if i > 0 && j > 0 {
                    let [a, b, d, c] = self.at(i, j);
                    self.sheet.face(&[a, b, c, d]);
                    for (from, to) in [(a, b), (b, c), (c, d), (d, a)] {
                        self.sheet.crease(from, to, -angle);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;

    #[test]
    fn folds_flat_alone_and_in_a_grid() {
        for (columns, rows) in [(1, 1), (3, 2)] {
            for pleat in [20f64, 45.0, 70.0] {
                let twist = SquareTwist { columns, rows, pleat: pleat.to_radians(), ..SquareTwist::default() };
                let pattern = twist.pattern().unwrap();
                check::sound_and_flat(&pattern, 1);
                assert_eq!(check::flat_foldable_vertices(&pattern), 4 * columns * rows);
                let folded = check::folds_flat(&pattern);
                // Each row of pleats takes twice its width out of the sheet.
                let width = twist.cell * columns as f64 - 2.0 * columns as f64 * twist.pleat.sin();
                let corners: Vec<_> =
                    (0..pattern.vertices.len()).filter(|&v| is_corner(&pattern, v)).map(|v| folded[v]).collect();
                let widest = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
                let height = twist.cell * rows as f64 - 2.0 * rows as f64 * twist.pleat.sin();
                assert_eq!(corners.len(), 4);
                assert!((widest - width.hypot(height)).abs() < 1e-9, "{widest} {width} {height}");
            }
        }
    }

    fn is_corner(pattern: &CreasePattern, v: usize) -> bool {
        pattern.edges.iter().filter(|e| e.vertices.iter().any(|end| end.index() == v)).count() == 2
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |t: SquareTwist| t.pattern().unwrap_err().to_string();
        let good = SquareTwist::default();
        assert!(
            message(SquareTwist { cell: 1.0, ..good }).starts_with("parameter cell: is 1; expected more than 1.41")
        );
        assert!(message(SquareTwist { pleat: FRAC_PI_2, ..good }).starts_with("parameter pleat: is 90 degrees"));
        assert!(message(SquareTwist { columns: 0, ..good }).starts_with("parameter columns"));
    }
}
