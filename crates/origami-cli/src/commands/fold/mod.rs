//! `origami fold`: every input on its own, in parallel; what is told of them comes in their order.

mod one;
mod order;
mod queue;
mod summary;
mod touching;

use std::path::Path;

use rayon::prelude::*;

use crate::args::FoldArgs;
use crate::console;
use crate::draw;
use crate::exit::{Exit, Failure};
use crate::files::{self, Destination, Format, Input, Reading, Target};
use crate::oddities;
use crate::progress::ProgressLine;
use crate::report::{self, Report};
use crate::settings::Settings;
use crate::threads;

use one::{Finished, Seen};
use queue::Queue;

/// Folds all inputs.
pub(super) fn run(args: &FoldArgs) -> Result<Exit, Failure> {
    let reading = Reading::new(&args.reading)?;
    let inputs: Vec<Input> = args.inputs.iter().map(|path| Input::new(path, &reading)).collect();
    let targets = plan(args, &inputs)?;
    let mut formats: Vec<Format> = targets.iter().flatten().map(|target| target.format).collect();
    formats.dedup();
    let drawn = formats.iter().any(|format| format.is_drawn());
    let settings = Settings::new(args, drawn)?;
    if let (Some(style), Some(_)) = (&settings.style, &args.sheet) {
        draw::check_contact(style, settings.stages_of(Format::Contact))?;
    }
    let report_to = args.report.as_deref().map(Destination::new);
    check_streams(&inputs, &targets, report_to.as_ref())?;
    let named = targets.iter().flatten().map(|target| &target.destination).chain(&report_to);
    files::refuse_beforehand(&inputs, named)?;
    if !args.quiet {
        oddities::of_fold(args, &formats).iter().for_each(console::warning);
        warn_of_single_stages(args, &targets);
    }

    let stdout_taken = report_to == Some(Destination::Stdout)
        || targets.iter().flatten().any(|t| t.destination == Destination::Stdout);
    let line = ProgressLine::new(inputs.len(), args.quiet);
    let queue = Queue::new(&line, args.quiet, inputs.len() > 1, stdout_taken);
    let finished = fold_all(args, &inputs, &targets, &settings, &line, &queue)?;
    line.finish();

    let exit = finished.iter().map(|f| f.exit).max().unwrap_or(Exit::Done);
    if let Some(destination) = report_to {
        let reports: Vec<Report> = finished.into_iter().filter_map(|f| f.report).collect();
        write_report(&destination, &reports)?;
    }
    queue.result()?;
    Ok(exit)
}

/// Which files are written.
fn plan(args: &FoldArgs, inputs: &[Input]) -> Result<Vec<Vec<Target>>, String> {
    let mut outputs = args.outputs.clone();
    if let Some(path) = &args.png {
        files::refuse_other_than_png("--png", path)?;
        outputs.push(path.clone());
    }
    let mut targets = files::plan(inputs, &outputs, &args.formats)?;
    if let Some(path) = &args.sheet {
        files::plan_drawing(inputs, &mut targets, "--sheet", path, Format::Contact)?;
    }
    if let Some(path) = &args.animate {
        draw::check_film(path)?;
        let goes = args.contact.sequence.is_some() || args.contact.backwards;
        if args.frames.is_none() && args.turntable.is_none() && !goes {
            return Err("--animate: nothing moves; expected --frames N, --turntable N, both or --sequence".to_owned());
        }
        files::plan_drawing(inputs, &mut targets, "--animate", path, Format::Film)?;
    }
    Ok(targets)
}

fn fold_all(
    args: &FoldArgs,
    inputs: &[Input],
    targets: &[Vec<Target>],
    settings: &Settings,
    line: &ProgressLine,
    queue: &Queue<'_>,
) -> Result<Vec<Finished>, Failure> {
    let way = settings.way(settings.stages());
    let fold = |(i, (input, targets)): (usize, (&Input, &Vec<Target>))| {
        let mut observe = |seen| match seen {
            _ if inputs.len() > 1 => {}
            Seen::Stage(stage, progress) => line.show(stage, way, progress),
            Seen::Pictures(drawn, of) => line.show_pictures(drawn, of),
        };
        let mut finished = one::fold(input, targets, settings, &mut observe);
        queue.push(i, std::mem::take(&mut finished.told));
        if inputs.len() > 1 {
            line.file_done();
        }
        finished
    };
    if let Some(threads) = args.threads {
        // A single sheet is shared out among the threads of the global pool.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads::count(Some(threads))).build_global();
        pool.map_err(|error| format!("cannot start threads: {error}"))?;
    }
    if inputs.len() == 1 {
        return Ok(inputs.iter().zip(targets).enumerate().map(fold).collect());
    }
    // Indexed, so the results come in the order of the inputs. One at a time, since a large input takes long.
    Ok(inputs.par_iter().zip(targets).enumerate().with_max_len(1).map(fold).collect())
}

fn write_report(destination: &Destination, reports: &[Report]) -> Result<(), Failure> {
    let text = report::to_json(reports).map_err(|error| format!("{destination}: {error}"))?;
    match destination {
        Destination::Stdout => console::print(&text)?,
        Destination::File(path) => {
            // Where nothing could be written, the folder for the outputs is not there yet.
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
            }
            origami::export::write_whole(path, |writer| {
                writer.write_all(&text).map_err(|source| origami::Error::Io { path: "-".to_owned(), source })
            })?;
        }
    }
    Ok(())
}

/// One stream takes one thing, and a report overwrites nothing else that is named.
fn check_streams(inputs: &[Input], targets: &[Vec<Target>], report: Option<&Destination>) -> Result<(), String> {
    if inputs.iter().filter(|input| input.file().is_none()).count() > 1 {
        return Err("standard input (-) is named twice; expected it once".to_owned());
    }
    let Some(report) = report else { return Ok(()) };
    if targets.iter().flatten().any(|target| target.destination.is(report)) {
        return Err(format!("{report} is named for the report and for an output; expected different ones"));
    }
    if let Destination::File(path) = report {
        let is = |file: &Path| report.is(&Destination::new(file)) || files::is_same_file(file, path);
        let replaced = |input: &Input| input.file().is_some_and(is);
        if inputs.iter().any(replaced) {
            return Err(format!("{report}: the report would overwrite an input; expected another file"));
        }
        // A folder for the outputs is made when the first one is written.
        let made = |target: &Target| target.folder.as_deref().is_some_and(|folder| path.parent() == Some(folder));
        if !targets.iter().flatten().any(made) {
            files::refuse_missing_folder(path)?;
        }
    }
    Ok(())
}

fn warn_of_single_stages(args: &FoldArgs, targets: &[Vec<Target>]) {
    let single = targets.iter().flatten().find(|target| matches!(target.format, Format::Obj | Format::Stl));
    if let (Some(_), Some(target)) = (args.frames, single) {
        console::warning(format!("{}: holds the last stage only; FOLD files hold all of them", target.destination));
    }
}
