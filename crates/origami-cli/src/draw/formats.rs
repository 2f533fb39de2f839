//! Which format is drawn by what.

use std::io::Write;

use origami::{CreasePattern, Error};

use super::contact::contact;
use super::still::{glb, pattern_png, png, svg};
use super::{Artist, Subject};
use crate::files::Format;

/// Draws a folded sheet: its last state as PNG, all of them as glTF (so many a second) or on a contact sheet.
///
/// # Errors
/// [`Error::Invalid`] for a format that draws no folded sheet, and whatever drawing and writing say.
pub(crate) fn sheet(
    format: Format,
    artist: &Artist,
    subject: Subject<'_>,
    fps: Option<u16>,
    writer: &mut dyn Write,
) -> Result<(), Error> {
    match format {
        Format::Png => png(artist, subject, writer),
        Format::Glb => glb(artist, subject, fps, writer),
        Format::Contact => contact(artist, subject, writer),
        _ => Err(Error::invalid("format", "draws no folded sheet", "PNG, glTF or a contact sheet")),
    }
}

/// Draws the flat crease pattern, as SVG or else as PNG.
///
/// # Errors
/// [`Error::Invalid`] for a pattern that is not flat, and whatever drawing and writing say.
pub(crate) fn pattern(
    format: Format,
    artist: &Artist,
    pattern: &CreasePattern,
    writer: &mut dyn Write,
) -> Result<(), Error> {
    match format {
        Format::Svg => svg(artist, pattern, writer),
        _ => pattern_png(artist, pattern, writer),
    }
}
