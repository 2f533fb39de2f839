//! Bytes as text: byte-order marks, encodings, and lines with any of the ends that programs write.

use std::borrow::Cow;

use encoding_rs::{EUC_JP, Encoding, SHIFT_JIS, UTF_8};

/// The text in `bytes`: in the encoding of their byte-order mark, or else in UTF-8, where what is none becomes U+FFFD. The
/// formats that are read here are ASCII in all that counts.
pub(crate) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    UTF_8.decode(bytes).0
}

/// As [`decode`]; what is not UTF-8 is Japanese: Orihime writes the encoding of the machine that it runs on.
pub(crate) fn decode_japanese(bytes: &[u8]) -> Cow<'_, str> {
    let whole = |encoding: &'static Encoding| {
        let (text, _, damaged) = encoding.decode(bytes);
        (!damaged).then_some(text)
    };
    whole(UTF_8).or_else(|| whole(SHIFT_JIS)).or_else(|| whole(EUC_JP)).unwrap_or_else(|| decode(bytes))
}

/// The lines of `text`, numbered from 1, ended by `\n`, `\r\n` or `\r`.
pub(crate) fn numbered_lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let end = if text.contains('\n') { '\n' } else { '\r' };
    (1..).zip(text.split(end)).map(|(number, line)| (number, line.trim_matches(['\r', '\u{1a}', '\u{feff}'])))
}

/// `text` as a message quotes it.
pub(crate) fn quoted(text: &str) -> String {
    const MOST: usize = 40;
    format!("\"{}\"", printable(text, MOST))
}

/// `text` without what steers a terminal, and with no more than `most` of its characters.
pub(crate) fn printable(text: &str, most: usize) -> String {
    let harmless = |c: char| if c.is_control() || is_bidi(c) { '\u{fffd}' } else { c };
    let mut shown: String = text.chars().take(most).map(harmless).collect();
    if text.chars().nth(most).is_some() {
        shown.push('…');
    }
    shown
}

/// Whether it changes the direction in which a terminal shows text.
fn is_bidi(c: char) -> bool {
    matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn byte_order_marks_and_japanese_are_understood() {
        assert_eq!(decode(b"\xef\xbb\xbf1 0"), "1 0");
        assert_eq!(decode(b"\xff\xfe1\x00 \x000\x00"), "1 0");
        assert_eq!(decode(b"\xfe\xff\x001\x00 \x000"), "1 0");
        // The same word in both: checked against tables of the encodings.
        assert_eq!(decode_japanese(b"\x94\xd4\x8d\x86"), "番号");
        assert_eq!(decode_japanese("番号".as_bytes()), "番号");
    }

    #[test]
    fn all_line_ends_count_lines_alike() {
        for text in ["a\nb\n\nc", "a\r\nb\r\n\r\nc", "a\rb\r\rc"] {
            let lines: Vec<_> = numbered_lines(text).collect();
            assert_eq!(lines, [(1, "a"), (2, "b"), (3, ""), (4, "c")], "{text:?}");
        }
    }

    #[test]
    fn quotes_are_harmless_and_short() {
        assert_eq!(quoted("a\u{1b}[31m\u{202e}"), "\"a\u{fffd}[31m\u{fffd}\"");
        assert_eq!(quoted(&"x".repeat(1000)).chars().count(), 43);
    }
}
