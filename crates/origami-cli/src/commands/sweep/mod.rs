//! `origami sweep`: one pattern in many ways.

mod batch;
mod fingerprint;
mod folder;
mod ledger;
mod merge;
mod resume;
mod shares;
mod summary;
#[cfg(test)]
mod testing;

use std::sync::OnceLock;

use origami::export::Template;
use origami::solve::Sweep;
use origami::{CreasePattern, Error, Material, Model};

use crate::args::{PictureArgs, Shard, SweepArgs};
use crate::backend::Computer;
use crate::console;
use crate::draw::{self, Style};
use crate::exit::{Exit, Failure};
use crate::files::{self, Input, Reading};
use crate::numbers::grouped;
use crate::oddities;
use crate::progress::ProgressLine;
use crate::report::{self, Asked, Head, Seconds, Table};
use crate::settings;
use crate::stopwatch::Stopwatch;
use crate::text::plain;
use crate::threads;

use batch::Work;
use folder::Folder;
use ledger::Ledger;
use summary::Counts;

pub(super) use merge::run as merge;

/// Folds all sheets and writes the tables.
pub(super) fn run(args: &SweepArgs) -> Result<Exit, Failure> {
    // The perturbation comes with the instances.
    let method = settings::method(&args.solving, Some(0.0))?;
    let backend = settings::backend(&args.solving, &args.named_material())?;
    let (sweep, count) = args.sweep()?;
    let style = args.folded.iter().any(|format| format.is_drawn()).then(|| Style::new(&PictureArgs::default()));
    let style = style.transpose()?;
    let input = Input::new(&args.input, &Reading::new(&args.reading)?);
    let places = args.shard.map_or(0..count, |shard| shard.rows(count));
    let folder = Folder::new(&args.output, &args.folded, count, args.shard, &input)?;
    files::refuse_unwritable([folder.csv(), folder.json()].iter().map(|path| path.as_path()))?;
    files::tidy([folder.csv().as_path()]);
    if !args.quiet {
        oddities::of_sweep(args, &sweep).iter().for_each(console::warning);
    }

    let mut watch = Stopwatch::start();
    let told = |error| input.describe(&error);
    let document = input.read().map_err(told)?;
    let mut seconds = Seconds { read: watch.lap(), ..Seconds::default() };
    let frame = args.frame.map_or_else(|| document.pattern_frame(), Ok).map_err(told)?;
    let pattern = CreasePattern::from_document(&document, frame).map_err(told)?;
    let template = Template::new(&document, frame, &pattern).map_err(told)?;
    drop(document);
    if let Some(style) = &style {
        check_drawable(args, style, &pattern).map_err(told)?;
    }
    // A GPU is filled by all sheets together.
    let computer = backend.choose(&method, pattern.vertices.len().saturating_mul(places.len()));
    if !args.quiet {
        pattern.warnings.iter().chain(&computer.warning).for_each(console::warning);
    }
    let head = head(args, &input, &pattern, &sweep, count, &computer);
    let rows = if args.resume { resume::rows(&folder.json(), &head, places.clone())? } else { Vec::new() };
    let taken = rows.len();
    if args.resume && !args.quiet {
        console::say(&resumed(taken, places.len()));
    }
    seconds.build = watch.lap();

    let line = ProgressLine::of_sheets(places.len(), args.quiet);
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
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads::count(args.threads)).build();
    let pool = pool.map_err(|error| format!("cannot start threads: {error}"))?;
    let begin = || {
        folder.make()?;
        Ledger::begin([folder.csv(), folder.json()], &head, rows, places.clone(), seconds)
    };
    let mut ledger = None;
    let done = pool.install(|| work.run(places.clone(), taken, begin, &mut ledger));
    line.finish();
    let known = done.map_err(|error| broken_off(&input, &error, ledger.as_ref(), places.len()))?;
    if !args.quiet {
        known.scene_warnings.iter().chain(work.told.get()).for_each(console::warning);
    }
    let (instances, seconds) = ledger.map(Ledger::into_rows).unwrap_or_default();
    let table = Table { head, instances, seconds };

    let counts = Counts::of(&table.instances);
    let advice = settings::advice(args.solving.solver, args.solving.time_step());
    let divergence = known.first_divergence.as_ref().map(|(index, message)| (*index, message.as_str()));
    counts.complaints(&table, divergence, advice).iter().for_each(|error| console::error(error));
    if !args.quiet {
        let head = &table.head;
        let what = match args.shard {
            Some(Shard { number, of }) => format!("{}, part {number} of {of}", head.input),
            None => head.input.clone(),
        };
        let software =
            head.adapter.as_ref().filter(|adapter| adapter.is_software()).map(|adapter| adapter.name.as_str());
        let line = counts.line(&what, &table.instances, software, table.seconds);
        console::print_text(&format!("{}\n", plain(&line)))?;
    }
    Ok(counts.exit())
}

/// Nothing is folded for pictures that cannot be.
fn check_drawable(args: &SweepArgs, style: &Style, pattern: &CreasePattern) -> Result<(), Error> {
    let model = Model::new(pattern, &Material::default())?;
    args.folded.iter().try_for_each(|format| draw::check_drawable(*format, style, pattern, &model, 1))
}

/// All that rows depend on.
fn head(
    args: &SweepArgs,
    input: &Input,
    pattern: &CreasePattern,
    sweep: &Sweep,
    count: usize,
    computer: &Computer,
) -> Head {
    let solving = &args.solving;
    let grid = args.grid();
    let settings = Asked {
        version: env!("CARGO_PKG_VERSION"),
        pattern: fingerprint::of(pattern),
        count,
        percents: sweep.percents.clone(),
        perturbations: sweep.perturbations.clone(),
        seeds: sweep.seeds,
        ea: grid.ea,
        k_fold: grid.k_fold,
        k_facet: grid.k_facet,
        k_face: grid.k_face,
        zeta: grid.zeta,
        max_steps: solving.max_steps,
        steps: solving.steps,
        ramp: solving.ramp,
        residual: solving.residual,
        time_step: solving.time_step_name(),
        integrator: solving.integrator_name(),
        folded: args.folded.iter().map(|format| format.extension()).collect(),
        shard: args.shard,
    };
    Head {
        input: input.to_string(),
        solver: solving.solver.name(),
        backend: if computer.adapter.is_some() { "gpu" } else { "cpu" },
        backend_by: computer.by,
        precision: solving.precision_name(computer.adapter.is_some()),
        adapter: computer.adapter.clone(),
        tolerance: solving.tolerance,
        attitude: report::attitude(pattern, args.hold.unwrap_or_default()),
        settings,
    }
}

/// What is taken from before.
fn resumed(taken: usize, count: usize) -> String {
    match taken {
        0 => "there are no rows to go on from: all are made".to_owned(),
        _ => format!("{} of {} rows are taken from before", grouped(taken as u64), grouped(count as u64)),
    }
}

/// What ended a sweep early, and what is left of it.
fn broken_off(input: &Input, error: &Error, ledger: Option<&Ledger>, count: usize) -> String {
    let told = input.describe(error);
    match ledger.map_or(0, Ledger::written) {
        0 => told,
        rows => {
            let (rows, count) = (grouped(rows as u64), grouped(count as u64));
            format!("{told}; {rows} of {count} rows are in the tables, and --resume goes on from there")
        }
    }
}
