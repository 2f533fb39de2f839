//! The shape of a FOLD file.

use std::borrow::Cow;

use glam::DVec3;
use serde_json::{Map, Value};

use crate::error::Warning;

/// A FOLD file: its key frame and the frames of `file_frames`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// `file_spec`, as written.
    pub spec: Option<Value>,
    /// `file_classes`.
    pub classes: Vec<String>,
    /// Every other `file_…` key, in order. Keys of another name are not written.
    pub metadata: Map<String, Value>,
    /// Frame 0: the top level of the file.
    pub key_frame: Frame,
    /// `file_frames`: frame `i + 1` is `frames[i]`.
    pub frames: Vec<Frame>,
    /// The distance within which lines are joined when a pattern is made of a frame, in the file's unit of length; `None`:
    /// found from the file. Not written.
    pub join: Option<f64>,
    /// Oddities that the reader put right, such as keys by their FOLD 1.0 name. Not written.
    pub warnings: Vec<Warning>,
}

/// A vertex position as written: two or three numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinates {
    /// The position; z is 0 where the file gives two numbers.
    pub position: DVec3,
    /// How many numbers the file gives (2 or 3); further ones are refused unless they are 0.
    pub dimension: u8,
}

impl Coordinates {
    /// Written as `[x, y]`, unless z is not 0.
    #[must_use]
    pub fn planar(position: DVec3) -> Self {
        Self { position, dimension: if position.z == 0.0 { 2 } else { 3 } }
    }

    /// Written as `[x, y, z]`.
    #[must_use]
    pub fn spatial(position: DVec3) -> Self {
        Self { position, dimension: 3 }
    }
}

/// One frame, as written. Absent keys (and those that are `null`) are `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// `frame_parent`.
    pub parent: Option<u32>,
    /// `frame_inherit`.
    pub inherit: bool,
    /// `frame_classes`.
    pub classes: Option<Vec<String>>,
    /// `vertices_coords`, in the file's unit of length.
    pub vertices_coords: Option<Vec<Coordinates>>,
    /// `edges_vertices`.
    pub edges_vertices: Option<Vec<[u32; 2]>>,
    /// `edges_assignment`, the letters as written. The letters that FOLD knows are borrowed, as there are millions of them.
    pub edges_assignment: Option<Vec<Cow<'static, str>>>,
    /// `edges_foldAngle` (or 1.0's `edges_foldAngles`), in degrees, valley positive; `None` is `null`.
    pub edges_fold_angle: Option<Vec<Option<f64>>>,
    /// `faces_vertices`.
    pub faces_vertices: Option<Vec<Vec<u32>>>,
    /// All other keys, in order. Those that have a field of their own are not written from here.
    pub extra: Map<String, Value>,
}
