//! Frames: how many there are, and what each inherits.

use std::borrow::Cow;

use super::{Document, Frame, keys};
use crate::error::{Error, ErrorCode, Place, Warning, WarningCode};

const FOLDED_FORM: &str = "foldedForm";
const CREASE_PATTERN: &str = "creasePattern";

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
    /// or inherited. Where that one is a folded form, the first crease pattern is taken instead, if there is one.
    ///
    /// # Errors
    /// [`Error::Invalid`] if there is none.
    pub fn pattern_frame(&self) -> Result<usize, Error> {
        let placed = self.placed_frames();
        let Some(&first) = placed.first() else {
            let place = Place::key(keys::VERTICES_COORDS);
            return Err(Error::new(
                ErrorCode::MissingKey,
                place,
                "no frame has this key",
                "the positions of the vertices",
            ));
        };
        if self.is_of_class(first, FOLDED_FORM) && !self.is_of_class(first, CREASE_PATTERN) {
            let pattern = placed.into_iter().find(|&frame| self.is_of_class(frame, CREASE_PATTERN));
            return Ok(pattern.unwrap_or(first));
        }
        Ok(first)
    }

    /// A warning where the frame to fold is not the first.
    pub(super) fn other_frame(&self) -> Option<Warning> {
        let first = *self.placed_frames().first()?;
        let taken = self.pattern_frame().ok()?;
        let message =
            format!("is a foldedForm; frame {taken} is a creasePattern, and taken unless another is asked for");
        (taken != first).then(|| Warning::new(WarningCode::OtherFrame, Place::Frame(first), message))
    }

    /// The frames that have `vertices_coords`, their own or inherited.
    fn placed_frames(&self) -> Vec<usize> {
        // What is known of each frame. Each is visited once, so circles end too.
        let mut placed: Vec<Option<bool>> = vec![None; self.frame_count()];
        for index in 0..self.frame_count() {
            let (mut chain, mut at, mut has) = (Vec::new(), Some(index), false);
            while let Some(current) = at {
                let Some(frame) = self.written_frame(current) else { break };
                has = frame.vertices_coords.is_some() || placed[current] == Some(true);
                if has || placed[current].is_some() {
                    break;
                }
                placed[current] = Some(false);
                chain.push(current);
                at = self.parent(current);
            }
            placed[index] = Some(has);
            chain.into_iter().for_each(|frame| placed[frame] = Some(has));
        }
        (0..self.frame_count()).filter(|&frame| placed[frame] == Some(true)).collect()
    }

    /// Whether a frame has this class, its own or inherited.
    fn is_of_class(&self, index: usize, class: &str) -> bool {
        let mut at = Some(index);
        // A chain longer than there are frames is a circle.
        for _ in 0..self.frame_count() {
            let Some(frame) = at.and_then(|at| self.written_frame(at)) else { return false };
            if let Some(classes) = &frame.classes {
                return classes.iter().any(|one| one == class);
            }
            at = at.and_then(|at| self.parent(at));
        }
        false
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
