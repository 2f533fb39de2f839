//! The order of the five passes.

use super::{coefficients, fold_angles, forces, normals, positions};
use crate::kernels::Kernel;

/// In the order in which they run.
pub(crate) const PASSES: [&Kernel; 5] =
    [&normals::KERNEL, &fold_angles::KERNEL, &coefficients::KERNEL, &forces::KERNEL, &positions::KERNEL];
