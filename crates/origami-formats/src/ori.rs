//! ORI, Oriedita's own files: JSON with `lineSegments`, whose colours are letters.
//!
//! Colours are read as Oriedita itself writes FOLD: black is the border, red a mountain, blue a valley, and the others stay
//! flat. Auxiliary lines (`auxLineSegments`), circles, texts and points are left out, as they are there.

use glam::DVec2;
use origami_core::error::{Error, ErrorCode, Place};
use origami_core::fold::Document;
use serde_json::{Map, Value};

use crate::lines::Lines;
use crate::{number, text};

const SEGMENTS: &str = "lineSegments";
/// What is no crease, and what is said of it.
const LEFT_OUT: [(&str, &str); 4] = [
    ("auxLineSegments", "an auxiliary line; left out"),
    ("circles", "a circle; left out"),
    ("texts", "a text; left out"),
    ("points", "a point; left out"),
];

/// Reads an ORI file.
///
/// # Errors
/// [`Error::Invalid`] with the line and column where it is no JSON, and with the entry of `lineSegments` that is no line.
pub fn read(bytes: &[u8]) -> Result<Document, Error> {
    let text = text::decode(bytes);
    let project: Value = serde_json::from_str(text.trim_start_matches('\u{feff}')).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        let problem = format!("not JSON: {error}").replace(&format!(" at line {line} column {column}"), "");
        Error::new(ErrorCode::NotJson, Place::Line { line, column: Some(column) }, problem, "a project of Oriedita")
    })?;
    let segments = project.get(SEGMENTS).and_then(Value::as_array).ok_or_else(|| {
        let (place, expected) = (Place::key(SEGMENTS), "an array of line segments, as in a project of Oriedita");
        Error::new(ErrorCode::MissingKey, place, "is missing or no array", expected)
    })?;
    let mut lines = Lines::default();
    lines.about("file_creator", "Oriedita");
    // `_` is what Oriedita writes for none.
    lines.about(
        "frame_title",
        project.get("title").and_then(Value::as_str).filter(|title| *title != "_").unwrap_or_default(),
    );
    for (index, segment) in segments.iter().enumerate() {
        line(segment, index, &mut lines)?;
    }
    for (key, message) in LEFT_OUT {
        for index in 0..project.get(key).and_then(Value::as_array).map_or(0, Vec::len) {
            lines.left_out(|| Place::entry(key, index), message);
        }
    }
    Ok(lines.into_document())
}

fn line(segment: &Value, index: usize, lines: &mut Lines) -> Result<(), Error> {
    let place = || Place::entry(SEGMENTS, index);
    let wrong = |problem: &str, expected| Err(Error::new(ErrorCode::WrongType, place(), problem, expected));
    let Some(segment) = segment.as_object() else { return wrong("is no object", "a line with a, b and color") };
    let ends = [end(segment, "a", place)?, end(segment, "b", place)?];
    match segment.get("color").and_then(Value::as_str).and_then(letter) {
        Some(letter) => lines.push(ends, letter, None, format!("{SEGMENTS}[{index}]")),
        None if segment.get("color").is_some_and(|color| color == "NONE" || color == "ANGLE") => {
            lines.left_out(place, "a line without a colour; left out");
        }
        None => {
            let shown =
                segment.get("color").map_or_else(|| "nothing".to_owned(), |color| text::quoted(&color.to_string()));
            return wrong(&format!("has {shown} for a color"), "a color of Oriedita, such as RED_1");
        }
    }
    Ok(())
}

/// FOLD's letter for a colour, which Oriedita writes by name and number.
fn letter(color: &str) -> Option<&'static str> {
    match color.rsplit('_').next()?.parse().ok()? {
        0 => Some("B"),
        1 => Some("M"),
        2 => Some("V"),
        3..=9 => Some("F"),
        _ => None,
    }
}

/// An end, written as `"x,y"`; in an object or array too, for whoever writes the format by hand.
fn end(segment: &Map<String, Value>, key: &'static str, place: impl Fn() -> Place) -> Result<DVec2, Error> {
    let refuse = |problem| Err(Error::new(ErrorCode::WrongType, place(), problem, "\"x,y\""));
    let [x, y] = match segment.get(key) {
        Some(Value::String(text)) => match text.split(',').collect::<Vec<_>>().as_slice() {
            [x, y] => [x.trim().to_owned(), y.trim().to_owned()],
            _ => return refuse(format!("has {} for {key}", text::quoted(text))),
        },
        Some(Value::Array(numbers)) if numbers.len() == 2 => [numbers[0].to_string(), numbers[1].to_string()],
        Some(Value::Object(point)) => {
            ["x", "y"].map(|key| point.get(key).map_or_else(|| "0".to_owned(), Value::to_string))
        }
        Some(_) => return refuse(format!("has no text for {key}")),
        None => return refuse(format!("has no {key}")),
    };
    let coordinate = |word: &str, of| number::finite(word, &place, &format!("{of} of {key}"));
    Ok(DVec2::new(coordinate(&x, "x")?, coordinate(&y, "y")?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn project(segments: &str, more: &str) -> Result<Document, String> {
        let text = format!(r#"{{"@version":"v1.1","lineSegments":[{segments}],"title":"_"{more}}}"#);
        read(text.as_bytes()).map_err(|error| error.to_string())
    }

    fn segment(color: &str) -> String {
        format!(r#"{{"a":"0.0,-1.0E1","b":"2.5, 3","active":"INACTIVE_0","color":"{color}","customized":0}}"#)
    }

    #[test]
    fn colours_are_letters() {
        let colors = ["BLACK_0", "RED_1", "BLUE_2", "CYAN_3", "ORANGE_4", "OTHER_9", "NONE"];
        let document = project(&colors.map(segment).join(","), "").expect("ORI");
        let frame = &document.key_frame;
        assert_eq!(frame.edges_assignment.as_ref().expect("letters").concat(), "BMVFFF");
        let at: Vec<_> = frame.vertices_coords.iter().flatten().map(|c| c.position.truncate().to_array()).collect();
        assert_eq!(at, [[0.0, -10.0], [2.5, 3.0]]);
        assert_eq!(document.warnings[0].to_string(), "lineSegments[6]: a line without a colour; left out");
        assert!(!frame.extra.contains_key("frame_title"), "_ is no title");
    }

    #[test]
    fn what_is_no_crease_is_counted() {
        let more = r#","circles":[{},{}],"texts":[{}],"auxLineSegments":[{},{},{}],"points":[]"#;
        let document = project(&segment("RED_1"), more).expect("ORI");
        let told: Vec<_> = document.warnings.iter().map(ToString::to_string).collect();
        assert_eq!(
            told,
            [
                "auxLineSegments[0]: an auxiliary line; left out (and 2 more)",
                "circles[0]: a circle; left out (and 1 more)",
                "texts[0]: a text; left out",
            ]
        );
    }

    #[test]
    fn errors_name_the_segment() {
        for (segment, told) in [
            (r#"{"a":"0,0","b":"1","color":"RED_1"}"#, "lineSegments[0]: has \"1\" for b; expected \"x,y\""),
            (r#"{"a":"0,0","color":"RED_1"}"#, "lineSegments[0]: has no b; expected \"x,y\""),
            (
                r#"{"a":"0,NaN","b":"1,1","color":"RED_1"}"#,
                "lineSegments[0]: \"NaN\" is not finite; expected a number for y of a",
            ),
            (r#"{"a":"0,0","b":"1,1","color":"PINK"}"#, "lineSegments[0]: has \"\"PINK\"\" for a color"),
            (r#"{"a":"0,0","b":"1,1"}"#, "lineSegments[0]: has nothing for a color"),
            ("7", "lineSegments[0]: is no object"),
            ("{", "line 1 column "),
        ] {
            let error = project(segment, "").expect_err(segment);
            assert!(error.starts_with(told), "{segment}: {error}");
        }
    }
}
