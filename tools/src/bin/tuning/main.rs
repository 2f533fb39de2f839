//! How the default ramp and perturbation of `relax` were chosen: each choice on many sheets, as a Markdown table.
//!
//! `cargo run --release -p origami-tools --bin tuning -- FILE.fold ...`
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

mod patterns;
mod scenes;

use origami::solve::unwatched;
use std::error::Error;
use std::sync::Mutex;
use std::thread;

use origami::measure::align;
use origami::{Folded, Model, Relax, Solver, State};
use scenes::Case;

/// Larger sheets take too long for all of these runs.
const MOST_NODES: usize = 700;
/// Directions of the perturbation.
const SEEDS: [u64; 2] = [0, 1];
/// A distance from the equilibrium, in radii.
const CLOSE: f64 = 1e-4;

/// Evaluations of the ramp up to 300 nodes, and how far nodes are moved at the start.
type Choice = (f64, f64);

/// What came of one choice on one sheet.
struct Outcome {
    energy: f64,
    tangled: bool,
    converged: bool,
    evaluations: u64,
    /// Of the first attempt, with seed 0, if it ends: evaluations after which it was close to its end.
    arrival: Option<u64>,
    /// How far what was said to have converged was from where it ends.
    off: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let mut scenes = scenes::all(&files)?;
    scenes.retain(|scene| scene.model.node_count() <= MOST_NODES);
    let usual = Relax::default().perturbation;
    let ramps: Vec<Choice> = [1000.0, 500.0, 400.0, 300.0, 200.0, 0.0].map(|ramp| (ramp, usual)).to_vec();
    let perturbations: Vec<Choice> = [0.0, 1e-3, 3e-3, 1e-2, 3e-2].map(|share| (400.0, share)).to_vec();
    for choices in [ramps, perturbations] {
        table(&scenes, &choices)?;
    }
    Ok(())
}

fn table(scenes: &[Case], choices: &[Choice]) -> Result<(), Box<dyn Error>> {
    let outcomes = outcomes(scenes, choices)?;
    println!(
        "| ramp | perturbation | runs | converged | tangled | higher | off by 1e-4 | by 3e-4 | to 1e-4: median | 90 % | \
         evaluations: median | 90 % | all |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|"
    );
    for (place, (ramp, perturbation)) in choices.iter().enumerate() {
        let count = |is: &dyn Fn(&Outcome) -> bool| outcomes.iter().filter(|of_all| is(&of_all[place])).count();
        let higher = outcomes.iter().filter(|of_all| {
            let lowest = of_all.iter().map(|outcome| outcome.energy).fold(f64::INFINITY, f64::min);
            of_all[place].energy > 1.001 * lowest + 1e-7
        });
        let sorted = |of: &dyn Fn(&Outcome) -> Option<u64>| {
            let mut all: Vec<u64> = outcomes.iter().filter_map(|of_all| of(&of_all[place])).collect();
            all.sort_unstable();
            let at = |share: usize| all.get(all.len().saturating_sub(1) * share / 100).copied().unwrap_or(0);
            (at(50), at(90), all.iter().sum::<u64>())
        };
        let (arrival, late, _) = sorted(&|outcome| outcome.arrival);
        let (median, long, all) = sorted(&|outcome| Some(outcome.evaluations));
        println!(
            "| {ramp} | {perturbation} | {} | {} | {} | {} | {} | {} | {arrival} | {late} | {median} | {long} | {all} |",
            outcomes.len(),
            count(&|outcome| outcome.converged),
            count(&|outcome| outcome.tangled),
            higher.count(),
            count(&|outcome| outcome.converged && outcome.off > CLOSE),
            count(&|outcome| outcome.converged && outcome.off > 3.0 * CLOSE),
        );
    }
    println!();
    Ok(())
}

/// By run, then by choice, without runs that diverge with one of the choices.
fn outcomes(scenes: &[Case], choices: &[Choice]) -> Result<Vec<Vec<Outcome>>, Box<dyn Error>> {
    let runs = scenes.iter().flat_map(|scene| {
        let seeds = SEEDS.into_iter().filter(|seed| *seed == 0 || scene.plain);
        seeds.flat_map(move |seed| [60.0, 100.0].map(|percent| (scene, seed, percent)))
    });
    let (runs, outcomes) = (Mutex::new(runs), Mutex::new(Vec::new()));
    let work = || {
        while let Some((scene, seed, percent)) = runs.lock().ok().and_then(|mut runs| runs.next()) {
            let of_all: Option<Vec<Outcome>> =
                choices.iter().map(|choice| outcome(&scene.model, percent, seed, *choice)).collect();
            match (of_all, outcomes.lock()) {
                (Some(of_all), Ok(mut outcomes)) => outcomes.push(of_all),
                _ => println!("{} at {percent} %: diverges with one of the choices\n", scene.name),
            }
        }
    };
    thread::scope(|scope| {
        (0..thread::available_parallelism().map_or(1, usize::from)).for_each(|_| {
            scope.spawn(work);
        });
    });
    outcomes.into_inner().map_err(|_| "a thread has panicked".into())
}

/// `None` where it diverges.
fn outcome(model: &Model, percent: f64, seed: u64, (ramp, perturbation): Choice) -> Option<Outcome> {
    // Seed 0 is what `relax` does by itself.
    let (start, perturbation) = match seed {
        0 => (State::at_rest(model), perturbation),
        _ => (State::perturbed(model, perturbation, seed), 0.0),
    };
    let length = (ramp * (model.node_count() as f64 / 300.0).max(1.0).sqrt()) as u32;
    // As stiff as the material all the way: what softens flat sheets hides what a ramp does.
    let stiff = Relax { softening: None, max_steps: 30_000, ..Relax::default() };
    let relax = Relax { ramp: Some(length), perturbation, ..stiff };
    let fold = |relax: &Relax| -> Option<Folded> {
        relax.fold(model, &start, &origami::scene::Scene::percent(percent), &mut unwatched).ok()
    };
    let distance = |a: &Folded, b: &Folded| align(&a.state.positions, &b.state.positions).max;

    let claim = fold(&relax)?;
    let first = fold(&Relax { retry: false, ..relax.clone() })?;
    let end = fold(&Relax { retry: false, tolerance: 1e-7, ..relax.clone() })?;
    Some(Outcome {
        energy: claim.state.energy(model).total(),
        tangled: claim.state.tangled_creases() > 0,
        converged: first.converged(),
        evaluations: claim.steps,
        arrival: if seed == 0 && end.converged() { Some(arrival(&end, &fold, &relax)?) } else { None },
        off: distance(&first, &end),
    })
}

/// By halving: a run of a number of steps is the beginning of a longer one.
fn arrival(end: &Folded, fold: &dyn Fn(&Relax) -> Option<Folded>, relax: &Relax) -> Option<u64> {
    let (mut far, mut near) = (0, end.steps);
    while near > far + 10 {
        let middle = far.midpoint(near);
        let there = fold(&Relax { steps: Some(middle), ..relax.clone() })?;
        let close = align(&there.state.positions, &end.state.positions).max <= CLOSE;
        *(if close { &mut near } else { &mut far }) = middle;
    }
    Some(near)
}
