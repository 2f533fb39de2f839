//! What is told of a motion that was found backwards.

use origami::layers::Stacking;
use origami::solve::Motion;
use serde::Serialize;

/// A motion to the flat-folded state that was found from there.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct MotionFacts {
    /// How many of its states, from the first, contact leads from one to the next.
    touching: usize,
    /// The farthest that a crease is from flat in the last state but one.
    off_deg: f64,
    /// Pairs of faces that lie upon each other in the last.
    pairs: usize,
    /// Those of them that may lie the other way round in another order of the layers.
    pub(crate) free: Vec<[u32; 2]>,
}

impl From<&Motion> for MotionFacts {
    fn from(motion: &Motion) -> Self {
        let Stacking { faces, free, .. } = &motion.stacking;
        Self {
            touching: motion.touching,
            off_deg: motion.off.to_degrees(),
            pairs: faces.len(),
            free: free.iter().map(|pair| pair.map(|face| face.0)).collect(),
        }
    }
}
