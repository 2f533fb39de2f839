//! `origami analyse modes`.

use origami::analysis::{Configuration, Energies, Mode, ModeKind};
use serde::Serialize;
use serde_json::Value;

use super::report::{Laws, Units};
use super::subject::Subject;
use crate::args::ModesArgs;
use crate::draw;
use crate::exit::{Exit, Failure};

/// Own key: the number of a frame's mode.
const MODE: &str = "origami:mode";

/// Pictures of a period of a mode.
const PERIOD: u32 = 16;

#[derive(Serialize)]
struct Report<'a> {
    origami: &'static str,
    input: &'a str,
    units: Units<'a>,
    laws: Laws,
    /// That of the state that vibrates.
    load_factor: f64,
    /// How many of the modes move freely, fold creases, bend facets and stretch bars.
    counts: [(ModeKind, usize); 4],
    modes: Vec<Entry>,
}

#[derive(Serialize)]
struct Entry {
    /// A force per length and mass, which is 1 at each vertex where the job has no masses.
    eigenvalue: f64,
    /// In hertz; null without masses or units, and for modes that do not vibrate.
    frequency: Option<f64>,
    kind: ModeKind,
    /// The energy of a mode whose farthest vertex moves by a unit of length.
    stores: Energies,
}

/// Writes the lowest vibrations.
pub(super) fn run(args: &ModesArgs) -> Result<Exit, Failure> {
    if !args.amplitude.is_finite() {
        return Err(format!("--amplitude {}: expected a finite number", args.amplitude).into());
    }
    args.animate.as_deref().map_or(Ok(()), draw::check_film)?;
    let subject = Subject::read(&args.subject, "modes.json")?;
    let setup = &subject.setup;
    let (at, load_factor) = match &args.at {
        Some(path) => subject.state_in(path, args.at_frame)?,
        None => (setup.structure.as_drawn(), 0.0),
    };
    let modes = setup.structure.modes(&at, load_factor, args.count).map_err(|refused| subject.refused(&refused))?;
    let states: Vec<Configuration> = modes.iter().map(|mode| subject.moved(&at, &mode.shape, args.amplitude)).collect();
    if let Some(path) = &args.animate {
        // One after the other, each to and fro.
        let stages = modes.iter().flat_map(|mode| (0..PERIOD).map(move |k| (mode, f64::from(k) / f64::from(PERIOD))));
        let moved = |(mode, time): (&Mode, f64)| {
            subject.moved(&at, &mode.shape, args.amplitude * (std::f64::consts::TAU * time).sin())
        };
        subject.write_film(path, &stages.map(moved).collect::<Vec<Configuration>>())?;
    }
    subject.write_frames("modes.fold", states.iter().enumerate().map(|(i, state)| (state, MODE, Value::from(i))))?;
    let frequency = |mode: &Mode| {
        let vibrates = mode.kind != ModeKind::Free && mode.eigenvalue > 0.0;
        setup.hertz.filter(|_| vibrates).map(|hertz| hertz * mode.eigenvalue.sqrt())
    };
    let entry = |mode: &Mode| Entry {
        eigenvalue: mode.eigenvalue,
        frequency: frequency(mode),
        kind: mode.kind,
        stores: mode.stores,
    };
    let kinds = [ModeKind::Free, ModeKind::Creases, ModeKind::Facets, ModeKind::Bars];
    let counts = kinds.map(|kind| (kind, modes.iter().filter(|mode| mode.kind == kind).count()));
    let report = Report {
        origami: env!("CARGO_PKG_VERSION"),
        input: &subject.name,
        units: Units::of(&subject),
        laws: Laws::of(&subject),
        load_factor,
        counts,
        modes: modes.iter().map(entry).collect(),
    };
    subject.write_json("modes.json", &report)?;
    let [free, creases, facets, bars] = counts.map(|(_, count)| count);
    subject.say(&format!(
        "{}: {free} free, {creases} of creases, {facets} of facets, {bars} of bars",
        subject.output.join("modes.json").display()
    ))?;
    Ok(Exit::Done)
}
