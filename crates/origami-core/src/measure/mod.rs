//! What can be said of a state: strain, energy, angles, distance from another state. Nothing here is computed unless
//! asked for.

mod alignment;
mod angles;
mod closure;
mod dangers;
mod eigen;
mod strain;
mod summary;

pub use crate::forces::Energy;
pub use alignment::{Alignment, align};
pub use angles::{AngleError, angle_error, edge_fold_angles};
pub use closure::closures;
pub use dangers::{dangers, frustration, single_precision};
pub use strain::{Strain, node_strains};
pub use summary::Summary;
