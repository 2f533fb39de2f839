//! The parts of a run, the most important first.

use std::error::Error;

use crate::place::Place;
use crate::run::Asked;
use crate::{contact, ensembles, folded, machine, memory, parity, pictures, speed, suites};

/// What a section that had to leave something out ends with.
pub(crate) const CUT: i32 = 3;

/// Whether a section has done all that it had to, or time was over before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ended {
    Whole,
    Cut,
}

type Work = fn(&Place) -> Result<Ended, Box<dyn Error>>;

/// A part of a run.
pub(crate) struct Section {
    pub(crate) name: &'static str,
    /// Its share of the time that is left once the sections before it have ended, among those that are still to come.
    pub(crate) share: f64,
    work: Work,
}

const fn section(name: &'static str, share: f64, work: Work) -> Section {
    Section { name, share, work }
}

/// All of them, in their order. The tests are not among them: they are programs of their own.
pub(crate) const ALL: [Section; 8] = [
    section("machine", 2.0, machine::describe),
    section("parity", 8.0, parity::measure),
    section("speed", 22.0, speed::measure),
    section("ensembles", 7.0, ensembles::measure),
    section("folded", 10.0, folded::measure),
    section("contact", 4.0, contact::measure),
    section("memory", 2.0, memory::measure),
    section("pictures", 3.0, pictures::measure),
];

/// The section that runs the tests, and its share.
pub(crate) const TESTS: (&str, f64) = ("tests", 8.0);

/// Does the section `name`, within so many seconds.
///
/// # Errors
/// If there is none of this name, or it fails.
pub(crate) fn work(name: &str, asked: &Asked, seconds: f64) -> Result<(), Box<dyn Error>> {
    let ended = if name == TESTS.0 {
        suites::run(asked, seconds)?
    } else {
        let section = ALL.iter().find(|section| section.name == name).ok_or(format!("{name}: is no section"))?;
        (section.work)(&Place::open(name, asked.folder.clone(), seconds, asked.rehearse)?)?
    };
    if ended == Ended::Cut {
        std::process::exit(CUT);
    }
    Ok(())
}
