//! ORH, Orihime's own files: text in Japanese, sections between tags, a line an entry.
//!
//! The section 線分集合 (line segments) has for each line 番号 (its number), 色 (its colour, numbered as Oriedita's) and 座標
//! (the coordinates of its ends). Circles (円集合) are left out.

use glam::DVec2;
use origami_core::error::{Error, ErrorCode, Place};
use origami_core::fold::Document;

use crate::lines::Lines;
use crate::{number, text};

const SEGMENTS: &str = "<線分集合>";
const CIRCLES: &str = "<円集合>";
const TITLE: &str = "<タイトル>";
const NUMBER: &str = "番号";
const COLOUR: &str = "色";
const COORDINATES: &str = "座標";

/// Whether text in Orihime's encodings has a section of lines.
pub(crate) fn is_orh(bytes: &[u8]) -> bool {
    text::decode_japanese(bytes).contains(SEGMENTS)
}

/// Reads an ORH file.
///
/// # Errors
/// [`Error::Invalid`] with the number of the line that has no four finite numbers, or no colour.
pub fn read(bytes: &[u8]) -> Result<Document, Error> {
    let text = text::decode_japanese(bytes);
    let mut lines = Lines::default();
    lines.about("file_creator", "Orihime");
    let (mut section, mut colour) = ("", 0_i32);
    for (line, text) in text::numbered_lines(&text) {
        let place = || Place::Line { line, column: None };
        let text = text.trim();
        section = [SEGMENTS, CIRCLES, TITLE].into_iter().find(|tag| text.starts_with(tag)).unwrap_or(section);
        let (word, rest) = text.split_once(',').unwrap_or((text, ""));
        match (section, word) {
            (TITLE, "タイトル") if rest != "_" => lines.about("frame_title", rest),
            (CIRCLES, NUMBER) => lines.left_out(place, "a circle; left out"),
            (SEGMENTS, COLOUR) => {
                colour = rest.trim().parse().map_err(|_| {
                    let problem = format!("{} is no colour", text::quoted(rest));
                    Error::new(ErrorCode::WrongType, place(), problem, "a number: 0 border, 1 mountain, 2 valley")
                })?;
            }
            (SEGMENTS, COORDINATES) => match letter(colour) {
                Some(letter) => lines.push(ends(rest, place)?, letter, None, format!("line {line}")),
                None => lines.left_out(place, "a line without a colour; left out"),
            },
            _ => {}
        }
    }
    Ok(lines.into_document())
}

fn letter(colour: i32) -> Option<&'static str> {
    match colour {
        0 => Some("B"),
        1 => Some("M"),
        2 => Some("V"),
        3.. => Some("F"),
        _ => None,
    }
}

fn ends(text: &str, place: impl Fn() -> Place) -> Result<[DVec2; 2], Error> {
    let words: Vec<&str> = text.split(',').map(str::trim).collect();
    let [ax, ay, bx, by] = words.as_slice() else {
        let problem = format!("has {} coordinates", words.len());
        return Err(Error::new(ErrorCode::WrongLength, place(), problem, "four: x and y of both ends"));
    };
    let coordinate = |word: &str| number::finite(word, &place, "a coordinate");
    Ok([DVec2::new(coordinate(ax)?, coordinate(ay)?), DVec2::new(coordinate(bx)?, coordinate(by)?)])
}

#[cfg(test)]
mod tests {
    use encoding_rs::{EUC_JP, SHIFT_JIS};

    use super::*;

    const TEXT: &str = "<タイトル>\nタイトル,鶴\n</タイトル>\n<線分集合>\n番号,1\n色,1\n<tpp>0</tpp>\niactive,0\n座標,0.0,-1.0,2.5,3.0\n\
        番号,2\n色,2\n座標,2.5,3.0,-1,0\n番号,3\n色,-1\n座標,0,0,1,1\n<円集合>\n番号,1\n中心と半径と色,0,0,1,3\n";

    #[test]
    fn all_encodings_are_read_alike() {
        let read = |bytes: &[u8]| {
            assert!(is_orh(bytes));
            let document = read(bytes).expect("ORH");
            let told: Vec<_> = document.warnings.iter().map(ToString::to_string).collect();
            assert_eq!(told, ["line 15: a line without a colour; left out", "line 17: a circle; left out"]);
            let frame = document.key_frame;
            assert_eq!(frame.extra["frame_title"], "鶴");
            assert_eq!(frame.extra["edges_origami:source"], serde_json::json!(["line 9", "line 12"]));
            assert_eq!(frame.edges_vertices, Some(vec![[0, 1], [1, 2]]));
            assert_eq!(frame.edges_assignment.expect("letters").concat(), "MV");
        };
        read(TEXT.as_bytes());
        read(&SHIFT_JIS.encode(TEXT).0);
        read(&EUC_JP.encode(&TEXT.replace('\n', "\r\n")).0);
    }

    #[test]
    fn errors_name_the_line() {
        let bad = |old: &str, new: &str| read(TEXT.replace(old, new).as_bytes()).expect_err(new).to_string();
        assert_eq!(bad("2.5,3.0\n", "2.5\n"), "line 9: has 3 coordinates; expected four: x and y of both ends");
        assert_eq!(bad("-1.0", "inf"), "line 9: \"inf\" is not finite; expected a number for a coordinate");
        assert!(bad("色,2", "色,x").starts_with("line 11: \"x\" is no colour"));
    }
}
