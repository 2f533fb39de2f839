//! From the command line to what the library wants.

use origami::measure::attitude::Hold;
use origami::model::{Material, Model};
#[cfg(feature = "newton")]
use origami::solve::Newton;
use origami::solve::{Dynamics, Integrator, Precision, Relax, TimeStep, frame_percents, time_step};
use origami::{CreasePattern, Warning, measure};

use crate::args::{
    ADAPTER_VARIABLE, BackendName, FoldArgs, IntegratorName, PictureArgs, PrecisionName, SolverName, SolvingArgs,
    SweepArgs,
};
use crate::backend::{Backend, Method};
use crate::draw::{Film, Style};
use crate::numbers::plain;

/// Stages after the flat one in a contact sheet, where nothing is asked for.
const STAGES: u32 = 4;

/// How every input of a run is folded.
pub(crate) struct Settings {
    /// Which frame of the file; `None` is the file's own choice.
    pub(crate) frame: Option<usize>,
    /// Percentages to stop at, in order.
    pub(crate) percents: Vec<f64>,
    /// Whether all of them are wanted, or only the last.
    pub(crate) animated: bool,
    /// How pictures look; `None` where none are wanted.
    pub(crate) style: Option<Style>,
    /// What films are like.
    pub(crate) film: Film,
    /// What keeps its place.
    pub(crate) hold: Hold,
    /// What the sheet is made of.
    pub(crate) material: Material,
    /// As on the command line.
    pub(crate) solver_name: SolverName,
    /// What folds.
    pub(crate) method: Method,
    /// Where.
    pub(crate) backend: Backend,
    /// What reports call the numbers of the processor, and of a GPU.
    pub(crate) precisions: [&'static str; 2],
    /// Distance from the equilibrium, in radii.
    pub(crate) tolerance: f64,
    /// The rule for the length of a step of dynamics.
    time_step: TimeStep,
    integrator: Integrator,
}

impl Settings {
    /// Those of the arguments; pictures are `drawn` or not.
    ///
    /// # Errors
    /// What this build or this machine cannot do.
    pub(crate) fn new(args: &FoldArgs, drawn: bool) -> Result<Self, String> {
        let solving = &args.solving;
        let (time_step, integrator) = (solving.time_step(), solving.integrator());
        let stages = args.frames.or(args.sheet.is_some().then_some(STAGES));
        Ok(Self {
            frame: args.frame,
            percents: stages.map_or_else(|| vec![args.percent], |stages| frame_percents(args.percent, stages)),
            animated: args.frames.is_some(),
            style: drawn.then(|| Style::new(&args.picture)).transpose()?,
            film: Film { turntable: args.turntable, fps: args.fps },
            hold: args.hold.unwrap_or_default(),
            material: args.material.material(),
            solver_name: solving.solver,
            method: method(solving, args.perturbation)?,
            backend: backend(solving)?,
            precisions: [solving.precision_name(false), solving.precision_name(true)],
            tolerance: solving.tolerance,
            time_step,
            integrator,
        })
    }

    /// What may help against divergence.
    pub(crate) fn advice(&self) -> &'static str {
        advice(self.solver_name, self.time_step)
    }

    /// The length of the first step; relaxations have none that can be told beforehand.
    pub(crate) fn first_time_step(&self, model: &Model) -> Option<f64> {
        match (self.solver_name, self.time_step) {
            (SolverName::Relax | SolverName::Newton, _) => None,
            (SolverName::Dynamics, TimeStep::Paper) => Some(time_step::paper(model)),
            (SolverName::Dynamics, TimeStep::Safe) => Some(time_step::safe(model, &model.rest, self.integrator)),
            (SolverName::Dynamics, TimeStep::Fixed(dt)) => Some(dt),
            (SolverName::Dynamics, _) => None,
        }
    }
}

/// What folds.
///
/// # Errors
/// What this build cannot do.
pub(crate) fn method(solving: &SolvingArgs, perturbation: Option<f64>) -> Result<Method, String> {
    let (tolerance, max_steps, steps) = (solving.tolerance, solving.max_steps, solving.steps);
    let precision = solving.precision();
    let mut relax = Relax { tolerance, ramp: solving.ramp, max_steps, steps, precision, ..Relax::default() };
    relax.perturbation = perturbation.unwrap_or(relax.perturbation);
    match solving.solver {
        SolverName::Relax => Ok(Method::Relax(relax)),
        SolverName::Dynamics => {
            let ramp = solving.ramp.unwrap_or(0);
            let (time_step, integrator) = (solving.time_step(), solving.integrator());
            Ok(Method::Dynamics(Dynamics {
                time_step,
                integrator,
                ramp,
                tolerance,
                max_steps,
                steps,
                precision,
                ..Dynamics::default()
            }))
        }
        SolverName::Newton => newton(Relax { steps: None, precision: Precision::F64, ..relax }, solving.residual),
    }
}

/// Newton's method after `relax`.
#[cfg(feature = "newton")]
#[expect(clippy::unnecessary_wraps, reason = "a build without it has none")]
fn newton(relax: Relax, residual: Option<f64>) -> Result<Method, String> {
    let newton = Newton { relax: Some(relax), ..Newton::default() };
    Ok(Method::Newton(Newton { residual: residual.unwrap_or(newton.residual), ..newton }))
}

#[cfg(not(feature = "newton"))]
fn newton(_relax: Relax, _residual: Option<f64>) -> Result<Method, String> {
    Err("--solver newton: this build is without it (feature `newton`); expected relax or dynamics, or a build without \
         --no-default-features or with --features newton"
        .to_owned())
}

/// Where.
///
/// # Errors
/// What this build or this machine cannot do.
pub(crate) fn backend(solving: &SolvingArgs) -> Result<Backend, String> {
    if solving.solver == SolverName::Newton && solving.backend == BackendName::Gpu {
        return Err("--backend gpu: newton runs on the processor; expected auto or cpu".to_owned());
    }
    if solving.precision.is_some() && solving.backend == BackendName::Gpu {
        return Err("--precision: GPUs have numbers of their own; expected --backend cpu, or neither".to_owned());
    }
    let wanted = if solving.precision.is_some() { BackendName::Cpu } else { solving.backend };
    Backend::new(wanted, solving.adapter.as_deref())
}

/// What may help against divergence.
pub(crate) fn advice(solver: SolverName, time_step: TimeStep) -> &'static str {
    match (solver, time_step) {
        (SolverName::Relax | SolverName::Newton, _) => "stiffnesses nearer to the defaults or a longer --ramp may hold",
        (SolverName::Dynamics, TimeStep::Safe) => "a smaller --time-step may hold",
        (SolverName::Dynamics, _) => "--time-step safe or a smaller one may hold",
    }
}

impl SolvingArgs {
    /// The rule for the length of a step of dynamics.
    pub(crate) fn time_step(&self) -> TimeStep {
        self.time_step.unwrap_or(TimeStep::Paper)
    }

    /// The processor's numbers.
    fn precision(&self) -> Precision {
        match self.precision {
            None | Some(PrecisionName::F64) => Precision::F64,
            Some(PrecisionName::Mixed) => Precision::Mixed,
        }
    }

    /// What the report calls the numbers of a run `on_gpu` or not.
    pub(crate) fn precision_name(&self, on_gpu: bool) -> &'static str {
        match self.solver {
            _ if on_gpu => "f32",
            SolverName::Newton => Precision::F64.name(),
            SolverName::Relax | SolverName::Dynamics => self.precision().name(),
        }
    }

    fn integrator(&self) -> Integrator {
        match self.integrator {
            None | Some(IntegratorName::Euler) => Integrator::Euler,
            Some(IntegratorName::Verlet) => Integrator::Verlet,
        }
    }
}

/// What is dangerous about folding `model` so far. On a GPU, which computes in single precision, the tolerance counts too.
pub(crate) fn scene_warnings(
    pattern: &CreasePattern,
    model: &Model,
    percents: &[f64],
    on_gpu: Option<f64>,
) -> Vec<Warning> {
    let mut warnings = measure::scene_warnings(model, percents);
    warnings.extend(on_gpu.and_then(|tolerance| measure::single_precision(model, tolerance)));
    warnings.iter_mut().for_each(|warning| pattern.name_sources(warning));
    warnings
}

/// What is allowed but odd about the arguments.
pub(crate) fn oddities(args: &FoldArgs, drawn: bool) -> Vec<String> {
    let mut oddities = past_the_angles(&[args.percent]);
    oddities.extend(oddities_of_picture(&args.picture, drawn));
    oddities.extend(without_effect(&args.solving, args.material.zeta.is_some(), args.perturbation.is_some()));
    oddities
}

/// The same of how pictures shall look.
pub(crate) fn oddities_of_picture(args: &PictureArgs, drawn: bool) -> Vec<String> {
    if !drawn && *args != PictureArgs::default() {
        return vec!["options of pictures have no effect: none is asked for".to_owned()];
    }
    args.idle_of_maps().map(|name| format!("{name} has no effect without --map or --strain")).collect()
}

/// The same of a sweep, where either solver takes the perturbation.
pub(crate) fn oddities_of_sweep(args: &SweepArgs, percents: &[f64]) -> Vec<String> {
    let mut oddities = past_the_angles(percents);
    oddities.extend(without_effect(&args.solving, args.has_zeta(), false));
    oddities
}

fn past_the_angles(percents: &[f64]) -> Vec<String> {
    let past = percents.iter().find(|percent| percent.abs() > 100.0);
    past.map(|p| format!("--percent {}: folds past the pattern's own angles", plain(*p))).into_iter().collect()
}

fn without_effect(solving: &SolvingArgs, zeta: bool, perturbation: bool) -> Vec<String> {
    use SolverName::{Dynamics, Newton, Relax};
    let given = [
        ("--time-step", &[Dynamics][..], solving.time_step.is_some()),
        ("--integrator", &[Dynamics], solving.integrator.is_some()),
        ("--zeta", &[Dynamics], zeta),
        ("--perturbation", &[Relax, Newton], perturbation),
        ("--steps", &[Relax, Dynamics], solving.steps.is_some()),
        ("--residual", &[Newton], solving.residual.is_some()),
        ("--precision", &[Relax, Dynamics], solving.precision.is_some()),
    ];
    let given = given.iter().filter(|(_, solvers, given)| *given && !solvers.contains(&solving.solver));
    let mut oddities: Vec<String> =
        given.map(|(name, ..)| format!("{name} has no effect with --solver {}", solving.solver.name())).collect();
    // What the environment names is meant for other runs.
    let named = solving.adapter.is_some() && solving.adapter != std::env::var(ADAPTER_VARIABLE).ok();
    if named && solving.solver == Newton {
        oddities.push("--adapter has no effect with --solver newton".to_owned());
    } else if named && solving.precision.is_some() {
        oddities.push("--adapter has no effect with --precision".to_owned());
    } else if named && solving.backend == BackendName::Cpu {
        oddities.push("--adapter has no effect with --backend cpu".to_owned());
    } else if named && cfg!(not(feature = "gpu")) {
        oddities.push("--adapter has no effect in a build without the feature `gpu`".to_owned());
    }
    oddities
}
