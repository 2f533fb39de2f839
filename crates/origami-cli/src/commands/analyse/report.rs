//! `path.json`: what a path is of, what happened on it, and from where it can be taken up again.

use std::path::Path;

use origami::analysis::job::Job;
use origami::analysis::{Ended, Event, Start, Trace};
use serde::{Deserialize, Serialize};

use super::subject::Subject;

/// The content of `path.json`.
#[derive(Serialize)]
pub(super) struct Report<'a> {
    /// The program and its version.
    origami: &'static str,
    input: &'a str,
    units: Units<'a>,
    laws: Laws,
    /// Free degrees of freedom.
    unknowns: usize,
    ended: Ended,
    points: usize,
    rejected: u32,
    monitors: Vec<Monitor>,
    events: Vec<Entry>,
    /// From where other paths go: both sides of each null vector of each bifurcation.
    branches: Vec<Start>,
    /// From where this one goes on.
    last: Option<Start>,
    job: &'a Job,
}

/// Units of lengths and forces; energies are in their product.
#[derive(Serialize)]
pub(super) struct Units<'a> {
    length: &'a str,
    force: &'a str,
}

impl<'a> Units<'a> {
    pub(super) fn of(subject: &'a Subject) -> Self {
        Self { length: &subject.setup.length, force: &subject.setup.force }
    }
}

/// Laws of the members, by name.
#[derive(Serialize)]
pub(super) struct Laws {
    bars: &'static str,
    creases: &'static str,
    facets: &'static str,
}

impl Laws {
    pub(super) fn of(subject: &Subject) -> Self {
        let Job { crease, facet, .. } = &subject.job;
        Self { bars: subject.setup.bar_law().name(), creases: crease.law().name(), facets: facet.law().name() }
    }
}

#[derive(Serialize)]
struct Monitor {
    vertex: u32,
    axis: &'static str,
}

#[derive(Serialize)]
struct Entry {
    /// The row of curve.csv.
    step: usize,
    event: &'static str,
    load_factor: f64,
    displacements: Vec<f64>,
    energy: f64,
    negative: usize,
    /// Negative eigenvalues before and after it, of limit points and bifurcations.
    change: Option<[usize; 2]>,
}

impl<'a> Report<'a> {
    /// That of a path of `subject`.
    pub(super) fn of(subject: &'a Subject, trace: &Trace) -> Self {
        let setup = &subject.setup;
        let structure = &setup.structure;
        let noted = trace.points.iter().enumerate().filter(|(_, point)| point.event != Event::Step);
        let entry = |(step, point): (usize, &origami::analysis::Point)| Entry {
            step,
            event: point.event.name(),
            load_factor: point.load_factor,
            displacements: setup.monitors.iter().map(|(_, dof)| point.displacement(&structure.nodes, *dof)).collect(),
            energy: point.energies.total(),
            negative: point.negative,
            change: match &point.event {
                Event::LimitPoint { before, after } | Event::Bifurcation { before, after, .. } => {
                    Some([*before, *after])
                }
                _ => None,
            },
        };
        let branches = trace.points.iter().flat_map(|point| match &point.event {
            Event::Bifurcation { modes, .. } => {
                let sides = (0..modes.len()).flat_map(|mode| [1.0, -1.0].map(|side| Start::branch(point, mode, side)));
                sides.flatten().collect()
            }
            _ => Vec::new(),
        });
        Self {
            origami: env!("CARGO_PKG_VERSION"),
            input: &subject.name,
            units: Units::of(subject),
            laws: Laws::of(subject),
            unknowns: structure.unknowns(),
            ended: trace.ended,
            points: trace.points.len(),
            rejected: trace.rejected,
            monitors: setup
                .monitors
                .iter()
                .map(|(vertex, dof)| Monitor { vertex: *vertex, axis: dof.axis.name() })
                .collect(),
            events: noted.map(entry).collect(),
            branches: branches.collect(),
            last: trace.points.last().map(Start::again),
            job: &subject.job,
        }
    }
}

/// What a restart needs of an earlier file.
#[derive(Deserialize)]
struct Earlier {
    #[serde(default)]
    branches: Vec<Start>,
    last: Option<Start>,
}

/// Where a path takes up an earlier one, at its end or at one of its branches.
///
/// # Errors
/// That the file cannot be read, is none of these, or has no such branch.
pub(super) fn start(path: &Path, branch: Option<usize>) -> Result<Start, String> {
    let shown = path.display();
    let bytes = std::fs::read(path).map_err(|error| format!("{shown}: {error}"))?;
    let earlier: Earlier = serde_json::from_slice(&bytes)
        .map_err(|error| format!("{shown}: {error}; expected a path.json of `origami analyse path`"))?;
    let Some(branch) = branch else {
        return earlier.last.ok_or_else(|| format!("{shown}: `last` is missing; expected where the path ended"));
    };
    let count = earlier.branches.len();
    earlier
        .branches
        .into_iter()
        .nth(branch)
        .ok_or_else(|| format!("--branch {branch}: {shown} has {count} `branches`; expected one of them, from 0"))
}
