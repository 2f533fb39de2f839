//! Which lines may meet, without a look at all pairs.

use std::f64::consts::PI;

use glam::DVec2;

use super::boxes::{Bounds, BoxTree};
use super::rings::{NONE, Rings};

/// Vertices of so many lines are hubs. Boxes do not tell their lines from each other, as all of them begin there:
/// directions do.
const HUB: usize = 64;
/// For the rounding of angles.
const SLACK: f64 = 1e-9;

/// Lines, to be asked for those near one of them.
pub(super) struct Near<'a> {
    points: &'a [DVec2],
    lines: &'a [[u32; 2]],
    touch: f64,
    /// The items of the tree: a line, or a hub with its lines.
    items: Vec<Item>,
    bounds: Vec<Bounds>,
    tree: BoxTree,
    /// The hub of each line, the one with most lines; none of others.
    hub: Vec<u32>,
    rings: Rings,
}

#[derive(Clone, Copy)]
enum Item {
    Line(u32),
    Hub(u32),
}

impl<'a> Near<'a> {
    /// A search over `lines`, given by their ends among `points`. Lines at a distance below `touch` are near.
    pub(super) fn new(points: &'a [DVec2], lines: &'a [[u32; 2]], touch: f64) -> Self {
        let rings = Rings::new(points, lines.iter().copied().map(Some));
        let valence = |v: u32| rings.at(v as usize).len();
        let hub = lines.iter().map(|[a, b]| {
            let (most, hub) = (valence(*a), *a).max((valence(*b), *b));
            if most < HUB { NONE } else { hub }
        });
        let hub: Vec<u32> = hub.collect();
        let alone = (0..).zip(&hub).filter(|(_, hub)| **hub == NONE).map(|(line, _)| Item::Line(line));
        let hubs = (0..points.len() as u32).filter(|v| valence(*v) >= HUB).map(Item::Hub);
        let items: Vec<Item> = alone.chain(hubs).collect();
        let of_line = |line: u32| {
            let [a, b] = lines[line as usize].map(|v| points[v as usize]);
            Bounds::of(a, b)
        };
        let of_item = |item: &Item| match item {
            Item::Line(line) => of_line(*line),
            Item::Hub(v) => {
                let lines = rings.at(*v as usize).iter().map(|half| of_line(half / 2));
                lines.reduce(Bounds::union).unwrap_or_else(|| Bounds::of(points[*v as usize], points[*v as usize]))
            }
        };
        let bounds: Vec<Bounds> = items.iter().map(of_item).collect();
        let tree = BoxTree::new(&bounds);
        Self { points, lines, touch, items, bounds, tree, hub, rings }
    }

    /// All lines, those that lie near each other one after the other.
    pub(super) fn order(&self) -> Vec<usize> {
        let mut order = Vec::with_capacity(self.lines.len());
        for item in self.tree.items() {
            match self.items[*item as usize] {
                Item::Line(line) => order.push(line as usize),
                Item::Hub(hub) => order.extend(self.of_hub(hub, 0.0, PI)),
            }
        }
        order
    }

    /// The lines that have this hub, in directions that are within `angle` of `direction`.
    fn of_hub(&self, hub: u32, direction: f64, angle: f64) -> impl Iterator<Item = usize> {
        let halves = self.rings.towards(hub as usize, direction, angle);
        halves.map(|half| half as usize / 2).filter(move |line| self.hub[*line] == hub)
    }

    /// Visits the lines near `line` that have no end in common with it.
    pub(super) fn apart(&self, line: usize, mut visit: impl FnMut(usize)) {
        let ends = self.lines[line];
        let [a, b] = ends.map(|v| self.points[v as usize]);
        let own = Bounds::of(a, b).grown(self.touch);
        let wanted = |other: &Bounds| own.overlaps(other) && !other.grown(self.touch).misses_line(a, b - a);
        let mut visit = |other: usize| {
            if !self.lines[other].iter().any(|v| ends.contains(v)) {
                visit(other);
            }
        };
        self.tree.visit(wanted, |item| {
            if !own.overlaps(&self.bounds[item]) {
                return;
            }
            match self.items[item] {
                Item::Line(other) => visit(other as usize),
                Item::Hub(hub) if ends.contains(&hub) => {}
                Item::Hub(hub) => {
                    let (direction, angle) = self.seen([a, b], self.points[hub as usize]);
                    self.of_hub(hub, direction, angle).for_each(&mut visit);
                }
            }
        });
    }

    /// In which direction from `eye` a line lies, and how far to either side whatever touches it does.
    fn seen(&self, [a, b]: [DVec2; 2], eye: DVec2) -> (f64, f64) {
        let (from, to) = (a - eye, b - eye);
        let along = b - a;
        let nearest = from + along * (-from.dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let distance = nearest.length() - self.touch;
        if distance <= self.touch {
            return (0.0, PI);
        }
        // It is seen under less than half a turn.
        let half = 0.5 * from.angle_to(to);
        (from.to_angle() + half, half.abs() + (self.touch / distance).asin() + SLACK)
    }

    /// As [`along`](Self::along), but for ends at hubs.
    pub(super) fn beside(&self, line: usize, visit: impl FnMut(usize)) {
        if self.hub[line] == NONE {
            self.along(line, visit);
        }
    }

    /// Visits the lines from an end of `line` that its other end may lie on.
    pub(super) fn along(&self, line: usize, mut visit: impl FnMut(usize)) {
        let [a, b] = self.lines[line].map(|v| self.points[v as usize]);
        // At which the other end is just so far away.
        let angle = (self.touch / a.distance(b)).min(1.0).asin() + SLACK;
        for (end, direction) in self.lines[line].into_iter().zip([b - a, a - b]) {
            let others = self.rings.towards(end as usize, direction.to_angle(), angle);
            others.map(|half| half as usize / 2).filter(|other| *other != line).for_each(&mut visit);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Spokes, `length` times the outline of a flower long, and the lines between the outer ends of neighbours.
    fn wheel(spokes: u32, length: impl Fn(u32) -> f64) -> (Vec<DVec2>, Vec<[u32; 2]>) {
        let point = |i: u32| {
            let angle = 2.0 * PI * f64::from(i) / f64::from(spokes);
            length(i) * (0.6 + 0.4 * (5.0 * angle).sin()) * DVec2::from_angle(angle)
        };
        let mut points: Vec<DVec2> = (0..spokes).map(point).collect();
        points.push(DVec2::ZERO);
        (points, (0..spokes).flat_map(|i| [[spokes, i], [i, (i + 1) % spokes]]).collect())
    }

    /// Lines looked at for each line.
    fn looks(spokes: u32) -> f64 {
        let (points, lines) = wheel(spokes, |_| 1.0);
        let near = Near::new(&points, &lines, 1e-9);
        let mut looks = 0;
        for line in 0..lines.len() {
            near.apart(line, |_| looks += 1);
            near.along(line, |_| looks += 1);
        }
        f64::from(looks) / lines.len() as f64
    }

    #[test]
    fn lines_of_a_hub_do_not_look_at_each_other() {
        let (few, many) = (looks(500), looks(8000));
        assert!(many < 2.0 * few + 8.0, "{few} and {many} for each line");
    }

    #[test]
    fn whatever_meets_is_near() {
        let (mut points, mut lines) = wheel(100, |i| 0.1 + (f64::from(i) * 0.618).fract());
        // Onto a spoke, across others, and a spoke along another one.
        points.extend([0.5 * points[7], DVec2::new(-1.0, 0.05), DVec2::new(1.0, 0.06), 2.0 * points[30]]);
        lines.extend([[101, 50], [102, 103], [100, 104]]);
        let near = Near::new(&points, &lines, 1e-9);
        let found = |line: usize| {
            let mut found = Vec::new();
            near.apart(line, |other| found.push(other));
            near.along(line, |other| found.push(other));
            found
        };
        assert!(found(200).contains(&14), "an end on a spoke");
        assert!(found(60).contains(&202), "a spoke along a longer one");
        let point = |v: u32| points[v as usize];
        let side = |[a, b]: [u32; 2], c: u32| (point(b) - point(a)).perp_dot(point(c) - point(a));
        let across = |one: [u32; 2], two: [u32; 2]| {
            side(one, two[0]) * side(one, two[1]) < 0.0 && side(two, one[0]) * side(two, one[1]) < 0.0
        };
        let crossed: Vec<usize> = (0..200).filter(|&other| across(lines[201], lines[other])).collect();
        let found = found(201);
        assert!(crossed.len() > 20 && crossed.iter().all(|other| found.contains(other)), "{crossed:?}");
    }
}
