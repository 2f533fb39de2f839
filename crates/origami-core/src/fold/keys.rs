//! The keys that have a typed field.

pub(super) const FILE_SPEC: &str = "file_spec";
pub(super) const FILE_CREATOR: &str = "file_creator";
pub(super) const FILE_CLASSES: &str = "file_classes";
pub(super) const FILE_FRAMES: &str = "file_frames";
pub(super) const FRAME_PARENT: &str = "frame_parent";
pub(super) const FRAME_INHERIT: &str = "frame_inherit";
pub(super) const FRAME_CLASSES: &str = "frame_classes";
pub(super) const VERTICES_COORDS: &str = "vertices_coords";
pub(super) const EDGES_VERTICES: &str = "edges_vertices";
pub(super) const EDGES_ASSIGNMENT: &str = "edges_assignment";
pub(super) const EDGES_FOLD_ANGLE: &str = "edges_foldAngle";
/// FOLD 1.0's name for [`EDGES_FOLD_ANGLE`].
pub(super) const EDGES_FOLD_ANGLES: &str = "edges_foldAngles";
pub(super) const FACES_VERTICES: &str = "faces_vertices";

/// Whether `key` belongs to the whole file, not to a frame.
pub(super) fn is_metadata(key: &str) -> bool {
    key.starts_with("file_")
}

/// Whether a field of [`Frame`](super::Frame) holds `key`.
pub(super) fn is_frame_field(key: &str) -> bool {
    const FIELDS: [&str; 9] = [
        FRAME_PARENT,
        FRAME_INHERIT,
        FRAME_CLASSES,
        VERTICES_COORDS,
        EDGES_VERTICES,
        EDGES_ASSIGNMENT,
        EDGES_FOLD_ANGLE,
        EDGES_FOLD_ANGLES,
        FACES_VERTICES,
    ];
    FIELDS.contains(&key)
}
