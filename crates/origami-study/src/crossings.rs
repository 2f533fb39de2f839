//! How often the paper of a final state goes through itself.

use origami_core::Model;
use origami_core::contact::Crossings;
use origami_core::glam::DVec3;

/// Sheets of more triangles are not looked at: it would take longer than a glance.
const MOST_TRIANGLES: usize = 20_000;

/// Crossings by the exact test, of a sheet that is small enough.
pub(crate) fn crossings(model: &Model, positions: &[DVec3]) -> Option<usize> {
    let small = model.mesh.triangles.len() <= MOST_TRIANGLES;
    small.then(|| Crossings::of(&model.mesh, positions).all.len())
}
