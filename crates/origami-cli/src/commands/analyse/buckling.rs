//! `origami analyse buckling`.

use origami::analysis::Configuration;
use serde::Serialize;
use serde_json::Value;

use super::report::{Laws, Units};
use super::subject::{LOAD_FACTOR, Subject};
use crate::args::BucklingArgs;
use crate::exit::{Exit, Failure};
use crate::numbers::plain;

#[derive(Serialize)]
struct Report<'a> {
    origami: &'static str,
    input: &'a str,
    units: Units<'a>,
    laws: Laws,
    load_factors: Vec<f64>,
}

/// Writes the smallest critical loads.
pub(super) fn run(args: &BucklingArgs) -> Result<Exit, Failure> {
    if !args.amplitude.is_finite() {
        return Err(format!("--amplitude {}: expected a finite number", args.amplitude).into());
    }
    let subject = Subject::read(&args.subject, "buckling.json")?;
    let found = subject.setup.structure.buckling(args.count).map_err(|refused| subject.refused(&refused))?;
    let drawn = subject.setup.structure.as_drawn();
    let states: Vec<Configuration> =
        found.iter().map(|own| subject.moved(&drawn, &own.shape, args.amplitude)).collect();
    let loads = found.iter().map(|own| Value::from(own.load_factor));
    subject.write_frames("buckling.fold", states.iter().zip(loads).map(|(state, load)| (state, LOAD_FACTOR, load)))?;
    let report = Report {
        origami: env!("CARGO_PKG_VERSION"),
        input: &subject.name,
        units: Units::of(&subject),
        laws: Laws::of(&subject),
        load_factors: found.iter().map(|own| own.load_factor).collect(),
    };
    subject.write_json("buckling.json", &report)?;
    let smallest = match found.first() {
        Some(own) => format!("the smallest critical load factor is {}", plain(own.load_factor)),
        None => "no critical load".to_owned(),
    };
    subject.say(&format!("{}: {smallest}", subject.output.join("buckling.json").display()))?;
    Ok(Exit::Done)
}
