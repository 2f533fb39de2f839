//! A scene builds what it needs, and says what it does without and why.

use origami::generate::{Degree4, miura};
use origami::model::Inventory;
use origami::{CreasePattern, Dynamics, Material, Model, Relax, Solver};

fn inventory(pattern: &CreasePattern, material: Material, solver: &dyn Solver) -> Inventory {
    solver.inventory(&Model::new(pattern, &material).expect("valid"))
}

fn built(inventory: &Inventory) -> Vec<(&str, usize)> {
    inventory.built.iter().map(|b| (b.what, b.count)).collect()
}

fn left_out(inventory: &Inventory) -> Vec<(&str, usize, &str)> {
    inventory.left_out.iter().map(|l| (l.what, l.count, l.why)).collect()
}

#[test]
fn a_full_scene_has_every_group() {
    // 2 x 2 parallelograms: 12 sides, 4 of them inside, and a diagonal each; 8 triangles.
    let pattern = miura(2, 2).expect("valid");
    let all = inventory(&pattern, Material::default(), &Dynamics::default());
    let groups = [
        ("beams", 16),
        ("mountain and valley creases", 4),
        ("facet creases", 4),
        ("corner angles", 24),
        ("areas", 8),
        ("damping", 16),
    ];
    assert_eq!(built(&all), groups);
    assert_eq!(left_out(&all), [("fixed vertices", 0, "the pattern has none")]);
}

#[test]
fn what_has_no_stiffness_is_not_built() {
    let pattern = miura(2, 2).expect("valid");
    let none = Material { k_facet: 0.0, k_face: 0.0, zeta: 0.0, collapse: 0.0, ..Material::default() };
    let few = inventory(&pattern, none, &Dynamics::default());
    assert_eq!(built(&few), [("beams", 16), ("mountain and valley creases", 4)]);
    let reasons = left_out(&few);
    assert!(reasons.contains(&("crease springs", 4, "their stiffness is 0")), "{reasons:?}");
    assert!(reasons.contains(&("corner angles", 24, "k_face is 0")), "{reasons:?}");
    assert!(reasons.contains(&("areas", 8, "collapse is 0")), "{reasons:?}");
    assert!(reasons.contains(&("damping", 0, "zeta is 0")), "{reasons:?}");
    let model = Model::new(&pattern, &none).expect("valid");
    assert!(model.corner_angles.is_empty() && model.creases.len() == 4);
}

#[test]
fn a_relaxation_has_no_damping_and_a_free_crease_no_spring() {
    let pattern = Degree4 { driven_only: true, ..Degree4::default() }.pattern().expect("valid");
    let driven = inventory(&pattern, Material::default(), &Relax::default());
    assert_eq!(built(&driven), [("beams", 8), ("mountain and valley creases", 1), ("corner angles", 12), ("areas", 4)]);
    let reasons = left_out(&driven);
    assert!(reasons.contains(&("crease springs", 3, "their edges are undriven")), "{reasons:?}");
    assert!(reasons.iter().any(|(what, _, _)| *what == "damping"), "{reasons:?}");
}

#[test]
fn own_stiffness_of_an_edge_replaces_the_materials() {
    let mut pattern = miura(2, 2).expect("valid");
    let driven = pattern.edges.iter().position(|e| e.fold_angle.is_some()).expect("a crease");
    pattern.edges[driven].k_crease = Some(7.0);
    pattern.edges[driven].ea = Some(200.0);
    let model = Model::new(&pattern, &Material::default()).expect("valid");
    let side = model.mesh.side_of_edge[driven].expect("a side");
    let beam = &model.beams[side.index()];
    assert!((beam.stiffness * beam.rest_length - 200.0).abs() < 1e-12);
    let crease = model.creases.iter().find(|c| c.side == side).expect("its spring");
    assert!((crease.stiffness - 7.0 * beam.rest_length).abs() < 1e-12);
    let usual = model.creases.iter().filter(|c| c.side != side);
    for crease in usual {
        assert!((crease.stiffness - 0.7 * model.beams[crease.side.index()].rest_length).abs() < 1e-12);
    }
}
