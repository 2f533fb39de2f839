//! Whether an equilibrium is a minimum, and the way down where it is a saddle.
//!
//! Forces vanish on a saddle too, and no test of convergence sees that it is none. Curvature does: conjugate gradients on the
//! Hessian come upon a direction of negative curvature if there is one (M. R. Hestenes and E. Stiefel, J. Res. Natl. Bur.
//! Stand. 49 (1952) 409; T. Steihaug, SIAM J. Numer. Anal. 20 (1983) 626), at one product with it a step and without factors.

use glam::DVec3;

use super::largest::largest;
use super::row_sums::{OnTheWay, all_row_sums};
use super::{Failed, Folded, SparseHessian, State, Stop};
use crate::forces::Forces;
use crate::model::Model;
use crate::scene::{Held, Scene};

/// Curvature as a share of the row sums: what is less negative counts as none.
const NEUTRAL: f64 = 1e-6;
/// Under forces a rotation has one of about their share of the row sums: so many times that counts as none too.
const TURNED: f64 = 10.0;
/// The residual of the conjugate gradients has fallen so far: nothing that the first vector had a part of is left.
const EXHAUSTED: f64 = 1e-20;
/// Lengths of the first step to each side that are tried, each twice the one before, ...
const LENGTHS: u32 = 12;
/// ... from this share of the shortest beam on.
const SHORTEST: f64 = 1e-4;
/// No crease turns farther in that step, in radians: it might turn to another branch.
const LONGEST_TURN: f64 = 0.7;

/// Energy as a share of that of the sheet at rest with the same targets: below it there is next to nothing to fall.
const UNSTRAINED: f64 = 1e-6;
/// Sheets of more nodes are not searched: their Hessian would take gigabytes while it is put together.
const LARGEST: usize = 10_000;
/// How many saddles are left, one after the other.
const ESCAPES: u32 = 3;

/// Goes down from where a solver has settled until it is no saddle. The search may take `share` products with the Hessian for
/// each evaluation of the solver; `again` settles from another state, within a number of evaluations.
///
/// # Errors
/// None of its own: where the way down does not hold, the state on the saddle stays.
pub(super) fn leave(
    (model, scene): (&Model, &Scene),
    mut folded: Folded,
    (share, limit): (f64, u64),
    again: &mut dyn FnMut(&State, u64, u64) -> Result<Folded, Failed>,
) -> Folded {
    for _ in 0..ESCAPES {
        let left = limit.saturating_sub(folded.steps);
        if folded.stop != Stop::Converged || left == 0 || !is_worth_it(model, scene, &folded.state) {
            break;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a u64, saturating")]
        let products = (share * folded.steps as f64) as u64;
        let Some(down) = direction(model, scene, &folded.state, products) else { break };
        let Some(off) = lowest_along(model, scene, &folded.state, &down) else { break };
        let Ok(next) = again(&off, left, folded.steps) else { break };
        folded = Folded {
            steps: folded.steps + next.steps,
            attempts: folded.attempts,
            saddles: folded.saddles + 1,
            factorisations: folded.factorisations + next.factorisations,
            ..next
        };
    }
    folded
}

/// Whether the sheet is of a size for the search, and can have a way down: springs alone have no energy below 0.
fn is_worth_it(model: &Model, scene: &Scene, state: &State) -> bool {
    let unfolded = State { targets: state.targets.clone(), ..State::at_rest(model) };
    let strained = || state.energy(model).total() > UNSTRAINED * unfolded.energy(model).total();
    model.node_count() <= LARGEST && (!scene.has_springs_only() || strained())
}

/// A direction in which the energy falls to both sides, the longest move 1, by node; `None` where `products` with the
/// Hessian find none, or a force of one's own has no Hessian.
pub(super) fn direction(model: &Model, scene: &Scene, state: &State, products: u64) -> Option<Vec<DVec3>> {
    if products == 0 {
        return None;
    }
    let hessian = state.hessian(model, scene)?;
    let mut weights = vec![0.0; model.node_count()];
    all_row_sums(false, (model, &OnTheWay::default(), &scene.forces), &state.positions, &mut weights);
    let least = weights.iter().copied().fold(f64::INFINITY, f64::min);
    let mut forces = Forces::in_scene(model, scene);
    let forces = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles.clone());
    let threshold = NEUTRAL.max(TURNED * largest(forces) / least);
    let held = Held::new(model, scene);

    // Conjugate gradients on the Hessian plus `threshold` times the weights, which are the preconditioner too.
    let mut residual: Vec<DVec3> = weights.iter().enumerate().map(|(i, w)| irregular(i as f64) * *w).collect();
    held.clear(&mut residual);
    let mut along: Vec<DVec3> = residual.iter().zip(&weights).map(|(r, w)| *r / *w).collect();
    let mut size = dot(&residual, &along);
    let enough = EXHAUSTED * size;
    for _ in 0..products {
        let mut product = times(&hessian, &along);
        held.clear(&mut product);
        product.iter_mut().zip(&along).zip(&weights).for_each(|((q, p), w)| *q += *p * (threshold * *w));
        let curvature = dot(&along, &product);
        if curvature < 0.0 {
            let longest = largest(&along);
            return Some(along.iter().map(|p| *p / longest).collect());
        }
        if size <= enough || curvature == 0.0 {
            return None;
        }
        let length = size / curvature;
        residual.iter_mut().zip(&product).for_each(|(r, q)| *r -= *q * length);
        let preconditioned = residual.iter().zip(&weights).map(|(r, w)| *r / *w);
        let next: f64 = residual.iter().zip(preconditioned.clone()).map(|(r, z)| r.dot(z)).sum();
        along.iter_mut().zip(preconditioned).for_each(|(p, z)| *p = z + *p * (next / size));
        size = next;
    }
    None
}

/// Energies that [`lowest_along`] looks at.
#[cfg(feature = "newton")]
pub(super) const TRIALS: u64 = 2 * LENGTHS as u64;

/// The state of lowest energy along `direction` to either side; `None` where it falls to neither.
pub(super) fn lowest_along(model: &Model, scene: &Scene, state: &State, direction: &[DVec3]) -> Option<State> {
    let shortest = model.beams.iter().map(|b| b.rest_length).fold(f64::INFINITY, f64::min);
    let mut lowest = (state.energy_in(model, scene).total(), None);
    for k in 0..LENGTHS {
        for side in [1.0, -1.0] {
            let far = side * SHORTEST * shortest * f64::from(1 << k);
            let positions = state.positions.iter().zip(direction).map(|(p, d)| *p + *d * far).collect();
            let trial = state.moved_to(model, positions);
            let energy = trial.energy_in(model, scene).total();
            let turns = trial.fold_angles.iter().zip(&state.fold_angles).map(|(a, b)| (a - b).abs());
            if energy < lowest.0 && turns.fold(0.0, f64::max) <= LONGEST_TURN {
                lowest = (energy, Some(trial));
            }
        }
    }
    lowest.1
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

fn times(hessian: &SparseHessian, of_nodes: &[DVec3]) -> Vec<DVec3> {
    let column: Vec<f64> = of_nodes.iter().flat_map(|v| v.to_array()).collect();
    hessian.times(&column).chunks_exact(3).map(DVec3::from_slice).collect()
}

/// A vector without a pattern, which no symmetry forbids: the fractions of multiples of irrational numbers.
pub(super) fn irregular(i: f64) -> DVec3 {
    (DVec3::new(2.0_f64.sqrt(), 3.0_f64.sqrt(), 5.0_f64.sqrt()) * (i + 1.0)).fract() - 0.5
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;
    use crate::model::Material;
    use crate::solve::{Reflect, Relax, Solver};

    /// Sheets so symmetric that, unperturbed, they settle on a saddle.
    const SYMMETRIC: [&str; 2] = ["fan", "curved-pleat"];

    fn model(name: &str) -> Model {
        Model::new(&catalog::generate(name, &[]).expect(name), &Material::default()).expect(name)
    }

    fn unperturbed(saddle_search: f64) -> Relax {
        Relax { perturbation: 0.0, saddle_search, ..Relax::default() }
    }

    #[test]
    fn a_symmetric_sheet_leaves_its_saddle_and_says_so() {
        for name in SYMMETRIC {
            let model = model(name);
            let on_saddle = unperturbed(0.0).fold_from_rest(&model, 60.0).expect("it holds");
            let left = unperturbed(Relax::default().saddle_search).fold_from_rest(&model, 60.0).expect("it holds");
            let energies = [&on_saddle, &left].map(|folded| folded.state.energy(&model).total());
            assert!(on_saddle.converged() && left.converged() && left.steps > on_saddle.steps);
            assert!(
                on_saddle.saddles == 0 && left.saddles > 0 && energies[1] < 0.95 * energies[0],
                "{name}: {energies:?}"
            );
        }
    }

    #[test]
    fn the_energy_falls_to_both_sides_of_a_saddle_and_there_is_no_way_down_from_a_minimum() {
        for name in SYMMETRIC {
            let model = model(name);
            let scene = Scene::percent(60.0);
            let state = unperturbed(0.0).fold_from_rest(&model, 60.0).expect("it holds").state;
            let down = direction(&model, &scene, &state, 200).expect("a way down");
            let energy = |far: f64| {
                let positions = state.positions.iter().zip(&down).map(|(p, d)| *p + *d * far).collect();
                state.moved_to(&model, positions).energy(&model).total()
            };
            let second = energy(1e-3) - 2.0 * energy(0.0) + energy(-1e-3);
            assert!(second < 0.0, "{name}: {second}");
        }
        let bird = model("bird-base");
        let flat = Reflect::default().fold_from_rest(&bird, 100.0).expect("it folds flat").state;
        assert_eq!(direction(&bird, &Scene::percent(100.0), &flat, 1000), None);
    }

    #[test]
    fn a_sheet_without_strain_is_not_searched() {
        let scene = Scene::percent(100.0);
        let bird = model("bird-base");
        let folded = unperturbed(0.0).fold_from_rest(&bird, 60.0).expect("it holds");
        assert!(is_worth_it(&bird, &Scene::percent(60.0), &folded.state), "no rigid state leads there");
        assert!(!is_worth_it(&bird, &scene, &Reflect::default().fold_from_rest(&bird, 100.0).expect("flat").state));
    }

    #[test]
    fn held_nodes_have_no_part_in_a_way_down() {
        let mut model = model("fan");
        let state = unperturbed(0.0).fold_from_rest(&model, 60.0).expect("it holds").state;
        model.fixed = model.mesh.triangles[0].to_vec();
        model.fixed.sort_unstable();
        let down = direction(&model, &Scene::percent(60.0), &state, 1000).expect("a way down");
        assert!(model.fixed.iter().all(|node| down[node.index()] == DVec3::ZERO));
        model.fixed = (0..model.node_count()).map(crate::ids::NodeId::new).collect();
        assert_eq!(direction(&model, &Scene::percent(60.0), &state, 1000), None);
    }
}
