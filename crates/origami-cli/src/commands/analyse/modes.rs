//! `origami analyse modes`.

use origami::analysis::{Configuration, Energies, Mode, ModeKind};
use serde::Serialize;
use serde_json::Value;

use super::report::{Laws, Units};
use super::subject::Subject;
use crate::args::ModesArgs;
use crate::exit::{Exit, Failure};

/// Own key: the number of a frame's mode.
const MODE: &str = "origami:mode";

#[derive(Serialize)]
struct Report<'a> {
    origami: &'static str,
    input: &'a str,
    units: Units<'a>,
    laws: Laws,
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
    let subject = Subject::read(&args.subject, "modes.json")?;
    let setup = &subject.setup;
    let drawn = setup.structure.as_drawn();
    let modes = setup.structure.modes(&drawn, 0.0, args.count).map_err(|refused| subject.refused(&refused))?;
    let states: Vec<Configuration> = modes.iter().map(|mode| subject.moved(&mode.shape, args.amplitude)).collect();
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
