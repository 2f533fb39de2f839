//! Curved creases: from Bezier curves to straight pieces whose ends face each other, and to the rulings between them.
//!
//! 1. [`runs`]: each stroke in many short pieces, far closer to the curve than asked for.
//! 2. [`ends`], [`knots`]: ends that nearly meet do; where strokes cross, and where one ends on another, both have a point.
//! 3. [`spread`]: of all these points those are kept that the tolerance needs, and those that face a kept point across a face:
//!    a ruling leaves a curve as nearly at a right angle as it can.
//! 4. [`rulings`]: each face between the kept points is cut along rulings, which become flat lines.
//!
//! `docs/CURVED.md` says why, and what was measured.

mod ends;
mod faces;
mod knots;
mod rulings;
mod runs;
mod spread;
mod straight;

use std::collections::BTreeMap;

use glam::DVec2;
use kurbo::PathSeg;
use origami_core::CreasePattern;
use origami_core::error::{Error, Place, WarningCode};

use crate::lines::Lines;
use runs::Run;

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

/// How far pieces may be from their curve where nothing is said, in sizes of the pattern.
const TOLERANCE: f64 = 5e-4;

/// The strokes in straight pieces, and the rulings between curved ones. `tolerance` is how far the pieces may be from the
/// curves, in the units of the file.
pub(crate) fn lines(strokes: Vec<Stroke>, tolerance: Option<f64>) -> Result<Lines, Error> {
    let size = runs::size(&strokes);
    let tolerance = match tolerance {
        None => TOLERANCE * size,
        Some(tolerance) if tolerance > 0.0 && tolerance.is_finite() => tolerance,
        Some(tolerance) => {
            return Err(Error::invalid("curve-tolerance", format!("is {tolerance}"), "a length above 0"));
        }
    };
    let mut runs = runs::of(&strokes, tolerance)?;
    if !runs.iter().any(Run::is_curved) {
        straight::join(&mut runs, &strokes, size);
        return Ok(written(&strokes, &runs, &[]));
    }
    let moved = ends::join(&mut runs, tolerance);
    runs.retain(|run| run.nodes.len() > 1);
    knots::tie(&mut runs, tolerance);
    // The faces between the fine pieces say which points face each other. Where there are none, nothing is to be faced.
    let faces = pattern(&strokes, &runs).map_or_else(Vec::new, |pattern| faces::of(&pattern, &runs));
    let feet = spread::choose(&mut runs, &faces, tolerance);
    runs.iter_mut().for_each(Run::thin);
    spread::split(&mut runs, &feet, size);
    let rulings = pattern(&strokes, &runs).map_or_else(Vec::new, |pattern| rulings::of(&faces::of(&pattern, &runs)));
    let mut lines = written(&strokes, &runs, &rulings);
    for stroke in moved {
        let place = || Place::key("edges_vertices").written_at(&strokes[stroke].source);
        let message = "an end is within the curve tolerance of another stroke, and was moved there";
        lines.note(WarningCode::VerticesMerged, place, message);
    }
    Ok(lines)
}

/// The pattern that the runs make, if they make one.
fn pattern(strokes: &[Stroke], runs: &[Run]) -> Option<CreasePattern> {
    CreasePattern::from_document(&written(strokes, runs, &[]).into_document(), 0).ok()
}

fn written(strokes: &[Stroke], runs: &[Run], rulings: &[[DVec2; 2]]) -> Lines {
    let mut lines = Lines::default();
    let mut pieces: BTreeMap<usize, usize> = BTreeMap::new();
    for run in runs {
        *pieces.entry(run.stroke).or_default() += run.nodes.len() - 1;
    }
    let mut piece = BTreeMap::new();
    for run in runs {
        let stroke = &strokes[run.stroke];
        for ends in run.nodes.windows(2) {
            let number = piece.entry(run.stroke).or_insert(0_usize);
            *number += 1;
            let source = if pieces[&run.stroke] > 1 {
                format!("{} piece {number}", stroke.source)
            } else {
                stroke.source.clone()
            };
            lines.push([ends[0].at, ends[1].at], stroke.letter, stroke.angle, source);
        }
    }
    for ends in rulings {
        lines.push(*ends, "F", None, "a ruling");
    }
    lines
}

/// A key for places that are written alike.
fn key(at: DVec2) -> [u64; 2] {
    let at = at + DVec2::ZERO;
    [at.x.to_bits(), at.y.to_bits()]
}

#[cfg(test)]
mod tests;
