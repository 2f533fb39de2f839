//! SVG for plotters, cutters and drawing programs, which `svg::read` takes back.

use std::io::{self, BufWriter, Write};

use origami_core::error::Warning;
use origami_core::{CreasePattern, Error};

use super::page::{Length, Unit, extent};
use super::strokes::{Kind, Stroke};
use super::{Options, Plain, lost, unwritable};

/// The width of a sheet of which nothing else is said: the field's most common paper.
const WIDTH: Length = Length { number: 150.0, unit: Unit::Millimetre };
/// The width of lines, as a share of the sheet's longer side.
const LINE: f64 = 2e-3;
/// What is left empty around the sheet, as a share of its longer side.
const MARGIN: f64 = 0.01;

/// Writes a pattern as SVG: a group for each kind of line, with its name for an id (`boundary`, `cut`, `mountain`, `valley`,
/// `flat`, `undriven`), which Inkscape shows as a layer. Colours are the field's (black, green, red, blue, yellow, magenta);
/// the opacity of mountains and valleys is their fold angle as a share of 180 degrees.
///
/// Coordinates are the file's, with all their digits, y negated since SVG's points down; `width` and `height` make the sheet
/// as wide as asked for, or 150 mm. Pieces of one line are one line, unless the options want them apart.
///
/// Returns what the format cannot hold: angles past 180 degrees and against their letter, and what only FOLD has.
///
/// # Errors
/// [`Error::Invalid`] for a pattern that is not flat; [`Error::Io`] with path `-` if writing fails.
pub fn svg(pattern: &CreasePattern, options: &Options, writer: impl Write) -> Result<Vec<Warning>, Error> {
    let strokes = options.strokes(pattern, true)?;
    write(&strokes, options.width.unwrap_or(WIDTH), BufWriter::new(writer)).map_err(unwritable)?;
    let odd = strokes.iter().filter(|stroke| opacity(stroke).is_none()).count();
    let odd = lost::lost(
        "SVG",
        odd,
        "line loses its",
        "lines lose their",
        "fold angle: it is past 180 degrees, against its letter, or not there, and opacity cannot hold it; FOLD can",
    );
    Ok(odd.into_iter().chain(lost::of_ours("SVG", pattern)).collect())
}

fn write(strokes: &[Stroke], paper: Length, mut writer: impl Write) -> io::Result<()> {
    let (low, high) = extent(strokes.iter().flat_map(|stroke| stroke.ends));
    let size = (high - low).max_element();
    let size = if size > 0.0 { size } else { 1.0 };
    let margin = MARGIN * size;
    let box_size = high - low + 2.0 * margin;
    // A pattern that is a line from below to above has no width of its own.
    let width = if high.x > low.x { high.x - low.x } else { size };
    let [across, down] = [box_size.x, box_size.y].map(|side| side / width * paper.number);
    let unit = paper.unit.name();
    writeln!(writer, r#"<?xml version="1.0" encoding="UTF-8"?>"#)?;
    writeln!(
        writer,
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" width="{}{unit}" height="{}{unit}" viewBox="{} {} {} {}" fill="none" stroke-width="{}" stroke-linecap="round">"#,
        Plain(across),
        Plain(down),
        Plain(low.x - margin),
        Plain(-high.y - margin),
        Plain(box_size.x),
        Plain(box_size.y),
        Plain(LINE * size),
    )?;
    for kind in Kind::ALL {
        if !strokes.iter().any(|stroke| stroke.kind == kind) {
            continue;
        }
        let (name, colour) = (kind.name(), colour(kind));
        writeln!(writer, r#"<g id="{name}" inkscape:groupmode="layer" inkscape:label="{name}" stroke="{colour}">"#)?;
        for stroke in strokes.iter().filter(|stroke| stroke.kind == kind) {
            let [x1, y1, x2, y2] = stroke.ends.map(|end| [end.x, -end.y]).concat()[..] else { continue };
            let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(Plain);
            write!(writer, r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}""#)?;
            match opacity(stroke) {
                Some(share) if share < 1.0 => writeln!(writer, r#" stroke-opacity="{}"/>"#, Plain(share))?,
                _ => writeln!(writer, "/>")?,
            }
        }
        writeln!(writer, "</g>")?;
    }
    writeln!(writer, "</svg>")?;
    writer.flush()
}

/// The field's.
fn colour(kind: Kind) -> &'static str {
    match kind {
        Kind::Boundary => "#000000",
        Kind::Cut => "#00ff00",
        Kind::Mountain => "#ff0000",
        Kind::Valley => "#0000ff",
        Kind::Flat => "#ffff00",
        Kind::Undriven => "#ff00ff",
    }
}

/// How opaque a line is; `None` where that cannot say how it folds.
fn opacity(stroke: &Stroke) -> Option<f64> {
    let towards = match (stroke.kind, stroke.angle) {
        (Kind::Mountain, angle) => -angle?,
        (Kind::Valley, angle) => angle?,
        (Kind::Flat, Some(angle)) if angle != 0.0 => return None,
        _ => return Some(1.0),
    };
    (0.0..=180.0).contains(&towards).then_some(towards / 180.0)
}
