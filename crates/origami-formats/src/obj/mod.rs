//! Wavefront OBJ: a sheet of faces, in space or flat, with lines for creases.
//!
//! OBJ has no letters. A line (`l`) has that of the name of its material, group or object, or else that of the colour of its
//! ends ([`crate::Colours`]); a line that Freeform Origami wrote (`#e`) has its own. Without any, letters and fold angles
//! follow from the shape. Where texture coordinates are the flat sheet, they are the pattern and the shape is its folded form.

mod sheet;
mod statements;

use origami_core::error::{Error, ErrorCode, Place};
use origami_core::fold::Document;

use crate::{Options, text};

/// Reads an OBJ file.
///
/// # Errors
/// [`Error::Invalid`] with the number of the line whose numbers are none or whose vertex does not exist, and for a file
/// without faces and lines.
pub fn read(bytes: &[u8], options: &Options) -> Result<Document, Error> {
    let text = text::decode(bytes);
    let obj = statements::read(&text, &options.colours)?;
    if obj.faces.is_empty() && obj.lines.is_empty() {
        let place = Place::Line { line: 1, column: None };
        let (problem, expected) = ("an OBJ file without faces (f) and lines (l)", "a sheet of faces, or lines");
        return Err(Error::new(ErrorCode::NoLines, place, problem, expected));
    }
    Ok(sheet::document(obj))
}

/// What a file says, indices from 0.
#[derive(Debug, Default)]
struct Obj {
    vertices: Vec<glam::DVec3>,
    /// The vertices' texture coordinates, where each has one and no other.
    texture: Option<Vec<glam::DVec2>>,
    faces: Vec<Vec<u32>>,
    /// Where each face was written.
    faces_at: Vec<usize>,
    lines: Vec<Line>,
    warnings: Vec<origami_core::Warning>,
}

/// A crease.
#[derive(Debug)]
struct Line {
    ends: [u32; 2],
    letter: Option<&'static str>,
    /// Where it was written.
    at: usize,
}
