//! `origami render`: a frame of a file as it lies.

mod bare;
mod lying;

use std::time::Duration;

use origami::Error;

use crate::args::{BackendName, RenderArgs, ViewName};
use crate::backend::Backend;
use crate::console;
use crate::draw::{self, Artist, Faults, Style, Subject};
use crate::exit::{Exit, Failure};
use crate::files::{self, Destination, Format, Input, Reading, whole};
use crate::numbers::duration;
use crate::oddities::{self, Drawn};
use crate::stopwatch::Stopwatch;
use crate::text::plain;

use bare::Bare;
use lying::Lying;

/// Draws it.
pub(super) fn run(args: &RenderArgs) -> Result<Exit, Failure> {
    let mut watch = Stopwatch::start();
    let input = Input::new(&args.input, &Reading::new(&args.reading)?);
    let outputs = outputs(args)?;
    files::refuse_beforehand(std::slice::from_ref(&input), outputs.iter().map(|(destination, _)| destination))?;
    let style = Style::new(&args.picture)?;
    // Without a word the processor draws.
    let wanted = if args.backend == BackendName::Auto { BackendName::Cpu } else { args.backend };
    let backend = Backend::new(wanted, args.adapter.as_deref())?;
    let told = |error| input.describe(&error);
    let document = input.read().map_err(told)?;
    let frame = args.frame.map_or_else(|| document.pattern_frame(), Ok).map_err(told)?;
    let lying = match Lying::of(&document, frame) {
        Ok(lying) => lying,
        Err(refusal) => {
            let bare = document.frame(frame).ok().and_then(|written| Bare::of(&written, &refusal));
            let Some(bare) = bare.filter(|_| args.view != Some(ViewName::Sheet) && args.picture.quantity().is_none())
            else {
                return Err(told(refusal).into());
            };
            return draw_bare(args, &outputs, &Artist::new(style, None), (&input, &bare, frame, &refusal));
        }
    };
    if !args.quiet {
        lying.pattern.warnings.iter().for_each(console::warning);
    }
    let as_pattern = match args.view {
        Some(view) => view == ViewName::Pattern,
        None => lying.is_pattern,
    };
    if as_pattern && args.picture.quantity().is_some() {
        let expected = "a folded form, `--view sheet`, or `origami fold` with --map";
        let problem = "a crease pattern as it lies has nothing to map";
        return Err(format!("{input}: frame {}: {problem}; expected {expected}", lying.frame).into());
    }
    if !args.quiet {
        let drawn: Vec<Drawn> = outputs.iter().map(|(_, format)| drawn_as(*format, as_pattern)).collect();
        oddities::of_render(args, &drawn).iter().for_each(console::warning);
    }
    for (_, format) in &outputs {
        // A pattern as it lies needs no more than to be flat.
        let format = if as_pattern && *format == Format::Png { Format::Svg } else { *format };
        let sheet = if format == Format::Svg { &lying.drawn } else { &lying.pattern };
        draw::check_drawable(format, &style, sheet, &lying.model, 1).map_err(told)?;
    }
    let state = lying.state(args.picture.quantity()).map_err(told)?;
    let states = [(0.0, &state)];
    let subject = Subject { pattern: &lying.pattern, model: &lying.model, states: &states, steps: &[] };
    let artist = Artist::new(style, (args.backend == BackendName::Gpu).then_some(&backend));
    let faults = if args.no_marks { Faults::None } else { Faults::Found };
    for (destination, format) in &outputs {
        let flat = *format == Format::Svg || (as_pattern && *format == Format::Png);
        whole(destination, |writer| {
            if flat {
                draw::faulty_pattern(*format, &artist, &lying.drawn, &faults, writer)
            } else {
                draw::sheet(*format, &artist, subject, None, writer)
            }
        })
        .map_err(told)?;
    }
    if let (Some(trouble), false) = (artist.trouble(), args.quiet) {
        console::warning(format!("drawn by the processor, since {trouble}"));
    }
    report(args, &outputs, &format!("{input}: frame {}", lying.frame), &mut watch)
}

/// Draws lines of which no sheet can be made, and says why.
fn draw_bare(
    args: &RenderArgs,
    outputs: &[(Destination, Format)],
    artist: &Artist,
    (input, bare, frame, refusal): (&Input, &Bare, usize, &Error),
) -> Result<Exit, Failure> {
    let mut watch = Stopwatch::start();
    let told = input.describe(refusal);
    if let Some((destination, _)) = outputs.iter().find(|(_, format)| *format == Format::Glb) {
        return Err(format!("{told}; {destination} needs a sheet, .png and .svg show its lines").into());
    }
    if !args.quiet {
        console::warning(format!("{told}; no sheet can be made of it, its lines are drawn as they are"));
    }
    let why = format!("No sheet can be made of this: {refusal}");
    let faults = match args.no_marks {
        true => Faults::None,
        false => Faults::Refused { why: &why, open_ends: &bare.open_ends, blamed: &bare.blamed },
    };
    for (destination, format) in outputs {
        whole(destination, |writer| draw::faulty_pattern(*format, artist, &bare.lines, &faults, writer))?;
    }
    report(args, outputs, &format!("{input}: lines of frame {frame}"), &mut watch)
}

/// Says what was drawn.
fn report(
    args: &RenderArgs,
    outputs: &[(Destination, Format)],
    what: &str,
    watch: &mut Stopwatch,
) -> Result<Exit, Failure> {
    if !args.quiet {
        let names: Vec<String> = outputs.iter().map(|(destination, _)| destination.to_string()).collect();
        let time = duration(Duration::from_secs_f64(watch.lap()));
        let line = format!("{what} drawn as {}, {time}", names.join(", "));
        if names.iter().any(|name| name == "-") {
            console::say(&line);
        } else {
            console::print_text(&format!("{}\n", plain(&line)))?;
        }
    }
    Ok(Exit::Done)
}

/// What a format shows.
fn drawn_as(format: Format, as_pattern: bool) -> Drawn {
    match format {
        Format::Svg => Drawn::Svg,
        Format::Glb => Drawn::Glb,
        _ if as_pattern => Drawn::Pattern,
        _ => Drawn::Sheet,
    }
}

/// Where to write, and as what.
fn outputs(args: &RenderArgs) -> Result<Vec<(Destination, Format)>, String> {
    let mut outputs: Vec<(Destination, Format)> = Vec::new();
    for path in &args.outputs {
        let destination = Destination::new(path);
        let format = match &destination {
            Destination::Stdout => Format::Png,
            Destination::File(path) => match Format::of(path) {
                Ok(format) if format.is_drawn() => format,
                _ => return Err(format!("{}: expected a path ending in .png, .svg or .glb", path.display())),
            },
        };
        files::refuse_missing_folder(path)?;
        if outputs.iter().any(|(other, _)| other.is(&destination)) {
            return Err(format!("{destination} is named twice as an output; expected different ones"));
        }
        outputs.push((destination, format));
    }
    Ok(outputs)
}
