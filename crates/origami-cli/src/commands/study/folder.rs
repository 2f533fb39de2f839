//! The folder of a study or an analysis. They take minutes: what cannot be written is found before.

use std::fs::{self, OpenOptions};
use std::io;
use std::path::Path;

/// Written and removed again, to see whether that can be done.
const PROBE: &str = ".origami.part";

/// Refuses what can be no folder, before any work.
///
/// # Errors
/// That something else is there.
pub(in crate::commands) fn check(folder: &Path) -> Result<(), String> {
    if folder.as_os_str() == "-" || (folder.exists() && !folder.is_dir()) {
        return Err(format!("{}: is no folder; expected one, or a path where one can be made", folder.display()));
    }
    Ok(())
}

/// Makes it where it is missing, and tries to write to it.
///
/// # Errors
/// What the system says.
pub(in crate::commands) fn make(folder: &Path, document: &str) -> Result<(), String> {
    let told = |error: io::Error| format!("{}: {error}", folder.display());
    fs::create_dir_all(folder).map_err(told)?;
    let document = folder.join(document);
    if document.is_dir() {
        return Err(format!("{}: is a folder; expected a file or nothing there", document.display()));
    }
    let probe = folder.join(PROBE);
    OpenOptions::new().write(true).create(true).truncate(false).open(&probe).map_err(told)?;
    fs::remove_file(&probe).map_err(told)
}
