//! The exact test of crossings against a plain one, against exact motions, and on sheets whose crossings are known.
#![expect(clippy::expect_used, reason = "a test may")]

use origami_core::contact::Crossings;
use origami_core::fold::Document;
use origami_core::generate::catalog;
use origami_core::glam::DVec3;
use origami_core::mesh::Mesh;
use origami_core::solve::Reflect;
use origami_core::{CreasePattern, Material, Model, Solver};

fn model(name: &str) -> Model {
    Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

/// Numbers from -1 to 1, by a fixed sequence.
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 32).expect("32 bits")) / f64::from(1_u32 << 31) - 1.0
    }
}

/// A sheet that was crumpled without regard to itself.
fn crumpled(model: &Model, seed: u64) -> Vec<DVec3> {
    let mut next = noise(seed);
    model.rest.iter().map(|p| *p + 0.8 * DVec3::new(next(), next(), next())).collect()
}

/// All sides against all triangles, by solving for the point where each line meets each plane.
fn plainly(mesh: &Mesh, positions: &[DVec3]) -> Vec<(u32, u32)> {
    let mut found = Vec::new();
    for (s, side) in (0..).zip(&mesh.sides) {
        for (t, corners) in (0..).zip(&mesh.triangles) {
            if side.nodes.iter().any(|node| corners.contains(node)) {
                continue;
            }
            let [p, q] = side.nodes.map(|n| positions[n.index()]);
            let [a, b, c] = corners.map(|n| positions[n.index()]);
            // p + u (q - p) = a + v (b - a) + w (c - a), by Cramer's rule.
            let det = |x: DVec3, y: DVec3, z: DVec3| x.dot(y.cross(z));
            let all = det(p - q, b - a, c - a);
            let [u, v, w] =
                [det(p - a, b - a, c - a), det(p - q, p - a, c - a), det(p - q, b - a, p - a)].map(|x| x / all);
            if u > 0.0 && u < 1.0 && v > 0.0 && w > 0.0 && v + w < 1.0 {
                found.push((s, t));
            }
        }
    }
    found
}

#[test]
fn it_finds_what_a_plain_test_finds() {
    let mut total = 0;
    for (name, seed) in [("bird-base", 1), ("miura", 2), ("square-twist", 3), ("waterbomb", 4)] {
        let model = model(name);
        let positions = crumpled(&model, seed);
        let found = Crossings::of(&model.mesh, &positions);
        let pairs: Vec<(u32, u32)> = found.all.iter().map(|c| (c.side.0, c.triangle.0)).collect();
        assert_eq!(pairs, plainly(&model.mesh, &positions), "{name}");
        assert!(found.deepest() > 0.0 && found.deepest() < 1.0, "{}", found.deepest());
        assert!(found.faces.is_sorted() && !found.faces.is_empty());
        total += pairs.len();
    }
    assert!(total > 200, "{total} crossings say something");
}

#[test]
fn motions_without_rounding_change_nothing() {
    let model = model("square-twist");
    let positions = crumpled(&model, 5);
    let before = Crossings::of(&model.mesh, &positions);
    assert!(!before.is_empty());
    type Motion = fn(DVec3) -> DVec3;
    let motions: [Motion; 3] = [|p| DVec3::new(p.y, p.z, p.x), |p| DVec3::new(-p.x, p.y, p.z), |p| 4.0 * p];
    for motion in motions {
        let moved: Vec<DVec3> = positions.iter().map(|p| motion(*p)).collect();
        let after = Crossings::of(&model.mesh, &moved);
        let pairs = |c: &Crossings| c.all.iter().map(|c| (c.side, c.triangle)).collect::<Vec<_>>();
        assert_eq!(pairs(&after), pairs(&before));
        assert_eq!(after.faces, before.faces);
    }
}

#[test]
fn layers_in_one_plane_do_not_cross_and_their_noise_does_as_deep_as_it_is() {
    let model = model("miura");
    let flat = Reflect::default().fold_from_rest(&model, 100.0).expect("it folds flat").state.positions;
    assert!(flat.iter().all(|p| p.z == flat[0].z), "all layers lie in one plane");
    assert_eq!(Crossings::of(&model.mesh, &flat), Crossings::default());
    let mut next = noise(6);
    let noisy: Vec<DVec3> = flat.iter().map(|p| *p + 1e-7 * DVec3::Z * next()).collect();
    let found = Crossings::of(&model.mesh, &noisy);
    assert!(found.all.len() > 100 && found.deepest() < 2e-7, "{} {}", found.all.len(), found.deepest());
}

/// Two triangles that share a corner, one in the plane z = 0, the other in the plane y = 0 through it.
const THROUGH_A_CORNER: &str = r#"{"vertices_coords": [[0,0,0], [1,-1,0], [1,1,0], [0.5,0,-0.5], [0.5,0,0.5]],
    "edges_vertices": [[0,1], [1,2], [2,0], [0,3], [3,4], [4,0]], "edges_assignment": ["B","B","B","B","B","B"],
    "faces_vertices": [[0,1,2], [0,3,4]]}"#;

#[test]
fn triangles_with_a_common_corner_cross_where_the_side_opposite_to_it_does() {
    let document = Document::from_slice(THROUGH_A_CORNER.as_bytes()).expect("a document");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let positions: Vec<DVec3> = model.mesh.vertex_of_node.iter().map(|v| pattern.vertices[v.index()]).collect();
    let found = Crossings::of(&model.mesh, &positions);
    let [crossing] = found.all.as_slice() else { panic!("one crossing, not {}", found.all.len()) };
    assert_eq!(crossing.point, DVec3::new(0.5, 0.0, 0.0));
    // The nearest ways out: half a side along it, half a unit to either border.
    assert!((crossing.depth - 0.5 / 2.0_f64.sqrt()).abs() < 1e-15, "{}", crossing.depth);
    assert_eq!(found.faces.iter().map(|pair| pair.map(|face| face.0)).collect::<Vec<_>>(), [[0, 1]]);
}
