//! Finds the point that is already at a position: a grid of cells, each a few tolerances wide.

use std::collections::HashMap;

use glam::DVec2;

/// Points of the plane that are told apart only when farther than a tolerance.
#[derive(Debug)]
pub(crate) struct PointGrid {
    origin: DVec2,
    tolerance: f64,
    /// First point of each cell; the others follow by `next`.
    cells: HashMap<(i64, i64), u32>,
    entries: Vec<Entry>,
}

#[derive(Debug)]
struct Entry {
    id: u32,
    point: DVec2,
    next: u32,
}

const NONE: u32 = u32::MAX;
/// Cells this many tolerances wide: a point seldom has to look into more than one.
const CELL: f64 = 16.0;

impl PointGrid {
    pub(crate) fn new(origin: DVec2, tolerance: f64, capacity: usize) -> Self {
        let cells = HashMap::with_capacity(capacity);
        Self { origin, tolerance, cells, entries: Vec::with_capacity(capacity) }
    }

    fn cell(&self, point: DVec2) -> (i64, i64) {
        let cell = ((point - self.origin) / (CELL * self.tolerance)).floor();
        (cell.x as i64, cell.y as i64)
    }

    /// The nearest point within the tolerance.
    pub(crate) fn find(&self, point: DVec2) -> Option<u32> {
        let (low, high) = (self.cell(point - self.tolerance), self.cell(point + self.tolerance));
        let mut best: Option<(f64, u32)> = None;
        for x in low.0..=high.0 {
            for y in low.1..=high.1 {
                let mut at = self.cells.get(&(x, y)).copied().unwrap_or(NONE);
                while let Some(entry) = self.entries.get(at as usize) {
                    let distance = entry.point.distance(point);
                    if distance <= self.tolerance && best.is_none_or(|(least, id)| (distance, entry.id) < (least, id)) {
                        best = Some((distance, entry.id));
                    }
                    at = entry.next;
                }
            }
        }
        best.map(|(_, id)| id)
    }

    pub(crate) fn insert(&mut self, id: u32, point: DVec2) {
        let next = self.cells.insert(self.cell(point), self.entries.len() as u32).unwrap_or(NONE);
        self.entries.push(Entry { id, point, next });
    }
}
