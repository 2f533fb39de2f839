//! Triangles that lie upon each other in a circle: no depths say which is in front, so pairs do.

use origami_core::csr::Csr;

use crate::camera::View;
use crate::figure::Figure;
use crate::layers::NEAR;

/// By triangle: those that it is in front of or behind.
pub(super) struct Circles {
    /// By triangle: the other one, and whether this one is in front of it; no rows where there are no circles.
    others: Csr<(u32, bool)>,
    /// In clip depth: nearer than this pairs tell.
    near: f64,
}

impl Circles {
    pub(super) fn new(figure: &Figure, view: &View) -> Self {
        let mut entries: Vec<(u32, u32, bool)> = Vec::new();
        for [low, high] in &figure.circles {
            let up = figure.layers.get(*low as usize).map(|layer| layer.up).unwrap_or_default();
            let from_above = up.iter().zip(view.towards).map(|(a, b)| a * b).sum::<f32>() > 0.0;
            entries.extend([(*low, *high, !from_above), (*high, *low, from_above)]);
        }
        entries.sort_unstable();
        let rows = if entries.is_empty() { 0 } else { figure.triangles.len() };
        let others = entries.iter().map(|(triangle, other, front)| (*triangle as usize, (*other, *front)));
        Self { others: Csr::from_entries(rows, others), near: NEAR * view.depth_of_radius() }
    }

    /// Whether there are any.
    pub(super) fn is_empty(&self) -> bool {
        self.others.items().is_empty()
    }

    /// Whether `triangle` is in front of `other`, whose depths without layers these are; `None` if they are in no circle.
    pub(super) fn in_front(&self, [triangle, other]: [u32; 2], depths: [f64; 2]) -> Option<bool> {
        let pair = self.pair(triangle, other)?;
        let nearer = depths[1] - depths[0];
        Some(if nearer.abs() > self.near { nearer > 0.0 } else { pair })
    }

    /// Whether `triangle` belongs in front of `other`.
    fn pair(&self, triangle: u32, other: u32) -> Option<bool> {
        let triangle = triangle as usize;
        let own = if triangle < self.others.rows() { self.others.row(triangle) } else { return None };
        let index = own.binary_search_by_key(&other, |(other, _)| *other).ok()?;
        own.get(index).map(|(_, front)| *front)
    }

    /// The two triangles beside a line, the one in front first.
    pub(super) fn top_first(&self, [one, two]: [Option<u32>; 2]) -> [Option<u32>; 2] {
        match (one, two) {
            (Some(a), Some(b)) if self.pair(a, b) == Some(false) => [two, one],
            (None, _) => [two, one],
            _ => [one, two],
        }
    }

    /// Whether a line beside `triangles` is in front of the triangle `other`; the first depth is that of the line. `None` if
    /// they are in no circle.
    pub(super) fn line_in_front(&self, triangles: [Option<u32>; 2], other: u32, depths: [f64; 2]) -> Option<bool> {
        let answer = |t: u32| if t == other { Some(true) } else { self.in_front([t, other], depths) };
        // What lies in the fold, between the two, hides nothing of it.
        match triangles.map(|t| t.and_then(answer)) {
            [None, answer] | [answer, None] => answer,
            [Some(a), Some(b)] => Some(a || b),
        }
    }
}
