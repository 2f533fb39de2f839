//! A sheet as a frame has it, and as it was before it was folded, where the file has that too.

use origami::fold::{Document, Frame};
use origami::glam::DVec3;
use origami::pattern::keys::PERCENT;
use origami::{CreasePattern, Error, Material, Model, State};

use crate::args::MapName;

/// A frame, read.
pub(super) struct Lying {
    /// Which one.
    pub(super) frame: usize,
    /// What lies there.
    pub(super) drawn: CreasePattern,
    /// Whether it is flat and not called a folded form.
    pub(super) is_pattern: bool,
    /// The sheet before it was folded, or what lies there where the file has nothing else.
    pub(super) pattern: CreasePattern,
    /// Its model.
    pub(super) model: Model,
    /// Where the frame has the nodes, in radii; `None` where rest lengths are not known.
    folded: Option<Vec<DVec3>>,
    percent: Option<f64>,
}

impl Lying {
    /// Frame `frame`.
    ///
    /// # Errors
    /// As for what makes no pattern.
    pub(super) fn of(document: &Document, frame: usize) -> Result<Self, Error> {
        let written = document.frame(frame)?;
        let drawn = CreasePattern::from_document(document, frame)?;
        let is_folded = written.classes.iter().flatten().any(|class| class == "foldedForm");
        let is_pattern = drawn.is_flat() && !is_folded;
        let percent = written.extra.get(PERCENT).and_then(serde_json::Value::as_f64);
        let (pattern, model, folded) = match Self::at_rest(document, frame, &written) {
            Some((pattern, model, folded)) => (pattern, model, Some(folded)),
            None => (drawn.clone(), Model::new(&drawn, &Material::default())?, None),
        };
        Ok(Self { frame, drawn, is_pattern, pattern, model, folded, percent })
    }

    /// The sheet that the frame inherits from, where it has vertices of its own in the same number.
    fn at_rest(document: &Document, frame: usize, written: &Frame) -> Option<(CreasePattern, Model, Vec<DVec3>)> {
        let root = root(document, frame);
        if root == frame {
            return None;
        }
        let places = written.vertices_coords.as_ref()?;
        let pattern = CreasePattern::from_document(document, root).ok()?;
        if pattern.vertices.len() != places.len() {
            return None;
        }
        let model = Model::new(&pattern, &Material::default()).ok()?;
        let mut folded = model.rest.clone();
        for (node, place) in model.mesh.node_of_vertex.iter().zip(places) {
            if let Some(to) = node.and_then(|node| folded.get_mut(node.index())) {
                *to = model.normalisation.to_model(place.position);
            }
        }
        Some((pattern, model, folded))
    }

    /// The state to draw, which must know as much as a map of `quantity` needs.
    ///
    /// # Errors
    /// What the file does not tell.
    pub(super) fn state(&self, quantity: Option<MapName>) -> Result<State, Error> {
        let place = || format!("frame {}", self.frame);
        let folded = match (&self.folded, quantity) {
            (Some(folded), _) => folded.clone(),
            (None, None) => self.model.rest.clone(),
            (None, Some(_)) => {
                let problem = "does not tell how long its edges were before it was folded, so there is nothing to map";
                let expected = "a frame that inherits from its crease pattern, as `origami fold --frames` writes, or \
                                `origami fold` with --map";
                return Err(Error::invalid(place(), problem, expected));
            }
        };
        let mut state = State::at(&self.model, folded);
        match (self.percent, quantity) {
            (Some(percent), _) => {
                state.targets = self.model.targets(percent);
                // Positions do not tell how often a crease has turned.
                for (angle, target) in state.fold_angles.iter_mut().zip(&state.targets) {
                    *angle += std::f64::consts::TAU * ((target - *angle) / std::f64::consts::TAU).round();
                }
            }
            (None, Some(MapName::AngleError | MapName::Energy)) => {
                let problem = format!("has no {PERCENT}, so the angles asked for are not known");
                return Err(Error::invalid(place(), problem, "a frame that has it, or --map strain"));
            }
            (None, _) => {}
        }
        Ok(state)
    }
}

/// The frame at the end of a chain of parents.
fn root(document: &Document, frame: usize) -> usize {
    let mut at = frame;
    for _ in 0..document.frame_count() {
        match at.checked_sub(1).and_then(|i| document.frames.get(i)) {
            Some(written) if written.inherit => at = written.parent.unwrap_or(0) as usize,
            _ => break,
        }
    }
    at
}
