//! Strips of triangles that roll up into a cylinder, and the closed cylinders themselves.

use glam::DVec3;

use super::builder::SheetBuilder;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;

/// `columns` by `rows` cells of two triangles each. Vertex (i, j) is the i-th of line j.
pub(super) struct Lattice<Rising> {
    /// Cells around.
    pub(super) columns: usize,
    /// Cells along the axis.
    pub(super) rows: usize,
    /// Whether the cells of a row are split from their lower left to their upper right corner.
    pub(super) rising: Rising,
}

impl<Rising: Fn(usize) -> bool> Lattice<Rising> {
    /// The flat strip, with the fold angles that it has when its vertices are at `space`; letters are seen from outside.
    pub(super) fn strip(
        &self,
        flat: impl Fn(usize, usize) -> DVec3,
        space: impl Fn(usize, usize) -> DVec3,
    ) -> CreasePattern {
        let (mut sheet, folded) = self.sheet(self.columns + 1, flat, space);
        sheet.fold_to(&folded);
        sheet.finish()
    }

    /// The closed cylinder at rest in space; its edges fold by the angles that they have, or are free.
    pub(super) fn ring(&self, space: impl Fn(usize, usize) -> DVec3, driven: bool) -> CreasePattern {
        let (mut sheet, folded) = self.sheet(self.columns, &space, &space);
        if driven {
            sheet.fold_to(&folded);
        } else {
            sheet.free_all();
        }
        sheet.finish()
    }

    fn sheet(
        &self,
        around: usize,
        rest: impl Fn(usize, usize) -> DVec3,
        space: impl Fn(usize, usize) -> DVec3,
    ) -> (SheetBuilder, Vec<DVec3>) {
        let mut sheet = SheetBuilder::default();
        let places = || (0..=self.rows).flat_map(|j| (0..around).map(move |i| (i, j)));
        let vertices: Vec<VertexId> = places().map(|(i, j)| sheet.vertex(rest(i, j))).collect();
        let folded = places().map(|(i, j)| space(i, j)).collect();
        for (j, (low, high)) in vertices.chunks(around).zip(vertices.chunks(around).skip(1)).enumerate() {
            for i in 0..self.columns {
                let next = (i + 1) % around;
                let [a, b, c, d] = [low[i], low[next], high[next], high[i]];
                let halves = if (self.rising)(j) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
                halves.iter().for_each(|half| sheet.face(half));
            }
        }
        (sheet, folded)
    }
}
