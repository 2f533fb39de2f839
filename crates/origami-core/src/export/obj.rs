//! Wavefront OBJ: the faces of the pattern, with texture coordinates from the flat sheet.

use std::io::{self, BufWriter, Write};

use glam::DVec3;

use super::{CREATOR, texture_coordinates, unwritable};
use crate::error::{Error, ErrorCode, Place};
use crate::ids::VertexId;
use crate::pattern::CreasePattern;

/// Writes `positions`, one for each vertex of the pattern, as a Wavefront OBJ file.
///
/// Vertices and faces are those of the pattern, in its order. On a flat pattern (all z equal) each vertex has the texture
/// coordinates of its position on the unfolded sheet, which is scaled to fit the unit square, its aspect kept.
///
/// # Errors
/// [`Error::Invalid`] if the number of positions is not the number of vertices, or one is not finite; [`Error::Io`] with
/// path `-` if writing fails.
pub fn write_obj(writer: impl Write, pattern: &CreasePattern, positions: &[DVec3]) -> Result<(), Error> {
    if positions.len() != pattern.vertices.len() {
        let problem = format!("{} positions for {} vertices", positions.len(), pattern.vertices.len());
        return Err(Error::new(ErrorCode::WrongLength, "OBJ", problem, "as many as the pattern has"));
    }
    if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
        let place = Place::Vertices(vec![VertexId::new(vertex)]);
        return Err(Error::new(ErrorCode::NotFinite, place, positions[vertex].to_string(), "a finite position"));
    }
    write(BufWriter::new(writer), pattern, positions).map_err(unwritable)
}

fn write(mut writer: impl Write, pattern: &CreasePattern, positions: &[DVec3]) -> io::Result<()> {
    writeln!(writer, "# {CREATOR}")?;
    for vertex in 0..positions.len() {
        let alias = pattern.alias_of.get(vertex).copied().flatten();
        let DVec3 { x, y, z } = positions[alias.map_or(vertex, |alias| alias.index())];
        writeln!(writer, "v {x:?} {y:?} {z:?}")?;
    }
    let texture = texture_coordinates(&pattern.vertices);
    for [u, v] in texture.iter().flatten() {
        writeln!(writer, "vt {u:?} {v:?}")?;
    }
    for face in &pattern.faces {
        writer.write_all(b"f")?;
        for corner in face {
            // OBJ counts from 1.
            let corner = u64::from(corner.0) + 1;
            match texture {
                Some(_) => write!(writer, " {corner}/{corner}")?,
                None => write!(writer, " {corner}")?,
            }
        }
        writeln!(writer)?;
    }
    writer.flush()
}
