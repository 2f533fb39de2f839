//! A part of the pairs, measured and pushing, on one thread.

use glam::DVec3;

use super::Contact;
use super::lanes::{Given, Measured, Push, WIDTH, measure_edges, measure_points, push};
use super::pairs::Pair;
use super::soon::{Brief, Soon};
use crate::ids::NodeId;
use crate::parallel;

/// Pairs that are worth a task of their own, and how many for each node: each task has forces of all nodes.
const PAIRS: usize = 512;
const PAIRS_OF_NODE: usize = 2;
/// More tasks are never made.
const MOST: usize = 8;

/// What a node feels of contact: the force, and the bound on the row sum of its stiffness.
pub(super) type Felt = [f64; 4];

/// What is done to a part of the pairs, with memory of its own.
#[derive(Clone, Debug)]
pub(super) struct Task {
    /// By node.
    pub(super) felt: Vec<Felt>,
    /// How many pairs of the part push.
    pub(super) pushing: usize,
    given: Given,
    measured: Measured,
    push: Push,
}

impl Task {
    fn new() -> Self {
        Self { felt: Vec::new(), pushing: 0, given: Given::new(), measured: Measured::new(), push: Push::new() }
    }

    /// Measures and pushes its part.
    fn run(&mut self, all: &All<'_>, part: Part<'_>) {
        self.felt.clear();
        self.felt.resize(all.positions.len(), [0.0; 4]);
        self.pushing = 0;
        pulp::Arch::new().dispatch(Work { task: self, all, part });
    }

    /// The first pairs of one kind that may push, as many as lie side by side. The result is how many were looked at.
    #[inline(always)]
    fn block(&mut self, edges: bool, all: &All<'_>, pairs: &[Brief], due: &mut [f64]) -> usize {
        let Self { given, measured, push: pushes, .. } = self;
        let mut own = [0; WIDTH];
        let (mut count, mut seen) = (0, 0);
        for due in &*due {
            own[count] = seen;
            count += usize::from(*due < all.bound);
            seen += 1;
            if count == WIDTH {
                break;
            }
        }
        if count == 0 {
            return seen;
        }
        // All pairs are fetched before the first is looked at: memory is far away.
        let mut nodes = [[NodeId(0); 4]; WIDTH];
        for (i, pair) in own[..count].iter().map(|i| &pairs[*i]).enumerate() {
            nodes[i] = pair.nodes;
            given.eased[i] = pair.eased;
            [given.width[i], given.closed[i]] = all.widths[pair.width as usize];
        }
        for (i, nodes) in nodes[..count].iter().enumerate() {
            given.place(i, nodes, all.positions);
        }
        if edges {
            measure_edges(given, measured);
        } else {
            measure_points(given, measured);
        }
        let least = measured.gap[..count].iter().copied().fold(f64::INFINITY, f64::min);
        if least < all.contact.gap {
            push(edges, all.contact.stiffness, given, measured, pushes);
        }
        for i in 0..count {
            let mut gap = self.measured.gap[i];
            if edges && self.measured.is_parallel(i) {
                gap = self.plainly(&pairs[own[i]], all);
            } else if gap < self.given.width[i] {
                self.pushing += 1;
                self.add(edges, i, &nodes[i]);
            }
            due[own[i]] = gap + all.twice_the_way;
        }
        seen
    }

    /// Adds what pair `i` of a block does.
    #[inline(always)]
    fn add(&mut self, edges: bool, i: usize, nodes: &[NodeId; 4]) {
        let Self { measured, push, felt, .. } = self;
        let [x, y, z] = [push.force[0][i], push.force[1][i], push.force[2][i]];
        let stiffness = push.stiffness[i];
        for (node, weights) in nodes.iter().zip(&measured.weights) {
            let weight = weights[i];
            let own = &mut felt[node.index()];
            *own = [own[0] + weight * x, own[1] + weight * y, own[2] + weight * z, own[3] + weight.abs() * stiffness];
        }
        if edges && push.factor[i] < 1.0 {
            let [first, second] = [&push.turning[0], &push.turning[1]].map(|by| [by[0][i], by[1][i], by[2][i]]);
            let by = [first.map(|x| -x), first, second.map(|x| -x), second];
            for (node, by) in nodes.iter().zip(by) {
                let own = &mut felt[node.index()];
                *own = [own[0] + by[0], own[1] + by[1], own[2] + by[2], own[3]];
            }
        }
    }

    /// The same of edges that are nearly parallel; the result is their gap.
    #[cold]
    fn plainly(&mut self, brief: &Brief, all: &All<'_>) -> f64 {
        let [width, closed] = all.widths[brief.width as usize];
        let pair = &Pair { nodes: brief.nodes, split: 2, closed, width, eased: brief.eased };
        let near = pair.near(brief.number, all.positions);
        if near.gap < pair.width {
            self.pushing += 1;
            let pushes = pair.push(&near, all.positions, all.contact.stiffness);
            for (node, (force, sum)) in pair.nodes.iter().zip(pushes) {
                let own = &mut self.felt[node.index()];
                *own = [own[0] + force.x, own[1] + force.y, own[2] + force.z, own[3] + sum];
            }
        }
        near.gap
    }
}

/// What all tasks look at.
#[derive(Clone, Copy)]
pub(super) struct All<'a> {
    pub(super) contact: Contact,
    pub(super) widths: &'a [[f64; 2]],
    pub(super) positions: &'a [DVec3],
    /// Pairs that are due before this are measured.
    pub(super) bound: f64,
    pub(super) twice_the_way: f64,
}

/// Some pairs, of which the first `points` are of points; and when each is due.
struct Part<'a> {
    pairs: &'a [Brief],
    points: usize,
    due: &'a mut [f64],
}

/// The work of a task, compiled for each set of instructions.
struct Work<'a, 'b> {
    task: &'a mut Task,
    all: &'a All<'b>,
    part: Part<'a>,
}

impl pulp::NullaryFnOnce for Work<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { task, all, part: Part { pairs, points, due } } = self;
        let mut from = 0;
        while from < points {
            from += task.block(false, all, &pairs[from..points], &mut due[from..points]);
        }
        while from < pairs.len() {
            from += task.block(true, all, &pairs[from..], &mut due[from..]);
        }
    }
}

/// Measures the pairs that are due, in as many tasks as they are worth, and lets them push; by several threads or not. How
/// many tasks there are does not depend on threads, and neither does any sum.
pub(super) fn run(tasks: &mut Vec<Task>, all: &All<'_>, soon: &mut Soon, shared: bool) {
    let worth = PAIRS.max(PAIRS_OF_NODE * all.positions.len());
    let count = (soon.pairs.len() / worth).clamp(1, MOST);
    tasks.resize_with(count, Task::new);
    let each = soon.pairs.len().div_ceil(count);
    let part = Part { pairs: &soon.pairs, points: soon.points, due: &mut soon.due };
    halve(tasks, all, (part, each), shared);
}

fn halve(tasks: &mut [Task], all: &All<'_>, (part, each): (Part<'_>, usize), shared: bool) {
    let half = tasks.len() / 2;
    if half == 0 {
        if let [task] = tasks {
            task.run(all, part);
        }
        return;
    }
    let Part { pairs, points, due } = part;
    let at = (half * each).min(pairs.len());
    let (first, second) = tasks.split_at_mut(half);
    let ((pairs, other_pairs), (due, other_due)) = (pairs.split_at(at), due.split_at_mut(at));
    let own = Part { pairs, points: points.min(at), due };
    let others = Part { pairs: other_pairs, points: points.saturating_sub(at), due: other_due };
    let one = move || halve(first, all, (own, each), shared);
    let other = move || halve(second, all, (others, each), shared);
    if shared {
        parallel::join(one, other);
    } else {
        one();
        other();
    }
}
