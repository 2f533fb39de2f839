//! Lines on their way into a FOLD document.

use std::borrow::Cow;
use std::collections::BTreeMap;

use glam::DVec2;
use origami_core::error::{Place, Warning, WarningCode};
use origami_core::fold::{Coordinates, Document, Frame};
use origami_core::pattern::keys;
use serde_json::{Map, Value};

/// Lines of a pattern, each with a letter, a fold angle and where it was written; what the file says of itself; and what of
/// it was left out.
#[derive(Debug, Default)]
pub struct Lines {
    coords: Vec<Coordinates>,
    /// Vertices by the bits of their coordinates: ends that are written alike are one vertex.
    at: BTreeMap<[u64; 2], u32>,
    edges: Vec<[u32; 2]>,
    letters: Vec<Cow<'static, str>>,
    angles: Vec<Option<f64>>,
    sources: Vec<String>,
    about: Map<String, Value>,
    odd: Vec<Oddity>,
}

/// What a file has and a pattern has not, as one warning for all of a kind.
#[derive(Debug)]
struct Oddity {
    code: WarningCode,
    first: Place,
    message: &'static str,
    more: usize,
}

impl Lines {
    /// Appends a line. `letter` is FOLD's, `angle` in degrees, valley positive; `None` leaves it to the letter. `source` is
    /// what a person finds it by in the file, such as `line 12`.
    ///
    /// A line whose ends are one point is left out, with a warning.
    pub fn push(&mut self, ends: [DVec2; 2], letter: &'static str, angle: Option<f64>, source: impl Into<String>) {
        let source = source.into();
        if ends[0] == ends[1] {
            return self.note(WarningCode::EdgeWithoutLength, || source.into(), "line without length; left out");
        }
        let ends = ends.map(|end| self.vertex(end));
        self.edges.push(ends);
        self.letters.push(letter.into());
        self.angles.push(angle);
        self.sources.push(source);
    }

    /// Notes that the file has something that a pattern has not: `message` says what, and that it is left out. Of several
    /// alike, which have the same message, the first place is told and the others are counted.
    pub fn left_out(&mut self, place: impl FnOnce() -> Place, message: &'static str) {
        self.note(WarningCode::LeftOut, place, message);
    }

    /// Notes something odd at `place` that is read nevertheless; alike as for [`left_out`](Self::left_out).
    pub fn note(&mut self, code: WarningCode, place: impl FnOnce() -> Place, message: &'static str) {
        match self.odd.iter_mut().find(|odd| odd.code == code && odd.message == message) {
            Some(odd) => odd.more += 1,
            None => self.odd.push(Oddity { code, first: place(), message, more: 0 }),
        }
    }

    /// What the file says of itself, under a key of FOLD: `file_author`, `frame_title` or one of our own. Nothing is kept
    /// of an empty text.
    pub fn about(&mut self, key: &'static str, text: &str) {
        if !text.trim().is_empty() {
            self.about.insert(key.into(), text.trim().into());
        }
    }

    /// How many lines there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The FOLD document that has them. Its fold angles are written only if a line has one.
    #[must_use]
    pub fn into_document(self) -> Document {
        let angles = self.angles.iter().any(Option::is_some).then(|| {
            let of_letter = |letter: &str| match letter {
                "M" => Some(-180.0),
                "V" => Some(180.0),
                "U" => None,
                _ => Some(0.0),
            };
            self.angles.iter().zip(&self.letters).map(|(angle, letter)| angle.or_else(|| of_letter(letter))).collect()
        });
        let (metadata, mut extra): (Map<_, _>, Map<_, _>) =
            self.about.into_iter().partition(|(key, _)| key.starts_with("file_"));
        extra.insert(keys::SOURCE.into(), self.sources.into());
        let key_frame = Frame {
            classes: Some(vec!["creasePattern".into()]),
            vertices_coords: Some(self.coords),
            edges_vertices: Some(self.edges),
            edges_assignment: Some(self.letters),
            edges_fold_angle: angles,
            extra,
            ..Frame::default()
        };
        Document {
            key_frame,
            metadata,
            warnings: self.odd.into_iter().map(Warning::from).collect(),
            ..Document::default()
        }
    }

    fn vertex(&mut self, at: DVec2) -> u32 {
        // -0 and 0 are one place.
        let at = at + DVec2::ZERO;
        let next = self.coords.len() as u32;
        let vertex = *self.at.entry([at.x.to_bits(), at.y.to_bits()]).or_insert(next);
        if vertex == next {
            self.coords.push(Coordinates::planar(at.extend(0.0)));
        }
        vertex
    }
}

impl From<Oddity> for Warning {
    fn from(odd: Oddity) -> Self {
        let more = if odd.more > 0 { format!(" (and {} more)", odd.more) } else { String::new() };
        Self::new(odd.code, odd.first, format!("{}{more}", odd.message))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_share_vertices_and_keep_what_is_odd() {
        let mut lines = Lines::default();
        let [a, b] = [DVec2::ZERO, DVec2::X];
        lines.push([a, b], "M", None, "line 1");
        lines.push([-a, a], "V", None, "line 2");
        lines.push([b, -a], "V", Some(90.0), "line 3");
        for line in 4..7 {
            lines.left_out(|| Place::Line { line, column: None }, "a circle; left out");
        }
        lines.about("file_author", " somebody ");
        lines.about("frame_title", " ");
        let document = lines.into_document();
        let frame = &document.key_frame;
        assert_eq!(frame.vertices_coords.as_ref().map(Vec::len), Some(2));
        assert_eq!(frame.edges_vertices, Some(vec![[0, 1], [1, 0]]));
        assert_eq!(frame.edges_fold_angle, Some(vec![Some(-180.0), Some(90.0)]));
        assert_eq!(frame.extra[keys::SOURCE], serde_json::json!(["line 1", "line 3"]));
        assert_eq!(document.metadata["file_author"], "somebody");
        assert!(!frame.extra.contains_key("frame_title"));
        let told: Vec<String> = document.warnings.iter().map(ToString::to_string).collect();
        assert_eq!(told, ["line 2: line without length; left out", "line 4: a circle; left out (and 2 more)"]);
    }
}
