//! A sheet whose layers push each other away: forces at its positions, and how far it may move from there.

mod closing;

use glam::DVec3;

use super::barrier::Barrier;
use super::limit::{FLOOR, Shares, limit_pair};
use super::pairs::{Finder, Near, Pair, eased};
use super::soon::Soon;
use super::task::{self, All, Felt, Task};
use super::{Contact, NEARER};
use crate::ids::NodeId;
use crate::mesh::Mesh;
use crate::parallel;

/// Pairs are listed up to so much beyond the gap, as a share of the median edge.
const SKIN: f64 = 0.1;
/// Or up to so many times that where few are found there. More: lists last longer and are longer.
const MOST_SKINS: f64 = 4.0;
/// As many pairs for each node are few, and many.
const FEW: usize = 4;
const MANY: usize = 32;
/// No node moves farther in one evaluation than this share of the skin, so that a new list has all that may close.
const LONGEST: f64 = 0.2;
/// A pair is looked at before a move if its gap, but for what is never used up of it, is below so many times what both of its
/// things may move: half of it may be used up. What is not looked at could come below that.
const WITHIN: f64 = 2.0;
/// The pairs that may come near within about so many evaluations are kept apart from the others.
const SOON: f64 = 16.0;
/// Pairs that one task measures at least.
const TASK: usize = 512;

/// The layers of one sheet.
#[derive(Clone, Debug)]
pub(crate) struct Layers {
    contact: Contact,
    /// Whether many pairs are measured by many threads.
    shared: bool,
    finder: Finder,
    skin: f64,
    /// How far beyond the gap pairs are listed now.
    room: f64,
    pairs: Vec<Pair>,
    /// By pair: its gap when it was last measured, and twice the `way` at that time. Its gap is now at least this less twice the
    /// way, so that most pairs need not be measured.
    due: Vec<f64>,
    /// The largest moves of all evaluations so far, added up; and the last of them.
    way: f64,
    last: f64,
    /// Where the nodes were when the pairs were listed, and the way then; no nodes before.
    listed_at: Vec<DVec3>,
    listed_way: f64,
    /// Those of the pairs that may come near soon.
    soon: Soon,
    /// Pairs at the positions of the last [`Layers::measure`] whose gap may be below their width, in the order of the list.
    near: Vec<Near>,
    /// How many pairs push, as last measured in either way.
    pushing: usize,
    tasks: Vec<Task>,
    /// Kept for their memory.
    felt: Vec<Felt>,
    wanted: Vec<u32>,
    measured: Vec<Near>,
    gaps: Vec<f64>,
    lengths: Vec<f64>,
    /// By node: the share of its move that it may make.
    shares: Vec<f64>,
}

impl Layers {
    /// Those of a sheet with its nodes at `rest`; `shared` out among the threads of the pool or not: equal bits.
    pub(crate) fn new(mesh: &Mesh, rest: &[DVec3], contact: Contact, shared: bool) -> Self {
        let finder = Finder::new(mesh, rest, contact);
        let skin = SKIN * finder.median_edge();
        Self {
            contact,
            shared,
            finder,
            skin,
            room: skin,
            pairs: Vec::new(),
            due: Vec::new(),
            way: 0.0,
            last: 0.0,
            listed_at: Vec::new(),
            listed_way: 0.0,
            soon: Soon::new(),
            near: Vec::new(),
            pushing: 0,
            tasks: Vec::new(),
            felt: Vec::new(),
            wanted: Vec::new(),
            measured: Vec::new(),
            gaps: Vec::new(),
            lengths: Vec::new(),
            shares: Vec::new(),
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
        let bound = self.look_for_near(positions);
        let Self { pairs, soon, wanted, measured, .. } = self;
        wanted.clear();
        wanted.extend((0..).zip(&soon.due).filter(|(_, due)| **due < bound).map(|(i, _)| i));
        let number = |i: &u32| soon.pairs[*i as usize].number;
        let one = |i: &u32| pairs[number(i) as usize].near(number(i), positions);
        if self.shared && wanted.len() >= 2 * TASK {
            parallel::map_into(wanted, TASK, one, measured);
        } else {
            measured.clear();
            measured.extend(wanted.iter().map(one));
        }
        std::mem::swap(&mut self.near, &mut self.measured);
        for (i, near) in self.wanted.iter().zip(&self.near) {
            self.soon.due[*i as usize] = near.gap + 2.0 * self.way;
        }
        self.pushing = self.pushing().count();
    }

    /// What each node feels of the pairs at these positions; empty where nothing pushes. It is what [`Layers::measure`] and
    /// [`Layers::add`] find out, but for rounding, in less time; no pair is known for [`Layers::pushing`] then.
    pub(crate) fn felt(&mut self, positions: &[DVec3]) -> &[Felt] {
        let bound = self.look_for_near(positions);
        self.near.clear();
        self.pushing = 0;
        if self.soon.due.iter().all(|due| *due >= bound) {
            return &[];
        }
        let Self { contact, soon, tasks, way, .. } = self;
        let widths = std::mem::take(&mut soon.widths);
        let all = All { contact: *contact, widths: &widths, positions, bound, twice_the_way: 2.0 * *way };
        task::run(tasks, &all, soon, self.shared);
        soon.widths = widths;
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

    /// Sees to it that all pairs are known whose gap may be below the width of contact: they are due before the result.
    fn look_for_near(&mut self, positions: &[DVec3]) -> f64 {
        self.list_for(positions, 0.0);
        let bound = self.contact.gap + 2.0 * self.way;
        self.look_ahead(bound);
        bound
    }

    /// Lists the pairs anew where nodes have moved so far that others may be nearer than the gap or than `distance`; true if so.
    fn list_for(&mut self, positions: &[DVec3], distance: f64) -> bool {
        let most = 0.5 * (self.room - (distance - self.contact.gap).max(0.0));
        if !self.listed_at.is_empty() {
            if self.way - self.listed_way <= most {
                return false;
            }
            let moved = |(p, listed): (&DVec3, &DVec3)| (*p - *listed).length_squared();
            let farthest = positions.iter().zip(&self.listed_at).map(moved).fold(0.0, f64::max).sqrt();
            // They cannot be farther than that before the way is so much longer.
            self.listed_way = self.way - farthest;
            if farthest <= most {
                return false;
            }
        }
        self.list(positions);
        true
    }

    /// Lists the pairs anew.
    fn list(&mut self, positions: &[DVec3]) {
        if !self.listed_at.is_empty() {
            let listed = self.pairs.len();
            if listed <= FEW * positions.len() {
                self.room = (2.0 * self.room).min(MOST_SKINS * self.skin);
            } else if listed > MANY * positions.len() {
                self.room = (0.5 * self.room).max(self.skin);
            }
        }
        let reach = self.contact.gap + self.room;
        self.finder.find(positions, reach, &mut self.pairs, &mut self.gaps);
        self.due.clear();
        self.due.extend(self.gaps.iter().map(|gap| gap + 2.0 * self.way));
        self.listed_at.clear();
        self.listed_at.extend_from_slice(positions);
        self.listed_way = self.way;
        self.soon.forget();
    }

    /// Sees to it that all pairs that are due before `bound` are known.
    fn look_ahead(&mut self, bound: f64) {
        let later = (SOON * 2.0 * self.last).max(0.1 * self.contact.gap);
        self.soon.look_ahead(bound, later, (&self.pairs, &mut self.due));
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
            let (factor, gradient) = eased(pair, positions);
            let Barrier { energy, slope, .. } = Barrier::of(near.gap, pair.width, self.contact.stiffness);
            let curvature = Barrier::of(NEARER * near.gap, pair.width, self.contact.stiffness).curvature;
            for ((node, weight), of_factor) in pair.nodes.iter().zip(near.weights).zip(gradient) {
                forces[node.index()] -= factor * slope * weight * near.normal + energy * of_factor;
                sums[node.index()] += 2.0 * factor * curvature * weight.abs();
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

    /// Shortens moves from the positions last measured so that nothing goes through anything: no node beyond a plane between
    /// the nearest points of a pair. Moves that are in no pair's way stay whole. The result has the share of each move that is
    /// left, by node; all 1 where nothing was in the way.
    pub(crate) fn limit(&mut self, positions: &[DVec3], moves: &[DVec3]) -> &[f64] {
        self.lengths.clear();
        self.lengths.extend(moves.iter().map(|by| by.length()));
        self.shares.clear();
        self.shares.resize(moves.len(), 1.0);
        let largest = self.lengths.iter().copied().fold(0.0, f64::max);
        let bound = self.look_for_limits(positions, largest);
        let Self { pairs, lengths, shares, soon, way, .. } = self;
        let most = |nodes: &[NodeId]| nodes.iter().map(|n| lengths[n.index()]).fold(0.0, f64::max);
        for (brief, due) in soon.pairs.iter().zip(&mut soon.due) {
            if *due >= bound {
                continue;
            }
            let pair = &pairs[brief.number as usize];
            let (first, second) = pair.nodes.split_at(pair.split);
            let within = WITHIN * (most(first) + most(second)) + FLOOR * pair.width;
            if *due - 2.0 * *way < within {
                let near = pair.near(brief.number, positions);
                *due = near.gap + 2.0 * *way;
                if near.gap < within {
                    limit_pair(pair, &near, (positions, moves), Shares(shares));
                }
            }
        }
        &self.shares
    }

    /// Whether some pair may be in the way of moves no longer than this, in radii, from the positions last measured.
    pub(crate) fn in_the_way(&mut self, positions: &[DVec3], largest: f64) -> bool {
        let bound = self.look_for_limits(positions, largest);
        self.soon.due.iter().any(|due| *due < bound)
    }

    /// Sees to it that all pairs are known that may be in the way of moves no longer than this: they are due before the result.
    fn look_for_limits(&mut self, positions: &[DVec3], largest: f64) -> f64 {
        self.look_for_near_within(positions, 2.0 * WITHIN * largest + FLOOR * self.contact.gap)
    }

    /// Sees to it that all pairs are known whose gap may be below `within`: they are due before the result.
    fn look_for_near_within(&mut self, positions: &[DVec3], within: f64) -> f64 {
        let known = !self.near.is_empty();
        if self.list_for(positions, within) && known {
            // They have other places in the list.
            self.measure(positions);
        }
        let bound = within + 2.0 * self.way;
        self.look_ahead(bound);
        bound
    }

    /// Takes note that no node moved farther than this, in radii.
    pub(crate) fn moved(&mut self, largest: f64) {
        self.way += largest;
        self.last = largest;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Crossings;
    use crate::generate::catalog;
    use crate::model::{Material, Model};

    fn model(name: &str) -> Model {
        Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
    }

    /// Numbers from -1 to 1, by a fixed sequence.
    fn noise(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 32).expect("32 bits")) / f64::from(1_u32 << 31) - 1.0
        }
    }

    /// A sheet crumpled at random, whose layers are near each other in every way.
    fn crumpled(name: &str, gap: f64) -> (Vec<DVec3>, Layers) {
        let model = model(name);
        let mut next = noise(3);
        let positions: Vec<DVec3> = model.rest.iter().map(|p| *p + 0.4 * DVec3::new(next(), next(), next())).collect();
        let mut layers = Layers::new(&model.mesh, &model.rest, Contact { gap, ..Contact::default() }, true);
        layers.measure(&positions);
        (positions, layers)
    }

    #[test]
    fn forces_are_the_gradient_of_the_energy_in_every_region() {
        let (mut corners, mut insides) = (0, 0);
        for name in ["square-twist", "waterbomb", "miura"] {
            let (positions, mut layers) = crumpled(name, 0.1);
            let (mut forces, mut sums) = (vec![DVec3::ZERO; positions.len()], vec![0.0; positions.len()]);
            layers.add(&positions, &mut forces, &mut sums);
            for (_, near) in layers.pushing() {
                let zeros = near.weights.iter().filter(|weight| **weight == 0.0).count();
                corners += usize::from(zeros > 0);
                insides += usize::from(zeros == 0);
            }
            let size = forces.iter().map(|f| f.length()).fold(0.0, f64::max);
            assert!(size > 0.0);
            for node in 0..positions.len() {
                for axis in 0..3 {
                    let mut at = |h: f64| {
                        let mut moved = positions.clone();
                        moved[node][axis] += h;
                        layers.measure(&moved);
                        layers.energy(&moved)
                    };
                    // Of fourth order: gaps are as small as a hundred steps.
                    let h = 1e-7;
                    let slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
                    let error = (slope + forces[node][axis]).abs() / size;
                    assert!(error < 1e-7, "{name}, node {node}: {slope}, force {}", forces[node][axis]);
                }
            }
        }
        assert!(corners > 20 && insides > 20, "{corners} {insides}");
    }

    #[test]
    fn contact_has_no_momentum_and_no_moment() {
        let (positions, layers) = crumpled("waterbomb", 0.1);
        let (mut forces, mut sums) = (vec![DVec3::ZERO; positions.len()], vec![0.0; positions.len()]);
        layers.add(&positions, &mut forces, &mut sums);
        let size: f64 = forces.iter().map(|f| f.length()).sum();
        let sum: DVec3 = forces.iter().sum();
        let moment: DVec3 = positions.iter().zip(&forces).map(|(p, f)| p.cross(*f)).sum();
        assert!(sum.length() < 1e-13 * size && moment.length() < 1e-12 * size, "{sum} {moment} of {size}");
        assert!(sums.iter().any(|sum| *sum > 0.0) && sums.iter().all(|sum| *sum >= 0.0));
    }

    /// A walk of random moves from a flat sheet, shortened or not: the steps after which it is crossed.
    fn walk(name: &str, seed: u64, shortened: bool) -> usize {
        let model = model(name);
        let mut layers = Layers::new(&model.mesh, &model.rest, Contact::default(), false);
        let (mut next, mut positions, mut crossed) = (noise(seed), model.rest.clone(), 0);
        let mut drift: Vec<DVec3> = positions.iter().map(|_| DVec3::new(next(), next(), next())).collect();
        for step in 0..150 {
            if step % 40 == 39 {
                drift.iter_mut().for_each(|by| *by = DVec3::new(next(), next(), next()));
            }
            let longest = layers.longest_move();
            let moves: Vec<DVec3> = drift.iter().map(|by| *by * (longest / 1.8)).collect();
            layers.measure(&positions);
            let shares = layers.limit(&positions, &moves).to_vec();
            let mut largest = 0.0_f64;
            for ((p, by), share) in positions.iter_mut().zip(&moves).zip(shares) {
                let by = *by * if shortened { share } else { 1.0 };
                *p += by;
                largest = largest.max(by.length());
            }
            layers.moved(largest);
            crossed += usize::from(!Crossings::of(&model.mesh, &positions).is_empty());
        }
        crossed
    }

    #[test]
    fn shortened_moves_never_cross_and_whole_ones_do() {
        for name in ["bird-base", "square-twist", "miura"] {
            for seed in 1..4 {
                assert_eq!(walk(name, seed, true), 0, "{name}, seed {seed}");
            }
            assert!(walk(name, 1, false) > 50, "{name}: whole moves cross");
        }
    }
}
