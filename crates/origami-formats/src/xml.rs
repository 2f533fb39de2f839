//! XML documents, with errors in the house's words.

use origami_core::error::{Error, ErrorCode, Place};
use roxmltree::{Document, Node, ParsingOptions};

/// More elements than any pattern has, and few enough to hold.
const MOST_NODES: u32 = 20_000_000;
/// Deeper than anybody nests; parsing takes memory for each level.
const DEEPEST: usize = 1024;

/// The XML document in `text`. Entities are not expanded, so none can swell.
///
/// # Errors
/// The line and column where it is no XML; `what` it should be.
pub(crate) fn parse<'t>(text: &'t str, what: &str) -> Result<Document<'t>, Error> {
    if deeper_than(text, DEEPEST) {
        let place = Place::Line { line: 1, column: None };
        let (problem, expected) = ("elements are nested too deeply", format!("fewer than {DEEPEST} levels"));
        return Err(Error::new(ErrorCode::NestedTooDeeply, place, problem, expected));
    }
    // A document type is harmless without entities; drawing programs and Java's old writers have one.
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let at = error.pos();
        let place = Place::Line { line: at.row as usize, column: Some(at.col as usize) };
        let problem = error.to_string();
        let position = format!(" at {}:{}", at.row, at.col);
        let problem: String =
            problem.replace(&position, "").chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
        Error::new(ErrorCode::NotXml, place, format!("not XML: {problem}"), what)
    })
}

/// Where an element begins.
pub(crate) fn line_of(node: Node) -> usize {
    node.document().text_pos_at(node.range().start).row as usize
}

/// Whether more than `most` elements are open at once, roughly: comments and texts may count too.
fn deeper_than(text: &str, most: usize) -> bool {
    let mut depth = 0_usize;
    let mut bytes = text.bytes().peekable();
    while let Some(byte) = bytes.next() {
        match (byte, bytes.peek()) {
            (b'<', Some(b'/')) | (b'/', Some(b'>')) => depth = depth.saturating_sub(1),
            (b'<', Some(b'!' | b'?')) => {}
            (b'<', _) => depth += 1,
            _ => {}
        }
        if depth > most {
            return true;
        }
    }
    false
}
