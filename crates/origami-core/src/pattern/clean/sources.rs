//! Where edges and faces were written before there was a FOLD file: a line's number, an element's id.

use serde_json::Value;

use super::draft::{DraftEdge, Origin};
use crate::error::{CreasePlace, Error, Place, Warning};
use crate::fold::Frame;
use crate::pattern::crease_pattern::CreasePattern;
use crate::pattern::keys;

/// What the frame has under [`keys::SOURCE`] and [`keys::FACES_SOURCE`].
pub(super) struct Sources<'a> {
    edges: &'a [Value],
    faces: &'a [Value],
}

impl<'a> Sources<'a> {
    pub(super) fn of(frame: &'a Frame) -> Self {
        let under = |key| frame.extra.get(key).and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        Self { edges: under(keys::SOURCE), faces: under(keys::FACES_SOURCE) }
    }

    fn is_empty(&self) -> bool {
        self.edges.is_empty() && self.faces.is_empty()
    }

    /// The sources of `edges`, pieces having that of the line they are pieces of; none where the frame has none.
    pub(super) fn of_edges(&self, edges: &[DraftEdge]) -> Vec<Box<str>> {
        if self.is_empty() {
            return Vec::new();
        }
        let source = |edge: &DraftEdge| match edge.origin {
            Origin::File(edge) => at(self.edges, edge as usize),
            Origin::Face(face) => at(self.faces, face as usize),
        };
        edges.iter().map(|edge| source(edge).unwrap_or_default().into()).collect()
    }

    /// `error` with the sources of what it names.
    pub(super) fn of_error(&self, mut error: Error) -> Error {
        if let (false, Error::Invalid(invalid)) = (self.is_empty(), &mut error) {
            invalid.place = self.of_place(invalid.place.clone());
            invalid.problem = self.of_text(&invalid.problem);
        }
        error
    }

    /// `warning` with the sources of what it names.
    pub(super) fn of_warning(&self, warning: &mut Warning) {
        if !self.is_empty() {
            warning.place = self.of_place(std::mem::replace(&mut warning.place, Place::Frame(0)));
            warning.message = self.of_text(&warning.message);
        }
    }

    fn of_place(&self, place: Place) -> Place {
        let edge = place.edge().and_then(|edge| at(self.edges, edge.index()));
        let face = || place.face().and_then(|face| at(self.faces, face.index()));
        match edge.or_else(face) {
            Some(source) => place.written_at(source),
            None => place,
        }
    }

    /// `text` with the source behind each entry that it names, as `edges_vertices[7]`.
    fn of_text(&self, text: &str) -> String {
        let mut told = String::with_capacity(text.len());
        let mut rest = text;
        while let Some((before, (of, index, end))) = next_entry(rest) {
            let source = at(if of == "edges" { self.edges } else { self.faces }, index);
            told.push_str(&rest[..before + end]);
            if let Some(source) = source {
                told.extend([" (", source, ")"]);
            }
            rest = &rest[before + end..];
        }
        told.push_str(rest);
        told
    }
}

fn at(sources: &[Value], index: usize) -> Option<&str> {
    sources.get(index)?.as_str().filter(|source| !source.is_empty())
}

/// Where the next entry of an array of edges or faces is named: what it is of, its index, and the length of its name.
fn next_entry(text: &str) -> Option<(usize, (&'static str, usize, usize))> {
    let mut from = 0;
    loop {
        let (start, of) = ["edges", "faces"]
            .into_iter()
            .filter_map(|of| text[from..].find(&format!("{of}_")).map(|at| (from + at, of)))
            .min()?;
        let name = text[start..].find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == ':'));
        let index = name.and_then(|name| {
            let rest = text[start + name..].strip_prefix('[')?;
            let digits = rest.find(']')?;
            Some((name + digits + 2, rest[..digits].parse().ok()?))
        });
        match index {
            Some((end, index)) => return Some((start, (of, index, end))),
            None => from = start + of.len(),
        }
    }
}

impl CreasePattern {
    /// Gives the creases that a warning about the model or a scene names the places where they were written, if
    /// [`sources`](Self::sources) has them.
    pub fn name_sources(&self, warning: &mut Warning) {
        if let Place::Creases(creases) = &mut warning.place {
            for crease in creases {
                let source = crease.edge.and_then(|edge| self.sources.get(edge.index()));
                if let Some(source) = source.filter(|source| !source.is_empty()) {
                    *crease = CreasePlace::new(crease.vertices, crease.edge).written_at(source);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::WarningCode;
    use crate::fold::Document;
    use crate::ids::{EdgeId, VertexId};

    /// Two lines that cross, one of which is there twice with another letter.
    const TEXT: &str = r#"{"vertices_coords": [[0,0],[4,0],[4,4],[0,4]],
        "edges_vertices": [[0,1],[1,2],[2,3],[3,0],[0,2],[1,3],[2,0]], "edges_assignment": ["B","B","B","B","M","V","V"],
        "edges_origami:source": ["line 1","line 2","line 3","line 4","line 15","line 16",""]}"#;

    #[test]
    fn warnings_name_both_lines_and_pieces_know_theirs() {
        let document = Document::from_slice(TEXT.as_bytes()).expect("FOLD");
        let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
        let crossing =
            pattern.warnings.iter().find(|w| w.code == WarningCode::EdgesCross).expect("they cross").to_string();
        assert!(crossing.starts_with("line 15, edges_vertices[4]: crosses edges_vertices[5] (line 16);"), "{crossing}");
        let twice =
            pattern.warnings.iter().find(|w| w.code == WarningCode::EdgeTwiceLetters).expect("twice").to_string();
        assert!(twice.contains("M at edges_assignment[4] (line 15),"), "{twice}");
        let piece = pattern.edges.len() - 1;
        assert!(piece >= pattern.edges_in_file, "the crossing lines are cut");
        assert_eq!(&*pattern.sources[piece], "line 16");
        let creases = vec![CreasePlace::new([VertexId(0), VertexId(4)], Some(EdgeId::new(piece)))];
        let mut warning = Warning::new(WarningCode::OverFolding, Place::Creases(creases), "too far");
        pattern.name_sources(&mut warning);
        assert_eq!(warning.to_string(), "crease 0-4 (line 16): too far");
    }

    #[test]
    fn names_in_texts_are_found() {
        for (text, found) in [
            ("crosses edges_vertices[12];", Some((8, ("edges", 12, 18)))),
            ("edges_ and faces_vertices[3]", Some((11, ("faces", 3, 17)))),
            ("edges_vertices[x] edges_a[7]", Some((18, ("edges", 7, 10)))),
            ("edges_vertices", None),
            ("edges_é[1]", None),
        ] {
            assert_eq!(next_entry(text), found, "{text}");
        }
    }
}
