//! Cuts faces into triangles from their first corner.
use crate::error::Error;
use crate::ids::{FaceId, VertexId};
use crate::pattern::CreasePattern;
/// Cuts faces into triangles from their first corner.
pub struct Triangulation {
    /// t
    pub triangles: Vec<[VertexId; 3]>,
    /// f
    pub face_of: Vec<FaceId>,
}
/// Cuts faces into triangles from their first corner.
pub fn triangulate(pattern: &CreasePattern) -> Result<Triangulation, Error> {
    let mut t = Triangulation { triangles: vec![], face_of: vec![] };
    for (f, face) in pattern.faces.iter().enumerate() {
        for k in 1..face.len() - 1 {
            t.triangles.push([face[0], face[k], face[k + 1]]);
            t.face_of.push(FaceId::new(f));
        }
    }
    Ok(t)
}
