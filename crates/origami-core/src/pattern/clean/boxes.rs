//! A tree of boxes over segments, halved at the median: finds what lies near without looking at all pairs.

use glam::DVec2;

/// A box along the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) low: DVec2,
    pub(super) high: DVec2,
}

impl Bounds {
    pub(super) fn of(a: DVec2, b: DVec2) -> Self {
        Self { low: a.min(b), high: a.max(b) }
    }

    pub(super) fn grown(self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    pub(super) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub(super) fn overlaps(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    /// Whether the line through `a` in `direction` passes it by.
    pub(super) fn misses_line(&self, a: DVec2, direction: DVec2) -> bool {
        let half = (self.high - self.low) * 0.5;
        let reach = half.x * direction.y.abs() + half.y * direction.x.abs();
        direction.perp_dot(self.low + half - a).abs() > reach
    }
}

/// The tree. Items are numbered as in the slice that it was made from.
#[derive(Debug)]
pub(super) struct BoxTree {
    nodes: Vec<Node>,
    items: Vec<u32>,
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    /// The items below are `items[first..last]`.
    first: u32,
    last: u32,
    /// The second child; the first one follows the node itself. 0 on a leaf.
    second: u32,
}

const LEAF: usize = 4;

impl BoxTree {
    pub(super) fn new(boxes: &[Bounds]) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(boxes.len()), items: (0..boxes.len() as u32).collect() };
        if !boxes.is_empty() {
            tree.grow(boxes, 0, boxes.len());
        }
        tree
    }

    /// Halving: the depth is the logarithm of the number of items.
    fn grow(&mut self, boxes: &[Bounds], first: usize, last: usize) -> usize {
        let items = &mut self.items[first..last];
        let bounds = items.iter().map(|&i| boxes[i as usize]).reduce(Bounds::union).unwrap_or(boxes[0]);
        let node = self.nodes.len();
        self.nodes.push(Node { bounds, first: first as u32, last: last as u32, second: 0 });
        if items.len() > LEAF {
            let wide = bounds.high - bounds.low;
            let centre = |i: u32| {
                let sum = boxes[i as usize].low + boxes[i as usize].high;
                if wide.x >= wide.y { sum.x } else { sum.y }
            };
            let half = items.len() / 2;
            items.select_nth_unstable_by(half, |&a, &b| centre(a).total_cmp(&centre(b)).then(a.cmp(&b)));
            self.grow(boxes, first, first + half);
            let second = self.grow(boxes, first + half, last);
            self.nodes[node].second = second as u32;
        }
        node
    }

    /// All items, those that lie near each other one after the other.
    pub(super) fn items(&self) -> &[u32] {
        &self.items
    }

    /// Visits all items in boxes for which `near` holds, roughly from the right and from above.
    pub(super) fn visit(&self, near: impl Fn(&Bounds) -> bool, mut visit: impl FnMut(usize)) {
        let mut stack = vec![0usize];
        while let Some(at) = stack.pop() {
            let Some(node) = self.nodes.get(at).filter(|node| near(&node.bounds)) else { continue };
            if node.second == 0 {
                self.items[node.first as usize..node.last as usize].iter().for_each(|&item| visit(item as usize));
            } else {
                stack.extend([at + 1, node.second as usize]);
            }
        }
    }
}
