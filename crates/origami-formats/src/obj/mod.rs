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

#[cfg(test)]
mod tests {
    use origami_core::CreasePattern;
    use origami_core::pattern::{Assignment, PatternEdge};

    use super::*;

    fn document(text: &str) -> Document {
        read(text.as_bytes(), &Options::default()).unwrap_or_else(|error| panic!("{error}: {text}"))
    }

    fn pattern(text: &str) -> CreasePattern {
        CreasePattern::from_document(&document(text), 0).unwrap_or_else(|error| panic!("{error}: {text}"))
    }

    /// The creases, by letter and fold angle in degrees.
    fn creases(pattern: &CreasePattern) -> Vec<(&'static str, f64)> {
        let of = |edge: &PatternEdge| (edge.assignment.letter(), edge.fold_angle.unwrap_or(0.0).to_degrees());
        pattern
            .edges
            .iter()
            .filter(|edge| edge.assignment != Assignment::Boundary && edge.alias_of.is_none())
            .map(of)
            .collect()
    }

    const SQUARE: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

    #[test]
    fn names_and_colours_of_lines_are_letters() {
        let faces = "f 1 2 3\nf -4 -2 -1\n";
        for line in [
            "usemtl Mountain\nl 1 3\n",
            "g valley\nusemtl m.001\nl 3 1\n",
            "o sheet\ng MountainLine\nl 1/ 3\n",
            "#e 1 3 3 0\n",
        ] {
            assert_eq!(creases(&pattern(&format!("{SQUARE}{line}{faces}"))), [("M", -180.0)], "{line}");
        }
        let coloured = SQUARE.replace(" 0\n", " 0 0.0 0.0 1.0\n");
        assert_eq!(creases(&pattern(&format!("{coloured}{faces}l 1 3"))), [("V", 180.0)]);
        let table = Options { colours: "#00f=M".parse().expect("a table"), ..Options::default() };
        let told = read(format!("{coloured}{faces}l 1 3").as_bytes(), &table).expect("OBJ");
        assert_eq!(told.key_frame.edges_assignment.expect("letters").concat(), "M");
    }

    /// A sheet bent by 60 degrees, a valley, with the flat one as texture coordinates, half as large.
    const BENT: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1.5 0 0.8660254\nv 1.5 1 0.8660254\n\
        vt 0 0\nvt .5 0\nvt .5 .5\nvt 0 .5\nvt 1 0\nvt 1 .5\nf 1/1 2/2 3/3 4/4\nf 2/2 5/5 6/6 3/3\n";

    #[test]
    fn texture_coordinates_are_the_flat_sheet() {
        let document = document(BENT);
        assert_eq!(document.frames[0].classes, Some(vec!["foldedForm".to_owned()]));
        let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
        assert!(pattern.is_flat());
        assert!((pattern.vertices[5].x - 2.0).abs() < 1e-7 && (pattern.vertices[5].y - 1.0).abs() < 1e-7);
        let [(letter, angle)] = creases(&pattern)[..] else { panic!("one crease") };
        assert!(letter == "V" && (angle - 60.0).abs() < 1e-5, "{letter} {angle}");
        let below = BENT.replace("0.8660254", "-0.8660254");
        assert!(matches!(creases(&self::pattern(&below))[..], [("M", angle)] if (angle + 60.0).abs() < 1e-5));
    }

    #[test]
    fn other_texture_coordinates_leave_the_sheet_in_space() {
        let document = document(&BENT.replace("vt .5 .5", "vt .5 .9"));
        assert!(document.frames.is_empty());
        assert!(document.warnings[0].message.starts_with("texture coordinates that are no flat sheet"));
        let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
        assert!(!pattern.is_flat());
        // The core measures what the file does not say.
        assert!(
            matches!(creases(&pattern)[..], [(_, angle)] if (angle - 60.0).abs() < 1e-5),
            "{:?}",
            creases(&pattern)
        );
    }

    #[test]
    fn lines_without_faces_are_a_pattern() {
        let borders = "usemtl border\nl 1 2 3 4 1\nusemtl valley\nl 1 3\n";
        let pattern = pattern(&format!("{SQUARE}{borders}"));
        assert_eq!((pattern.faces.len(), creases(&pattern)), (2, vec![("V", 180.0)]));
        assert_eq!(&*pattern.sources[4], "line 8");
    }

    #[test]
    fn errors_name_the_line() {
        for (more, told) in [
            ("f 1 2 9", "line 5: vertex 9 does not exist; expected up to 4"),
            ("f 1 2 -5", "line 5: vertex -5 does not exist"),
            ("f 1 2 0", "line 5: vertex 0 does not exist"),
            ("f 1 2", "line 5: has 2 corners; expected 3 or more"),
            ("f 1 2 x", "line 5: \"x\" is no number of a vertex"),
            ("v 1 2 nan", "line 5: \"nan\" is not finite"),
            ("v 1 2", "line 5: a vertex of 2 numbers; expected v x y z"),
            ("f 1/7 2/1 3/1", "line 5: texture vertex 7 does not exist"),
            ("# nothing", "line 1: an OBJ file without faces (f) and lines (l)"),
            ("f 1 2 \\\n9", "line 5: vertex 9 does not exist"),
        ] {
            let error = read(format!("{SQUARE}{more}\n").as_bytes(), &Options::default()).expect_err(more);
            assert!(error.to_string().starts_with(told), "{more}: {error}");
        }
    }
}
