//! The largest time step that holds, found by trying.
//!
//! A step holds at an equilibrium if a small vibration about it does not grow. What is tried is the solver itself, at
//! [`TimeStep::Fixed`]: it runs twice the same number of steps from a deviation so small that springs answer linearly, and
//! the step holds unless the vibration's energy in the second half grew by [`GROWTH`]. Beyond the limit a damped vibration
//! grows in each step by at least twice the share by which the step is too long, an undamped one by far more, while below
//! the limit the energy that one sees of it may swing by 400 at half a percent off: both are told apart to half a percent.
//! Each trial begins with the shape that grew in the trial before, and with something of all shapes.

use origami_core::forces::Forces;
use origami_core::glam::DVec3;
use origami_core::model::DEGENERATE;
use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use origami_core::solve::{Integrator, TimeStep};
use origami_core::{Dynamics, Model, Solver, State};

/// Energy of a vibration at the end over that in the middle, beyond which it grew.
const GROWTH: f64 = 1e3;
/// The first deviation, as a share of the shortest height or beam.
const SMALL: f64 = 1e-6;
/// So many times as far away, a node has left: no rigid motion or mechanism gets there in the steps of a trial. What grew
/// may by then be at rest again, elsewhere.
const STRAYED: f64 = 1e4;
/// What has decayed to this share of the energy at the start is not asked whether it grows: rounding might.
const DECAYED: f64 = 1e-8;
/// How much of all shapes is mixed to the one that grew.
const MIXED: f64 = 0.2;
/// Factor from one trial to the next while the limit is not yet enclosed.
const FURTHER: f64 = 1.3;
/// Trials after which the limit counts as not found.
const TRIALS: u32 = 100;

/// How hard to look.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// Steps in each half of a trial.
    pub(super) half: u64,
    /// How near the limit is enclosed, as a share of it.
    pub(super) precision: f64,
}

/// The longest step, in units of model time, that was seen to hold about `equilibrium`, which is to be in equilibrium at
/// its targets; `guess` is tried first. `None` where all steps hold or none does.
pub(super) fn largest(
    model: &Model,
    equilibrium: &State,
    integrator: Integrator,
    guess: f64,
    effort: Effort,
) -> Option<f64> {
    let mut asked = model.clone();
    for (crease, target) in asked.creases.iter_mut().zip(&equilibrium.targets) {
        crease.full_target = *target;
    }
    let mut vibration = Vibration::new(&asked, equilibrium, integrator, effort.half);
    let (mut holds, mut fails) = (None, None);
    let mut dt = guess;
    for _ in 0..TRIALS {
        *(if vibration.grows(dt) { &mut fails } else { &mut holds }) = Some(dt);
        dt = match (holds, fails) {
            (Some(low), Some(high)) if high <= low * (1.0 + effort.precision) => return holds,
            (Some(low), Some(high)) => (low * high).sqrt(),
            (Some(low), None) => low * FURTHER,
            (None, Some(high)) => high / FURTHER,
            (None, None) => return None,
        };
    }
    None
}

/// Small vibrations about an equilibrium.
struct Vibration<'m> {
    model: &'m Model,
    equilibrium: State,
    forces: Forces<'m>,
    /// At the equilibrium: what the solver left, and rounding.
    residual: Vec<DVec3>,
    integrator: Integrator,
    half: u64,
    /// Length of the first deviation, in radii.
    small: f64,
    /// A little of all shapes; no rigid motion. None longer than 1.
    noise: Vec<DVec3>,
    /// The shape that grew last: positions, and way in one step.
    shape: [Vec<DVec3>; 2],
}

impl<'m> Vibration<'m> {
    fn new(model: &'m Model, equilibrium: &State, integrator: Integrator, half: u64) -> Self {
        let mut equilibrium = equilibrium.clone();
        equilibrium.velocities.fill(DVec3::ZERO);
        let mut forces = Forces::new(model);
        let State { positions, targets, fold_angles, .. } = &mut equilibrium;
        let residual = forces.evaluate(positions, targets, fold_angles).to_vec();
        let mut noise = differences(&State::perturbed(model, 1.0, 1).positions, &model.rest);
        scale_to_1([&mut noise, &mut Vec::new()]);
        let nothing = vec![DVec3::ZERO; noise.len()];
        let shape = [nothing, noise.clone()];
        let small = SMALL * least_length(model, &equilibrium.positions);
        Self { model, equilibrium, forces, residual, integrator, half, small, noise, shape }
    }

    /// Whether a vibration grows in steps of `dt`.
    fn grows(&mut self, dt: f64) -> bool {
        let solver = Dynamics {
            time_step: TimeStep::Fixed(dt),
            integrator: self.integrator,
            steps: Some(self.half),
            ..Dynamics::default()
        };
        let mut state = self.equilibrium.clone();
        let nodes = state.positions.iter_mut().zip(&mut state.velocities).zip(&self.noise);
        for (((x, v), noise), [deviation, way]) in
            nodes.zip(self.shape[0].iter().zip(&self.shape[1]).map(|(x, w)| [x, w]))
        {
            *x += *deviation * self.small;
            *v = (*way + *noise * MIXED) * (self.small / dt);
        }
        let at_first = self.energy(&state);
        let half = |state: &State| {
            solver.fold(self.model, state, &Scene::percent(100.0), &mut unwatched).ok().map(|f| f.state)
        };
        let Some(middle) = half(&state) else { return true };
        let Some(end) = half(&middle) else { return true };
        let (in_the_middle, at_the_end) = (self.energy(&middle), self.energy(&end));
        let strayed = [&middle, &end].into_iter().any(|state| self.strayed(state));
        let grows = strayed || at_the_end > GROWTH * in_the_middle.max(DECAYED * at_first);
        if grows {
            let ways = end.velocities.iter().map(|v| *v * dt).collect();
            let mut shape = [differences(&end.positions, &self.equilibrium.positions), ways];
            let [positions, ways] = &mut shape;
            scale_to_1([positions, ways]);
            self.shape = shape;
        }
        grows
    }

    fn strayed(&self, state: &State) -> bool {
        let deviations = state.positions.iter().zip(&self.equilibrium.positions).map(|(x, x0)| x.distance(*x0));
        deviations.fold(0.0, f64::max) > STRAYED * self.small
    }

    /// The energy of a small vibration, twice: squared speeds, and what the springs do along the way back.
    fn energy(&mut self, state: &State) -> f64 {
        let mut fold_angles = state.fold_angles.clone();
        let forces = self.forces.evaluate(&state.positions, &state.targets, &mut fold_angles);
        let moved = state.positions.iter().zip(&self.equilibrium.positions).map(|(x, x0)| *x - *x0);
        let pull = moved.zip(forces.iter().zip(&self.residual)).map(|(d, (f, f0))| d.dot(*f0 - *f)).sum::<f64>();
        state.velocities.iter().map(|v| v.length_squared()).sum::<f64>() + pull.max(0.0)
    }
}

fn differences(to: &[DVec3], from: &[DVec3]) -> Vec<DVec3> {
    to.iter().zip(from).map(|(a, b)| *a - *b).collect()
}

/// Divides all by the length of the longest.
fn scale_to_1(lists: [&mut Vec<DVec3>; 2]) {
    let longest = lists.iter().flat_map(|list| list.iter()).map(|v| v.length()).fold(0.0, f64::max);
    if longest > 0.0 {
        lists.into_iter().flatten().for_each(|v| *v /= longest);
    }
}

/// The shortest beam or height of a triangle, of those that carry springs.
fn least_length(model: &Model, positions: &[DVec3]) -> f64 {
    let height = |nodes: &[origami_core::ids::NodeId; 3]| {
        let [a, b, c] = nodes.map(|n| positions[n.index()]);
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        (b - a).cross(c - a).length() / longest
    };
    let heights = model.mesh.triangles.iter().map(height).filter(|h| *h >= DEGENERATE);
    model.beams.iter().map(|beam| beam.rest_length).chain(heights).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use origami_core::solve::time_step;
    use origami_core::{CreasePattern, Material};

    use super::super::cases::patterns::{hinge, triangle};
    use super::*;

    const EFFORT: Effort = Effort { half: 400, precision: 0.005 };

    fn found(pattern: &CreasePattern, material: Material, integrator: Integrator) -> f64 {
        let model = Model::new(pattern, &material).expect("a sheet");
        let guess = time_step::safe(&model, &model.rest, integrator) / origami_core::twins::safe_time_step::SAFE_SHARE;
        largest(&model, &State::at_rest(&model), integrator, guess, EFFORT).expect("there is a limit")
    }

    /// Within what the bisection promises.
    fn agrees(found: f64, expected: f64) -> bool {
        (found / expected - 1.0).abs() < 0.01
    }

    const NOTHING: Material = Material { ea: 1e-3, k_fold: 0.0, k_facet: 0.0, k_face: 0.0, zeta: 0.0, collapse: 0.0 };

    /// Of a beam of the triangle, whose box has its centre elsewhere than the triangle.
    fn stiffness(ea: f64) -> f64 {
        ea / (3.0_f64.sqrt() / 0.75_f64.hypot(0.75_f64.sqrt()))
    }

    #[test]
    fn finds_the_limit_of_a_crease() {
        // METHOD 5.4: omega^2 = 4 k_fold l / h^2, and a step of 2 / omega is the longest.
        for (height, k_fold) in [(1.0, 0.7), (0.3, 0.7), (0.01, 100.0)] {
            let omega = (4.0 * k_fold * 2.0_f64).sqrt() / height;
            for integrator in [Integrator::Euler, Integrator::Verlet] {
                let found = found(&hinge(height, 1.0), Material { k_fold, ..NOTHING }, integrator);
                assert!(agrees(found, 2.0 / omega), "{found} and not {}", 2.0 / omega);
                assert!(!agrees(found, 2.0 / (1.05 * omega)), "nor any other");
            }
        }
    }

    #[test]
    fn finds_the_limit_of_three_beams_with_and_without_damping() {
        // A regular triangle breathes with omega^2 = 3 k, and each node is damped by 3 c.
        let k = stiffness(20.0);
        for zeta in [0.0, 0.01, 0.45, 2.0] {
            let (stiffness, damping) = (3.0 * k, 3.0 * 2.0 * zeta * k.sqrt());
            let limit = 4.0 / (damping + (damping * damping + 4.0 * stiffness).sqrt());
            let found = found(&triangle(), Material { ea: 20.0, zeta, ..NOTHING }, Integrator::Euler);
            assert!(agrees(found, limit), "zeta {zeta}: {found} and not {limit}");
            assert!(!agrees(found, 0.97 * limit) && !agrees(found, 1.03 * limit));
        }
    }

    #[test]
    fn what_grew_and_came_to_rest_elsewhere_did_not_hold() {
        // The apexes of a thin hinge, once they have left, lie still farther out. Damping only shortens the limit.
        for height in [0.03, 1e-3, 1e-5] {
            let limit = 2.0 * height / (4.0 * 0.7 * 2.0_f64).sqrt();
            let found = found(&hinge(height, 1.0), Material::default(), Integrator::Euler);
            assert!(found < 1.01 * limit && found > 0.6 * limit, "height {height}: {found} and not {limit}");
        }
    }

    #[test]
    fn a_bad_first_guess_does_no_harm() {
        let model = Model::new(&triangle(), &Material { ea: 20.0, ..NOTHING }).expect("a sheet");
        let limit = 2.0 / (3.0 * stiffness(20.0)).sqrt();
        for guess in [0.03 * limit, 0.999 * limit, 1.001 * limit, 30.0 * limit] {
            let found = largest(&model, &State::at_rest(&model), Integrator::Euler, guess, EFFORT).expect("a limit");
            assert!(agrees(found, limit), "from {guess}: {found} and not {limit}");
        }
    }
}
