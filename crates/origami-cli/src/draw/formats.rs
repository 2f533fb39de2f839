//! Which format is drawn by what.

use std::io::Write;

use origami::picture::{MarkKind, Marks};
use origami::{CreasePattern, Error};

use super::contact::contact;
use super::still::{glb, marked_png, pattern_png, png, svg};
use super::{Artist, Faults, Subject};
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
        Format::Svg => svg(artist, pattern, &Marks::default(), writer),
        _ => pattern_png(artist, pattern, writer),
    }
}

/// The same with its faults marked.
///
/// # Errors
/// As [`pattern`].
pub(crate) fn faulty_pattern(
    format: Format,
    artist: &Artist,
    pattern: &CreasePattern,
    faults: &Faults<'_>,
    writer: &mut dyn Write,
) -> Result<(), Error> {
    let marks = match faults {
        Faults::None => Marks::default(),
        Faults::Found => Marks::of(pattern),
        Faults::Refused { open_ends, blamed, .. } => {
            let ends = open_ends.iter().map(|at| (MarkKind::OpenEnd, *at));
            Marks { at: ends.chain(blamed.iter().map(|at| (MarkKind::Refusal, *at))).collect() }
        }
    };
    let caption = if let Faults::Refused { why, .. } = faults { why } else { "" };
    match format {
        Format::Svg => svg(artist, pattern, &marks, writer),
        _ if marks.is_empty() && caption.is_empty() => pattern_png(artist, pattern, writer),
        _ => marked_png(artist, pattern, (&marks, caption), writer),
    }
}
