//! Lines on their way into a FOLD document.

use std::borrow::Cow;
use std::collections::BTreeMap;

use glam::DVec2;
use origami_core::fold::{Coordinates, Document, Frame};
use origami_core::pattern::keys;

/// Lines of a pattern, each with a letter, a fold angle and where it was written.
#[derive(Debug, Default)]
pub struct Lines {
    coords: Vec<Coordinates>,
    /// Vertices by the bits of their coordinates: ends that are written alike are one vertex.
    at: BTreeMap<[u64; 2], u32>,
    edges: Vec<[u32; 2]>,
    letters: Vec<Cow<'static, str>>,
    angles: Vec<Option<f64>>,
    sources: Vec<String>,
}

impl Lines {
    /// Appends a line. `letter` is FOLD's, `angle` in degrees, valley positive; `None` leaves it to the letter. `source` is
    /// what a person finds it by in the file, such as `line 12`.
    pub fn push(&mut self, ends: [DVec2; 2], letter: &'static str, angle: Option<f64>, source: impl Into<String>) {
        let ends = ends.map(|end| self.vertex(end));
        self.edges.push(ends);
        self.letters.push(letter.into());
        self.angles.push(angle);
        self.sources.push(source.into());
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
        let mut frame = Frame {
            classes: Some(vec!["creasePattern".into()]),
            vertices_coords: Some(self.coords),
            edges_vertices: Some(self.edges),
            edges_assignment: Some(self.letters),
            edges_fold_angle: angles,
            ..Frame::default()
        };
        frame.extra.insert(keys::SOURCE.into(), self.sources.into());
        Document { key_frame: frame, ..Document::default() }
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
