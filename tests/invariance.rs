//! Results do not depend on numbering, rigid motion, scale or direction of the input; swapping mountain and valley mirrors
//! the shape; the same input gives the same bits.

mod common;

use origami::generate::{catalog, miura};
use origami::glam::{DMat3, DQuat, DVec3};
use origami::ids::{TriangleId, VertexId};
use origami::measure::{align, edge_fold_angles};
use origami::pattern::Assignment;
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::{CreasePattern, Dynamics, Material, Model, Relax, Solver, State};

const NAMES: [&str; 4] = ["bird-base", "square-twist", "miura", "waterbomb"];

fn made(name: &str) -> CreasePattern {
    catalog::generate(name, &[]).expect("default parameters")
}

/// Equilibria of `pattern` at 60 % and the motion towards it, in radii, by vertex.
fn states(pattern: &CreasePattern) -> [Vec<DVec3>; 2] {
    let model = Model::new(pattern, &Material::default()).expect("a generated pattern");
    let start = State::at_rest(&model);
    let relaxed =
        Relax { tolerance: 1e-9, ..Relax::default() }.fold(&model, &start, &Scene::percent(60.0), &mut unwatched);
    let moving = Dynamics { steps: Some(200), ..Dynamics::default() }.fold(
        &model,
        &start,
        &Scene::percent(60.0),
        &mut unwatched,
    );
    [relaxed, moving].map(|folded| {
        let state = folded.expect("holds").state;
        let node = |v: usize| model.mesh.node_of_vertex[v].expect("no isolated vertices");
        (0..pattern.vertices.len()).map(|v| state.positions[node(v).index()]).collect()
    })
}

fn assert_same(name: &str, changed: &[Vec<DVec3>; 2], original: &[Vec<DVec3>; 2]) {
    for (changed, original) in changed.iter().zip(original) {
        let distance = align(changed, original).max;
        assert!(distance < 1e-6, "{name}: {distance}");
    }
}

/// The scale on which the material's numbers hold comes from the bounding box along the axes: turns leave it alone where
/// the sheet is centrally symmetric, quarter turns everywhere.
#[test]
fn neither_place_nor_direction_nor_scale_matters() {
    let any_turn = DQuat::from_euler(origami::glam::EulerRot::XYZ, 0.4, -1.1, 2.0);
    let quarter_turn = DQuat::from_mat3(&DMat3::from_cols(DVec3::Y, DVec3::Z, DVec3::X));
    for name in NAMES {
        let original = states(&made(name));
        let turn = if ["bird-base", "square-twist"].contains(&name) { any_turn } else { quarter_turn };
        for (scale, shift) in [(1.0, DVec3::new(3.0, -2.0, 1.0)), (1e-9, DVec3::ZERO), (1e9, DVec3::splat(1e8))] {
            let mut pattern = made(name);
            for p in &mut pattern.vertices {
                *p = (turn * *p) * scale + shift;
            }
            assert_same(name, &states(&pattern), &original);
        }
    }
}

#[test]
fn numbering_does_not_matter() {
    for name in NAMES {
        let original = made(name);
        let mut pattern = original.clone();
        // Vertices backwards, edges and faces backwards and turned: the same sheet.
        let last = u32::try_from(pattern.vertices.len()).expect("a small pattern") - 1;
        let renumbered = |v: VertexId| VertexId(last - v.0);
        pattern.vertices.reverse();
        for edge in &mut pattern.edges {
            edge.vertices = [renumbered(edge.vertices[1]), renumbered(edge.vertices[0])];
        }
        pattern.edges.reverse();
        for face in &mut pattern.faces {
            face.iter_mut().for_each(|v| *v = renumbered(*v));
            // Where a quad's diagonals are equally long, the first corner chooses.
            let turn = if face.len() == 4 { 2 } else { 1 };
            face.rotate_left(turn);
        }
        pattern.faces.reverse();
        let changed = states(&pattern).map(|mut state| {
            state.reverse();
            state
        });
        assert_same(name, &changed, &states(&original));
    }
}

#[test]
fn swapped_letters_mirror_the_shape() {
    for name in NAMES {
        let original = made(name);
        let mut swapped = original.clone();
        for edge in &mut swapped.edges {
            edge.fold_angle = edge.fold_angle.map(|angle| -angle);
            edge.assignment = match edge.assignment {
                Assignment::Mountain => Assignment::Valley,
                Assignment::Valley => Assignment::Mountain,
                other => other,
            };
        }
        let original = states(&original);
        let mirrored = states(&swapped).map(|state| state.iter().map(|p| p.with_z(-p.z)).collect());
        assert_same(name, &mirrored, &original);
        assert!(align(&states(&swapped)[0], &original[0]).max > 1e-3, "{name}: the check can fail");
    }
}

#[test]
fn the_same_input_gives_the_same_bits() {
    for name in NAMES {
        let first = states(&made(name));
        let second = std::thread::spawn(move || states(&made(name))).join().expect("no panic");
        assert_eq!(first, second, "{name}");
    }
}

/// A sheet large enough to be renumbered, and the same with its vertices shuffled; the new number of each vertex.
fn shuffled_miura() -> (CreasePattern, CreasePattern, impl Fn(VertexId) -> VertexId) {
    let original = miura(33, 33).expect("valid");
    let count = original.vertices.len();
    // A factor without a divisor in common with the number of vertices.
    assert!(!count.is_multiple_of(7919));
    let renumbered = move |v: VertexId| VertexId::new(v.index() * 7919 % count);
    let mut pattern = original.clone();
    for (i, p) in original.vertices.iter().enumerate() {
        pattern.vertices[renumbered(VertexId::new(i)).index()] = *p;
    }
    for edge in &mut pattern.edges {
        edge.vertices = edge.vertices.map(renumbered);
    }
    pattern.faces.iter_mut().flatten().for_each(|v| *v = renumbered(*v));
    (original, pattern, renumbered)
}

#[test]
fn a_large_shuffled_sheet_moves_as_the_ordered_one_does() {
    let (original, shuffled, renumbered) = shuffled_miura();
    let moved = |pattern: &CreasePattern| {
        let model = Model::new(pattern, &Material::default()).expect("valid");
        let relax = Relax { steps: Some(150), ramp: Some(100), ..Relax::default() };
        let folded = relax.fold_from_rest(&model, 60.0).expect("holds");
        model.file_positions(pattern, &folded.state.positions)
    };
    let (expected, got) = (moved(&original), moved(&shuffled));
    let got: Vec<DVec3> = (0..got.len()).map(|i| got[renumbered(VertexId::new(i)).index()]).collect();
    let radius = Model::new(&original, &Material::default()).expect("valid").normalisation.radius;
    let distance = expected.iter().zip(&got).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) / radius;
    assert!(distance < 1e-9, "{distance}");
    let way = expected.iter().zip(&original.vertices).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) / radius;
    assert!(way > 1e-3, "the sheet moves, by {way}");
}

#[test]
fn what_is_written_is_in_the_order_of_the_file_bit_for_bit() {
    let (original, shuffled, renumbered) = shuffled_miura();
    let written = |pattern: &CreasePattern| {
        let model = Model::new(pattern, &Material::default()).expect("valid");
        let mesh = &model.mesh;
        let corners = |t: &TriangleId| mesh.triangles[t.index()].map(|n| model.rest[n.index()]);
        let triangles: Vec<[DVec3; 3]> = mesh.triangles_by_face.iter().map(corners).collect();
        let numbered_as_given = mesh.vertex_of_node.is_sorted();
        let angles = edge_fold_angles(&model, pattern, &State::at_rest(&model));
        (model.file_positions(pattern, &model.rest), triangles, angles, numbered_as_given)
    };
    let (positions, triangles, angles, as_given) = written(&original);
    let (of_shuffled, triangles_of_shuffled, angles_of_shuffled, shuffled_as_given) = written(&shuffled);
    assert!(as_given && !shuffled_as_given, "the one keeps its numbers, the other does not");
    let back: Vec<DVec3> = (0..positions.len()).map(|i| of_shuffled[renumbered(VertexId::new(i)).index()]).collect();
    assert_eq!(back, positions);
    assert_eq!(triangles_of_shuffled, triangles);
    assert_eq!(angles_of_shuffled, angles);
}
