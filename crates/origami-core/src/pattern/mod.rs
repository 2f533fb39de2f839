//! The crease pattern: a sheet of simple polygons and lettered edges, cleaned of what files get wrong.
//!
//! [`CreasePattern::from_frame`] makes one from a frame of a FOLD file, [`CreasePattern::read`] from a file.

mod check;
mod clean;
mod crease_pattern;
mod dihedral;
mod hull;
pub(crate) mod joins;
pub mod keys;
mod paper;
pub(crate) mod plane;
pub(crate) mod point_grid;
mod read;
mod reading;
pub(crate) mod region;

pub use crease_pattern::{Assignment, CreasePattern, PatternEdge};
pub use dihedral::fold_angle;
pub use joins::{Join, JoinedTo};
pub use paper::Paper;
pub use reading::Reading;
