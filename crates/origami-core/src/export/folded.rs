//! Folded sheets as FOLD documents.

use glam::DVec3;
use serde_json::{Value, json};

use super::Template;
use super::sheet::{coordinates, number, set_angles, set_topology};
use crate::error::{Error, ErrorCode};
use crate::fold::{Coordinates, Document, Frame};
use crate::measure::edge_fold_angles;
use crate::model::Model;
use crate::pattern::CreasePattern;
use crate::pattern::keys::{FOLD_ANGLE, PERCENT};
use crate::sequence::STEP;
use crate::solve::Folded;

/// What programs write of a folded frame, and a pattern does not have.
const CONVERGED: &str = "origami:converged";
const DISTANCE: &str = "origami:distance";

/// A folded sheet as files hold it: positions and fold angles, and how far it was asked to fold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pose {
    /// The percentage of all fold angles that the sheet was asked for, 100 being all the way; `None` where it was asked for
    /// something else. Files have it as `origami:percent`.
    pub percent: Option<f64>,
    /// The position of each vertex of the pattern, in the file's unit of length. Those that were merged into another
    /// are written where that one is, whatever stands here.
    pub positions: Vec<DVec3>,
    /// The fold angle reached by each edge of the pattern, in radians, valley positive; `None` for boundaries.
    pub fold_angles: Vec<Option<f64>>,
    /// The step of a sequence that the pose shows; the title of its frame. Files have it as `origami:step`.
    pub step: Option<String>,
}

impl Pose {
    /// The pose of a state that a solver arrived at.
    #[must_use]
    pub fn of(model: &Model, pattern: &CreasePattern, folded: &Folded) -> Self {
        Self {
            percent: folded.percent(),
            positions: model.file_positions(pattern, &folded.state.positions),
            fold_angles: edge_fold_angles(model, pattern, &folded.state),
            step: None,
        }
    }
}

/// The folded form as a FOLD document of one frame: [`Template::folded_form`] of a template that is not kept.
///
/// # Errors
/// [`Error::Invalid`] if there is no such frame, or if the pose has not one position for each vertex and one angle
/// for each edge.
pub fn folded_form(source: &Document, frame: usize, pattern: &CreasePattern, pose: &Pose) -> Result<Document, Error> {
    Template::new(source, frame, pattern)?.folded_form(pattern, pose)
}

/// Folding as a FOLD animation: [`Template::animation`] of a template that is not kept.
///
/// # Errors
/// As for [`folded_form`].
pub fn animation(source: &Document, frame: usize, pattern: &CreasePattern, poses: &[Pose]) -> Result<Document, Error> {
    Template::new(source, frame, pattern)?.animation(pattern, poses)
}

impl Template {
    /// The folded form of `pattern`, the pattern of the template, as a FOLD document of one frame.
    ///
    /// Metadata and unknown keys of the source are kept, other frames dropped. `edges_foldAngle` are the angles reached.
    /// `origami:percent` says how far the sheet was asked to fold, where the pose knows it.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the pose has not one position for each vertex and one angle for each edge.
    pub fn folded_form(&self, pattern: &CreasePattern, pose: &Pose) -> Result<Document, Error> {
        check(pattern, pose)?;
        let mut key_frame = self.frame();
        set_topology(&mut key_frame, pattern);
        for key in [FOLD_ANGLE, PERCENT, STEP] {
            key_frame.extra.shift_remove(key);
        }
        let attributes = folded_attributes(&key_frame);
        key_frame.extra.insert("frame_attributes".into(), attributes);
        set_stage(&mut key_frame, pattern, pose);
        Ok(self.document(key_frame))
    }

    /// `pattern`, the pattern of the template, as a FOLD document of one frame that is not folded: as it was cleaned, with the
    /// angles that it asks for. Metadata and unknown keys of the source are kept, other frames dropped.
    #[must_use]
    pub fn crease_pattern(&self, pattern: &CreasePattern) -> Document {
        let mut key_frame = self.frame();
        set_topology(&mut key_frame, pattern);
        for key in [PERCENT, STEP, CONVERGED, DISTANCE] {
            key_frame.extra.shift_remove(key);
        }
        set_rest(&mut key_frame, pattern);
        self.document(key_frame)
    }

    /// Folding as a FOLD animation: the key frame is the crease pattern at rest with the angles it was asked for; each pose
    /// is a frame that inherits from it.
    ///
    /// The rest is as for [`Template::folded_form`].
    ///
    /// # Errors
    /// As for [`Template::folded_form`].
    pub fn animation(&self, pattern: &CreasePattern, poses: &[Pose]) -> Result<Document, Error> {
        let mut key_frame = self.frame();
        set_topology(&mut key_frame, pattern);
        set_rest(&mut key_frame, pattern);
        let attributes = folded_attributes(&key_frame);
        let poses = poses.iter().enumerate().map(|(i, pose)| {
            check(pattern, pose)?;
            let mut folded = Frame { parent: Some(0), inherit: true, ..Frame::default() };
            let percent = pose.percent.map(|percent| format!("{} %", rounded(percent)));
            let title = pose.step.clone().or(percent).unwrap_or_else(|| format!("pose {}", i + 1));
            folded.extra.insert("frame_title".into(), title.into());
            folded.extra.insert("frame_attributes".into(), attributes.clone());
            for key in [FOLD_ANGLE, PERCENT, STEP].into_iter().filter(|key| key_frame.extra.contains_key(*key)) {
                // Without its own this frame would inherit that of the crease pattern.
                folded.extra.insert(key.into(), Value::Null);
            }
            set_stage(&mut folded, pattern, pose);
            Ok(folded)
        });
        let frames = poses.collect::<Result<_, Error>>()?;
        let mut document = self.document(key_frame);
        document.classes.push("animation".into());
        document.frames = frames;
        Ok(document)
    }
}

/// To the six digits that a title has; `origami:percent` has all.
fn rounded(percent: f64) -> f64 {
    format!("{percent:.5e}").parse().unwrap_or(percent)
}

/// A new FOLD document of `pattern`, with two coordinates a vertex where all z are 0.
#[must_use]
pub fn crease_pattern_document(pattern: &CreasePattern, title: &str) -> Document {
    let mut frame = Frame::default();
    frame.extra.insert("frame_title".into(), title.into());
    let flat = pattern.vertices.iter().all(|position| position.z == 0.0);
    frame.extra.insert("frame_attributes".into(), json!([if flat { "2D" } else { "3D" }]));
    set_topology(&mut frame, pattern);
    set_rest(&mut frame, pattern);
    let mut document = Template::default().document(frame);
    document.classes.push("singleModel".into());
    document
}

/// The crease pattern before it is folded.
fn set_rest(frame: &mut Frame, pattern: &CreasePattern) {
    frame.classes = Some(vec!["creasePattern".into()]);
    frame.extra.shift_remove(FOLD_ANGLE);
    let flat = pattern.vertices.iter().all(|position| position.z == 0.0);
    let write = if flat { Coordinates::planar } else { Coordinates::spatial };
    frame.vertices_coords = Some(coordinates(pattern, &pattern.vertices, write));
    set_angles(frame, pattern, |edge| pattern.edges[edge].fold_angle);
}

fn set_stage(frame: &mut Frame, pattern: &CreasePattern, pose: &Pose) {
    frame.classes = Some(vec!["foldedForm".into()]);
    frame.vertices_coords = Some(coordinates(pattern, &pose.positions, Coordinates::spatial));
    if let Some(percent) = pose.percent {
        frame.extra.insert(PERCENT.into(), number(percent));
    }
    if let Some(step) = &pose.step {
        frame.extra.insert(STEP.into(), step.as_str().into());
    }
    set_angles(frame, pattern, |edge| pose.fold_angles[edge]);
}

/// The attributes of `frame` once it is folded.
fn folded_attributes(frame: &Frame) -> Value {
    let old = frame.extra.get("frame_attributes").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let kept = old.iter().filter(|&attribute| attribute != "2D" && attribute != "3D").cloned();
    kept.chain([Value::from("3D")]).collect()
}

fn check(pattern: &CreasePattern, pose: &Pose) -> Result<(), Error> {
    let counts = [
        ("positions", pose.positions.len(), "vertices", pattern.vertices.len()),
        ("fold angles", pose.fold_angles.len(), "edges", pattern.edges.len()),
    ];
    for (what, count, of, expected) in counts {
        if count != expected {
            let problem = format!("{count} {what} for {expected} {of}");
            let place = pose.percent.map_or_else(|| "pose".to_owned(), |percent| format!("pose at {percent} %"));
            return Err(Error::new(ErrorCode::WrongLength, place, problem, "as many as the pattern has"));
        }
    }
    Ok(())
}
