//! Measures of a state: strain, energy, fold angles, closure of its vertices, distance from another state. None is computed
//! unless it is called for.

mod alignment;
mod angles;
pub mod attitude;
mod closure;
mod eigen;
mod scene_warnings;
mod strain;
mod summary;

pub use crate::forces::Energy;
pub use alignment::{Alignment, align};
pub use angles::{AngleError, angle_error, edge_fold_angles};
pub use closure::closures;
pub use scene_warnings::{
    crushed, folded_warnings, scene_warnings, single_precision, squeezed, strained_at_rest, touching_lips,
};
pub use strain::{Strain, node_strains};
pub use summary::Summary;
