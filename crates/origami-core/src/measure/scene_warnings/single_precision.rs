//! The limits of single precision: stiff parts whose rounding moves soft ones farther than the tolerance.

use crate::error::{Place, Warning, WarningCode};
use crate::ids::NodeId;
use crate::model::Model;

/// Error of a length: the GPU keeps of each position an integer part and an f32 of at most 2^-13, whose rounding is at most
/// 2^-38 (`docs/GPU.md`, Precision); a difference of two, itself rounded, is off by up to four times that.
const LENGTH: f64 = 1.0 / (1_u64 << 36) as f64;

/// Error of an angle: those between 1 and 4 are 2^-23 to 2^-22 apart in f32, and the arc tangent is good to two of them.
const ANGLE: f64 = 1.0 / (1_u64 << 22) as f64;

/// A warning if single precision cannot tell where the equilibrium is to within `tolerance` (in radii).
///
/// Rounding puts a force on each node: of a beam its stiffness times the error of a length, of a crease (paper 2.3) and a
/// corner (paper 2.4) its stiffness times the error of an angle times that angle's slope, 1 / h. As they are independent,
/// their squares add up. The softest that holds a node is a crease of which it is an apex, with k / h^2; force over stiffness
/// is how far rounding moves the node. That is an estimate of size: long sheets, which bend over many creases, are softer.
#[must_use]
pub fn single_precision(model: &Model, tolerance: f64) -> Option<Warning> {
    let forces = rounding(model);
    let moved = model.creases.iter().filter(|crease| crease.stiffness > 0.0).flat_map(|crease| {
        let heights = heights(model, crease.nodes);
        let of_apex = |i: usize| {
            let node = crease.nodes[i];
            (forces[node.index()] * heights[i] * heights[i] / crease.stiffness, node)
        };
        [of_apex(0), of_apex(1)]
    });
    let (distance, node) = moved.filter(|(d, _)| d.is_finite()).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (distance > tolerance).then(|| {
        let message = format!(
            "single precision moves it by about {distance:.0e} of the radius, more than the tolerance of {tolerance:.0e}: its \
             creases are too soft for what else holds it; the processor computes in double precision"
        );
        let place = Place::Vertices(vec![model.mesh.vertex_of_node[node.index()]]);
        Warning::new(WarningCode::SinglePrecision, place, message)
    })
}

/// Force on each node from rounding alone.
fn rounding(model: &Model) -> Vec<f64> {
    let mut squares = vec![0.0; model.node_count()];
    let mut add = |node: NodeId, force: f64| squares[node.index()] += force * force;
    for beam in &model.beams {
        beam.nodes.into_iter().for_each(|node| add(node, beam.stiffness * LENGTH));
    }
    for crease in &model.creases {
        let height = heights(model, crease.nodes).into_iter().fold(f64::INFINITY, f64::min);
        crease.nodes.into_iter().for_each(|node| add(node, crease.stiffness * ANGLE / height));
    }
    for corners in &model.corner_angles {
        let [a, b, c] = corners.nodes.map(|node| model.rest[node.index()]);
        let shortest = [b - a, c - b, a - c].into_iter().map(|side| side.length()).fold(f64::INFINITY, f64::min);
        corners.nodes.into_iter().for_each(|node| add(node, model.material.k_face * ANGLE / shortest));
    }
    squares.into_iter().map(f64::sqrt).collect()
}

/// The heights of both apexes above the crease, at rest.
fn heights(model: &Model, nodes: [NodeId; 4]) -> [f64; 2] {
    let [first, second, from, to] = nodes.map(|node| model.rest[node.index()]);
    let along = (to - from).normalize_or_zero();
    [first, second].map(|apex| (apex - from).reject_from_normalized(along).length())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::Miura;
    use crate::model::Material;

    /// How far rounding is said to move a vertex: the largest tolerance that is warned of.
    fn reach(material: Material) -> f64 {
        let model = Model::new(&Miura::default().pattern().unwrap(), &material).unwrap();
        let warned = |power: &i32| single_precision(&model, 10_f64.powf(f64::from(*power) / 20.0)).is_some();
        (-280..0).rev().find(warned).map_or(0.0, |power| 10_f64.powf(f64::from(power) / 20.0))
    }

    #[test]
    fn the_default_material_is_resolved() {
        let default = reach(Material::default());
        assert!((1e-8..1e-5).contains(&default), "{default:e}");
    }

    #[test]
    fn soft_creases_and_stiff_beams_are_not() {
        let soft = |k: f64| Material { k_fold: k, k_facet: k, ..Material::default() };
        let (default, softer) = (reach(soft(0.7)), reach(soft(0.0007)));
        // What single precision leaves is the corners' rounding, over a stiffness of a thousandth.
        assert!((300.0..2000.0).contains(&(softer / default)), "{softer:e} {default:e}");
        let stiff = |ea: f64| Material { ea, ..Material::default() };
        let (stiff, stiffer) = (reach(stiff(1e7)), reach(stiff(1e8)));
        assert!((9.0..11.0).contains(&(stiffer / stiff)) && stiff > 10.0 * default, "{stiff:e} {stiffer:e}");
    }

    #[test]
    fn what_nothing_holds_cannot_be_moved() {
        let material = Material { k_fold: 0.0, k_facet: 0.0, ..Material::default() };
        assert_eq!(reach(material), 0.0);
    }
}
