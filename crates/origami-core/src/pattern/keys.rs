//! Keys of our own in FOLD files, all optional.

/// For each edge the stiffness of its crease in place of the material's (a force per radian), or `null`.
pub const K_CREASE: &str = "edges_origami:k_crease";
/// For each edge its axial rigidity in place of the material's, or `null`.
pub const EA: &str = "edges_origami:ea";
/// For each edge its fold angle in degrees as it is, where FOLD's range from -180 to 180 cannot hold it.
pub const FOLD_ANGLE: &str = "edges_origami:foldAngle";
/// For each edge where it was written in the file that the FOLD file was made from, such as `line 12`.
pub const SOURCE: &str = "edges_origami:source";
/// For each face where it was written, as for edges.
pub const FACES_SOURCE: &str = "faces_origami:source";
/// How far a folded frame was asked to fold, in percent of all fold angles.
pub const PERCENT: &str = "origami:percent";
/// For each vertex whether it stays where it is.
pub const FIXED: &str = "vertices_origami:fixed";
