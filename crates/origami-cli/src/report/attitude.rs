//! How results lie in space.

use origami::CreasePattern;
use origami::measure::attitude::Hold;

/// What keeps its place when a result is turned: `sheet`, `face 3`, `fixed vertices`, or `none`.
pub(crate) fn attitude(pattern: &CreasePattern, hold: Hold) -> String {
    match hold {
        Hold::Sheet if !pattern.fixed.is_empty() => "fixed vertices".to_owned(),
        Hold::Sheet => "sheet".to_owned(),
        Hold::Face(face) => format!("face {}", face.0),
        Hold::Nothing => "none".to_owned(),
    }
}
