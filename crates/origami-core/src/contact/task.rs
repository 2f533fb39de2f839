//! A part of the pairs, measured and pushing, on one thread.

mod grouped;
mod part;

use glam::DVec3;

use super::Contact;
use super::groups::Groups;
use super::lanes::{Arms, Given, Measured, Push, WIDTH, measure_edges, measure_ends, measure_points, push};
use super::pairs::Pair;
use super::soon::{Brief, Kind, Soon};
use super::stars::Star;
use super::stiff::{STIFF, Stiff};
use crate::ids::NodeId;
use crate::parallel;
use part::{Part, Those};

/// Pairs that are worth a task of their own, and how many for each node: each task has forces of all nodes.
const PAIRS: usize = 512;
const PAIRS_OF_NODE: usize = 4;
/// A group is worth as many pairs.
const OF_GROUP: usize = 4;
/// More tasks are never made.
const MOST: usize = 8;

/// What a node feels of contact: the force, and the bound on the row sum of its stiffness but for that of stiff pairs.
pub(super) type Felt = [f64; 4];

/// What is done to a part of the pairs, with memory of its own.
#[derive(Clone, Debug)]
pub(super) struct Task {
    /// By node.
    pub(super) felt: Vec<Felt>,
    /// How many pairs of the part push.
    pub(super) pushing: usize,
    /// Those that are stiff.
    pub(super) stiff: Vec<Stiff>,
    given: Given,
    measured: Measured,
    push: Push,
    /// Pairs that push and that a group may take.
    met: Vec<Met>,
    /// Pairs that were in a group until now, of points and of edges.
    lost: [Kind; 2],
}

/// A pair whose nearest points are not inside both of its things.
#[derive(Clone, Copy, Debug)]
struct Met {
    edges: bool,
    /// Which it is of its kind in [`Soon`].
    index: usize,
    /// The nodes whose weights are not 0, as bits.
    weights: u8,
}

impl Task {
    fn new() -> Self {
        Self {
            felt: Vec::new(),
            pushing: 0,
            stiff: Vec::new(),
            given: Given::new(),
            measured: Measured::new(),
            push: Push::new(),
            met: Vec::new(),
            lost: Default::default(),
        }
    }

    /// Measures and pushes its part.
    fn run(&mut self, all: &All<'_>, part: Part<'_>) {
        self.felt.clear();
        self.felt.resize(all.positions.len(), [0.0; 4]);
        self.pushing = 0;
        self.stiff.clear();
        self.met.clear();
        pulp::Arch::new().dispatch(Work { task: self, all, part });
    }

    /// The first pairs of one kind that may push, as many as lie side by side. The result is how many were looked at. Groups are
    /// told of those that push by their places after `from`, where that is known.
    #[inline(always)]
    fn block(
        &mut self,
        edges: bool,
        all: &All<'_>,
        (pairs, due): (&[Brief], &mut [f64]),
        from: Option<usize>,
    ) -> usize {
        let Self { given, measured, push: pushes, .. } = self;
        let (own, count, seen) = first_due(due, all.bound);
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
            if (0..count).any(|i| measured.is_parallel(i)) {
                measure_ends(given, measured);
            }
        } else {
            measure_points(given, measured);
        }
        let least = measured.gap[..count].iter().copied().fold(f64::INFINITY, f64::min);
        if least < all.contact.gap {
            push(edges, all.contact.stiffness, given, measured, pushes);
        }
        for i in 0..count {
            let gap = self.measured.gap[i];
            if gap < self.given.width[i] {
                self.pushing += 1;
                self.add(edges, i, &nodes[i]);
                let single = edges && self.push.factor[i] < 1.0 || pairs[own[i]].width != 0;
                let weights = self.measured.nodes(i);
                if let (Some(from), true) = (from, all.takes && !single && weights != ALL) {
                    self.met.push(Met { edges, index: from + own[i], weights });
                }
            }
            due[own[i]] = gap.min(all.farthest) + all.twice_the_way;
        }
        seen
    }

    /// The bound on the rows of pair `i` of a block, per weight, if it is not stiff; else it is kept as it is, and nothing is left.
    #[inline(always)]
    fn less_stiff(&mut self, i: usize, (nodes, weights): (&[NodeId; 4], [f64; 4]), bound: f64) -> f64 {
        let Self { given, measured, stiff, .. } = self;
        if measured.gap[i] >= STIFF * given.width[i] {
            return bound;
        }
        stiff.push(Stiff { nodes: *nodes, weights, normal: measured.normal(i), stiffness: 0.5 * bound });
        0.0
    }

    /// Adds what pair `i` of a block does.
    #[inline(always)]
    fn add(&mut self, edges: bool, i: usize, nodes: &[NodeId; 4]) {
        let weights = [0, 1, 2, 3].map(|node| self.measured.weights[node][i]);
        let stiffness = self.less_stiff(i, (nodes, weights), self.push.stiffness[i]);
        let Self { measured, push, felt, .. } = self;
        let [x, y, z] = [push.force[0][i], push.force[1][i], push.force[2][i]];
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
}

/// The bits of all four nodes of a pair.
const ALL: u8 = 0b1111;

/// Where layers are looked at.
#[derive(Clone, Copy)]
pub(super) struct Here<'a> {
    pub(super) contact: Contact,
    pub(super) positions: &'a [DVec3],
    /// Pairs that are due before this are measured.
    pub(super) bound: f64,
    pub(super) twice_the_way: f64,
    /// The largest moves of all evaluations so far, added up.
    pub(super) path: f64,
    /// What is farther apart than this has not come nearer by more than the way tells.
    pub(super) farthest: f64,
    /// Whether groups take pairs.
    pub(super) takes: bool,
    /// The whole list.
    pub(super) pairs: &'a [Pair],
}

/// What all tasks look at.
struct All<'a> {
    here: Here<'a>,
    widths: &'a [[f64; 2]],
    stars: &'a [Star],
    arms: &'a [Arms],
}

impl<'a> std::ops::Deref for All<'a> {
    type Target = Here<'a>;

    fn deref(&self) -> &Here<'a> {
        &self.here
    }
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
        let Self { task, all, part: Part { points, edges, groups, group_due, places } } = self;
        let mut from = 0;
        while from < groups.len() {
            from += task.groups(all, (&mut groups[from..], &mut group_due[from..], &places[from..]));
        }
        let mut lost = std::mem::take(&mut task.lost);
        for (is_edges, some) in [(false, points), (true, edges)] {
            let mut from = 0;
            while from < some.pairs.len() {
                let own = (&some.pairs[from..], &mut some.due[from..]);
                from += task.block(is_edges, all, own, Some(some.from + from));
            }
            let Kind { pairs, due } = &mut lost[usize::from(is_edges)];
            let mut from = 0;
            while from < pairs.len() {
                from += task.block(is_edges, all, (&pairs[from..], &mut due[from..]), None);
            }
        }
        task.lost = lost;
    }
}

/// The places of the first that are due before the bound, as many as lie side by side; how many these are, and how many were
/// looked at.
#[inline(always)]
fn first_due(due: &[f64], bound: f64) -> ([usize; WIDTH], usize, usize) {
    let mut own = [0; WIDTH];
    let (mut count, mut seen) = (0, 0);
    for due in due {
        own[count] = seen;
        count += usize::from(*due < bound);
        seen += 1;
        if count == WIDTH {
            break;
        }
    }
    (own, count, seen)
}

/// Measures the pairs that are due, in as many tasks as they are worth, and lets them push; by several threads or not. How
/// many tasks there are does not depend on threads, and neither does any sum.
pub(super) fn run(tasks: &mut Vec<Task>, here: Here<'_>, soon: &mut Soon, groups: &mut Groups, shared: bool) {
    let worth = PAIRS.max(PAIRS_OF_NODE * here.positions.len());
    let count = ((soon.len() + OF_GROUP * groups.all.len()) / worth).clamp(1, MOST);
    tasks.resize_with(count, Task::new);
    groups.place(here.positions);
    let all = All { here, widths: &soon.widths, stars: &groups.stars, arms: &groups.arms };
    let [points, edges] = soon.kinds.each_mut().map(|Kind { pairs, due }| Those { pairs, due, from: 0 });
    halve(
        tasks,
        &all,
        Part { points, edges, groups: &mut groups.all, group_due: &mut groups.due, places: &groups.places },
        shared,
    );
    let mut taken = 0;
    for task in tasks {
        for Met { edges, index, weights } in task.met.drain(..) {
            let kind = &mut soon.kinds[usize::from(edges)];
            if groups.take(&kind.pairs[index], !edges, weights, kind.due[index]) {
                kind.due[index] = f64::INFINITY;
                taken += 1;
            }
        }
        soon.kinds.iter_mut().zip(&mut task.lost).for_each(|(kind, lost)| kind.append(lost));
    }
    soon.note_taken(taken);
}

fn halve(tasks: &mut [Task], all: &All<'_>, part: Part<'_>, shared: bool) {
    let half = tasks.len() / 2;
    if half == 0 {
        if let [task] = tasks {
            task.run(all, part);
        }
        return;
    }
    let [part, others] = part.split([half, tasks.len()]);
    let (first, second) = tasks.split_at_mut(half);
    let one = move || halve(first, all, part, shared);
    let other = move || halve(second, all, others, shared);
    if shared {
        parallel::join(one, other);
    } else {
        one();
        other();
    }
}
