//! Triangles that are nearly lines.

use glam::DVec3;

use crate::error::{Place, Warning, WarningCode};
use crate::ids::NodeId;
use crate::model::Model;

/// Height over longest side. A hinge at a triangle of height h is as stiff as k / h^2 (the slope of its angle is 1 / h,
/// paper 2.3), and the paper's time step knows of beams only: with its default stiffnesses it is about twice too long at
/// 0.01 and six times at 0.003, so that it no longer holds from about here on.
const SLIVER: f64 = 0.02;

/// Triangles thinner than [`SLIVER`], the thinnest first.
pub(super) fn slivers(model: &Model) -> Option<Warning> {
    let shape = |nodes: &[NodeId; 3]| (thinness(nodes.map(|node| model.rest[node.index()])), *nodes);
    let mut thin: Vec<(f64, [NodeId; 3])> =
        model.mesh.triangles.iter().map(shape).filter(|(shape, _)| *shape < SLIVER).collect();
    thin.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (thinnest, _) = thin.first()?;
    let message = format!(
        "height of the thinnest {thinnest:.1e} of its longest side, expected {SLIVER} or more: the paper's time step may not \
         hold, angles there are inexact and convergence is slow"
    );
    let vertices = |nodes: [NodeId; 3]| nodes.map(|node| model.mesh.vertex_of_node[node.index()]);
    let place = Place::Triangles(thin.iter().map(|(_, nodes)| vertices(*nodes)).collect());
    Some(Warning::new(WarningCode::Slivers, place, message))
}

/// Smallest height over longest side; 0 for a triangle without area.
fn thinness([a, b, c]: [DVec3; 3]) -> f64 {
    let longest = [b - a, c - b, a - c].into_iter().map(DVec3::length_squared).fold(0.0, f64::max);
    let shape = (b - a).cross(c - a).length() / longest;
    if shape.is_finite() { shape } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::Miura;
    use crate::model::Material;

    #[test]
    fn heights_are_those_of_a_ruler() {
        let [a, b] = [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0)];
        for height in [3.0, 0.01, 1e-9] {
            let flat = thinness([a, DVec3::new(1.0, 0.0, height), b]);
            let longest = if height > 2.9 { (9.0 + 9.0_f64).sqrt().max(4.0) } else { 4.0 };
            let lowest = 4.0 * height / longest;
            assert!((flat / (lowest / longest) - 1.0).abs() < 1e-12, "{height}");
        }
        assert_eq!(thinness([a, b, b]), 0.0);
        assert_eq!(thinness([a; 3]), 0.0);
    }

    #[test]
    fn slivers_are_named_and_others_are_not() {
        let mut pattern = Miura::default().pattern().unwrap();
        let whole = Model::new(&pattern, &Material::default()).unwrap();
        assert_eq!(slivers(&whole), None);
        // A vertex of the first face is moved to its neighbour, nearly.
        let (moved, neighbour) = (pattern.faces[0][0], pattern.faces[0][1]);
        let [from, to] = [moved, neighbour].map(|v| pattern.vertices[v.index()]);
        pattern.vertices[moved.index()] = to + (from - to) * 1e-3;
        let model = Model::new(&pattern, &Material::default()).unwrap();
        let warning = slivers(&model).unwrap();
        let Place::Triangles(thin) = &warning.place else { panic!("{warning}") };
        assert!(thin[0].contains(&moved) && thin[0].contains(&neighbour), "{warning}");
    }
}
