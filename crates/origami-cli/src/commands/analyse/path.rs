//! `origami analyse path`.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Duration;

use origami::analysis::{Configuration, Ended, Event, Point, Start, Trace};

use super::subject::{LOAD_FACTOR, Subject};
use super::{curve, report};
use crate::args::PathArgs;
use crate::draw;
use crate::exit::{Exit, Failure};
use crate::numbers::{count, duration};
use crate::stopwatch::Stopwatch;

/// Follows a path and writes what there is on it.
pub(super) fn run(args: &PathArgs) -> Result<Exit, Failure> {
    args.animate.as_deref().map_or(Ok(()), draw::check_film)?;
    let start = match &args.restart {
        Some(path) => report::start(path, args.branch)?,
        None => Start::default(),
    };
    let subject = Subject::read(&args.subject, "path.json")?;
    let mut watch = Stopwatch::start();
    let trace = follow(&subject, &start)?;
    let seconds = watch.lap();
    subject.write("curve.csv", curve::csv(&subject.setup, &subject.model, &trace).as_bytes())?;
    subject.write("curve.svg", curve::svg(&subject.setup, &trace, &subject.name)?.as_bytes())?;
    let shown = spread(&trace.points, args.frames);
    let frames = shown.iter().map(|point| (&point.configuration, LOAD_FACTOR, point.load_factor.into()));
    subject.write_frames("frames.fold", frames)?;
    if let Some(path) = &args.animate {
        let states: Vec<Configuration> = shown.iter().map(|point| point.configuration.clone()).collect();
        subject.write_film(path, &states)?;
    }
    subject.write_json("path.json", &report::Report::of(&subject, &trace))?;
    subject.say(&summary(&subject.output, &trace, Duration::from_secs_f64(seconds)))?;
    Ok(if trace.ended == Ended::Stuck { Exit::NotConverged } else { Exit::Done })
}

/// The path of the job.
///
/// # Errors
/// Why it cannot be followed.
pub(super) fn follow(subject: &Subject, start: &Start) -> Result<Trace, String> {
    let setup = &subject.setup;
    let trace = setup.structure.trace(start, &setup.path, &mut |_| ControlFlow::Continue(()));
    trace.map_err(|refused| subject.refused(&refused))
}

/// At most `most` points, evenly spread, the first and the last among them.
fn spread(points: &[Point], most: usize) -> Vec<&Point> {
    let (last, most) = (points.len().saturating_sub(1), most.max(2).min(points.len().max(1)));
    (0..most).filter_map(|i| points.get(if most > 1 { i * last / (most - 1) } else { last })).collect()
}

/// Such as `out/path.json and 3 files beside it: 44 points, 2 limit points, 4 bifurcations, reached its end, 0.3 s`.
fn summary(folder: &Path, trace: &Trace, time: Duration) -> String {
    let how_many = |is: fn(&Event) -> bool| trace.points.iter().filter(|point| is(&point.event)).count();
    let limits = how_many(|event| matches!(event, Event::LimitPoint { .. }));
    let bifurcations = how_many(|event| matches!(event, Event::Bifurcation { .. }));
    let ended = match trace.ended {
        Ended::Reached => "reached its end",
        Ended::Stuck => "no step leads on",
        _ => "more points were not asked for",
    };
    format!(
        "{} and 3 files beside it: {}, {}, {}, {ended}, {}",
        folder.join("path.json").display(),
        count(trace.points.len(), "point", "points"),
        count(limits, "limit point", "limit points"),
        count(bifurcations, "bifurcation", "bifurcations"),
        duration(time),
    )
}
