//! CP, as ORIPA, Orihime, Oriedita, CP Editor and Box Pleating Studio write it: a line a crease, `type x1 y1 x2 y2`.
//!
//! Types: 1 border, 2 mountain, 3 valley. 0 (ORIPA's auxiliary line) and 4 (the others' unfolded or auxiliary crease) are
//! flat creases, as in what ORIPA and Oriedita write as FOLD. The format has no comments and no header; what is met in
//! practice is read nevertheless (`docs/FORMATS.md`).

use glam::DVec2;
use origami_core::error::{Error, ErrorCode, Place, WarningCode};
use origami_core::fold::Document;

use crate::lines::Lines;
use crate::{number, text};

/// What a line must be.
const EXPECTED: &str = "a line of CP: type x1 y1 x2 y2, the type from 0 to 4 (1 border, 2 mountain, 3 valley)";
/// Words in a line of CP.
const WORDS: usize = 5;

/// Reads a CP file.
///
/// # Errors
/// [`Error::Invalid`] with the number of the line that is not five finite numbers or whose type is not 0 to 4.
pub fn read(bytes: &[u8]) -> Result<Document, Error> {
    let text = text::decode(bytes);
    let mut lines = Lines::default();
    for (line, text) in text::numbered_lines(&text) {
        let words = words(text);
        if !words.is_empty() && !is_comment(text) {
            crease(&words, line, &mut lines)?;
        }
    }
    Ok(lines.into_document())
}

/// The words of a line, apart by white space; in a line without, by commas or semicolons.
fn words(line: &str) -> Vec<&str> {
    let words: Vec<&str> = line.split_whitespace().map(|word| word.trim_end_matches([',', ';'])).collect();
    let [word] = words.as_slice() else { return words };
    let separator = if word.contains(';') { ';' } else { ',' };
    word.split(separator).filter(|word| !word.is_empty()).collect()
}

/// How many of the first words of a line are numbers, if it can be a line of CP at all.
pub(crate) fn numbers_in(line: &str) -> usize {
    if is_comment(line) { 0 } else { words(line).iter().take_while(|word| number::is_number(word)).count() }
}

fn is_comment(line: &str) -> bool {
    ["#", "//", ";", "%"].iter().any(|mark| line.trim_start().starts_with(mark))
}

fn crease(words: &[&str], line: usize, lines: &mut Lines) -> Result<(), Error> {
    let place = || Place::Line { line, column: None };
    let numbers = words.iter().filter(|word| number::is_number(word)).count();
    if numbers <= 2 && !number::is_number(words[0]) {
        lines.left_out(place, "text in place of a line; left out");
        return Ok(());
    }
    let [kind, ends @ ..] = words else { return Ok(()) };
    let letter = letter(kind).ok_or_else(|| {
        let problem = format!("{} is no type of a line", text::quoted(kind));
        Error::new(ErrorCode::WrongValue, place(), problem, EXPECTED)
    })?;
    if words.len() < WORDS {
        let problem = format!("has {} words", words.len());
        return Err(Error::new(ErrorCode::WrongLength, place(), problem, EXPECTED));
    }
    let mut coordinates = [0.0; WORDS - 1];
    for ((coordinate, word), what) in coordinates.iter_mut().zip(ends).zip(["x1", "y1", "x2", "y2"]) {
        *coordinate = number::finite(word, place, what)?;
    }
    if ends[..WORDS - 1].iter().any(|word| word.contains(',')) {
        lines.note(WarningCode::OddNumber, place, "decimal commas; read as points");
    }
    if words.len() > WORDS {
        lines.left_out(place, "more than the five numbers of a line; the rest of the line is left out");
    }
    let [x1, y1, x2, y2] = coordinates;
    lines.push([DVec2::new(x1, y1), DVec2::new(x2, y2)], letter, None, format!("line {line}"));
    Ok(())
}

/// FOLD's letter for a type, which some programs write as `2.0`.
fn letter(kind: &str) -> Option<&'static str> {
    let kind: f64 = kind.parse().ok()?;
    ["F", "B", "M", "V", "F"]
        .into_iter()
        .zip(0..)
        .find(|(_, number)| kind == f64::from(*number))
        .map(|(letter, _)| letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "1 0 0 2 0\n1 2 0 2 2\n1 2 2 0 2\n1 0 2 0 0\n";

    /// Letters and coordinates of what is read, and the warnings.
    type Told = (String, Vec<[f64; 4]>, Vec<String>);

    fn read_text(text: impl AsRef<[u8]>) -> Result<Told, String> {
        let document = read(text.as_ref()).map_err(|error| error.to_string())?;
        let frame = document.key_frame;
        let at: Vec<_> = frame.vertices_coords.expect("vertices").iter().map(|c| c.position).collect();
        let ends = frame.edges_vertices.expect("edges").iter().map(|e| e.map(|v| at[v as usize])).collect::<Vec<_>>();
        let letters = frame.edges_assignment.expect("letters").concat();
        let ends = ends.iter().map(|[a, b]| [a.x, a.y, b.x, b.y]).collect();
        Ok((letters, ends, document.warnings.iter().map(ToString::to_string).collect()))
    }

    #[test]
    fn types_are_letters() {
        let text = format!("{SQUARE}0 0 0 1 1\n2 0 2 1 1\n3 2 0 1 1\n4 2 2 1 1\n2.0 0 1 1 1\n");
        let (letters, ends, warnings) = read_text(text).expect("CP");
        assert_eq!(letters, "BBBBFMVFM");
        assert_eq!(ends[5], [0.0, 2.0, 1.0, 1.0]);
        assert_eq!(warnings, [""; 0]);
    }

    /// Each is the valley from (1, 0) to (1, 2e-1), as somebody's program or editor leaves it.
    #[test]
    fn what_is_written_in_practice_is_read() {
        for text in [
            "3 1 0 1 0.2",
            "3\t1.0\t0.0\t1\t2E-1\r\n",
            "  3   1  -0.0 +1 .2  ",
            "\u{feff}3 1 0 1 2.0e-1",
            "3,1,0,1,0.2",
            "3, 1, 0, 1, 0.2",
            "3;1;0;1;0,2",
            "# made by hand\n\n// and again\n3 1 0 1 0.2\n\n\u{1a}",
            "\r\r3 1 0 1 0.2\r",
        ] {
            let (letters, ends, _) = read_text(text).unwrap_or_else(|error| panic!("{text:?}: {error}"));
            assert_eq!((letters.as_str(), ends.as_slice()), ("V", &[[1.0, 0.0, 1.0, 0.2]][..]), "{text:?}");
        }
        let utf16: Vec<u8> = "3 1 0 1 0.2".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(read_text([b"\xff\xfe".as_slice(), &utf16].concat()).expect("UTF-16").1, [[1.0, 0.0, 1.0, 0.2]]);
    }

    #[test]
    fn what_is_left_out_is_told_with_its_line() {
        let japanese = [b"\x90\xdc\x82\xe8\x90\xfc 1\n".as_slice(), SQUARE.as_bytes()].concat();
        let (letters, _, warnings) = read_text(japanese).expect("Shift-JIS in a comment");
        assert_eq!(
            (letters.as_str(), warnings),
            ("BBBB", vec!["line 1: text in place of a line; left out".to_owned()])
        );
        let (.., warnings) =
            read_text(format!("{SQUARE}3 0 0 2 2 90\n3 0 0 2 2 0.5 red\n2 1 1 1 1\n3 0,5 0 0,5 2\n")).expect("CP");
        assert_eq!(
            warnings,
            [
                "line 5: more than the five numbers of a line; the rest of the line is left out (and 1 more)",
                "line 7: line without length; left out",
                "line 8: decimal commas; read as points",
            ]
        );
    }

    #[test]
    fn errors_name_the_line_and_the_word() {
        for (line, told) in [
            ("1 0 0 l 0", "line 5: \"l\" is no number; expected a number for x2"),
            ("1 0 0 1", "line 5: has 4 words; expected a line of CP: type x1 y1 x2 y2"),
            ("7 0 0 1 1", "line 5: \"7\" is no type of a line; expected a line of CP"),
            ("-1 0 0 1 1", "line 5: \"-1\" is no type of a line"),
            ("M 0 0 1 1", "line 5: \"M\" is no type of a line"),
            ("1 0 0 NaN 1", "line 5: \"NaN\" is not finite; expected a number for x2"),
            ("1 0 0 1 1e999", "line 5: \"1e999\" is too large; expected at most 1e100 for y2"),
            ("2 \u{1b}[31m 0 1 1", "line 5: \"\u{fffd}[31m\" is no number"),
        ] {
            let error = read_text(format!("{SQUARE}{line}\n{SQUARE}")).expect_err(line);
            assert!(error.starts_with(told), "{line}: {error}");
        }
    }
}
