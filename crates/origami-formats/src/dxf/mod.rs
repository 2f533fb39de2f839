//! DXF as text, as CAD programs, ORIPA and Oriedita write it: lines, polylines, arcs, circles, ellipses and splines.
//!
//! The letter of an entity is that of its layer's name (`MountainLine`, `valley`), or else of its colour: by the rules for
//! index colours (`docs/FORMATS.md`) and [`Colours`](crate::Colours) for true ones. y is up, as in FOLD.
//!
//! The reader is our own: text in pairs is simple, and the crate `dxf` brings 25 others, of which one decodes pictures.

mod entities;
mod letters;
mod pairs;
mod shapes;

use origami_core::error::{Error, ErrorCode, Place};
use origami_core::fold::Document;

use crate::{Options, curves, text};

/// Reads a DXF file.
///
/// # Errors
/// [`Error::Invalid`] with the line where a group code or a number is none, and for a file in which nothing is drawn.
pub fn read(bytes: &[u8], options: &Options) -> Result<Document, Error> {
    let text = text::decode(bytes);
    let drawing = entities::read(&text, &options.colours)?;
    if drawing.strokes.is_empty() {
        let (problem, expected) = ("no line of a crease pattern is drawn", "lines, polylines, arcs or splines");
        return Err(Error::new(ErrorCode::NoLines, Place::Line { line: 1, column: None }, problem, expected));
    }
    let mut document = curves::lines(drawing.strokes, options.curve_tolerance)?.into_document();
    document.warnings.splice(0..0, drawing.odd.into_document().warnings);
    Ok(document)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of these entities, each of pairs that are given in one line.
    fn drawing(entities: &[&str]) -> Result<Document, String> {
        let head = "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 hidden 62 -1 0 LAYER 2 blue 62 5 0 ENDTAB 0 ENDSEC";
        let all = format!("{head} 0 SECTION 2 ENTITIES {} 0 ENDSEC 0 EOF", entities.join(" "));
        let text: String = all.split(' ').flat_map(|word| [word, "\r\n"]).collect();
        read(text.as_bytes(), &Options::default()).map_err(|error| error.to_string())
    }

    fn letters(document: &Document) -> String {
        document.key_frame.edges_assignment.as_ref().expect("letters").concat()
    }

    fn points(document: &Document) -> Vec<[f64; 2]> {
        document.key_frame.vertices_coords.iter().flatten().map(|c| [c.position.x, c.position.y]).collect()
    }

    #[test]
    fn letters_come_from_layers_and_colours() {
        let ends = "10 0 20 0 11 1 21 2.5";
        let line = |about: &str| format!("0 LINE {about} {ends}");
        let all = ["8 MountainLine 62 5", "8 0 62 5", "8 blue", "8 0 62 7", "8 0 62 3 420 16711680", "8 0", "8 hidden"]
            .map(line);
        let document = drawing(&all.each_ref().map(String::as_str)).expect("DXF");
        assert_eq!(letters(&document), "MVVBMU");
        assert_eq!(points(&document), [[0.0, 0.0], [1.0, 2.5]]);
        let told: Vec<String> = document.warnings.iter().map(ToString::to_string).collect();
        assert!(told[0].ends_with("neither layer nor colour says what this line is; taken as unassigned"), "{told:?}");
        assert!(told[1].ends_with("an entity of a layer that is hidden; left out"), "{told:?}");
    }

    #[test]
    fn polylines_of_both_kinds_close_and_bulge() {
        let square = "10 0 20 0 10 1 20 0 10 1 20 1 10 0 20 1";
        let document = drawing(&[&format!("0 LWPOLYLINE 8 border 90 4 70 1 {square}")]).expect("DXF");
        assert_eq!((letters(&document).as_str(), points(&document).len()), ("BBBB", 4));
        let old = "0 POLYLINE 8 cut 66 1 70 0 0 VERTEX 10 0 20 0 0 VERTEX 10 2 20 0 42 1 0 VERTEX 10 2 20 2 0 SEQEND";
        let document = drawing(&[old]).expect("DXF");
        // A half circle about (2, 1), to the right of the way up.
        let on_circle = |p: &&[f64; 2]| p[0] > 2.0 + 1e-9;
        let points = points(&document);
        assert!(points.iter().filter(on_circle).count() > 5, "{points:?}");
        for [x, y] in points.iter().filter(on_circle) {
            assert!(((x - 2.0).hypot(y - 1.0) - 1.0).abs() < 1e-6, "{x} {y}");
        }
    }

    #[test]
    fn arcs_that_were_drawn_on_the_back_are_turned() {
        let document = drawing(&["0 ARC 8 valley 10 5 20 0 40 1 50 0 51 90 210 0 220 0 230 -1"]).expect("DXF");
        assert!(points(&document).iter().all(|[x, y]| ((x + 5.0).hypot(*y) - 1.0).abs() < 1e-6 && *x < -5.0 + 1e-9));
    }

    #[test]
    fn what_is_no_line_is_told_and_errors_name_the_line() {
        let document =
            drawing(&["0 LINE 8 M 10 0 20 0 11 1 21 1", "0 TEXT 8 0 1 crane", "0 INSERT 2 block", "0 TEXT 8 0 1 x"]);
        let told: Vec<String> = document.expect("DXF").warnings.iter().map(ToString::to_string).collect();
        assert_eq!(told, ["line 42: a text; left out (and 1 more)", "line 48: a block that is inserted; left out"]);
        let told = drawing(&["0 LINE 8 M 10 0 20 l 11 1 21 1"]).expect_err("a letter");
        assert_eq!(told, "line 36: \"l\" is no number; expected a number for group 20");
        assert!(
            drawing(&["0 LINE 8 M 10 0"]).expect_err("cut off").ends_with("has no group 20; expected a coordinate")
        );
        assert!(
            drawing(&["0 CIRCLE 8 M 10 0 20 0 40 0"]).expect_err("nothing").contains("no line of a crease pattern")
        );
        assert!(read(b"0\nSECTION\nx\n", &Options::default()).expect_err("odd").to_string().starts_with("line 3: "));
    }
}
