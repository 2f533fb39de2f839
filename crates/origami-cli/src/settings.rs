//! From the command line to what the library wants.

use std::time::Duration;

use origami::contact::Contact;
use origami::measure::attitude::Hold;
use origami::model::{Material, Model};
#[cfg(feature = "newton")]
use origami::solve::Newton;
use origami::solve::{Dynamics, Failed, Integrator, Precision, Reflect, Relax, Solver, State, TimeStep, time_step};
use origami::{CreasePattern, Warning, measure};

use crate::args::{
    BackendName, ContactArgs, FoldArgs, IntegratorName, PrecisionName, SequenceSource, SolverName, SolvingArgs,
};
use crate::backend::{Backend, Method};
use crate::draw::{Film, Style};
use crate::files::Format;
use crate::numbers::plain;
use crate::progress::Way;

/// Stages after the flat one in a contact sheet, where nothing is asked for.
const STAGES: u32 = 4;

/// Stages of a motion that is found backwards, where nothing is asked for.
const BACKWARDS: u32 = 10;

/// By how much a sheet that is opened from flat may miss itself there, in radii: the solver mends it.
const CLOSED: f64 = 1e-3;

/// How every input of a run is folded.
pub(crate) struct Settings {
    /// Which frame of the file; `None` is the file's own choice.
    pub(crate) frame: Option<usize>,
    /// Percentages to stop at, in order.
    pub(crate) percents: Vec<f64>,
    /// Those of a contact sheet, where it has stages that nothing else has: what stands beside it is folded without them.
    pub(crate) sheet_percents: Option<Vec<f64>>,
    /// Steps of each, where their number is given.
    steps: Option<u64>,
    /// Whether all of them are wanted, or only the last.
    pub(crate) animated: bool,
    /// Whether a report is asked for.
    pub(crate) reported: bool,
    /// How paper keeps away from paper; `None` is not at all.
    pub(crate) contact: Option<AskedContact>,
    /// The order in which creases fold; `None` is all at once.
    pub(crate) sequence: Option<SequenceSource>,
    /// The motion is found backwards, in so many stages under contact.
    pub(crate) backwards: Option<u32>,
    /// How many parts of each stage are shown.
    pub(crate) parts: u32,
    /// The percentage that was asked for.
    pub(crate) percent: f64,
    /// Whether states are tested for crossings.
    pub(crate) check: bool,
    /// How pictures look; `None` where none are wanted.
    pub(crate) style: Option<Style>,
    /// What films are like.
    pub(crate) film: Film,
    /// What keeps its place.
    pub(crate) hold: Hold,
    /// What the sheet is made of.
    pub(crate) material: Material,
    /// The percentage of the flat-folded state to begin at; `None` is the sheet as the file has it.
    from_flat: Option<f64>,
    /// After which to give up.
    pub(crate) max_time: Option<Duration>,
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
        let sequence = &args.contact.sequence;
        let stepwise = refuse_for_stepwise(args)?;
        let (time_step, integrator) = (solving.time_step(), solving.integrator());
        let beside_sheet = !args.outputs.is_empty() || args.png.is_some() || args.animate.is_some();
        let of_sheet = args.sheet.is_some() && args.frames.is_none();
        let sheet_alone = of_sheet && !beside_sheet && args.report.is_none();
        let stages = args.frames.or(sheet_alone.then_some(STAGES));
        let from_flat = args.from_flat.then(|| 100.0_f64.copysign(args.percent));
        let stages_to = |n| frame_percents(from_flat.unwrap_or(0.0), args.percent, n);
        let percents = stages
            .filter(|_| sequence.is_none() && !args.contact.backwards)
            .map_or_else(|| vec![args.percent], stages_to);
        Ok(Self {
            frame: args.frame,
            percents,
            sheet_percents: (of_sheet && !sheet_alone && sequence.is_none()).then(|| stages_to(STAGES)),
            steps: solving.steps,
            animated: args.frames.is_some() || sequence.is_some() || args.contact.backwards,
            backwards: args.contact.backwards.then(|| args.frames.unwrap_or(BACKWARDS)),
            parts: args.frames.unwrap_or(1),
            percent: args.percent,
            reported: args.report.is_some(),
            check: args.contact.check || args.contact.keeps_apart(),
            contact: contact(args),
            sequence: sequence.clone(),
            style: drawn.then(|| Style::new(&args.picture)).transpose()?,
            film: Film { turntable: args.turntable, fps: args.fps },
            hold: args.hold.unwrap_or_default(),
            material: args.material.material(material(solving.solver)),
            from_flat,
            // One longer than a clock can tell is none.
            max_time: args.max_seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok()),
            solver_name: solving.solver,
            method: method(solving, args.perturbation)?,
            backend: if stepwise && solving.backend != BackendName::Gpu {
                Backend::new(BackendName::Cpu, None)?
            } else {
                backend(solving, &args.material.named())?
            },
            precisions: [solving.precision_name(false), solving.precision_name(true)],
            tolerance: solving.tolerance,
            time_step,
            integrator,
        })
    }

    /// Where the sheet is when it begins to fold.
    ///
    /// # Errors
    /// Why it has no flat-folded state.
    pub(crate) fn start(&self, model: &Model) -> Result<State, Failed> {
        let flat = |percent| Reflect { tolerance: CLOSED }.fold_from_rest(model, percent);
        self.from_flat.map_or_else(|| Ok(State::at_rest(model)), |percent| flat(percent).map(|folded| folded.state))
    }

    /// What reports call that.
    pub(crate) fn start_name(&self) -> &'static str {
        if self.from_flat.is_some() { "flat" } else { "rest" }
    }

    /// How many states are settled for one input.
    pub(crate) fn stages(&self) -> usize {
        self.percents.len() + self.sheet_percents.as_ref().map_or(0, Vec::len)
    }

    /// How many states a file has room for that takes all.
    pub(crate) fn stages_of(&self, format: Format) -> usize {
        match (format, &self.sheet_percents) {
            (Format::Contact, Some(stages)) => stages.len(),
            (Format::Contact, None) => self.percents.len(),
            (Format::Glb | Format::Html | Format::Film | Format::Fold, _) if self.animated => self.percents.len(),
            _ => 1,
        }
    }

    /// How much there is to do for so many states.
    pub(crate) fn way(&self, stages: usize) -> Way {
        Way { stages, steps: self.steps }
    }

    /// What may help against divergence.
    pub(crate) fn advice(&self) -> &'static str {
        advice(self.solver_name, self.time_step)
    }

    /// The length of the first step; relaxations have none that can be told beforehand.
    pub(crate) fn first_time_step(&self, model: &Model) -> Option<f64> {
        match (self.solver_name, self.time_step) {
            (SolverName::Relax | SolverName::Newton | SolverName::Reflect, _) => None,
            (SolverName::Dynamics, TimeStep::Paper) => Some(time_step::paper(model)),
            (SolverName::Dynamics, TimeStep::Safe) => Some(time_step::safe(model, &model.rest, self.integrator)),
            (SolverName::Dynamics, TimeStep::Fixed(dt)) => Some(dt),
            (SolverName::Dynamics, _) => None,
        }
    }
}

/// Whether `--sequence` or `--contact` is asked for; what does not go with it is refused.
fn refuse_for_stepwise(args: &FoldArgs) -> Result<bool, String> {
    let solving = &args.solving;
    let asked = [
        ("--backwards", args.contact.backwards),
        ("--sequence", args.contact.sequence.is_some()),
        ("--contact", args.contact.keeps_apart()),
    ];
    let Some((option, _)) = asked.iter().find(|(_, given)| *given) else { return Ok(false) };
    // These have a way of their own.
    let by_itself = args.contact.backwards || args.contact.sequence.is_some();
    let (able, expected): (&[SolverName], _) = match by_itself {
        true => (&[SolverName::Relax], "relax"),
        false => (&[SolverName::Relax, SolverName::Dynamics, SolverName::Newton], "relax, newton or dynamics"),
    };
    if !able.contains(&solving.solver) {
        return Err(format!("--solver {}: it has no {option}; expected {expected}", solving.solver.name()));
    }
    if solving.backend == BackendName::Gpu && by_itself {
        return Err(format!("--backend gpu: {option} runs on the processor; expected auto or cpu"));
    }
    if solving.backend == BackendName::Gpu && solving.solver != SolverName::Relax {
        let solver = solving.solver.name();
        return Err(format!(
            "--backend gpu: it has no --contact for {solver}; expected auto or cpu, or --solver relax"
        ));
    }
    if args.contact.keeps_apart() && solving.precision() != Precision::F64 {
        return Err("--precision mixed: contact needs f64; expected f64 with --contact".to_owned());
    }
    Ok(true)
}

/// Contact as it is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AskedContact {
    /// In radii.
    gap: Option<f64>,
    /// In the model's unit of force per radius.
    stiffness: Option<f64>,
    /// In the file's unit.
    pub(crate) thickness: Option<f64>,
}

impl AskedContact {
    /// That of a sheet, whose file has a unit.
    pub(crate) fn of(self, model: &Model) -> Contact {
        let thick = |thickness| Contact::thick(thickness / model.normalisation.radius);
        let contact = self.thickness.map_or_else(Contact::default, thick);
        let (gap, stiffness) = (self.gap.unwrap_or(contact.gap), self.stiffness.unwrap_or(contact.stiffness));
        Contact { gap, stiffness, ..contact }
    }
}

fn contact(args: &FoldArgs) -> Option<AskedContact> {
    let ContactArgs { contact_gap: gap, contact_stiffness: stiffness, thickness, .. } = args.contact;
    args.contact.keeps_apart().then_some(AskedContact { gap, stiffness, thickness })
}

/// The material of a solver: the paper's motion has the paper's springs.
pub(crate) fn material(solver: SolverName) -> Material {
    if solver == SolverName::Dynamics { Material::paper() } else { Material::default() }
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
        SolverName::Reflect => Ok(Method::Reflect(Reflect { tolerance })),
        SolverName::Newton => newton(Relax { steps: None, precision: Precision::F64, ..relax }, solving),
    }
}

/// Newton's method after `relax`.
#[cfg(feature = "newton")]
#[expect(clippy::unnecessary_wraps, reason = "a build without it has none")]
fn newton(relax: Relax, solving: &SolvingArgs) -> Result<Method, String> {
    let newton = Newton { relax: Some(relax), max_steps: solving.max_steps, ..Newton::default() };
    Ok(Method::Newton(Newton { residual: solving.residual.unwrap_or(newton.residual), ..newton }))
}

#[cfg(not(feature = "newton"))]
fn newton(_relax: Relax, _solving: &SolvingArgs) -> Result<Method, String> {
    Err("--solver newton: this build is without it (feature `newton`); expected relax or dynamics, or a build without \
         --no-default-features or with --features newton"
        .to_owned())
}

/// Where; `material` has each of its numbers with its option.
///
/// # Errors
/// What this build or this machine cannot do.
pub(crate) fn backend(solving: &SolvingArgs, material: &[(&str, f64)]) -> Result<Backend, String> {
    let processor_only = matches!(solving.solver, SolverName::Newton | SolverName::Reflect);
    if processor_only && solving.backend == BackendName::Gpu {
        let name = solving.solver.name();
        return Err(format!("--backend gpu: {name} runs on the processor; expected auto or cpu"));
    }
    if solving.precision.is_some() && solving.backend == BackendName::Gpu {
        return Err("--precision: GPUs have numbers of their own; expected --backend cpu, or neither".to_owned());
    }
    let beyond = beyond_single(solving, material);
    if let (Some((option, x)), BackendName::Gpu) = (beyond, solving.backend) {
        let [least, most] = SINGLE.map(|end| format!("{end:e}"));
        let expected = format!("expected {least} to {most}, or --backend cpu");
        return Err(format!("{option} {}: GPUs compute in f32, which is too narrow for it; {expected}", plain(x)));
    }
    let on_processor = solving.precision.is_some() || processor_only || beyond.is_some();
    let wanted = if on_processor { BackendName::Cpu } else { solving.backend };
    Backend::new(wanted, solving.adapter.as_deref())
}

/// Numbers that a GPU can compute with: f32 ends a hundred million times farther out, where what is made of them lies.
const SINGLE: [f64; 2] = [1e-30, 1e30];

/// The first number that is beyond them, with its option; 0 is not.
fn beyond_single<'a>(solving: &SolvingArgs, material: &[(&'a str, f64)]) -> Option<(&'a str, f64)> {
    let time_step = match solving.time_step {
        Some(TimeStep::Fixed(x)) => Some(("--time-step", x)),
        _ => None,
    };
    let [least, most] = SINGLE;
    let all = material.iter().copied().chain(time_step).chain([("--tolerance", solving.tolerance)]);
    all.into_iter().find(|(_, x)| *x != 0.0 && !(least..=most).contains(&x.abs()))
}

/// Percentages of `frames` + 1 states between two, both included, evenly spaced.
fn frame_percents(from: f64, to: f64, frames: u32) -> Vec<f64> {
    let ways = origami::solve::frame_percents(to - from, frames);
    ways.into_iter().map(|way| from + way).collect()
}

/// What may help against divergence.
pub(crate) fn advice(solver: SolverName, time_step: TimeStep) -> &'static str {
    match (solver, time_step) {
        (SolverName::Relax | SolverName::Newton | SolverName::Reflect, _) => {
            "stiffnesses nearer to the defaults or a longer --ramp may hold"
        }
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
            SolverName::Newton | SolverName::Reflect => Precision::F64.name(),
            SolverName::Relax | SolverName::Dynamics => self.precision().name(),
        }
    }

    /// As on the command line.
    pub(crate) fn time_step_name(&self) -> String {
        match self.time_step() {
            TimeStep::Safe => "safe".to_owned(),
            TimeStep::Fixed(x) => x.to_string(),
            _ => "paper".to_owned(),
        }
    }

    /// As on the command line.
    pub(crate) fn integrator_name(&self) -> &'static str {
        match self.integrator() {
            Integrator::Verlet => "verlet",
            _ => "euler",
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
