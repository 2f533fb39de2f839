//! A Miura sheet on its way, by its closed form: M. Schenk and S. D. Guest, Geometry of Miura-folded metamaterials, PNAS 110
//! (2013).

use origami_core::analysis::{Bar, BarLaw, Hinge, HingeKind, HingeLaw, Structure};
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;

/// `cells` unit cells of parallelograms with sides 1 and the angle `theta`, folded by `gamma` (both in radians): stiffness of
/// folds and facets per length, rigidity of bars. Free of stress, and free.
pub(crate) fn miura(cells: [u32; 2], theta: f64, gamma: f64, [fold, facet, rigidity]: [f64; 3]) -> Structure {
    let [columns, rows] = cells.map(|n| 2 * n + 1);
    let slope = gamma.cos() * theta.tan();
    let (across, shift) = (slope / slope.hypot(1.0), 1.0 / slope.hypot(1.0));
    let height = theta.sin() * gamma.sin();
    let along = (1.0 - height * height).sqrt();
    let odd = |i: u32| f64::from(i % 2);
    let node = |i: u32, j: u32| NodeId(i * rows + j);
    let mut structure = Structure::default();
    for i in 0..columns {
        for j in 0..rows {
            let y = f64::from(j) * along + odd(i) * shift;
            structure.nodes.push(DVec3::new(f64::from(i) * across, y, odd(j) * height));
        }
    }
    // Triangles of each panel, cut along its shorter diagonal; a side between two of them is a hinge.
    let mut triangles = Vec::new();
    let mut diagonals = Vec::new();
    for i in 0..columns - 1 {
        for j in 0..rows - 1 {
            let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            let length = |p: NodeId, q: NodeId| structure.nodes[p.index()].distance(structure.nodes[q.index()]);
            if length(a, c) < length(b, d) {
                triangles.extend([[a, b, c], [a, c, d]]);
                diagonals.push([a, c]);
            } else {
                triangles.extend([[b, c, d], [b, d, a]]);
                diagonals.push([b, d]);
            }
        }
    }
    let mut sides: Vec<([NodeId; 2], Vec<NodeId>)> = Vec::new();
    for [p, q, r] in triangles {
        for (from, to, apex) in [(p, q, r), (q, r, p), (r, p, q)] {
            match sides.iter_mut().find(|(own, _)| *own == [to, from]) {
                // The triangle to the right of the side as the first one has it.
                Some((_, apexes)) => apexes.push(apex),
                None => sides.push(([from, to], vec![apex])),
            }
        }
    }
    for (ends, apexes) in sides {
        let length = structure.nodes[ends[0].index()].distance(structure.nodes[ends[1].index()]);
        structure.bars.push(Bar { nodes: ends, rest_length: length, rigidity, law: BarLaw::Linear });
        if let [left, right] = apexes[..] {
            let bent = diagonals.iter().any(|d| *d == ends || [d[1], d[0]] == ends);
            let (kind, k) = if bent { (HingeKind::Facet, facet) } else { (HingeKind::Crease, fold) };
            let nodes = [left, right, ends[0], ends[1]];
            structure.hinges.push(Hinge { nodes, rest_angle: 0.0, stiffness: k * length, law: HingeLaw::Linear, kind });
        }
    }
    let angles = structure.fold_angles(&structure.nodes, &vec![0.0; structure.hinges.len()]);
    structure.hinges.iter_mut().zip(angles).for_each(|(hinge, angle)| hinge.rest_angle = angle);
    structure
}
