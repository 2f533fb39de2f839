//! Places in the input: where something is wrong or odd.

use std::borrow::Cow;
use std::fmt;

use crate::ids::{EdgeId, FaceId, VertexId};

/// Where in the input an error or a warning is: a person reads it by `Display`, a program takes it apart.
///
/// ```
/// use origami_core::error::Place;
/// use origami_core::ids::EdgeId;
///
/// let place = Place::entry("edges_assignment", 17).in_frame(3);
/// assert_eq!(place.to_string(), "file_frames[2].edges_assignment[17]");
/// assert_eq!(place.edge(), Some(EdgeId(17)));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Place {
    /// A key of a FOLD file, or an entry of its array. Made by [`Place::key`] and [`Place::entry`].
    #[non_exhaustive]
    Key {
        /// The frame, 0 for the key frame and `i + 1` for `file_frames[i]`. `None` for keys of the file as a whole, and
        /// where a pattern is made from one frame without the file around it.
        frame: Option<usize>,
        /// The key, such as `edges_vertices`.
        key: Cow<'static, str>,
        /// Which entry of the key's array; `None` for the array as a whole.
        index: Option<usize>,
        /// The path from that entry on, such as `[0]` for the first coordinate of a vertex; mostly empty.
        within: Box<str>,
        /// Where the edge was written in the file that this FOLD data was made from, such as `line 12`; mostly empty.
        source: Box<str>,
    },
    /// A frame of the file as a whole: 0 is the key frame.
    Frame(usize),
    /// A line of the text, counted from 1, and the column where it is known, counted in bytes.
    Line {
        /// The line.
        line: usize,
        /// The column.
        column: Option<usize>,
    },
    /// Vertices of the pattern.
    Vertices(Vec<VertexId>),
    /// Creases of the sheet.
    Creases(Vec<CreasePlace>),
    /// Triangles of the sheet, each by its corners.
    Triangles(Vec<[VertexId; 3]>),
    /// The sheet as a whole, at a percentage of its fold angles where it is known.
    Sheet {
        /// The percentage.
        percent: Option<f64>,
    },
    /// A setting or an argument of a call, by name.
    Setting(Cow<'static, str>),
    /// A file, or `-` for a stream.
    File(String),
}

/// Where a crease of the sheet is.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CreasePlace {
    /// Its ends.
    pub vertices: [VertexId; 2],
    /// The pattern's edge there; `None` for a diagonal that the triangulation added.
    pub edge: Option<EdgeId>,
    /// Where the edge was written in a file of another format than FOLD, such as `line 12`; mostly empty.
    pub source: Box<str>,
}

impl CreasePlace {
    /// A crease between `vertices`, along `edge` of the pattern.
    #[must_use]
    pub fn new(vertices: [VertexId; 2], edge: Option<EdgeId>) -> Self {
        Self { vertices, edge, source: "".into() }
    }

    /// This crease with where it was written before there was a FOLD file.
    #[must_use]
    pub fn written_at(mut self, at: &str) -> Self {
        self.source = at.into();
        self
    }
}

impl Place {
    /// The whole of what a FOLD file has under `key`.
    #[must_use]
    pub fn key(key: impl Into<Cow<'static, str>>) -> Self {
        Self::Key { frame: None, key: key.into(), index: None, within: "".into(), source: "".into() }
    }

    /// Entry `index` of the array under `key`.
    #[must_use]
    pub fn entry(key: impl Into<Cow<'static, str>>, index: usize) -> Self {
        Self::Key { frame: None, key: key.into(), index: Some(index), within: "".into(), source: "".into() }
    }

    /// This place in frame `of` of the file, 0 being the key frame. Only a [`Place::Key`] changes.
    #[must_use]
    pub fn in_frame(mut self, of: usize) -> Self {
        if let Self::Key { frame, .. } = &mut self {
            *frame = Some(of);
        }
        self
    }

    /// This place with the path from the entry on, such as `[0]`.
    pub(crate) fn within(mut self, path: &str) -> Self {
        if let Self::Key { within, .. } = &mut self {
            *within = path.into();
        }
        self
    }

    /// This place with where its edge or face was written before there was a FOLD file, such as `line 12`. Only a [`Place::Key`]
    /// changes.
    #[must_use]
    pub fn written_at(mut self, at: &str) -> Self {
        if let Self::Key { source, .. } = &mut self {
            *source = at.into();
        }
        self
    }

    /// The edge, where this is an entry of an array of edges, as `edges_assignment[17]` is.
    #[must_use]
    pub fn edge(&self) -> Option<EdgeId> {
        self.element("edges_").map(EdgeId)
    }

    /// The vertex, where this is an entry of an array of vertices.
    #[must_use]
    pub fn vertex(&self) -> Option<VertexId> {
        self.element("vertices_").map(VertexId)
    }

    /// The face, where this is an entry of an array of faces.
    #[must_use]
    pub fn face(&self) -> Option<FaceId> {
        self.element("faces_").map(FaceId)
    }

    fn element(&self, of: &str) -> Option<u32> {
        match self {
            Self::Key { key, index: Some(index), .. } if key.starts_with(of) => u32::try_from(*index).ok(),
            _ => None,
        }
    }
}

impl From<&'static str> for Place {
    /// A [`Place::Setting`].
    fn from(name: &'static str) -> Self {
        Self::Setting(name.into())
    }
}

impl From<String> for Place {
    /// A [`Place::Setting`].
    fn from(name: String) -> Self {
        Self::Setting(name.into())
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Key { frame, key, index, within, source } => {
                if !source.is_empty() {
                    write!(f, "{source}, ")?;
                }
                if let Some(frame) = frame.and_then(|frame| frame.checked_sub(1)) {
                    write!(f, "file_frames[{frame}].")?;
                }
                f.write_str(key)?;
                index.map_or(Ok(()), |index| write!(f, "[{index}]"))?;
                f.write_str(within)
            }
            Self::Frame(frame) => write!(f, "frame {frame}"),
            Self::Line { line, column: Some(column) } => write!(f, "line {line} column {column}"),
            Self::Line { line, column: None } => write!(f, "line {line}"),
            Self::Vertices(vertices) => list(f, ["vertex", "vertices"], vertices.iter().map(|v| ([*v], ""))),
            Self::Creases(creases) => list(f, ["crease", "creases"], creases.iter().map(|c| (c.vertices, &*c.source))),
            Self::Triangles(triangles) => list(f, ["triangle", "triangles"], triangles.iter().map(|t| (*t, ""))),
            Self::Sheet { percent: Some(percent) } => write!(f, "the sheet at {percent} %"),
            Self::Sheet { percent: None } => f.write_str("the sheet"),
            Self::Setting(name) => f.write_str(name),
            Self::File(path) => f.write_str(path),
        }
    }
}

/// How many elements of a list are written; the rest are counted.
const NAMED: usize = 3;

/// Such as `creases 0-4, 4-7, 7-9 and 12 more`; elements with where they were written, if known.
fn list<'e, const N: usize>(
    f: &mut fmt::Formatter<'_>,
    [one, many]: [&str; 2],
    elements: impl ExactSizeIterator<Item = ([VertexId; N], &'e str)>,
) -> fmt::Result {
    let count = elements.len();
    f.write_str(if count == 1 { one } else { many })?;
    for (i, (vertices, source)) in elements.take(NAMED).enumerate() {
        f.write_str(if i == 0 { " " } else { ", " })?;
        for (j, vertex) in vertices.iter().enumerate() {
            write!(f, "{}{}", if j == 0 { "" } else { "-" }, vertex.0)?;
        }
        if !source.is_empty() {
            write!(f, " ({source})")?;
        }
    }
    if count > NAMED { write!(f, " and {} more", count - NAMED) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_read_as_in_a_file() {
        let crease = |a, b| CreasePlace::new([VertexId(a), VertexId(b)], None);
        let told: [(Place, &str); 12] = [
            (Place::key("edges_vertices"), "edges_vertices"),
            (Place::entry("edges_vertices", 3).in_frame(0), "edges_vertices[3]"),
            (Place::entry("edges_vertices", 3).within("[1]").in_frame(2), "file_frames[1].edges_vertices[3][1]"),
            (Place::Frame(7), "frame 7"),
            (Place::Line { line: 2, column: Some(15) }, "line 2 column 15"),
            (Place::Line { line: 1, column: None }, "line 1"),
            (Place::Vertices(vec![VertexId(5)]), "vertex 5"),
            (Place::Creases(vec![crease(0, 4), crease(4, 7)]), "creases 0-4, 4-7"),
            (Place::Creases((0..15).map(|i| crease(i, i + 1)).collect()), "creases 0-1, 1-2, 2-3 and 12 more"),
            (Place::Triangles(vec![[1, 2, 3].map(VertexId)]), "triangle 1-2-3"),
            (Place::Sheet { percent: Some(-100.0) }, "the sheet at -100 %"),
            (Place::from("zoom"), "zoom"),
        ];
        for (place, text) in told {
            assert_eq!(place.to_string(), text);
        }
    }

    #[test]
    fn an_entry_names_its_element_and_nothing_else() {
        let [edge, vertex, face] = ["edges_foldAngle", "vertices_coords", "faces_vertices"].map(|k| Place::entry(k, 9));
        assert_eq!((edge.edge(), edge.vertex(), edge.face()), (Some(EdgeId(9)), None, None));
        assert_eq!((vertex.edge(), vertex.vertex(), vertex.face()), (None, Some(VertexId(9)), None));
        assert_eq!((face.edge(), face.vertex(), face.face()), (None, None, Some(FaceId(9))));
        for place in [Place::key("edges_vertices"), Place::Frame(9), Place::from("edges_vertices[9]")] {
            assert_eq!(place.edge(), None, "{place}");
        }
    }
}
