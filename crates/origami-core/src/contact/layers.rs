//! A sheet whose layers push each other away: forces at its positions, and how far it may move from there.

mod closing;
mod limits;
mod listing;
#[cfg(test)]
mod tests;

use glam::DVec3;

use super::Contact;
use super::barrier::Barrier;
use super::drift::nearer;
use super::finder::Finder;
use super::groups::Groups;
use super::limit::{FLOOR, Plane};
use super::pairs::{Near, Pair, eased};
use super::soon::Soon;
use super::stars::Star;
use super::stiff::Stiff;
use super::task::{self, Felt, Here, Task};
use crate::mesh::Mesh;
use crate::parallel;
pub(super) use listing::{FEW, MANY, MOST_SKINS};

/// Pairs are listed up to so much beyond the gap, as a share of the median edge.
pub(super) const SKIN: f64 = 0.1;
/// No node moves farther in one evaluation than this share of the skin, so that a new list has all that may close.
pub(super) const LONGEST: f64 = 0.2;
/// No pair that is not listed is nearer than the gap and this share of the skin when others are measured one by one.
const SPARE: f64 = 0.5;
/// Pairs that one task measures at least.
const TASK: usize = 512;

/// The layers of one sheet.
#[derive(Clone, Debug)]
pub(crate) struct Layers {
    contact: Contact,
    /// Whether many pairs are measured by many threads.
    shared: bool,
    finder: Finder,
    /// The share of a pair's width that is never used up.
    pub(crate) floor: f64,
    skin: f64,
    /// How far beyond the gap pairs are listed now, and at least.
    room: f64,
    least_room: f64,
    pairs: Vec<Pair>,
    /// By pair: its gap when it was last measured, and twice the `way` at that time. Its gap is now at least this less twice the
    /// way, so that most pairs need not be measured.
    due: Vec<f64>,
    /// The largest moves of all evaluations so far, added up; and the last of them.
    way: f64,
    last: f64,
    /// The same of all moves, whole.
    path: f64,
    /// Where the nodes were when they were last felt, and the way then; no nodes where others have been measured since.
    felt_at: Vec<DVec3>,
    felt_way: f64,
    /// Where the nodes were when the pairs were listed, and the way then; no nodes before.
    listed_at: Vec<DVec3>,
    listed_way: f64,
    /// Those of the pairs that may come near soon, but for those of groups.
    soon: Soon,
    groups: Groups,
    /// Pairs at the positions of the last [`Layers::measure`] whose gap may be below their width, in the order of the list.
    near: Vec<Near>,
    /// How many pairs push, as last measured in either way.
    pushing: usize,
    tasks: Vec<Task>,
    /// Kept for their memory.
    felt: Vec<Felt>,
    wanted: Vec<[u32; 2]>,
    measured: Vec<Near>,
    gaps: Vec<f64>,
    lengths: Vec<f64>,
    /// By node: the share of its move that it may make, and the one before.
    shares: Vec<f64>,
    old_shares: Vec<f64>,
    /// What divides the pairs that are in the way.
    planes: Vec<Plane>,
}

impl Layers {
    /// Those of a sheet with its nodes at `rest`; `shared` out among the threads of the pool or not: equal bits.
    pub(crate) fn new(mesh: &Mesh, rest: &[DVec3], contact: Contact, shared: bool) -> Self {
        let mut finder = Finder::new(mesh, rest, contact);
        finder.shared = shared;
        let skin = SKIN * finder.median_edge();
        Self {
            contact,
            shared,
            finder,
            floor: FLOOR,
            skin,
            room: skin,
            least_room: skin,
            pairs: Vec::new(),
            due: Vec::new(),
            way: 0.0,
            last: 0.0,
            path: 0.0,
            felt_at: Vec::new(),
            felt_way: 0.0,
            listed_at: Vec::new(),
            listed_way: 0.0,
            soon: Soon::new(contact.gap),
            groups: Groups::new(Star::all(mesh, rest)),
            near: Vec::new(),
            pushing: 0,
            tasks: Vec::new(),
            felt: Vec::new(),
            wanted: Vec::new(),
            measured: Vec::new(),
            gaps: Vec::new(),
            lengths: Vec::new(),
            shares: Vec::new(),
            old_shares: Vec::new(),
            planes: Vec::new(),
        }
    }

    /// The farthest that a node may move in one evaluation, in radii.
    pub(crate) fn longest_move(&self) -> f64 {
        LONGEST * self.skin
    }

    /// Pairs in the list.
    pub(crate) fn listed(&self) -> usize {
        self.pairs.len()
    }

    /// Measures all pairs that may push at these positions.
    pub(crate) fn measure(&mut self, positions: &[DVec3]) {
        self.ungroup();
        // Whoever measures may ask what comes near within a move.
        let bound = self.look_for_near(positions, self.contact.gap + SPARE * self.skin);
        let Self { pairs, soon, wanted, measured, .. } = self;
        wanted.clear();
        for (kind, own) in (0..).zip(&soon.kinds) {
            wanted.extend((0..).zip(&own.due).filter(|(_, due)| **due < bound).map(|(i, _)| [kind, i]));
        }
        let number = |[kind, i]: &[u32; 2]| soon.kinds[*kind as usize].pairs[*i as usize].number;
        let one = |i: &[u32; 2]| pairs[number(i) as usize].near(number(i), positions);
        if self.shared && wanted.len() >= 2 * TASK {
            parallel::map_into(wanted, TASK, one, measured);
        } else {
            measured.clear();
            measured.extend(wanted.iter().map(one));
        }
        let farthest = self.reach();
        std::mem::swap(&mut self.near, &mut self.measured);
        for ([kind, i], near) in self.wanted.iter().zip(&self.near) {
            self.soon.kinds[*kind as usize].due[*i as usize] = near.gap.min(farthest) + 2.0 * self.way;
        }
        self.pushing = self.pushing().count();
    }

    /// What each node feels of the pairs at these positions; empty where nothing pushes. It is what [`Layers::measure`] and
    /// [`Layers::add`] find out, but for rounding, in less time, and but for the stiffness of those that are told by
    /// [`Layers::stiff`]; no pair is known for [`Layers::pushing`] then.
    pub(crate) fn felt(&mut self, positions: &[DVec3]) -> &[Felt] {
        self.shorten_way(positions);
        let bound = self.look_for_near(positions, self.contact.gap);
        self.near.clear();
        let pushing = std::mem::take(&mut self.pushing);
        if !self.soon.is_due(bound) && !self.groups.is_due(bound) {
            self.tasks.iter_mut().for_each(|task| task.stiff.clear());
            return &[];
        }
        let (farthest, takes) = (self.reach(), pushing > positions.len());
        let Self { contact, pairs, soon, groups, tasks, way, path, .. } = self;
        let here = Here {
            contact: *contact,
            positions,
            bound,
            twice_the_way: 2.0 * *way,
            path: *path,
            farthest,
            takes,
            pairs,
        };
        task::run(tasks, here, soon, groups, self.shared);
        self.pushing = tasks.iter().map(|task| task.pushing).sum();
        match self.tasks.as_slice() {
            _ if self.pushing == 0 => &[],
            [one] => &one.felt,
            all => {
                self.felt.clear();
                self.felt.resize(positions.len(), [0.0; 4]);
                for task in all {
                    for (sum, own) in self.felt.iter_mut().zip(&task.felt) {
                        *sum = std::array::from_fn(|i| sum[i] + own[i]);
                    }
                }
                &self.felt
            }
        }
    }

    /// The stiff ones of the pairs that were felt last.
    pub(crate) fn stiff(&self) -> impl Iterator<Item = Stiff> {
        self.tasks.iter().flat_map(|task| &task.stiff).copied()
    }

    /// Sees to it that all pairs are listed whose gap may be below that, and that all are known for which it may be below the
    /// width of contact: they are due before the result.
    fn look_for_near(&mut self, positions: &[DVec3], listed: f64) -> f64 {
        self.measured_at();
        self.list_for(positions, listed);
        let bound = self.contact.gap + 2.0 * self.way;
        self.look_ahead(bound);
        bound
    }

    /// Pairs are going to be measured: at the positions that were last felt, or nothing is known of these any more.
    fn measured_at(&mut self) {
        if self.way > self.felt_way {
            self.felt_at.clear();
        }
    }

    /// No pair is in a group any more.
    fn ungroup(&mut self) {
        if self.groups.all.is_empty() {
            return;
        }
        self.soon.tell(&mut self.due);
        let Groups { all, due, places, .. } = &self.groups;
        for ((group, places), due) in all.iter().zip(places).zip(due) {
            group.pairs(places).for_each(|number| self.due[number as usize] = *due);
        }
        self.groups.clear();
        self.soon.forget();
    }

    /// The pairs that push, as last measured.
    pub(super) fn pushing(&self) -> impl Iterator<Item = (&Pair, &Near)> {
        let own = self.near.iter().map(|near| (&self.pairs[near.pair as usize], near));
        own.filter(|(pair, near)| near.gap < pair.width)
    }

    /// How many pairs push.
    pub(crate) fn count(&self) -> usize {
        self.pushing
    }

    /// The least gap of those that push, in radii; infinite where none does.
    pub(crate) fn least_gap(&self) -> f64 {
        self.pushing().map(|(_, near)| near.gap).fold(f64::INFINITY, f64::min)
    }

    /// How stiff the push is.
    #[cfg(feature = "newton")]
    pub(super) fn stiffness(&self) -> f64 {
        self.contact.stiffness
    }

    /// The energy of all gaps, as last measured.
    pub(crate) fn energy(&self, positions: &[DVec3]) -> f64 {
        self.pushing()
            .map(|(pair, near)| {
                let (factor, _) = eased(pair, positions);
                factor * Barrier::of(near.gap, pair.width, self.contact.stiffness).energy
            })
            .sum()
    }

    /// Adds the forces at the positions last measured, by node, and a bound on the row sums of their stiffness to `sums`.
    pub(crate) fn add(&self, positions: &[DVec3], forces: &mut [DVec3], sums: &mut [f64]) {
        for (pair, near) in self.pushing() {
            for (node, (force, sum)) in pair.nodes.iter().zip(pair.push(near, positions, self.contact.stiffness)) {
                forces[node.index()] += force;
                sums[node.index()] += sum;
            }
        }
    }

    /// How hard each pair that pushes does so, as last measured: a force.
    pub(super) fn presses(&self, positions: &[DVec3]) -> impl Iterator<Item = (&Pair, &Near, f64)> {
        self.pushing().map(|(pair, near)| {
            let slope = Barrier::of(near.gap, pair.width, self.contact.stiffness).slope;
            (pair, near, -slope * eased(pair, positions).0)
        })
    }

    /// Takes note that no node moved farther than this, in radii.
    pub(crate) fn moved(&mut self, largest: f64) {
        self.way += largest;
        self.last = largest;
        self.path += largest;
    }

    /// Takes off the way what all nodes moved together since they were last felt.
    fn shorten_way(&mut self, positions: &[DVec3]) {
        if self.soon.len() > MANY / 2 * positions.len() {
            if self.felt_at.len() == positions.len() && self.way > self.felt_way {
                let half = 0.5 * nearer(&self.felt_at, positions, self.reach() + self.finder.thickest());
                self.last = half.min(self.way - self.felt_way);
                self.way = self.felt_way + self.last;
            }
            self.felt_at.clear();
            self.felt_at.extend_from_slice(positions);
            self.felt_way = self.way;
        } else {
            self.felt_at.clear();
        }
    }
}
