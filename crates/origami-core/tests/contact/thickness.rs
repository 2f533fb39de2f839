//! Paper with a thickness: how high stacks come out.

use origami_core::contact::Contact;
use origami_core::fold::Document;
use origami_core::glam::DVec3;
use origami_core::scene::Scene;
use origami_core::solve::{ContactRelax, Stop};
use origami_core::{CreasePattern, Model};

use crate::{model_of, place, watched};

/// An accordion of so many panels of 1 x 1.5, mountains and valleys in turn. Its creases are slanted by a ten thousandth, so
/// that all diagonals by which panels are cut are parallel, or those of neighbours `mirrored`.
fn accordion(panels: u32, mirrored: bool) -> Model {
    let node = |column: u32, row: u32| 2 * column + row;
    let slant = |column: u32| match (mirrored, column.is_multiple_of(2)) {
        (false, _) => 1e-4,
        (true, true) => 1e-4 * f64::from(column),
        (true, false) => -1e-4 * f64::from(column),
    };
    let mut vertices = Vec::new();
    let (mut edges, mut letters, mut faces) = (Vec::new(), Vec::new(), Vec::new());
    for column in 0..=panels {
        vertices.extend([[f64::from(column), 0.0], [f64::from(column) + slant(column), 1.5]]);
        edges.push([node(column, 0), node(column, 1)]);
        let fold = if column.is_multiple_of(2) { "V" } else { "M" };
        letters.push(if column == 0 || column == panels { "B" } else { fold });
    }
    for column in 0..panels {
        let [a, b, c, d] = [node(column, 0), node(column + 1, 0), node(column + 1, 1), node(column, 1)];
        edges.extend([[a, b], [c, d]]);
        letters.extend(["B", "B"]);
        faces.push([a, b, c, d]);
    }
    let text = serde_json::json!({
        "vertices_coords": vertices, "edges_vertices": edges, "edges_assignment": letters, "faces_vertices": faces,
    });
    let document = Document::from_slice(text.to_string().as_bytes()).expect("a document");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = model_of(&pattern);
    // Which way each diagonal goes, from left to right.
    let diagonals = model.mesh.sides.iter().filter(|side| side.edge.is_none());
    let mut ways: Vec<(u32, bool)> = diagonals
        .map(|side| {
            let mut ends = side.nodes.map(|n| model.mesh.vertex_of_node[n.index()].0);
            ends.sort_unstable();
            (ends[0] / 2, ends[0].is_multiple_of(2))
        })
        .collect();
    ways.sort_unstable();
    assert_eq!(ways.len(), panels as usize);
    assert!(ways.windows(2).all(|pair| (pair[0].1 != pair[1].1) == mirrored), "{ways:?}");
    model
}

/// How far apart the centroids of the first and the last panel are along the stack, as a multiple of what rigid panels of
/// that thickness, in radii, have.
fn height(panels: u32, mirrored: bool, thickness: f64) -> f64 {
    let model = accordion(panels, mirrored);
    let solver = ContactRelax { contact: Contact::thick(thickness), ..ContactRelax::default() };
    let (folded, touch, crossed) = watched(&model, &solver, &Scene::percent(100.0));
    assert_eq!((folded.stop, crossed), (Stop::Converged, 0), "{panels} panels: {touch:?}");
    let at = |vertex: u32| place(&model, &folded.state, vertex);
    let centroid = |panel: u32| (0..4).map(|i| at(2 * panel + i)).sum::<DVec3>() / 4.0;
    // The stack is along the normal of its panels.
    let normal = (at(2) - at(0)).cross(at(1) - at(0)).normalize();
    (centroid(panels - 1) - centroid(0)).dot(normal).abs() / (f64::from(panels - 1) * thickness)
}

/// Within 5 % of rigid panels, and within 1 % of each other for both ways of cutting.
fn check(panels: u32, thickness: f64) {
    let [parallel, mirrored] = [false, true].map(|mirrored| height(panels, mirrored, thickness));
    for height in [parallel, mirrored] {
        assert!((height - 1.0).abs() < 0.05, "{panels} panels of {thickness}: {height} times (n - 1) t");
    }
    assert!((parallel - mirrored).abs() < 0.01, "{panels} panels of {thickness}: {parallel} and {mirrored}");
}

#[test]
fn an_accordion_is_as_high_as_its_panels_however_they_are_cut() {
    for panels in [4, 5, 8, 16] {
        check(panels, 0.004);
    }
    for thickness in [0.001, 0.002, 0.008] {
        check(8, thickness);
    }
}

#[test]
#[ignore = "seconds: every number of panels"]
fn accordions_of_all_sizes_are_as_high_as_their_panels() {
    for panels in 4..=16 {
        for thickness in [0.001, 0.002, 0.004] {
            check(panels, thickness);
        }
    }
}
