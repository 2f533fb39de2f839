//! CP, as ORIPA, Orihime, Oriedita and CP Editor read it: a line a crease, `type x1 y1 x2 y2`.

use std::io::{BufWriter, Write};

use origami_core::error::Warning;
use origami_core::{CreasePattern, Error};

use super::strokes::{Kind, Stroke};
use super::{Options, Plain, lost, unwritable};

/// Writes a pattern as CP: borders and cuts as type 1, mountains 2, valleys 3, all else 4. Coordinates are the file's, with
/// all their digits. Lines end where others meet them, unless the options want them joined.
///
/// Returns what the format cannot hold: fold angles, hinges that nothing drives, and what only FOLD has.
///
/// # Errors
/// [`Error::Invalid`] for a pattern that is not flat; [`Error::Io`] with path `-` if writing fails.
pub fn cp(pattern: &CreasePattern, options: &Options, writer: impl Write) -> Result<Vec<Warning>, Error> {
    let strokes = options.strokes(pattern, false)?;
    let mut writer = BufWriter::new(writer);
    for Stroke { ends: [a, b], kind, .. } in &strokes {
        let [x1, y1, x2, y2] = [a.x, a.y, b.x, b.y].map(Plain);
        writeln!(writer, "{} {x1} {y1} {x2} {y2}", number(*kind)).map_err(unwritable)?;
    }
    writer.flush().map_err(unwritable)?;
    let of = |kind| strokes.iter().filter(|stroke| stroke.kind == kind).count();
    let angles = lost::lost(
        "CP",
        lost::angled(&strokes),
        "line loses its",
        "lines lose their",
        "fold angle, which it cannot hold: read again, mountains and valleys fold all the way; SVG and FOLD can",
    );
    let cuts = lost::lost("CP", of(Kind::Cut), "cut is", "cuts are", "written as borders, since it knows no cuts");
    let free = lost::lost(
        "CP",
        of(Kind::Undriven),
        "line that nothing drives is",
        "lines that nothing drives are",
        "written as flat creases, since it knows no others",
    );
    Ok(angles.into_iter().chain(cuts).chain(free).chain(lost::of_ours("CP", pattern)).collect())
}

fn number(kind: Kind) -> u8 {
    match kind {
        Kind::Boundary | Kind::Cut => 1,
        Kind::Mountain => 2,
        Kind::Valley => 3,
        Kind::Flat | Kind::Undriven => 4,
    }
}
