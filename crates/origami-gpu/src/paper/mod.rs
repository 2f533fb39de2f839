//! The paper's five passes (normals, fold angles, coefficients, forces and velocities, positions), one kernel a file, in
//! f32 as displacement from rest: the plain form that the faster pipeline is measured against, each pass compared with the
//! CPU on its own.

mod coefficients;
mod dynamics;
mod fold_angles;
mod forces;
mod layout;
mod lists;
mod normals;
mod passes;
mod positions;
mod sheet;
#[cfg(test)]
mod testing;
mod traffic;

pub use dynamics::PaperDynamics;
#[cfg(test)]
pub(crate) use passes::PASSES;
