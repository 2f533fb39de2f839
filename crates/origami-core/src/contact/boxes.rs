//! Boxes around things, in a tree: which of them may meet something is found without looking at all.

use std::ops::Range;

use glam::DVec3;

/// Things in a leaf of the tree.
const LEAF: usize = 4;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub(super) low: DVec3,
    pub(super) high: DVec3,
}

impl Bounds {
    /// The smallest box around points.
    pub(super) fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        let none = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };
        points.into_iter().fold(none, |b, p| Self { low: b.low.min(p), high: b.high.max(p) })
    }

    /// The box with so much more on every side.
    pub(super) fn grown(self, by: f64) -> Self {
        Self { low: self.low - DVec3::splat(by), high: self.high + DVec3::splat(by) }
    }

    /// The smallest box around two.
    fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Whether they have a point in common, if only one of their surfaces.
    pub(super) fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }
}

/// A part of the tree. Nodes lie in the order in which they are visited.
#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    /// The node after all that is below this one.
    skip: u32,
    /// The things of a leaf, as a range of [`BoxTree::things`]; empty where there are nodes below.
    things: [u32; 2],
}

/// Boxes that are halved along their longest side again and again.
#[derive(Clone, Debug, Default)]
pub(super) struct BoxTree {
    nodes: Vec<Node>,
    things: Vec<u32>,
}

impl BoxTree {
    /// The tree of things with these boxes. Where boxes are not finite, things are found or not, but nothing else is wrong.
    pub(super) fn new(boxes: &[Bounds]) -> Self {
        let mut tree = Self { nodes: Vec::new(), things: (0..).take(boxes.len()).collect() };
        if !boxes.is_empty() {
            tree.halve(boxes, [0, boxes.len()]);
        }
        tree
    }

    /// Adds the node of a range of things, and all below it.
    fn halve(&mut self, boxes: &[Bounds], [from, to]: [usize; 2]) {
        let own = &mut self.things[from..to];
        let boxed = |thing: u32| boxes[thing as usize];
        let bounds = own.iter().map(|t| boxed(*t)).reduce(Bounds::union).unwrap_or(Bounds::around([]));
        let leaf = own.len() <= LEAF;
        let node = self.nodes.len();
        // Things were counted in `u32`.
        #[expect(clippy::cast_possible_truncation, reason = "the ids of things are u32")]
        let things = if leaf { [from as u32, to as u32] } else { [0, 0] };
        self.nodes.push(Node { bounds, skip: 0, things });
        if !leaf {
            let size = bounds.high - bounds.low;
            let longest = if size.x >= size.y && size.x >= size.z { 0 } else { 1 + usize::from(size.z > size.y) };
            let place = |t: u32| boxed(t).low[longest] + boxed(t).high[longest];
            let half = own.len() / 2;
            // By number where places are equal, so that there is one order only.
            own.select_nth_unstable_by(half, |a, b| place(*a).total_cmp(&place(*b)).then(a.cmp(b)));
            self.halve(boxes, [from, from + half]);
            self.halve(boxes, [from + half, to]);
        }
        #[expect(clippy::cast_possible_truncation, reason = "fewer nodes than things")]
        let skip = self.nodes.len() as u32;
        self.nodes[node].skip = skip;
    }

    /// The same tree of things whose boxes have become these. What was near each other and is no more makes it slower, not
    /// wrong.
    pub(super) fn moved(&self, boxes: &[Bounds]) -> Self {
        let mut tree = self.clone();
        for at in (0..tree.nodes.len()).rev() {
            let [from, to] = tree.nodes[at].things;
            let own = tree.things[from as usize..to as usize].iter().map(|thing| boxes[*thing as usize]);
            tree.nodes[at].bounds = own.reduce(Bounds::union).unwrap_or_else(|| {
                // Both halves lie behind.
                let half = at + 1;
                let other = tree.nodes[half].skip as usize;
                tree.nodes[half].bounds.union(tree.nodes[other].bounds)
            });
        }
        tree
    }

    /// Tells `visit` the things of all leaves that meet a box: all that meet it themselves, and some more.
    pub(super) fn near(&self, own: &Bounds, visit: impl FnMut(usize)) {
        self.near_from(0, own, visit);
    }

    /// How many parts there are: leaves and what is above them.
    pub(super) fn parts(&self) -> usize {
        self.nodes.len()
    }

    /// Tells `visit` all pairs of things whose boxes meet, once each, and some more. Only those of which the first is in one of
    /// these parts.
    pub(super) fn near_each_other(&self, parts: Range<usize>, mut visit: impl FnMut([usize; 2])) {
        for at in parts {
            let node = &self.nodes[at];
            let [from, to] = node.things.map(|i| i as usize);
            let own = &self.things[from..to];
            for (i, first) in own.iter().enumerate() {
                own[i + 1..].iter().for_each(|second| visit([*first as usize, *second as usize]));
            }
            if !own.is_empty() {
                // What lies before has met it already.
                self.near_from(at + 1, &node.bounds, |second| {
                    own.iter().for_each(|first| visit([*first as usize, second]));
                });
            }
        }
    }

    /// The same as [`BoxTree::near`] from a node on.
    #[inline]
    fn near_from(&self, mut at: usize, own: &Bounds, mut visit: impl FnMut(usize)) {
        while let Some(node) = self.nodes.get(at) {
            if node.bounds.meets(own) {
                let [from, to] = node.things;
                self.things[from as usize..to as usize].iter().for_each(|thing| visit(*thing as usize));
                at += 1;
            } else {
                at = node.skip as usize;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes of all sizes, some flat, by a fixed sequence.
    fn boxes(count: usize) -> Vec<Bounds> {
        let mut state = 9_u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 33).expect("31 bits")) / f64::from(1_u32 << 31)
        };
        let mut point = move || DVec3::new(next(), next(), next());
        (0..count)
            .map(|i| {
                let (low, size) = (point(), point() * if i % 7 == 0 { 1.0 } else { 0.05 });
                Bounds { low, high: low + if i % 3 == 0 { size * DVec3::new(1.0, 1.0, 0.0) } else { size } }
            })
            .collect()
    }

    #[test]
    fn it_finds_what_looking_at_all_finds() {
        for count in [0, 1, 4, 5, 300] {
            let boxes = boxes(count);
            let tree = BoxTree::new(&boxes);
            let turned = |p: DVec3| DVec3::new(p.y, p.z, p.x);
            let elsewhere: Vec<Bounds> =
                boxes.iter().map(|b| Bounds { low: turned(b.low), high: turned(b.high) }).collect();
            let moved = BoxTree::new(&elsewhere).moved(&boxes);
            let mut found = 0;
            for own in &boxes {
                let mut by_moved = Vec::new();
                moved.near(own, |thing| by_moved.push(thing));
                by_moved.retain(|thing| boxes[*thing].meets(own));
                by_moved.sort_unstable();
                let mut near = Vec::new();
                tree.near(own, |thing| near.push(thing));
                near.retain(|thing| boxes[*thing].meets(own));
                near.sort_unstable();
                let all: Vec<usize> = (0..count).filter(|thing| boxes[*thing].meets(own)).collect();
                found += all.len();
                assert_eq!(near, all);
                assert_eq!(by_moved, all);
            }
            let mut together = Vec::new();
            let half = tree.parts() / 2;
            for parts in [0..half, half..tree.parts()] {
                tree.near_each_other(parts, |[a, b]| together.push([a.min(b), a.max(b)]));
            }
            together.retain(|[a, b]| boxes[*a].meets(&boxes[*b]));
            let pairs = together.len();
            together.sort_unstable();
            together.dedup();
            assert_eq!((pairs, 2 * pairs + count), (together.len(), found), "each pair once");
            assert!(count < 300 || (found > 2 * count && found < count * count / 4), "{found} say something");
        }
    }

    #[test]
    fn equal_places_and_numbers_that_are_none_do_no_harm() {
        let mut boxes = vec![Bounds::around([DVec3::ZERO]); 50];
        boxes[7].low.x = f64::NAN;
        boxes[9] = Bounds::around([]);
        let tree = BoxTree::new(&boxes);
        let mut near = 0;
        tree.near(&boxes[0], |_| near += 1);
        assert!(near >= 40);
    }
}
