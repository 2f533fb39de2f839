//! One run of each solver ends in the same bits in this release as in the last: `tests/golden_bits.txt` holds their hash.
//!
//! A change of the numerics, however small, shows here; one that is meant is written down by
//! `ORIGAMI_UPDATE_GOLDEN=1 cargo test --test golden_bits` and named in the CHANGELOG.
//!
//! The hashes hold where a product and a sum are rounded once (FMA; AVX2 and AVX-512 then give equal bits) and arc tangents
//! are those of the GNU C library: x86-64 Linux. Elsewhere the test says that it is skipped. `Newton` is left out: faer sums
//! in another order with each set of instructions.

use std::fmt::Write as _;
use std::path::Path;

use origami::solve::{Integrator, Precision};
use origami::{CreasePattern, Dynamics, Folded, Material, Model, Relax, Solver};

const FILE: &str = "tests/golden_bits.txt";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// An unsymmetric sheet of 28 nodes, which is no multiple of a number of lanes.
fn model() -> Model {
    let pattern = CreasePattern::read(root().join("examples/patterns/kresling.fold")).expect("a pattern");
    Model::new(&pattern, &Material::default()).expect("a sheet")
}

fn fold(model: &Model, solver: &dyn Solver) -> Folded {
    solver.fold_from_rest(model, 60.0).expect("holds")
}

/// FNV-1a, 64 bits, of all numbers of a result.
fn hash(folded: &Folded) -> u64 {
    let state = &folded.state;
    let vectors = state.positions.iter().chain(&state.velocities).flat_map(|v| v.to_array());
    let angles = state.fold_angles.iter().chain(&state.targets).copied();
    let others = [folded.time_step, folded.residual, folded.distance];
    let bytes = vectors.chain(angles).chain(others).flat_map(|number| number.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// A line for each solver and precision: what ran, for how many evaluations, and the hash of what came of it.
fn lines() -> String {
    let model = model();
    let mut text = String::new();
    for precision in [Precision::F64, Precision::Mixed] {
        let dynamics = |integrator| Dynamics { precision, integrator, steps: Some(1000), ..Dynamics::default() };
        let solvers: [(&str, Box<dyn Solver>); 3] = [
            ("relax", Box::new(Relax { precision, ..Relax::default() })),
            ("dynamics euler", Box::new(dynamics(Integrator::Euler))),
            ("dynamics verlet", Box::new(dynamics(Integrator::Verlet))),
        ];
        for (name, solver) in solvers {
            let folded = fold(&model, solver.as_ref());
            let (precision, steps) = (precision.name(), folded.steps);
            writeln!(text, "{name}, {precision}: {steps} evaluations, {:016x}", hash(&folded)).expect("memory");
        }
    }
    text
}

/// Whether the assumptions of the hashes hold on this machine.
fn comparable() -> bool {
    #[cfg(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu"))]
    return is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
    #[cfg(not(all(target_arch = "x86_64", target_os = "linux", target_env = "gnu")))]
    return false;
}

#[test]
fn each_solver_ends_in_the_bits_of_the_last_release() {
    if !comparable() {
        eprintln!("skipped: the hashes are those of x86-64 Linux with AVX2 and FMA");
        return;
    }
    let (path, found) = (root().join(FILE), lines());
    if std::env::var_os("ORIGAMI_UPDATE_GOLDEN").is_some() {
        std::fs::write(&path, &found).expect("a folder that can be written");
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{FILE}: {error}"));
    assert_eq!(found, expected, "{FILE}: other bits; ORIGAMI_UPDATE_GOLDEN=1 writes it anew");
}

#[test]
fn the_last_bit_of_any_number_is_seen() {
    let folded = fold(&model(), &Dynamics { steps: Some(10), ..Dynamics::default() });
    let changes: [fn(&mut Folded); 5] = [
        |f| f.state.positions[3].y = f.state.positions[3].y.next_up(),
        |f| f.state.velocities[0].x = -f.state.velocities[0].x,
        |f| f.state.fold_angles[1] = f.state.fold_angles[1].next_down(),
        |f| f.state.targets.swap(0, 5),
        |f| f.residual = f.residual.next_up(),
    ];
    for (at, change) in changes.iter().enumerate() {
        let mut changed = folded.clone();
        change(&mut changed);
        assert_ne!(hash(&changed), hash(&folded), "change {at}");
    }
}
