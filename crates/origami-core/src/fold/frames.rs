//! Frames: how many there are, and what each inherits.

use std::borrow::Cow;

use super::{Document, Frame, keys};
use crate::error::{Error, ErrorCode, Place};

impl Document {
    /// How many frames there are, the key frame included.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        1 + self.frames.len()
    }

    /// Frame `index` with all that it inherits: 0 is the key frame, `i + 1` is `file_frames[i]`. The result has no
    /// parent. `file_…` keys belong to the file and are left out.
    ///
    /// A frame that inherits but names no parent inherits from the key frame. The key frame never inherits.
    ///
    /// # Errors
    /// [`Error::Invalid`] if there is no such frame, if a parent does not exist or if frames inherit in a circle.
    pub fn frame(&self, index: usize) -> Result<Frame, Error> {
        self.resolved(index).map(Cow::into_owned)
    }

    /// As [`Document::frame`], without a copy where the frame is written as a whole.
    pub(crate) fn resolved(&self, index: usize) -> Result<Cow<'_, Frame>, Error> {
        let mut current = self.written_frame(index).ok_or_else(|| {
            let expected = format!("a frame from 0 to {}", self.frames.len());
            Error::new(ErrorCode::NoSuchFrame, Place::Frame(index), "there is no such frame", expected)
        })?;
        if current.parent.is_none() && !current.inherit && !current.extra.keys().any(|key| keys::is_metadata(key)) {
            return Ok(Cow::Borrowed(current));
        }
        let mut resolved = current.clone();
        let mut at = index;
        // A chain longer than there are frames visits one of them twice.
        for _ in 0..self.frame_count() {
            let Some(parent) = self.parent(at) else {
                resolved.parent = None;
                resolved.inherit = false;
                resolved.extra.retain(|key, _| !keys::is_metadata(key));
                return Ok(Cow::Owned(resolved));
            };
            current = self.written_frame(parent).ok_or_else(|| {
                let expected = format!("a frame from 0 to {}", self.frames.len());
                let place = Place::key(keys::FRAME_PARENT).in_frame(at);
                Error::new(ErrorCode::NoSuchFrame, place, format!("there is no frame {parent}"), expected)
            })?;
            resolved.inherit_from(current);
            at = parent;
        }
        let problem = "the frame inherits from itself";
        let place = Place::key(keys::FRAME_PARENT).in_frame(index);
        Err(Error::new(ErrorCode::FramesInACircle, place, problem, "a chain of parents that ends"))
    }

    /// The frame to fold unless another is asked for: the first, key frame first, that has `vertices_coords`, its own
    /// or inherited.
    ///
    /// # Errors
    /// [`Error::Invalid`] if there is none.
    pub fn pattern_frame(&self) -> Result<usize, Error> {
        // Frames known to lead to no coordinates. Each is visited once, so circles end too.
        let mut barren = vec![false; self.frame_count()];
        for index in 0..self.frame_count() {
            let mut at = Some(index);
            while let Some(current) = at {
                let Some(frame) = self.written_frame(current) else { break };
                if frame.vertices_coords.is_some() {
                    return Ok(index);
                }
                if std::mem::replace(&mut barren[current], true) {
                    break;
                }
                at = self.parent(current);
            }
        }
        let place = Place::key(keys::VERTICES_COORDS);
        Err(Error::new(ErrorCode::MissingKey, place, "no frame has this key", "the positions of the vertices"))
    }

    fn written_frame(&self, index: usize) -> Option<&Frame> {
        match index.checked_sub(1) {
            None => Some(&self.key_frame),
            Some(index) => self.frames.get(index),
        }
    }

    /// The frame that an existing frame `index` inherits from.
    fn parent(&self, index: usize) -> Option<usize> {
        let frame = self.frames.get(index.checked_sub(1)?)?;
        frame.inherit.then(|| frame.parent.unwrap_or(0) as usize)
    }
}

impl Frame {
    /// Takes from `parent` what is not here.
    fn inherit_from(&mut self, parent: &Self) {
        fn fill<T: Clone>(own: &mut Option<T>, inherited: &Option<T>) {
            if own.is_none() {
                own.clone_from(inherited);
            }
        }
        fill(&mut self.classes, &parent.classes);
        fill(&mut self.vertices_coords, &parent.vertices_coords);
        fill(&mut self.edges_vertices, &parent.edges_vertices);
        fill(&mut self.edges_assignment, &parent.edges_assignment);
        fill(&mut self.edges_fold_angle, &parent.edges_fold_angle);
        fill(&mut self.faces_vertices, &parent.faces_vertices);
        for (key, value) in &parent.extra {
            if !self.extra.contains_key(key) {
                self.extra.insert(key.clone(), value.clone());
            }
        }
    }
}
