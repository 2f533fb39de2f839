//! Curved creases: from Bezier curves to straight pieces.

mod flatten;

use kurbo::PathSeg;
use origami_core::error::Error;

use crate::lines::Lines;

/// A line of a pattern as drawn, straight and curved pieces one after the other.
#[derive(Debug)]
pub(crate) struct Stroke {
    /// In the plane of the pattern.
    pub(crate) path: Vec<PathSeg>,
    /// FOLD's.
    pub(crate) letter: &'static str,
    /// In degrees; `None` leaves it to the letter.
    pub(crate) angle: Option<f64>,
    /// What a person finds it by.
    pub(crate) source: String,
}

/// The strokes in straight pieces. `tolerance` is how far these may be from the curves, in the units of the file.
pub(crate) fn lines(strokes: Vec<Stroke>, tolerance: Option<f64>) -> Result<Lines, Error> {
    let mut lines = Lines::default();
    let tolerance = flatten::tolerance(&strokes, tolerance)?;
    for stroke in strokes {
        let points = flatten::points(&stroke.path, tolerance);
        let many = points.iter().map(|run| run.len() - 1).sum::<usize>() > 1;
        let pieces = points.iter().flat_map(|run| run.windows(2)).filter(|ends| ends[0] != ends[1]);
        for (piece, ends) in (1..).zip(pieces) {
            let source = if many { format!("{} piece {piece}", stroke.source) } else { stroke.source.clone() };
            lines.push([ends[0], ends[1]], stroke.letter, stroke.angle, source);
        }
    }
    Ok(lines)
}
