//! What a format cannot hold, counted.

use origami_core::CreasePattern;
use origami_core::error::{Warning, WarningCode};

use super::strokes::{Kind, Stroke};

/// Angles that differ by less than this, in degrees, are equal.
const EQUAL: f64 = 1e-9;

/// A warning for what is lost of so many of something.
pub(super) fn lost(format: &'static str, count: usize, one: &str, many: &str, what: &str) -> Option<Warning> {
    let things = if count == 1 { one } else { many };
    (count > 0).then(|| Warning::new(WarningCode::Fallback, format, format!("{count} {things} {what}")))
}

/// Warnings of stiffnesses and fixed vertices, which no format but FOLD has.
pub(super) fn of_ours(format: &'static str, pattern: &CreasePattern) -> impl Iterator<Item = Warning> {
    let edges = pattern.edges.iter().filter(|edge| edge.alias_of.is_none());
    let stiff = edges.filter(|edge| edge.k_crease.is_some() || edge.ea.is_some()).count();
    let fixed = pattern.fixed.len();
    let stiff =
        lost(format, stiff, "edge loses its", "edges lose their", "own stiffness, which it cannot hold; FOLD can");
    let fixed = lost(format, fixed, "vertex is", "vertices are", "no longer fixed, which it cannot hold; FOLD can");
    stiff.into_iter().chain(fixed)
}

/// How many lines fold by another angle than their letter says without one.
pub(super) fn angled(strokes: &[Stroke]) -> usize {
    let whole = |stroke: &&Stroke| match (stroke.kind, stroke.angle) {
        (Kind::Mountain, Some(angle)) => (angle + 180.0).abs() < EQUAL,
        (Kind::Valley, Some(angle)) => (angle - 180.0).abs() < EQUAL,
        (Kind::Mountain | Kind::Valley, None) => false,
        (_, angle) => angle.is_none_or(|angle| angle.abs() < EQUAL),
    };
    strokes.iter().filter(|stroke| !whole(stroke)).count()
}
