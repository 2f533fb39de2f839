//! What is refused before any work.

use std::path::Path;

use origami::picture::Image;

use super::{Style, contact};

/// Whether a picture may be so large.
///
/// # Errors
/// That it may not, and what was expected.
pub(crate) fn check_size([width, height]: [u32; 2]) -> Result<(), String> {
    let pixels = u64::from(width) * u64::from(height);
    if width.max(height) > Image::LONGEST || pixels > Image::MOST {
        let (side, million) = (Image::LONGEST, Image::MOST / 1_000_000);
        return Err(format!(
            "{width} x {height} pixels are too many; expected at most {side} a side and {million} million in all"
        ));
    }
    Ok(())
}

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
