//! All that other programs found: their states in our equations, their curves, the spectra of their tangents.
//!
//! Every case of `cases` has states, a curve and, of MERLIN, the least eigenvalues as drawn. Left out are:
//! - the curve of `merlin1_single_crease` beyond the height at which its load grows without bound: there MERLIN steps over to
//!   another branch, and in its last step through the facets;
//! - the curve of `merlin2_waterbomb`, which turns back: in its place is that of the independent program;
//! - the eigenvalues of `merlin2_gmiura`: its facets have the stiffness that the rounding of an arc cosine leaves.

use std::ops::ControlFlow;

use origami_core::analysis::{Configuration, Dof, Ended, Event, Path, Point, Start, Structure, Trace, Until};
use origami_core::glam::{DVec2, DVec3};

use crate::case::{Found, case, dof, found};

/// A case: its name, its content, and the largest force out of balance of its states by the independent program.
const CASES: [(&str, &str, f64); 13] = [
    ("merlin1_eggbox_folding", include_str!("cases/merlin1_eggbox_folding.json"), 2.7e-5),
    ("merlin1_kresling", include_str!("cases/merlin1_kresling.json"), 3.5e-13),
    ("merlin1_miura_bending", include_str!("cases/merlin1_miura_bending.json"), 1.2e-8),
    ("merlin1_miura_folding", include_str!("cases/merlin1_miura_folding.json"), 2.3e-5),
    ("merlin1_miura_popthrough", include_str!("cases/merlin1_miura_popthrough.json"), 1.5e-11),
    ("merlin1_single_crease", include_str!("cases/merlin1_single_crease.json"), 1e-5),
    ("merlin2_crease", include_str!("cases/merlin2_crease.json"), 2e-8),
    ("merlin2_gmiura", include_str!("cases/merlin2_gmiura.json"), 2.8e-8),
    ("merlin2_hypar", include_str!("cases/merlin2_hypar.json"), 2.3e-13),
    ("merlin2_strip_linear", include_str!("cases/merlin2_strip_linear.json"), 2e-8),
    ("merlin2_waterbomb", include_str!("cases/merlin2_waterbomb.json"), 3e-13),
    ("merlin2_yoshimura", include_str!("cases/merlin2_yoshimura.json"), 2e-8),
    ("simfast_kresling", include_str!("cases/simfast_kresling.json"), 1.4e-9),
];

/// A state as a program wrote it down; its fold angles are followed from the drawn ones through the states before it.
fn configuration(structure: &Structure, before: &Configuration, positions: &[[f64; 3]]) -> Configuration {
    let positions: Vec<DVec3> = positions.iter().map(|p| DVec3::from_array(*p)).collect();
    Configuration { fold_angles: structure.fold_angles(&positions, &before.fold_angles), positions }
}

/// What is left over in a state: the largest force along free axes, and the energy.
fn left_over(structure: &Structure, at: &Configuration, factor: f64) -> (f64, f64) {
    let mut left = structure.unbalanced(at, factor).expect("a state");
    for held in &structure.supports.fixed {
        left[held.node.index()][held.axis.index()] = 0.0;
    }
    (left.iter().map(|f| f.abs().max_element()).fold(0.0, f64::max), structure.energies(at).total())
}

#[test]
fn states_of_other_programs_balance_and_store_what_they_say() {
    for (name, text, balanced) in CASES {
        let structure = case(text);
        let mut at = structure.as_drawn();
        for state in found(text).states {
            at = configuration(&structure, &at, &state.positions);
            let (residual, energy) = left_over(&structure, &at, state.factor);
            assert!(residual <= 2.0 * balanced, "{name}: {residual:e} of {balanced:e}");
            assert!((energy / state.energy - 1.0).abs() < 1e-8, "{name}: {energy} is not {}", state.energy);
        }
    }
}

#[test]
fn a_state_that_is_none_does_not_balance() {
    let (_, text, _) = CASES[1];
    let structure = case(text);
    let mut state = found(text).states.swap_remove(1);
    state.positions[12][2] += 1e-6;
    let at = configuration(&structure, &structure.as_drawn(), &state.positions);
    assert!(left_over(&structure, &at, state.factor).0 > 1e-4);
}

#[test]
fn tangents_as_drawn_have_the_spectra_that_merlin_finds() {
    for (name, text, _) in CASES {
        let (structure, found) = (case(text), found(text));
        let modes = structure.modes(&structure.as_drawn(), 0.0, found.eigenvalues.len()).expect("modes");
        assert_eq!(modes.len(), found.eigenvalues.len(), "{name}");
        for (mode, wanted) in modes.iter().zip(&found.eigenvalues) {
            let error = (mode.eigenvalue - wanted).abs();
            assert!(error < 1e-9 * found.eigenvalue_max, "{name}: {} is not {wanted}", mode.eigenvalue);
        }
    }
}

/// A path through all that a program found of a case: as far as its last state.
fn follow(structure: &Structure, found: &Found) -> Trace {
    let until = Until::Displacement(dof(found.monitor), found.curve[found.curve.len() - 1][0]);
    // Cubics between points: short steps where they cost little, and where a power law begins steeply.
    let longest = if structure.nodes.len() < 100 { 0.01 } else { 0.02 };
    let path = Path { longest, step: 1e-4, ..Path::steps(2000) }.until(until);
    let trace = structure.trace(&Start::default(), &path, &mut |_| ControlFlow::Continue(())).expect("a path");
    assert_eq!(trace.ended, Ended::Reached);
    trace
}

/// Displacement and load factor between two points of a path, by Hermite's cubic through both along the path's direction.
fn between(structure: &Structure, monitor: Dof, [from, to]: [&Point; 2], share: f64) -> [f64; 2] {
    let ends = [from, to].map(|point| [point.displacement(&structure.nodes, monitor), point.load_factor]);
    let rates = [from, to].map(|point| [monitor.of(&point.onward.moves), point.onward.load_factor]);
    let length = from.configuration.positions.iter().zip(&to.configuration.positions);
    let length = length.map(|(p, q)| p.distance_squared(*q)).sum::<f64>().sqrt();
    let (s, r) = (share, 1.0 - share);
    std::array::from_fn(|k| {
        let (a, b) = (ends[0][k], ends[1][k]);
        let (a_rate, b_rate) = (rates[0][k] * length, rates[1][k] * length);
        (1.0 + 2.0 * s) * r * r * a + s * r * r * a_rate + s * s * (3.0 - 2.0 * s) * b - s * s * r * b_rate
    })
}

/// How far each point of a curve is from a path at most, in shares of the curve's width and height.
fn farthest(structure: &Structure, trace: &Trace, monitor: Dof, curve: &[[f64; 2]]) -> f64 {
    const PIECES: u32 = 100;
    // The direction at a bifurcation is that of the step before.
    let is_own = |point: &&Point| !matches!(point.event, Event::Bifurcation { .. });
    let points: Vec<&Point> = trace.points.iter().filter(is_own).collect();
    let all = points.windows(2).flat_map(|pair| {
        (0..=PIECES).map(move |i| between(structure, monitor, [pair[0], pair[1]], f64::from(i) / f64::from(PIECES)))
    });
    let all: Vec<[f64; 2]> = all.collect();
    let range = |k: usize| {
        let values = curve.iter().map(|p| p[k]);
        values.clone().fold(f64::MIN, f64::max) - values.fold(f64::MAX, f64::min)
    };
    let ranges = [range(0), range(1)];
    let scaled = |p: [f64; 2]| DVec2::new(p[0] / ranges[0], p[1] / ranges[1]);
    let distance = |wanted: &[f64; 2]| {
        let wanted = scaled(*wanted);
        let to_piece = |pair: &[[f64; 2]]| {
            let (a, along) = (scaled(pair[0]), scaled(pair[1]) - scaled(pair[0]));
            let share = ((wanted - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            wanted.distance(a + along * share)
        };
        all.windows(2).map(to_piece).fold(f64::INFINITY, f64::min)
    };
    curve.iter().map(distance).fold(0.0, f64::max)
}

#[test]
fn curves_go_through_the_points_of_other_programs() {
    for (name, text, _) in CASES {
        let (structure, mut found) = (case(text), found(text));
        let monitor = dof(found.monitor);
        let trace = follow(&structure, &found);
        let apart = farthest(&structure, &trace, monitor, &found.curve);
        assert!(apart < 1e-4, "{name}: {apart}");
        // Were one of them elsewhere, it would be found.
        let middle = found.curve.len() / 2;
        found.curve[middle][1] *= 1.1;
        assert!(farthest(&structure, &trace, monitor, &found.curve) > 1e-4, "{name}");
    }
}
