//! `origami convert`: a pattern in, a pattern out.

#[cfg(not(feature = "formats"))]
#[path = "absent.rs"]
mod writers;
#[cfg(feature = "formats")]
mod writers;

use std::path::Path;
use std::time::Duration;

use origami::export::Template;
use origami::{CreasePattern, Error};

use crate::args::ConvertArgs;
use crate::console;
use crate::exit::{Exit, Failure};
use crate::files::{self, Destination, Input, Reading, whole};
use crate::numbers::{count, duration};
use crate::stopwatch::Stopwatch;
use crate::text::plain;

use writers::Writers;

/// What a pattern is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Fold,
    Cp,
    Svg,
    Dxf,
}

impl Form {
    /// That of a path's extension.
    ///
    /// # Errors
    /// What is wrong with it.
    fn of(path: &Path) -> Result<Self, String> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let problem = match extension.as_str() {
            "fold" => return Ok(Self::Fold),
            "cp" => return Ok(Self::Cp),
            "svg" => return Ok(Self::Svg),
            "dxf" => return Ok(Self::Dxf),
            "" => "no extension tells the format".to_owned(),
            "obj" | "stl" | "glb" | "png" => format!("patterns are not written as .{extension}, `origami fold` does"),
            other => format!("patterns are not written as .{other}"),
        };
        Err(format!("{}: {problem}; expected .fold, .cp, .svg or .dxf", path.display()))
    }
}

/// Converts it.
pub(super) fn run(args: &ConvertArgs) -> Result<Exit, Failure> {
    let mut watch = Stopwatch::start();
    let input = Input::new(&args.input, &Reading::new(&args.reading)?);
    let targets = targets(args)?;
    files::refuse_beforehand(std::slice::from_ref(&input), targets.iter().map(|(destination, _)| destination))?;
    let writers = Writers::new(args, targets.iter().map(|(_, form)| *form))?;

    let told = |error| input.describe(&error);
    let document = input.read().map_err(told)?;
    let frame = args.frame.map_or_else(|| document.pattern_frame(), Ok).map_err(told)?;
    let pattern = CreasePattern::from_document(&document, frame).map_err(told)?;
    let template = Template::new(&document, frame, &pattern).map_err(told)?;
    drop(document);
    if !args.quiet {
        pattern.warnings.iter().for_each(console::warning);
    }
    // What cannot be written as one of them is refused before any is written.
    let mut contents = Vec::new();
    for (destination, form) in &targets {
        let mut bytes = Vec::new();
        let warnings = match form {
            Form::Fold => template.crease_pattern(&pattern).write_to(&mut bytes).map(|()| Vec::new()),
            _ => writers.write(*form, &pattern, &mut bytes),
        };
        contents.push((destination, bytes, warnings.map_err(told)?));
    }
    for (destination, bytes, warnings) in contents {
        let put = |source| Error::Io { path: "-".to_owned(), source };
        whole(destination, |writer| writer.write_all(&bytes).map_err(put))?;
        if !args.quiet {
            warnings.iter().for_each(console::warning);
        }
    }
    if !args.quiet {
        let edges = pattern.edges.iter().filter(|edge| edge.alias_of.is_none()).count();
        let names: Vec<String> = targets.iter().map(|(destination, _)| destination.to_string()).collect();
        let time = duration(Duration::from_secs_f64(watch.lap()));
        let line = format!("{input}: {} written as {}, {time}", count(edges, "edge", "edges"), names.join(", "));
        if names.iter().any(|name| name == "-") {
            console::say(&line);
        } else {
            console::print_text(&format!("{}\n", plain(&line)))?;
        }
    }
    Ok(Exit::Done)
}

/// Where to write, and as what.
fn targets(args: &ConvertArgs) -> Result<Vec<(Destination, Form)>, String> {
    let mut targets: Vec<(Destination, Form)> = Vec::new();
    for path in &args.outputs {
        let destination = Destination::new(path);
        let form = if destination == Destination::Stdout { Form::Fold } else { Form::of(path)? };
        files::refuse_missing_folder(path)?;
        if targets.iter().any(|(other, _)| other.is(&destination)) {
            return Err(format!("{destination} is named twice as an output; expected different ones"));
        }
        targets.push((destination, form));
    }
    Ok(targets)
}
