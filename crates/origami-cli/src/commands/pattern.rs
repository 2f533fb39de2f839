//! `origami pattern`.

use std::fmt::Write;

use origami::Error;
use origami::export::crease_pattern_document;
use origami::generate::catalog;

use crate::args::PatternArgs;
use crate::console;
use crate::exit::{Exit, Failure};
use crate::files::{self, Destination, Format, refuse_missing_folder, write_document};
use crate::nearest::nearest;

/// Makes one pattern, or lists them all.
pub(super) fn run(args: &PatternArgs) -> Result<Exit, Failure> {
    let (Some(name), Some(output)) = (&args.name, &args.output) else {
        console::print_text(&list())?;
        return Ok(Exit::Done);
    };
    let destination = Destination::new(output);
    if let Destination::File(path) = &destination {
        if Format::of(path) != Ok(Format::Fold) {
            let problem = "crease patterns are written as FOLD; expected a path ending in .fold, or -";
            return Err(format!("{}: {problem}", path.display()).into());
        }
        refuse_missing_folder(path)?;
        files::refuse_unwritable([path.as_path()])?;
        files::tidy([path.as_path()]);
    }
    let pattern =
        catalog::generate(name, &args.parameters).map_err(|error| described(&error, name, &args.parameters))?;
    write_document(&destination, &crease_pattern_document(&pattern, &title(name, &args.parameters)))?;
    Ok(Exit::Done)
}

/// With the parameter that somebody may have meant who has misspelt one.
fn described(error: &Error, name: &str, parameters: &[(String, f64)]) -> String {
    let entry = catalog::entries().iter().find(|entry| entry.name == name);
    let names: Vec<&str> = entry.iter().flat_map(|entry| entry.parameters).map(|parameter| parameter.name).collect();
    let unknown = parameters.iter().find(|(key, _)| !names.contains(&key.as_str()));
    match unknown.and_then(|(key, _)| nearest(key, names.iter().copied())) {
        Some(perhaps) => format!("{error}; perhaps {perhaps}"),
        None => error.to_string(),
    }
}

/// Such as `miura, columns 6, rows 4`.
fn title(name: &str, parameters: &[(String, f64)]) -> String {
    parameters.iter().fold(name.to_owned(), |title, (key, value)| format!("{title}, {key} {value}"))
}

fn list() -> String {
    let mut text = String::new();
    for entry in catalog::entries() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}: {}", entry.name, entry.summary);
        for parameter in entry.parameters {
            let setting = format!("{}={}", parameter.name, parameter.default);
            let _ = writeln!(text, "    {setting:<22} {}", parameter.meaning);
        }
    }
    text
}
