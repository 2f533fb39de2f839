//! What is refused before any work.

use std::path::Path;

use super::{Style, contact};
use crate::args::check_size;

/// Whether a contact sheet of so many states may be as large as it gets.
///
/// # Errors
/// As for [`check_size`].
pub(crate) fn check_contact(style: &Style, states: usize) -> Result<(), String> {
    let states = u32::try_from(states).unwrap_or(u32::MAX);
    check_size(contact::extent(style, states.saturating_add(1)))
        .map_err(|problem| format!("--sheet: {problem}; fewer --frames or a smaller --size may do"))
}

/// Whether this names a film.
///
/// # Errors
/// What is wrong with the extension.
pub(crate) fn check_film(path: &Path) -> Result<(), String> {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    if ["apng", "gif", "png"].contains(&extension.as_str()) && path.file_stem().is_some() {
        return Ok(());
    }
    Err(format!("{}: no film is written as this; expected a path ending in .apng, .gif or .png", path.display()))
}
