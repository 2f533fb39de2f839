//! What the content of a file tells of it, without reading it all.

use serde::de::{Deserializer, IgnoredAny, MapAccess, Visitor};

use super::{Format, foreign};
use crate::{cp, orh, text};

/// What a file seems to be.
pub(super) enum Content {
    Known(Format),
    /// Something else, by name.
    Foreign(String),
    /// Nothing but white space.
    Empty,
    Unknown,
}

/// How much of a text is looked at.
const HEAD: usize = 1 << 16;
/// How many of its lines.
const LINES: usize = 200;

/// What these bytes are.
pub(super) fn sniff(bytes: &[u8]) -> Content {
    if let Some(what) = foreign::binary(bytes) {
        return Content::Foreign(what.to_owned());
    }
    let head = text::decode(&bytes[..bytes.len().min(HEAD)]);
    let head = head.trim_start();
    match head.chars().next() {
        None if bytes.len() <= HEAD => Content::Empty,
        // White space without end: FOLD's reader looks on.
        None => Content::Known(Format::Fold),
        Some('{' | '[') => json(bytes),
        Some('<') => xml(head, bytes),
        Some(_) if head.chars().filter(|c| *c == '\0').count() > 8 => Content::Foreign("a binary file".to_owned()),
        Some(_) => lines(head, bytes),
    }
}

/// Of JSON the keys at the top tell. They are looked for only where the text has no key that FOLD alone has.
fn json(bytes: &[u8]) -> Content {
    let has = |text: &[u8]| bytes.windows(text.len()).any(|window| window == text);
    if has(b"\"vertices_coords\"") || has(b"\"file_frames\"") {
        return Content::Known(Format::Fold);
    }
    if has(b"\"lineSegments\"") {
        return Content::Known(Format::Ori);
    }
    let keys = keys(bytes);
    match foreign::json(&keys) {
        Some(what) => Content::Foreign(what.to_owned()),
        None => Content::Known(Format::Fold),
    }
}

/// The keys of a JSON object, up to where it is wrong.
fn keys(bytes: &[u8]) -> Vec<String> {
    struct Keys<'k>(&'k mut Vec<String>);
    impl<'de> Visitor<'de> for Keys<'_> {
        type Value = ();

        fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            f.write_str("an object")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<(), A::Error> {
            while let Some(key) = object.next_key()? {
                self.0.push(key);
                object.next_value::<IgnoredAny>()?;
            }
            Ok(())
        }
    }
    let text = text::decode(bytes);
    let mut keys = Vec::new();
    // What is wrong is said by the reader of the format.
    let _ = serde_json::Deserializer::from_str(&text).deserialize_map(Keys(&mut keys));
    keys
}

/// Of XML the root element tells.
fn xml(head: &str, bytes: &[u8]) -> Content {
    if orh::is_orh(bytes) {
        return Content::Known(Format::Orh);
    }
    let mut rest = head;
    let root = loop {
        let Some(at) = rest.find('<') else { return Content::Unknown };
        rest = &rest[at + 1..];
        let end = match rest.get(..1) {
            Some("!") if rest.starts_with("!--") => rest.find("-->"),
            Some("!") if rest.to_ascii_lowercase().starts_with("!doctype html") => break "html",
            // A document type may have declarations in brackets.
            Some("!") => rest
                .find('[')
                .filter(|at| rest[..*at].find('>').is_none())
                .map_or_else(|| rest.find('>'), |at| rest[at..].find("]").map(|end| at + end)),
            Some("?") => rest.find("?>"),
            _ => break rest.split(|c: char| c.is_whitespace() || c == '>' || c == '/').next().unwrap_or_default(),
        };
        let Some(end) = end else { return Content::Unknown };
        rest = &rest[end..];
    };
    let local = root.rsplit(':').next().unwrap_or_default();
    match local {
        "java" if bytes.windows(5).any(|window| window.eq_ignore_ascii_case(b"oripa")) => Content::Known(Format::Opx),
        "svg" => Content::Known(Format::Svg),
        "" => Content::Unknown,
        _ => Content::Foreign(foreign::xml(&text::quoted(local).replace('"', ""))),
    }
}

/// Of other text most of the first lines tell.
fn lines(head: &str, bytes: &[u8]) -> Content {
    if is_dxf(head) {
        return Content::Known(Format::Dxf);
    }
    const OBJ: [&str; 12] = ["v", "vt", "vn", "f", "l", "o", "g", "s", "p", "usemtl", "mtllib", "#e"];
    let (mut all, mut of_cp, mut of_obj, mut vertices) = (0, 0, 0, 0);
    for line in text::numbered_lines(head).map(|(_, line)| line.trim()).filter(|line| !line.is_empty()).take(LINES) {
        let mut words = line.split_whitespace();
        let word = words.next().unwrap_or_default();
        if OBJ.contains(&word) {
            of_obj += 1;
            vertices += usize::from(word == "v" && words.next().is_some_and(crate::number::is_number));
        }
        if !word.starts_with(['#', ';', '%']) && !word.starts_with("//") {
            all += 1;
            // A typo leaves one word of five no number.
            of_cp += usize::from(cp::numbers_in(line) >= 3);
        }
    }
    if vertices > 0 && 2 * of_obj >= all {
        Content::Known(Format::Obj)
    } else if of_cp > 0 && 2 * of_cp >= all {
        Content::Known(Format::Cp)
    } else if orh::is_orh(bytes) {
        Content::Known(Format::Orh)
    } else {
        Content::Unknown
    }
}

/// Whether the pairs begin with comments (999) and then a section.
fn is_dxf(head: &str) -> bool {
    let mut lines = text::numbered_lines(head).map(|(_, line)| line.trim());
    loop {
        match (lines.next(), lines.next()) {
            (Some("999"), Some(_)) => {}
            (Some("0"), Some("SECTION")) => return true,
            _ => return false,
        }
    }
}
