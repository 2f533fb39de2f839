//! The order of the five passes.

use super::kernel::Kernel;
use super::{coefficients, fold_angles, forces, normals, positions};

/// In the order in which they run.
pub(crate) const PASSES: [&Kernel; 5] =
    [&normals::KERNEL, &fold_angles::KERNEL, &coefficients::KERNEL, &forces::KERNEL, &positions::KERNEL];
