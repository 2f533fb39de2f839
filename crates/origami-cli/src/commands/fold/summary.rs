//! The line about one input.

use std::time::Duration;

use origami::Warning;
use origami::solve::{Folded, Stop};

use crate::args::SolverName;
use crate::files::Input;
use crate::numbers::{count, duration, grouped, percent_of, plain, share, short};
use crate::report::{ContactFacts, Ending, Run};

/// What a person is told about one input.
#[derive(Default)]
pub(super) struct Told {
    pub(super) input: String,
    pub(super) warnings: Vec<Warning>,
    pub(super) errors: Vec<String>,
    pub(super) summary: Option<String>,
    /// Files, as long as there is no report that has them.
    pub(super) written: Vec<String>,
}

/// Where only the crease pattern is drawn.
pub(super) fn not_folded(input: &Input, seconds: f64) -> String {
    let time = duration(Duration::from_secs_f64(seconds));
    format!("{input}: the crease pattern is drawn, and nothing is folded, {time}")
}

/// Such as `bird.fold: folded to 90 % in 1 240 steps, converged (distance 3.0e-5 of the radius), strain mean 0.41 %
/// max 2.1 %, 12 ms`.
pub(super) fn line(run: &Run) -> String {
    let measured = &run.measured;
    let mut line = match &measured.step {
        Some(step) => format!("{}: folded to the end of `{step}`", run.input),
        None => format!("{}: folded to {} %", run.input, plain(measured.percent)),
    };
    if let Some(frames) = &run.frames {
        line += &format!(" in {}", count(frames.len(), "frame", "frames"));
    }
    if run.solver == SolverName::Reflect.name() {
        line += " by reflection, ";
    } else {
        let from = if run.from == "flat" { " from the flat-folded state" } else { "" };
        line += &format!("{from} in {} steps, ", grouped(measured.steps));
    }
    line += match measured.stop {
        Ending::Converged if run.solver == SolverName::Reflect.name() => "exact",
        Ending::Converged => "converged",
        Ending::StepsDone => "as many as asked",
        Ending::Blocked => "blocked",
        Ending::StepLimit | Ending::TimeLimit | Ending::Crushed | Ending::Failed | Ending::Diverged => "not converged",
    };
    line += &match measured.distance {
        Some(distance) if distance.is_finite() => format!(" (distance {} of the radius)", short(distance)),
        _ => " (distance not known)".to_owned(),
    };
    if let Some(strain) = measured.strain {
        line += &format!(", strain mean {} max {}", share(strain.mean), share(strain.max));
    }
    if let Some(tangled) = measured.tangled_creases.filter(|n| *n > 0) {
        line += &format!(", tangled ({} folded past 200 degrees)", count(tangled, "crease", "creases"));
    }
    let states = run.frames.iter().flatten().filter_map(|frame| frame.crossings.as_ref());
    let crossed = states.filter(|crossings| crossings.count > 0).count();
    if crossed > 0 {
        line += &format!(", {} crossed", count(crossed, "frame", "frames"));
    }
    if let Some(crossings) = &measured.crossings {
        line += &format!(", {crossings}");
    }
    if let Some(free) = run.backwards.as_ref().map(|motion| motion.free.len()).filter(|free| *free > 0) {
        line += &format!(", {} may lie the other way round", count(free, "pair of faces", "pairs of faces"));
    }
    if measured.attempts > 1 {
        line += &format!(", the best of {} attempts", measured.attempts);
    }
    if measured.factorisations > 0 {
        line += &format!(", {}", count(measured.factorisations as usize, "factorisation", "factorisations"));
    }
    if measured.saddles > 0 {
        line += &format!(", {} left on the way", count(measured.saddles as usize, "saddle", "saddles"));
    }
    if let Some(adapter) = run.adapter.as_ref().filter(|adapter| adapter.is_software()) {
        line += &format!(", on {} (software)", adapter.name);
    }
    let seconds = run.seconds;
    let total = seconds.read + seconds.build + seconds.solve + seconds.write + seconds.draw.unwrap_or(0.0);
    line + &format!(", {}", duration(Duration::from_secs_f64(total)))
}

/// Contact keeps the sheet from its angles.
pub(super) fn blocked(input: &Input, (folded, step): (&Folded, Option<&String>), touch: &ContactFacts) -> String {
    let place = place(folded, step);
    format!(
        "{input}: blocked at {place} after {} steps: {touch}; the output says so; another order may help (--sequence)",
        grouped(folded.steps)
    )
}

/// Such as `60 %`.
fn place(folded: &Folded, step: Option<&String>) -> String {
    step.map_or_else(|| format!("{} %", plain(percent_of(folded))), |step| format!("the end of `{step}`"))
}

/// The step limit or that of time came first, or a triangle was crushed, which more steps do not mend.
pub(super) fn not_converged(
    input: &Input,
    (folded, step): (&Folded, Option<&String>),
    crushed: bool,
    solver: SolverName,
    tolerance: f64,
) -> String {
    let place = place(folded, step);
    if crushed {
        return format!(
            "{input}: not converged at {place} after {} steps: a triangle is crushed to a line, where forces have no rest; the \
             output says so",
            grouped(folded.steps),
        );
    }
    if folded.stop == Stop::Cancelled {
        return format!(
            "{input}: not converged at {place} after {} steps, when its time was over; the output says so; more --max-seconds or \
             a larger --tolerance may help",
            grouped(folded.steps),
        );
    }
    if solver == SolverName::Newton {
        return format!(
            "{input}: not converged at {place} after {} steps: the largest force is {}; the output says so; \
             a larger --residual or more --max-steps may help",
            grouped(folded.steps),
            short(folded.residual),
        );
    }
    let distance = match folded.distance {
        d if d.is_finite() => format!("about {} of the radius from the equilibrium", short(d)),
        _ => "an unknown distance from the equilibrium".to_owned(),
    };
    format!(
        "{input}: not converged at {place} after {} steps: {distance}, expected {}; the output says so; \
         more --max-steps or a larger --tolerance may help",
        grouped(folded.steps),
        short(tolerance),
    )
}
