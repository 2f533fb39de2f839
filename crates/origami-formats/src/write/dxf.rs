//! DXF for cutters and CAD programs: lines on layers, in the oldest form that all of them read (release 12, as text).
//!
//! The format's reference is Autodesk's; every item is a line with the number of its group and a line with its value. What is
//! written here is so little of it that a library would not make it shorter.

use std::fmt::Display;
use std::io::{self, BufWriter, Write};

use origami_core::error::Warning;
use origami_core::{CreasePattern, Error};

use super::page::{Length, extent};
use super::strokes::{Kind, Stroke};
use super::{Options, Plain, lost, unwritable};

/// Writes a pattern as DXF: a layer for each kind of line, named as in SVG (`boundary`, `cut`, `mountain`, `valley`, `flat`,
/// `undriven`) and of its colour. Coordinates are the file's, or scaled to the width that the options ask for, in whose unit
/// they then are. Pieces of one line are one line, unless the options want them apart.
///
/// Returns what the format cannot hold: fold angles, and what only FOLD has.
///
/// # Errors
/// [`Error::Invalid`] for a pattern that is not flat; [`Error::Io`] with path `-` if writing fails.
pub fn dxf(pattern: &CreasePattern, options: &Options, writer: impl Write) -> Result<Vec<Warning>, Error> {
    let strokes = options.strokes(pattern, true)?;
    write(&strokes, options.width, BufWriter::new(writer)).map_err(unwritable)?;
    let angles = lost::lost(
        "DXF",
        lost::angled(&strokes),
        "line loses its",
        "lines lose their",
        "fold angle, which it cannot hold; SVG and FOLD can",
    );
    Ok(angles.into_iter().chain(lost::of_ours("DXF", pattern)).collect())
}

fn write(strokes: &[Stroke], paper: Option<Length>, mut writer: impl Write) -> io::Result<()> {
    let (low, high) = extent(strokes.iter().flat_map(|stroke| stroke.ends));
    let width = high.x - low.x;
    let scale = paper.filter(|_| width > 0.0).map_or(1.0, |paper| paper.number / width);
    let mut put = |group: u8, value: &dyn Display| writeln!(writer, "{group}\n{value}");
    put(0, &"SECTION")?;
    put(2, &"HEADER")?;
    put(9, &"$ACADVER")?;
    put(1, &"AC1009")?;
    put(0, &"ENDSEC")?;
    put(0, &"SECTION")?;
    put(2, &"TABLES")?;
    put(0, &"TABLE")?;
    put(2, &"LAYER")?;
    put(70, &Kind::ALL.len())?;
    for kind in Kind::ALL {
        put(0, &"LAYER")?;
        put(2, &kind.name())?;
        put(70, &0)?;
        put(62, &colour(kind))?;
        put(6, &"CONTINUOUS")?;
    }
    put(0, &"ENDTAB")?;
    put(0, &"ENDSEC")?;
    put(0, &"SECTION")?;
    put(2, &"ENTITIES")?;
    for stroke in strokes {
        put(0, &"LINE")?;
        put(8, &stroke.kind.name())?;
        for (end, groups) in stroke.ends.iter().zip([[10, 20, 30], [11, 21, 31]]) {
            for (group, number) in groups.into_iter().zip([end.x * scale, end.y * scale, 0.0]) {
                put(group, &Plain(number))?;
            }
        }
    }
    put(0, &"ENDSEC")?;
    put(0, &"EOF")?;
    writer.flush()
}

/// The number of the field's colour in the format's own table; 7 is black on white, and white on black.
fn colour(kind: Kind) -> u8 {
    match kind {
        Kind::Boundary => 7,
        Kind::Cut => 3,
        Kind::Mountain => 1,
        Kind::Valley => 5,
        Kind::Flat => 2,
        Kind::Undriven => 6,
    }
}
