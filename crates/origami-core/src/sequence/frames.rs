//! Folded frames as steps, so that what was written can be folded again.

use super::read::{Selector, Step, To};
use super::{STEP, Sequence};
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Document;
use crate::pattern::keys::FOLD_ANGLE;

impl Sequence {
    /// The frames of a file after that of its pattern as steps, each to the fold angles (`edges_foldAngle`) that the frame has
    /// itself and does not inherit. Edges whose angle is `null` keep their targets. A step has the frame's `origami:step` or
    /// `frame_title` as its name.
    ///
    /// # Errors
    /// [`Error::Invalid`] where no frame has angles of its own, or not one for each edge of the pattern's frame.
    pub fn of_frames(document: &Document, pattern_frame: usize) -> Result<Self, Error> {
        let edges = document.frame(pattern_frame)?.edges_vertices.map_or(0, |edges| edges.len());
        let mut steps = Vec::new();
        for (index, frame) in document.frames.iter().enumerate().skip(pattern_frame) {
            let Some(angles) = &frame.edges_fold_angle else { continue };
            if angles.len() != edges {
                let place = Place::key("edges_foldAngle").in_frame(index + 1);
                let problem = format!("has {} entries where the pattern has {edges} edges", angles.len());
                return Err(Error::new(ErrorCode::WrongLength, place, problem, "one angle for each edge"));
            }
            // FOLD's range ends at 180 degrees; ours has what was reached.
            let own = frame.extra.get(FOLD_ANGLE).and_then(serde_json::Value::as_array);
            let reached = |edge: usize| own.and_then(|own| own.get(edge)?.as_f64()).or(angles[edge]);
            let name = [STEP, "frame_title"].into_iter().find_map(|key| frame.extra.get(key)?.as_str());
            let name = name.map_or_else(|| format!("frame {}", index + 1), str::to_owned);
            let all = Selector { all: true, ..Selector::default() };
            steps.push(Step::drive(name, all, To::Each((0..edges).map(reached).collect())));
        }
        if steps.is_empty() {
            let problem = format!("no frame after frame {pattern_frame} has fold angles of its own");
            return Err(Error::new(ErrorCode::MissingKey, Place::key("edges_foldAngle"), problem, "frames to fold to"));
        }
        Ok(Self { steps, groups: Vec::new() })
    }
}
