//! The lines around each vertex, in the order of their directions.

use std::f64::consts::{PI, TAU};

use crate::csr::Csr;
use glam::DVec2;

pub(super) const NONE: u32 = u32::MAX;

/// Half `2 l` of a line `l` leaves its first end, half `2 l + 1` its second.
#[derive(Debug)]
pub(super) struct Rings {
    /// The vertex that each half leaves; [`NONE`] for lines that are left out.
    pub(super) origin: Vec<u32>,
    /// Halves that leave each vertex, counterclockwise from direction -pi.
    around: Csr<u32>,
    /// The index of each half in its row of `around`.
    rank: Vec<u32>,
    direction: Vec<f64>,
}

impl Rings {
    /// The rings of lines between `points`, given by their ends; `None` is left out.
    pub(super) fn new(points: &[DVec2], lines: impl ExactSizeIterator<Item = Option<[u32; 2]>>) -> Self {
        let mut origin = vec![NONE; 2 * lines.len()];
        let mut direction = vec![0.0; origin.len()];
        for (line, ends) in lines.enumerate() {
            let Some(ends) = ends else { continue };
            let [a, b] = ends.map(|v| points[v as usize]);
            origin[2 * line..2 * line + 2].copy_from_slice(&ends);
            direction[2 * line] = (b - a).to_angle();
            direction[2 * line + 1] = (a - b).to_angle();
        }
        let live = origin.iter().enumerate().filter(|(_, from)| **from != NONE);
        let mut around = Csr::from_entries(points.len(), live.map(|(half, &from)| (from as usize, half as u32)));
        let mut rank = vec![0; origin.len()];
        for vertex in 0..points.len() {
            let row = around.row_mut(vertex);
            row.sort_by(|&a, &b| direction[a as usize].total_cmp(&direction[b as usize]));
            row.iter().enumerate().for_each(|(place, &half)| rank[half as usize] = place as u32);
        }
        Self { origin, around, rank, direction }
    }

    pub(super) fn vertices(&self) -> usize {
        self.around.rows()
    }

    /// The halves that leave a vertex, counterclockwise from direction -pi.
    pub(super) fn at(&self, vertex: usize) -> &[u32] {
        self.around.row(vertex)
    }

    /// The half that comes `steps` halves after `half`, counterclockwise around its vertex.
    pub(super) fn turned(&self, half: u32, steps: usize) -> u32 {
        let row = self.at(self.origin[half as usize] as usize);
        row[(self.rank[half as usize] as usize + steps) % row.len()]
    }

    /// The halves that leave a vertex in directions within `angle` of `direction`.
    pub(super) fn towards(&self, vertex: usize, direction: f64, angle: f64) -> impl Iterator<Item = u32> {
        let row = self.at(vertex);
        let place = |limit: f64| row.partition_point(|half| self.direction[*half as usize] < limit);
        let (low, high) = (direction - angle, direction + angle);
        // Directions are known from -pi to pi: an arc may lie in either turn, or in two.
        let arc = |turn: f64| place(low + turn)..place((high + turn).next_up());
        let arcs = if angle >= PI { [0..row.len(), 0..0, 0..0] } else { [arc(-TAU), arc(0.0), arc(TAU)] };
        arcs.into_iter().flat_map(|arc| row[arc].iter().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_leaves_in_nearly_the_same_direction_is_found_on_both_sides() {
        let degrees = [0.0_f64, 178.0, -179.0, 90.0, 175.0, -100.0];
        let mut points: Vec<DVec2> = degrees.map(|d| DVec2::from_angle(d.to_radians())).to_vec();
        points.push(DVec2::ZERO);
        let lines = (0..6).map(|i| (i != 3).then_some([6, i]));
        let rings = Rings::new(&points, lines.collect::<Vec<_>>().into_iter());
        let within = |line: usize, angle: f64| {
            let halves = rings.towards(6, degrees[line].to_radians(), angle.to_radians());
            let mut found: Vec<u32> = halves.map(|half| half / 2).collect();
            found.sort_unstable();
            found
        };
        assert_eq!(within(1, 1.0), [1]);
        assert_eq!(within(1, 3.5), [1, 2, 4], "across the direction where angles jump");
        assert_eq!(within(2, 3.5), [1, 2]);
        assert_eq!(within(0, 101.0), [0, 5], "line 3 is left out");
        assert_eq!(within(0, 181.0), [0, 1, 2, 4, 5]);
        assert_eq!(rings.turned(2, 1), 4);
    }
}
