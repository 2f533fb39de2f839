//! `origami sweep`: one pattern in many ways.

mod batch;
mod folder;
mod shares;
mod summary;

use std::sync::OnceLock;

use origami::CreasePattern;
use origami::export::{Template, write_whole};

use crate::args::PictureArgs;
use crate::args::SweepArgs;
use crate::console;
use crate::draw::Style;
use crate::exit::{Exit, Failure};
use crate::files::{Input, Reading};
use crate::progress::ProgressLine;
use crate::report::{self, Seconds, Table, write_csv, write_json};
use crate::settings;
use crate::stopwatch::Stopwatch;

use batch::Work;
use folder::Folder;
use summary::Counts;

/// Folds all sheets and writes the tables.
pub(super) fn run(args: &SweepArgs) -> Result<Exit, Failure> {
    // The perturbation comes with the instances.
    let method = settings::method(&args.solving, Some(0.0))?;
    let backend = settings::backend(&args.solving)?;
    let (sweep, count) = args.sweep()?;
    if args.folded.iter().any(|format| format.is_drawn()) {
        Style::new(&PictureArgs::default())?;
    }
    let input = Input::new(&args.input, &Reading::new(&args.reading)?);
    let folder = Folder::new(&args.output, &args.folded, count, &input)?;
    if !args.quiet {
        settings::oddities_of_sweep(args, &sweep.percents).iter().for_each(console::warning);
    }

    let mut watch = Stopwatch::start();
    let told = |error| input.describe(&error);
    let document = input.read().map_err(told)?;
    let mut seconds = Seconds { read: watch.lap(), ..Seconds::default() };
    let frame = args.frame.map_or_else(|| document.pattern_frame(), Ok).map_err(told)?;
    let pattern = CreasePattern::from_document(&document, frame).map_err(told)?;
    let template = Template::new(&document, frame, &pattern).map_err(told)?;
    drop(document);
    // A GPU is filled by all sheets together.
    let computer = backend.choose(&method, pattern.vertices.len().saturating_mul(count));
    if !args.quiet {
        pattern.warnings.iter().chain(&computer.warning).for_each(console::warning);
    }
    seconds.build = watch.lap();

    let line = ProgressLine::of_sheets(count, args.quiet);
    let work = Work {
        template: &template,
        pattern: &pattern,
        sweep: &sweep,
        solver: computer.solver.as_ref(),
        folder: &folder,
        line: &line,
        told: OnceLock::new(),
        hold: args.hold.unwrap_or_default(),
        on_gpu: computer.adapter.is_some().then_some(args.solving.tolerance),
    };
    let threads = args.threads.map_or(0, usize::from);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| format!("cannot start threads: {error}"))?;
    let done = pool.install(|| work.run(count, &mut seconds));
    line.finish();
    let done = done.map_err(told)?;
    if !args.quiet {
        done.scene_warnings.iter().chain(work.told.get()).for_each(console::warning);
    }

    watch.lap();
    let mut table = Table {
        input: input.to_string(),
        solver: args.solving.solver.name(),
        backend: if computer.adapter.is_some() { "gpu" } else { "cpu" },
        precision: args.solving.precision_name(computer.adapter.is_some()),
        adapter: computer.adapter,
        tolerance: args.solving.tolerance,
        attitude: report::attitude(&pattern, work.hold),
        scenes: done.scenes,
        instances: done.rows,
        seconds,
    };
    write_whole(folder.csv(), |writer| write_csv(writer, &table.instances))?;
    table.seconds.write += watch.lap();
    write_whole(folder.json(), |writer| write_json(writer, &table))?;

    let counts = Counts::of(&table.instances);
    let advice = settings::advice(args.solving.solver, args.solving.time_step());
    counts.complaints(&table, done.first_divergence.as_deref(), advice).iter().for_each(|error| console::error(error));
    if !args.quiet {
        console::print(format!("{}\n", counts.line(&table)).as_bytes())?;
    }
    Ok(counts.exit())
}
