//! From files and their frames to patterns.

use super::clean;
use super::crease_pattern::CreasePattern;
use super::reading::Reading;
use crate::error::Error;
use crate::fold::{Document, Frame};

impl CreasePattern {
    /// The crease pattern that `frame` describes, with parents already resolved.
    ///
    /// Mistakes in the file are put right, each kind with a [`Warning`](crate::Warning) that names the first place, or
    /// refused:
    /// - Letters: lower case is accepted, an unknown letter counts as `U`. Without letters they follow from the fold
    ///   angles; an edge of one face is boundary. A letter other than `B` on the contour becomes `B`.
    /// - Angles: without them M folds to -180 degrees, V to 180, F and J to 0. A `null` is a free crease. On a sheet that
    ///   is not flat, missing angles are measured from the coordinates.
    /// - Faces that the file gives are turned to agree with their neighbours. Missing faces are built, on flat patterns,
    ///   from the lines: vertices nearer than two millionths of the size are merged, lines are split where they cross
    ///   or where a vertex lies on them, and the regions inside the boundary edges, less the holes, are the paper.
    /// - The sheet comes apart along cuts (`C`): they become pairs of boundary edges, with copies of the vertices.
    ///
    /// # Errors
    /// [`Error::Invalid`] for what has no sensible reading: arrays of unequal length, indices out of range, edges of no
    /// length, edges of three faces, a sheet that cannot be oriented, no faces at all.
    pub fn from_frame(frame: &Frame) -> Result<Self, Error> {
        Self::from_frame_with(frame, &Reading::default())
    }

    /// As [`from_frame`](Self::from_frame), where the caller knows more than the file does.
    ///
    /// # Errors
    /// As for [`from_frame`](Self::from_frame), and [`Error::Invalid`] for a distance that is none.
    pub fn from_frame_with(frame: &Frame, reading: &Reading) -> Result<Self, Error> {
        clean::pattern(frame, reading)
    }

    /// The crease pattern in the first frame of a FOLD file that has vertex positions. Needs the feature `files`.
    ///
    /// To write a FOLD file that keeps what else is in this one, read the [`Document`] first and take
    /// [`from_document`](Self::from_document).
    ///
    /// # Errors
    /// As for [`Document::read`], [`Document::pattern_frame`] and [`CreasePattern::from_frame`].
    #[cfg(feature = "files")]
    pub fn read(path: impl AsRef<std::path::Path>) -> Result<Self, Error> {
        let document = Document::read(path)?;
        Self::from_document(&document, document.pattern_frame()?)
    }

    /// The crease pattern in frame `frame` of `document`, with the warnings of both.
    ///
    /// # Errors
    /// As for [`Document::frame`] and [`CreasePattern::from_frame`].
    pub fn from_document(document: &Document, frame: usize) -> Result<Self, Error> {
        let reading = Reading::joining(document.join);
        let mut pattern = Self::from_frame_with(&*document.resolved(frame)?, &reading)?;
        pattern.warnings.splice(0..0, document.warnings.iter().cloned());
        Ok(pattern)
    }
}

#[cfg(all(test, feature = "files"))]
mod tests {
    use super::*;

    /// A square with a diagonal, its angles under the name of FOLD 1.0, in the second frame.
    const TEXT: &str = r#"{"file_frames": [{
        "vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
        "edges_assignment": ["B", "B", "B", "B", "v"],
        "edges_foldAngles": [0, 0, 0, 0, 90]
    }]}"#;

    #[test]
    fn finds_the_frame_and_keeps_all_warnings() {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), TEXT).unwrap();
        let pattern = CreasePattern::read(file.path()).unwrap();
        assert_eq!(pattern.faces.len(), 2);
        let places: Vec<String> = pattern.warnings.iter().map(|w| w.place.to_string()).collect();
        assert_eq!(places[0], "file_frames[0].edges_foldAngles", "{places:?}");
        assert!(places[1..].iter().any(|place| place == "edges_assignment[4]"), "{places:?}");
    }

    #[test]
    fn errors_say_what_is_wrong() {
        let document = Document::from_slice(TEXT.as_bytes()).unwrap();
        let error = CreasePattern::from_document(&document, 2).unwrap_err().to_string();
        assert_eq!(error, "frame 2: there is no such frame; expected a frame from 0 to 1");
        let error = CreasePattern::from_document(&document, 0).unwrap_err().to_string();
        assert!(error.starts_with("vertices_coords: "), "{error}");
        assert!(CreasePattern::read("no such file.fold").unwrap_err().to_string().starts_with("no such file.fold: "));
    }
}
