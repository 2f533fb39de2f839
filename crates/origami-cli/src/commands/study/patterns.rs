//! The patterns of a study, by name.

use std::path::Path;

use origami::generate::catalog;
use origami::{CreasePattern, Material, Model};

use crate::console;
use crate::files::{Input, Reading};

/// Reads or generates them all.
///
/// # Errors
/// What is wrong with one, or that two have the same name.
pub(super) fn read(
    paths: &[impl AsRef<Path>],
    reading: &Reading,
    quiet: bool,
) -> Result<Vec<(String, CreasePattern)>, String> {
    let mut patterns: Vec<(String, CreasePattern)> = Vec::new();
    for path in paths {
        let (name, pattern) = one(path.as_ref(), reading, quiet)?;
        if patterns.iter().any(|(other, _)| *other == name) {
            let path = path.as_ref().display();
            return Err(format!("{path}: another pattern is called {name} too; expected different names"));
        }
        patterns.push((name, pattern));
    }
    Ok(patterns)
}

fn one(path: &Path, reading: &Reading, quiet: bool) -> Result<(String, CreasePattern), String> {
    if let Some(name) = path.to_str().filter(|name| catalog::names().contains(name)) {
        let pattern = catalog::generate(name, &[]).map_err(|error| error.to_string())?;
        return Ok((name.to_owned(), pattern));
    }
    let input = Input::new(path, reading);
    let read = || {
        let document = input.read()?;
        let pattern = CreasePattern::from_document(&document, document.pattern_frame()?)?;
        // What makes no model is told here, with its file.
        Model::new(&pattern, &Material::default())?;
        Ok(pattern)
    };
    let pattern = read().map_err(|error| input.describe(&error))?;
    if !quiet {
        pattern.warnings.iter().for_each(|warning| console::warning(format!("{input}: {warning}")));
    }
    Ok((input.stem(), pattern))
}
