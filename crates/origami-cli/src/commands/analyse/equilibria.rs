//! `origami analyse equilibria`.

use origami::analysis::{Equilibrium, Start};
use serde::Serialize;
use serde_json::Value;

use super::path::follow;
use super::report::{Laws, Units};
use super::subject::Subject;
use crate::args::EquilibriaArgs;
use crate::exit::{Exit, Failure};
use crate::numbers::count;

/// Own key: what is stored in a frame.
const ENERGY: &str = "origami:energy";

#[derive(Serialize)]
struct Report<'a> {
    origami: &'static str,
    input: &'a str,
    units: Units<'a>,
    laws: Laws,
    equilibria: &'a [Equilibrium],
}

/// Follows the path and writes the states without load.
pub(super) fn run(args: &EquilibriaArgs) -> Result<Exit, Failure> {
    let subject = Subject::read(&args.subject, "equilibria.json")?;
    let trace = follow(&subject, &Start::default())?;
    let equilibria = trace.equilibria();
    let states = equilibria.iter().map(|own| (&trace.points[own.point].configuration, ENERGY, Value::from(own.energy)));
    subject.write_frames("equilibria.fold", states)?;
    let report = Report {
        origami: env!("CARGO_PKG_VERSION"),
        input: &subject.name,
        units: Units::of(&subject),
        laws: Laws::of(&subject),
        equilibria: &equilibria,
    };
    subject.write_json("equilibria.json", &report)?;
    let stable = equilibria.iter().filter(|own| own.index == 0).count();
    let states = count(equilibria.len(), "state", "states");
    subject.say(&format!(
        "{}: {states} without load, {stable} of them stable",
        subject.output.join("equilibria.json").display()
    ))?;
    Ok(Exit::Done)
}
