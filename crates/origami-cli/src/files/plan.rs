//! Which file comes from which input. All that can be refused is refused here, before any work.

use std::collections::HashMap;
use std::fmt;
use std::path::{Path, PathBuf};

use super::{Format, Input, page};

/// A place to write to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Destination {
    /// Written `-`.
    Stdout,
    /// A file.
    File(PathBuf),
}

impl Destination {
    /// As named on the command line.
    pub(crate) fn new(path: &Path) -> Self {
        if path.as_os_str() == "-" { Self::Stdout } else { Self::File(path.to_owned()) }
    }

    /// Whether both are one place, whatever they are called.
    pub(crate) fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::File(a), Self::File(b)) => a == b || resolved(a) == resolved(b),
            _ => self == other,
        }
    }
}

impl fmt::Display for Destination {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stdout => f.write_str("-"),
            Self::File(path) => path.display().fmt(f),
        }
    }
}

/// Without links and detours, as far as it exists.
fn resolved(path: &Path) -> PathBuf {
    let folder = || match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.canonicalize(),
        _ => Path::new(".").canonicalize(),
    };
    let beside = || Some(folder().ok()?.join(path.file_name()?));
    path.canonicalize().ok().or_else(beside).unwrap_or_else(|| path.to_owned())
}

/// A file to write, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Target {
    /// Where.
    pub(crate) destination: Destination,
    /// As what.
    pub(crate) format: Format,
    /// A folder to make first.
    pub(crate) folder: Option<PathBuf>,
}

/// The targets of each input, in order. Files in folders are named by their inputs and come in each of `formats`
/// (FOLD where that is empty).
///
/// # Errors
/// What cannot be done, and what was expected.
pub(crate) fn plan(inputs: &[Input], outputs: &[PathBuf], formats: &[Format]) -> Result<Vec<Vec<Target>>, String> {
    let folders = outputs.iter().filter(|path| is_folder(path)).count();
    if inputs.len() > 1
        && let Some(file) = outputs.iter().find(|path| !is_folder(path))
    {
        let count = inputs.len();
        return Err(format!(
            "{}: {count} inputs cannot go into one file; expected an existing folder or a path ending in /",
            file.display()
        ));
    }
    if !formats.is_empty() && folders == 0 {
        return Err("--format is for folders; the extension tells the format of a file".to_owned());
    }
    if folders > 0 {
        refuse_equal_stems(inputs)?;
    }
    if formats.contains(&Format::Html) {
        page::check().map_err(|error| format!("--format html: {error}"))?;
    }
    let formats = if formats.is_empty() { &[Format::Fold] } else { formats };
    let targets = |input: &Input| -> Result<Vec<Target>, String> {
        let mut targets = Vec::new();
        for output in outputs {
            if is_folder(output) {
                targets.extend(formats.iter().map(|format| in_folder(output, input, *format)));
            } else {
                targets.push(file(output)?);
            }
        }
        refuse_equal_targets(&targets)?;
        Ok(targets)
    };
    inputs.iter().map(targets).collect()
}

fn is_folder(path: &Path) -> bool {
    path.as_os_str() != "-" && (path.is_dir() || path.to_string_lossy().ends_with(std::path::is_separator))
}

/// What a film or a contact sheet is written to: a file for the one input there is, beside its `targets`.
///
/// # Errors
/// What cannot be done, and what was expected.
pub(crate) fn plan_drawing(
    inputs: &[Input],
    targets: &mut [Vec<Target>],
    option: &str,
    path: &Path,
    format: Format,
) -> Result<(), String> {
    let [targets] = targets else {
        return Err(format!("{option} takes one input; expected it without the other {}", inputs.len() - 1));
    };
    if is_folder(path) || path.as_os_str() == "-" {
        return Err(format!("{}: expected the path of a file for {option}", path.display()));
    }
    if format == Format::Contact {
        refuse_other_than_png(option, path)?;
    }
    // Pictures with numbers go into a folder of their own more often than not: it is made.
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.is_dir());
    let folder = folder.filter(|_| format == Format::Film && Format::of(path) == Ok(Format::Png)).map(Path::to_owned);
    if folder.is_none() {
        refuse_missing_folder(path)?;
    }
    targets.push(Target { destination: Destination::new(path), format, folder });
    refuse_equal_targets(targets)
}

/// Whether the extension is that of a picture.
///
/// # Errors
/// That it is not.
pub(crate) fn refuse_other_than_png(option: &str, path: &Path) -> Result<(), String> {
    match Format::of(path) {
        Ok(Format::Png) => Ok(()),
        _ => Err(format!("{}: expected a path ending in .png for {option}", path.display())),
    }
}

fn in_folder(folder: &Path, input: &Input, format: Format) -> Target {
    let name = format!("{}.{}", input.stem(), format.extension());
    Target { destination: Destination::File(folder.join(name)), format, folder: Some(folder.to_owned()) }
}

fn file(path: &Path) -> Result<Target, String> {
    let destination = Destination::new(path);
    let format = match destination {
        Destination::Stdout => Format::Fold,
        Destination::File(_) => Format::of(path)?,
    };
    refuse_missing_folder(path)?;
    Ok(Target { destination, format, folder: None })
}

/// Whether the folder that `path` lies in is there.
///
/// # Errors
/// That it is not.
pub(crate) fn refuse_missing_folder(path: &Path) -> Result<(), String> {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            Err(format!("{}: there is no folder {}; expected an existing one", path.display(), folder.display()))
        }
        _ => Ok(()),
    }
}

fn refuse_equal_stems(inputs: &[Input]) -> Result<(), String> {
    let mut seen: HashMap<String, &Input> = HashMap::new();
    for input in inputs {
        if let Some(other) = seen.insert(input.stem(), input) {
            let stem = input.stem();
            return Err(format!("{other} and {input} would both be written as {stem}; expected different names"));
        }
    }
    Ok(())
}

fn refuse_equal_targets(targets: &[Target]) -> Result<(), String> {
    for (i, target) in targets.iter().enumerate() {
        if targets[..i].iter().any(|other| other.destination.is(&target.destination)) {
            return Err(format!("{} is named twice as an output; expected different ones", target.destination));
        }
    }
    Ok(())
}
