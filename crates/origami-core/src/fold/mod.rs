//! FOLD 1.2 documents, as the file says it: nothing is interpreted here.
//! Specification: <https://github.com/edemaine/fold/blob/main/doc/spec.md>.

use glam::DVec3;
use serde_json::{Map, Value};

/// A FOLD file: its key frame and the frames of `file_frames`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// `file_spec`, as written.
    pub spec: Option<Value>,
    /// `file_classes`.
    pub classes: Vec<String>,
    /// Every other `file_…` key, in order.
    pub metadata: Map<String, Value>,
    /// Frame 0: the top level of the file.
    pub key_frame: Frame,
    /// `file_frames`: frame `i + 1` is `frames[i]`.
    pub frames: Vec<Frame>,
}

/// A vertex position as written: two or three numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinates {
    /// The position; z is 0 where the file gives two numbers.
    pub position: DVec3,
    /// How many numbers the file gives (2 or 3).
    pub dimension: u8,
}

/// One frame, as written. Absent keys are `None`.
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
    /// `edges_assignment`, the letters as written.
    pub edges_assignment: Option<Vec<String>>,
    /// `edges_foldAngle` (or 1.0's `edges_foldAngles`), in degrees, valley positive; `None` is `null`.
    pub edges_fold_angle: Option<Vec<Option<f64>>>,
    /// `faces_vertices`.
    pub faces_vertices: Option<Vec<Vec<u32>>>,
    /// All other keys, in order.
    pub extra: Map<String, Value>,
}
