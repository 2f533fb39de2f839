//! One input: read, build, solve, write.

use std::ops::ControlFlow;
use std::time::Instant;

use origami::error::WarningCode;
use origami::export::Template;
use origami::measure::attitude;
use origami::model::Model;
use origami::solve::{Failed, Folded, Progress, Stop, crushed_triangles, fold_path_from};
use origami::{CreasePattern, Error, Warning, measure};

use super::order::{self, Ended, Order};
use super::summary::{self, Told};
use super::touching::in_contact;
use crate::backend::Method;
use crate::draw::{self, Artist, Subject};
use crate::exit::Exit;
use crate::files::{self, Destination, Format, Input, Sheet, Target};
use crate::report::{self, Divergence, Ending, Measured, Note, Report, Run, SceneFacts, Seconds};
use crate::settings::{Settings, scene_warnings};
use crate::stopwatch::Stopwatch;

/// How far one input has come.
pub(super) enum Seen {
    /// In this stage its solver has come so far.
    Stage(usize, Progress),
    /// So many pictures of a film are drawn, of so many.
    Pictures(usize, usize),
}

/// What came of one input.
pub(super) struct Finished {
    pub(super) exit: Exit,
    /// None where nothing was folded, which is not done where a report is asked for.
    pub(super) report: Option<Report>,
    pub(super) told: Told,
}

/// Folds one input and writes its outputs. Nothing that is wrong with it stops the others.
pub(super) fn fold(input: &Input, targets: &[Target], settings: &Settings, observe: &mut dyn FnMut(Seen)) -> Finished {
    let mut told = Told { input: input.to_string(), ..Told::default() };
    match attempt(input, targets, settings, observe, &mut told) {
        Ok((exit, report)) => Finished { exit, report, told },
        // Nobody reads standard output any more: that is the reader's business.
        Err(Error::Io { path, source }) if path == "-" && source.kind() == std::io::ErrorKind::BrokenPipe => {
            let error = source.to_string();
            let outputs = std::mem::take(&mut told.written);
            let report = Report::Refused { input: told.input.clone(), error, outputs };
            Finished { exit: Exit::Done, report: Some(report), told }
        }
        Err(error) => {
            told.errors.push(input.describe(&error));
            let outputs = std::mem::take(&mut told.written);
            let report = Report::Refused { input: input.to_string(), error: error.to_string(), outputs };
            Finished { exit: Exit::BadInput, report: Some(report), told }
        }
    }
}

fn attempt(
    input: &Input,
    targets: &[Target],
    settings: &Settings,
    observe: &mut dyn FnMut(Seen),
    told: &mut Told,
) -> Result<(Exit, Option<Report>), Error> {
    let mut watch = Stopwatch::start();
    let mut seconds = Seconds::default();
    let document = input.read()?;
    seconds.read = watch.lap();

    let index = settings.frame.map_or_else(|| document.pattern_frame(), Ok)?;
    let pattern = CreasePattern::from_document(&document, index)?;
    told.warnings.clone_from(&pattern.warnings);
    let template = Template::new(&document, index, &pattern)?;
    let order = settings.sequence.as_ref();
    let order = order.map(|source| Order::read(source, &document, (index, settings.percent))).transpose()?;
    drop(document);
    let model = Model::new(&pattern, &settings.material)?;
    let stages = order.map(|order| order.stages(&pattern, &model)).transpose()?;
    check_room(settings.stages().max(stages.as_ref().map_or(0, |s| s.len() * settings.parts as usize)), &model)?;
    for target in targets {
        let states = settings.stages_of(target.format);
        let style = settings.style.as_ref();
        style.map_or(Ok(()), |style| draw::check_drawable(target.format, style, &pattern, &model, states))?;
    }
    seconds.build = watch.lap();
    // A picture of the pattern needs no folding.
    if !settings.reported && !settings.check && targets.iter().all(|target| target.format == Format::Svg) {
        draw_pattern(targets, settings, (&template, &pattern, &model))?;
        told.summary = Some(summary::not_folded(input, seconds.read + seconds.build + watch.lap()));
        return Ok((Exit::Done, None));
    }

    // A face that is not there is refused before the work.
    attitude::motion(&model, &model.rest, settings.hold)?;
    let computer = settings.backend.choose(&settings.method, model.node_count());
    let mut warnings =
        scene_warnings(&pattern, &model, &settings.percents, computer.adapter.is_some().then_some(settings.tolerance));
    warnings.extend(settings.contact.and_then(|_| measure::touching_lips(&model)));
    told.warnings.extend(warnings.iter().cloned().chain(computer.warning));
    warnings.splice(0..0, pattern.warnings.iter().cloned());
    let contact = settings.contact.map(|asked| asked.of(&model));
    let touching = contact.and_then(|contact| in_contact(settings, contact));
    let inventory = match &touching {
        Some(make) => make(false).inventory(&model),
        None => computer.solver.inventory(&model),
    };
    let scene = SceneFacts::new(&pattern, &model, &inventory, &warnings);
    let start = match settings.start(&model) {
        Ok(start) => start,
        Err(failed) => return Ok(refused(input, &format!("--from-flat: {failed}"), told)),
    };
    let end = settings.max_time.and_then(|time| Instant::now().checked_add(time));
    let mut watched = |stage, progress| {
        observe(Seen::Stage(stage, progress));
        let over = end.is_some_and(|end| Instant::now() >= end);
        if over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let (mut steps, mut touches, mut orders, mut motion) = (Vec::new(), Vec::new(), None, None);
    let mut path = |percents: &[f64], before: usize| {
        let gone = match (&stages, &touching, &settings.method) {
            (Some(stages), _, Method::Relax(relax)) => {
                // How many stages there are is not known where the way is told.
                let mut watched = |_, progress| watched(0, progress);
                order::in_steps(&model, (relax, contact), &start, (stages, settings.parts), &mut watched)?
            }
            (None, Some(_), Method::Relax(relax)) if let Some((stages, contact)) = settings.backwards.zip(contact) => {
                let mut watched = |progress| watched(0, progress);
                order::backwards(&model, (relax, contact), stages, &mut watched)?
            }
            (None, Some(make), _) => {
                let mut watched = |stage, progress| watched(before + stage, progress);
                order::in_contact(&model, make, &start, percents, &mut watched)?
            }
            _ => {
                let mut watched = |stage, progress| watched(before + stage, progress);
                return fold_path_from(&model, computer.solver.as_ref(), &start, percents, &mut watched)
                    .map_err(Ended::from);
            }
        };
        if before == 0 {
            (steps, touches, orders, motion) = (gone.steps, gone.touches, gone.orders, gone.motion);
        }
        Ok(gone.states)
    };
    // What stands beside a contact sheet is folded as if that were not asked for.
    let solved = path(&settings.percents, 0).and_then(|states| {
        let stages = settings.sheet_percents.as_deref().map(|stages| path(stages, states.len())).transpose()?;
        Ok((states, stages))
    });
    seconds.solve = watch.lap();
    let on_gpu = computer.adapter.is_some();
    let mut run = Run {
        input: input.to_string(),
        solver: settings.solver_name.name(),
        from: settings.start_name(),
        backend: if on_gpu { "gpu" } else { "cpu" },
        backend_by: computer.by,
        adapter: computer.adapter,
        precision: settings.precisions[usize::from(on_gpu)],
        scene,
        tolerance: settings.tolerance,
        attitude: report::attitude(&pattern, settings.hold),
        measured: Measured::default(),
        frames: None,
        backwards: None,
        diverged: None,
        outputs: Vec::new(),
        seconds,
    };
    let (mut states, mut shown) = match solved {
        Ok(solved) => solved,
        Err(failed) => {
            let Some(Failed::Diverged(diverged)) = failed.failed.as_deref() else {
                return Ok(refused(input, &failed.message, told));
            };
            run.measured = Measured {
                percent: failed.percent,
                time_step: settings.first_time_step(&model),
                steps: failed.states.iter().map(|folded| folded.steps).sum::<u64>() + diverged.step,
                stop: Ending::Diverged,
                attempts: 1,
                ..Measured::default()
            };
            run.diverged = Some(Divergence::from(diverged));
            let crushed = measure::crushed(&model, &diverged.last_good.positions);
            run.scene.warnings.extend(crushed.iter().map(Note::from));
            told.warnings.extend(crushed);
            let held = failed
                .states
                .iter()
                .map(|folded| Measured::new(&model, folded).checked(settings.check, &model, folded));
            run.frames = settings.animated.then(|| held.collect());
            told.errors.push(format!("{input}: {}; {}", failed.message, settings.advice()));
            return Ok((Exit::Diverged, Some(Report::Folded(Box::new(run)))));
        }
    };

    let limited = unfinished(&states, shown.as_deref());
    let mut at_the_end =
        states.last().map(|folded| measure::folded_warnings(&pattern, &model, folded)).unwrap_or_default();
    if !at_the_end.iter().any(|warning| warning.code == WarningCode::CrushedTriangle) {
        at_the_end.extend(limited.and_then(|folded| measure::crushed(&model, &folded.state.positions)));
    }
    run.scene.warnings.extend(at_the_end.iter().map(Note::from));
    told.warnings.extend(at_the_end);
    let mut frames: Vec<Measured> =
        states.iter().map(|folded| Measured::new(&model, folded).checked(settings.check, &model, folded)).collect();
    frames.iter_mut().zip(&steps).for_each(|(frame, step)| frame.step = Some(step.clone()));
    frames.iter_mut().zip(&touches).for_each(|(frame, touch)| frame.contact = Some(touch.clone()));
    run.measured = overall(&frames);
    run.frames = settings.animated.then_some(frames);
    run.backwards = motion;
    for folded in states.iter_mut().chain(shown.iter_mut().flatten()) {
        folded.state = attitude::turned(&model, &folded.state, settings.hold)?;
    }
    watch.lap();
    let artist = Artist::new(
        settings.style.clone().unwrap_or_default(),
        (on_gpu && settings.style.is_some()).then_some(&settings.backend),
    );
    let mut drawing = watch.lap();
    let name = input.stem();
    let sheet = Sheet {
        name: &name,
        template: &template,
        pattern: &pattern,
        model: &model,
        states: &states,
        steps: &steps,
        orders: orders.as_deref(),
        animated: settings.animated,
        artist: &artist,
        thickness: settings.contact.and_then(|asked| asked.thickness),
        fps: settings.film.fps,
    };
    let contact = Sheet { states: shown.as_deref().unwrap_or(&states), ..sheet };
    for target in targets {
        let sheet = if target.format == Format::Contact { &contact } else { &sheet };
        let (outputs, warning) = write(target, sheet, settings, observe)?;
        told.written.extend_from_slice(&outputs);
        run.outputs.extend(outputs);
        run.scene.warnings.extend(warning.iter().map(Note::from));
        told.warnings.extend(warning);
        let seconds = watch.lap();
        *(if target.format.is_drawn() { &mut drawing } else { &mut run.seconds.write }) += seconds;
    }
    run.seconds.draw = Some(drawing);
    if let Some(trouble) = artist.trouble() {
        told.warnings.push(Warning::new(
            WarningCode::Fallback,
            "pictures",
            format!("drawn by the processor, since {trouble}"),
        ));
    }

    told.summary = Some(summary::line(&run));
    let limited = unfinished(&states, shown.as_deref());
    if let Some(folded) = limited {
        let number = states.iter().position(|state| std::ptr::eq(state, folded));
        let step = number.and_then(|number| steps.get(number));
        let touch = number.and_then(|number| touches.get(number)).filter(|_| folded.stop == Stop::Blocked);
        told.errors.push(match touch {
            Some(touch) => summary::blocked(input, (folded, step), touch),
            None => {
                let crushed = !crushed_triangles(&model, &folded.state.positions).is_empty();
                summary::not_converged(input, (folded, step), crushed, settings.solver_name, settings.tolerance)
            }
        });
    }
    let exit = if limited.is_some() { Exit::NotConverged } else { Exit::Done };
    Ok((exit, Some(Report::Folded(Box::new(run)))))
}

/// What is told of an input that cannot be folded as it was asked.
fn refused(input: &Input, error: &str, told: &mut Told) -> (Exit, Option<Report>) {
    told.errors.push(format!("{input}: {error}"));
    let report = Report::Refused { input: input.to_string(), error: error.to_owned(), outputs: Vec::new() };
    (Exit::BadInput, Some(report))
}

/// The first state that is not what was asked for.
fn unfinished<'a>(states: &'a [Folded], stages: Option<&'a [Folded]>) -> Option<&'a Folded> {
    let mut all = states.iter().chain(stages.into_iter().flatten());
    all.find(|folded| matches!(folded.stop, Stop::StepLimit | Stop::Cancelled | Stop::Crushed | Stop::Blocked))
}

/// Places of vertices that all states of an input may have together: some gigabytes.
const MOST_PLACES: usize = 1 << 26;

/// Whether memory holds all states.
fn check_room(stages: usize, model: &Model) -> Result<(), Error> {
    let nodes = model.node_count().max(1);
    if stages <= MOST_PLACES / nodes || stages == 1 {
        return Ok(());
    }
    let problem = format!("{stages} states of {nodes} vertices are more than can be held");
    Err(Error::invalid("--frames", problem, format!("at most {} states", MOST_PLACES / nodes)))
}

/// Draws nothing but the pattern.
fn draw_pattern(
    targets: &[Target],
    settings: &Settings,
    (template, pattern, model): (&Template, &CreasePattern, &Model),
) -> Result<(), Error> {
    let artist = Artist::new(settings.style.clone().unwrap_or_default(), None);
    let sheet = Sheet {
        name: "sheet",
        template,
        pattern,
        model,
        states: &[],
        steps: &[],
        orders: None,
        animated: false,
        artist: &artist,
        thickness: None,
        fps: None,
    };
    targets.iter().try_for_each(|target| files::write(target, &sheet).map(|_| ()))
}

/// Writes one target and says which files it is, and what is not in them as it was asked for.
fn write(
    target: &Target,
    sheet: &Sheet<'_>,
    settings: &Settings,
    observe: &mut dyn FnMut(Seen),
) -> Result<(Vec<String>, Option<Warning>), Error> {
    if let (Format::Film, Destination::File(path)) = (target.format, &target.destination) {
        let states = sheet.states_of(Format::Film);
        let steps = sheet.steps_of(Format::Film);
        let subject = Subject { pattern: sheet.pattern, model: sheet.model, states: &states, steps };
        let mut drawn = |drawn, of| observe(Seen::Pictures(drawn, of));
        files::make_folder(target)?;
        return Ok((draw::film(sheet.artist, subject, settings.film, path, &mut drawn)?, None));
    }
    let warning = files::write(target, sheet)?;
    Ok((vec![target.destination.to_string()], warning))
}

/// The last state, with the steps of all of them; converged if all of them are.
fn overall(frames: &[Measured]) -> Measured {
    let last = frames.last().cloned().unwrap_or_default();
    let limited = frames.iter().find(|frame| !frame.converged);
    Measured {
        steps: frames.iter().map(|frame| frame.steps).sum(),
        converged: limited.is_none(),
        stop: limited.map_or(last.stop, |frame| frame.stop),
        attempts: frames.iter().map(|frame| frame.attempts).max().unwrap_or(0),
        saddles: frames.iter().map(|frame| frame.saddles).sum(),
        factorisations: frames.iter().map(|frame| frame.factorisations).sum(),
        ..last
    }
}
