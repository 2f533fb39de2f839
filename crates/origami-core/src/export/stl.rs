//! Binary STL: the triangles that were simulated.

use std::io::{self, BufWriter, Write};

use glam::{DVec3, Vec3};

use super::{CREATOR, unwritable};
use crate::error::{Error, ErrorCode};

/// Sizes at whose middle a sheet may lie from the origin: there 32 bits round its positions to a hundred thousandth of it.
const FAR: f64 = 100.0;
/// A sheet may not be smaller than this: products of such lengths are 0 in 32 bits.
const LEAST: f64 = 1e-18;

/// Writes a binary STL file: a header of 80 bytes, the number of triangles, and for each its normal and its corners
/// (32-bit floats, little-endian, in the unit of `positions`). Triangles without area have the normal 0.
///
/// Where the sheet lies so far from the origin (100 times its size) that 32 bits would make it ragged, the middle of its box
/// is moved to the origin. Returns by what all positions were moved, if they were: whoever asked for the file should know.
///
/// # Errors
/// [`Error::Invalid`] if a corner is not in `positions` or its position is not finite as a 32-bit float, if the sheet is
/// smaller than 1e-18, or if there are more triangles than the format can count; [`Error::Io`] with path `-` if writing fails.
pub fn write_stl(writer: impl Write, positions: &[DVec3], triangles: &[[u32; 3]]) -> Result<Option<DVec3>, Error> {
    let count = u32::try_from(triangles.len()).map_err(|_| {
        let (problem, expected) = (format!("{} triangles", triangles.len()), format!("at most {}", u32::MAX));
        Error::new(ErrorCode::TooManyEntries, "STL", problem, expected)
    })?;
    let moved = moved(positions, triangles)?;
    let by = moved.unwrap_or_default();
    for (index, triangle) in triangles.iter().enumerate() {
        for &corner in triangle {
            let (code, problem) = match positions.get(corner as usize) {
                Some(position) if (*position + by).as_vec3().is_finite() => continue,
                Some(position) => (ErrorCode::NotFinite, format!("a corner is at {position}")),
                None => (ErrorCode::NoSuchVertex, format!("corner {corner} of {} positions", positions.len())),
            };
            let expected = "corners at positions that are finite in 32 bits";
            return Err(Error::new(code, format!("triangle {index}"), problem, expected));
        }
    }
    let corners = triangles.iter().map(|triangle| triangle.map(|corner| positions[corner as usize] + by));
    write(BufWriter::new(writer), corners, count).map_err(unwritable)?;
    Ok(moved)
}

/// By what the corners are to be moved, where 32 bits cannot hold them as they lie.
fn moved(positions: &[DVec3], triangles: &[[u32; 3]]) -> Result<Option<DVec3>, Error> {
    let corners = || triangles.iter().flatten().filter_map(|corner| positions.get(*corner as usize));
    let (low, high) =
        corners().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)));
    let (middle, size) = (0.5 * low + 0.5 * high, (high - low).max_element());
    if size > 0.0 && size < LEAST {
        let expected = format!("at least {LEAST:e}, which 32 bits can hold");
        return Err(Error::new(ErrorCode::SheetSize, "STL", format!("the sheet is {size:e} large"), expected));
    }
    Ok((size > 0.0 && middle.is_finite() && middle.abs().max_element() > FAR * size).then_some(-middle))
}

fn write(mut writer: impl Write, triangles: impl Iterator<Item = [DVec3; 3]>, count: u32) -> io::Result<()> {
    // A reader takes a file that starts with "solid" for text.
    let header = format!("{:<80.80}", format!("binary STL, {CREATOR}"));
    writer.write_all(header.as_bytes())?;
    writer.write_all(&count.to_le_bytes())?;
    for [a, b, c] in triangles {
        let normal = (b - a).cross(c - a).normalize_or_zero();
        for Vec3 { x, y, z } in [normal, a, b, c].map(|vector| vector.as_vec3()) {
            for number in [x, y, z] {
                writer.write_all(&number.to_le_bytes())?;
            }
        }
        writer.write_all(&[0; 2])?;
    }
    writer.flush()
}
