//! Binary STL: the triangles that were simulated.

use std::io::{self, BufWriter, Write};

use glam::{DVec3, Vec3};

use super::{CREATOR, unwritable};
use crate::error::{Error, ErrorCode};

/// Writes a binary STL file: a header of 80 bytes, the number of triangles, and for each its normal and its corners
/// (32-bit floats, little-endian, in the unit of `positions`). Triangles without area have the normal 0.
///
/// # Errors
/// [`Error::Invalid`] if a corner is not in `positions` or its position is not finite as a 32-bit float, or if there
/// are more triangles than the format can count; [`Error::Io`] with path `-` if writing fails.
pub fn write_stl(writer: impl Write, positions: &[DVec3], triangles: &[[u32; 3]]) -> Result<(), Error> {
    let count = u32::try_from(triangles.len()).map_err(|_| {
        let (problem, expected) = (format!("{} triangles", triangles.len()), format!("at most {}", u32::MAX));
        Error::new(ErrorCode::TooManyEntries, "STL", problem, expected)
    })?;
    for (index, triangle) in triangles.iter().enumerate() {
        for &corner in triangle {
            let (code, problem) = match positions.get(corner as usize) {
                Some(position) if position.as_vec3().is_finite() => continue,
                Some(position) => (ErrorCode::NotFinite, format!("a corner is at {position}")),
                None => (ErrorCode::NoSuchVertex, format!("corner {corner} of {} positions", positions.len())),
            };
            let expected = "corners at positions that are finite in 32 bits";
            return Err(Error::new(code, format!("triangle {index}"), problem, expected));
        }
    }
    write(BufWriter::new(writer), positions, triangles, count).map_err(unwritable)
}

fn write(mut writer: impl Write, positions: &[DVec3], triangles: &[[u32; 3]], count: u32) -> io::Result<()> {
    // A reader takes a file that starts with "solid" for text.
    let header = format!("{:<80.80}", format!("binary STL, {CREATOR}"));
    writer.write_all(header.as_bytes())?;
    writer.write_all(&count.to_le_bytes())?;
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| positions[corner as usize]);
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
