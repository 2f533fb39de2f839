//! The edges of a star, side by side.

use glam::DVec3;

use crate::contact::stars::ARMS;
use crate::ids::NodeId;

/// A number of each edge.
pub(in crate::contact) type Row = [f64; ARMS];

/// The vectors of all edges from their node, by coordinate.
#[derive(Clone, Copy, Debug)]
pub(in crate::contact) struct Arms(pub(in crate::contact) [Row; 3]);

impl Arms {
    pub(in crate::contact) const NONE: Self = Self([[0.0; ARMS]; 3]);

    #[inline(always)]
    pub(in crate::contact) fn from(at: DVec3, ends: &[NodeId; ARMS], positions: &[DVec3]) -> Self {
        let mut arms = Self::NONE;
        for (i, end) in ends.iter().enumerate() {
            let by = positions[end.index()] - at;
            (arms.0[0][i], arms.0[1][i], arms.0[2][i]) = (by.x, by.y, by.z);
        }
        arms
    }

    #[inline(always)]
    pub(in crate::contact) fn at(&self, i: usize) -> DVec3 {
        DVec3::new(self.0[0][i], self.0[1][i], self.0[2][i])
    }

    /// The products of all with a vector.
    #[inline(always)]
    pub(in crate::contact) fn dot(&self, by: DVec3) -> Row {
        let [x, y, z] = &self.0;
        let mut all = [0.0; ARMS];
        for i in 0..ARMS {
            all[i] = x[i] * by.x + y[i] * by.y + z[i] * by.z;
        }
        all
    }
}

/// Which are not below 0, as bits.
#[inline(always)]
pub(in crate::contact) fn not_below_zero(row: &Row) -> u8 {
    let mut bits = 0;
    for (i, x) in row.iter().enumerate() {
        bits |= u8::from(*x >= 0.0) << i;
    }
    bits
}
