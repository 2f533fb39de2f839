//! Nodes so near to each other that they move as one: a preconditioner of several levels for FIRE.
//!
//! Short sides make the row sums of their ends large, for angles with the inverse square of their length. On such masses the
//! two ends hardly move against each other, as they should, but they hardly move together either: the rest of the sheet has
//! to drag them along, and the sheet crawls. So clusters of near nodes have a mass of their own for what they do as one, the row
//! sum of the springs that resist that, and clusters of clusters likewise.
//!
//! With the masses `m_i` of the members of a cluster and its own M, forces and velocities are split into what the members do as
//! one, `F = sum F_i` on M with `v = sum m_i v_i / sum m_i`, and the rest, `F_i - m_i F / sum m_i` on `m_i` with `v_i - v`.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::row_sums::{OnTheWay, cluster_sums};
use crate::ids::NodeId;
use crate::kernel::{Compute, Kernel};
use crate::model::Model;
use crate::scene::{Force, Held};
use crate::twins::fire_update::{Decision, Sums};

/// Sides of the next finer level over those of a level.
const FINER: f64 = 0.1;
/// Masses of clusters over their row sums, which bound what one level does and not what several do together.
const HEAVIER: f64 = 2.0;

/// All clusters of a sheet.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Clusters {
    /// By level, that of the shortest sides first, and by node: the number of its cluster at that level.
    levels: Vec<Vec<Option<u32>>>,
    /// Members come before what they are members of.
    clusters: Vec<Cluster>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Cluster {
    level: usize,
    /// At its level.
    number: u32,
    members: Vec<Member>,
    /// What its members do as one.
    whole: Body,
    /// Whether it is a member of another.
    is_member: bool,
    /// Whether one of its nodes is held, so that its members move by themselves.
    #[cfg_attr(feature = "serde", serde(skip))]
    is_held: bool,
}

#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Member {
    is: Is,
    body: Body,
}

#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum Is {
    Node(NodeId),
    /// By its place among all.
    Cluster(usize),
}

/// What moves by its own mass; all but that is found at each evaluation.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Body {
    mass: f64,
    #[cfg_attr(feature = "serde", serde(skip))]
    force: DVec3,
    #[cfg_attr(feature = "serde", serde(skip))]
    velocity: DVec3,
    #[cfg_attr(feature = "serde", serde(skip))]
    acceleration: DVec3,
}

impl Body {
    /// Finds the acceleration, and adds to the sums what it has of them.
    fn accelerate(&mut self, sums: &mut Sums) {
        self.acceleration = self.force / self.mass;
        sums.speed += self.mass * self.velocity.length_squared();
        sums.pull += self.force.dot(self.acceleration);
    }
}

impl Clusters {
    /// Those of sides shorter than the share `near` of their mean.
    pub(super) fn new(model: &Model, near: f64) -> Self {
        let lengths = || model.beams.iter().map(|beam| beam.rest_length);
        let shortest = lengths().fold(f64::INFINITY, f64::min);
        let longest = near * lengths().sum::<f64>() / lengths().count() as f64;
        let levels = std::iter::successors(Some(longest), |length| Some(FINER * length));
        let levels: Vec<f64> = levels.take_while(|length| *length > shortest).collect();
        let mut clusters = Self::default();
        let mut part_of: Vec<Is> = (0..model.node_count()).map(|node| Is::Node(NodeId::new(node))).collect();
        levels.iter().rev().for_each(|longest| clusters.add_level(model, *longest, &mut part_of));
        clusters
    }

    /// Joins the ends of all sides shorter than `longest`; `part_of` has, by node, what it is a part of at the level before.
    fn add_level(&mut self, model: &Model, longest: f64, part_of: &mut [Is]) {
        let number_of = joined(model, longest);
        let mut clusters: BTreeMap<u32, Vec<Is>> = BTreeMap::new();
        let mut seen = vec![false; self.clusters.len()];
        for (part, number) in part_of.iter().zip(&number_of) {
            let Some(number) = number else { continue };
            if !matches!(part, Is::Cluster(place) if std::mem::replace(&mut seen[*place], true)) {
                clusters.entry(*number).or_default().push(*part);
            }
        }
        // A cluster of one member is the one of the level before.
        clusters.retain(|_, members| members.len() > 1);
        let mut place_of = BTreeMap::new();
        for (number, members) in clusters {
            for member in &members {
                if let Is::Cluster(place) = member {
                    self.clusters[*place].is_member = true;
                }
            }
            place_of.insert(number, self.clusters.len());
            let members = members.into_iter().map(|is| Member { is, body: Body::default() }).collect();
            let (level, whole) = (self.levels.len(), Body::default());
            self.clusters.push(Cluster { level, number, members, whole, is_member: false, is_held: false });
        }
        for (part, number) in part_of.iter_mut().zip(&number_of) {
            if let Some(place) = number.and_then(|number| place_of.get(&number)) {
                *part = Is::Cluster(*place);
            }
        }
        self.levels.push(number_of);
    }

    /// Whether they are of a sheet of so many nodes.
    pub(super) fn fits(&self, nodes: usize) -> bool {
        let is_sound = |(place, cluster): (usize, &Cluster)| {
            let is_known = |member: &Member| match member.is {
                Is::Node(node) => node.index() < nodes,
                Is::Cluster(part) => part < place,
            };
            cluster.level < self.levels.len()
                && (cluster.number as usize) < nodes
                && cluster.members.iter().all(is_known)
        };
        let is_level = |level: &Vec<Option<u32>>| {
            level.len() == nodes && level.iter().flatten().all(|number| (*number as usize) < nodes)
        };
        self.levels.iter().all(is_level) && self.clusters.iter().enumerate().all(is_sound)
    }

    /// Takes the masses of the nodes in clusters, so that the passes leave these as they are, and finds those of the clusters.
    pub(super) fn take(
        &mut self,
        sheet: (&Model, &OnTheWay, &[Arc<dyn Force>]),
        positions: &[DVec3],
        masses: &mut [[f64; 2]],
    ) {
        let (mut sums, mut level) = (Vec::new(), None);
        for place in 0..self.clusters.len() {
            let (finer, others) = self.clusters.split_at_mut(place);
            let cluster = &mut others[0];
            if level != Some(cluster.level) {
                level = Some(cluster.level);
                sums = vec![0.0; positions.len()];
                cluster_sums(sheet, &self.levels[cluster.level], positions, &mut sums);
            }
            for Member { is, body } in &mut cluster.members {
                body.mass = match is {
                    Is::Node(node) => std::mem::take(&mut masses[node.index()])[0],
                    Is::Cluster(place) => finer[*place].whole.mass,
                };
            }
            let together: f64 = cluster.members.iter().map(|member| member.body.mass).sum();
            let sum = sums[cluster.number as usize];
            // Nothing resists what all of a sheet does as one.
            cluster.whole.mass = if sum > 0.0 { together.min(HEAVIER * sum) } else { together };
        }
    }

    /// Adds to the sums what the nodes in clusters have of them.
    pub(super) fn add_to<R: Compute>(&mut self, kernel: &Kernel<R>, held: &Held, sums: Sums) -> Sums {
        self.accelerate(&|node| kernel.force_and_velocity(node), held, sums)
    }

    /// Moves the nodes in clusters; the pass has moved the others.
    pub(super) fn shift<R: Compute>(&mut self, kernel: &mut Kernel<R>, decision: Decision) {
        self.each_acceleration(&mut |node, acceleration| {
            let faster = acceleration * decision.towards_force;
            kernel.shift(node, faster * decision.step, faster);
        });
    }

    /// Finds all accelerations from the force on each node and its velocity.
    fn accelerate(&mut self, of_node: &impl Fn(NodeId) -> [DVec3; 2], held: &Held, mut sums: Sums) -> Sums {
        for place in 0..self.clusters.len() {
            let (finer, others) = self.clusters.split_at_mut(place);
            others[0].accelerate(of_node, held, finer, &mut sums);
        }
        sums
    }

    /// Tells the acceleration of each node: against its cluster, with that against the next one, and so on.
    fn each_acceleration(&mut self, tell: &mut impl FnMut(NodeId, DVec3)) {
        for place in (0..self.clusters.len()).rev() {
            let (finer, others) = self.clusters.split_at_mut(place);
            for Member { is, body } in &others[0].members {
                let acceleration = others[0].whole.acceleration + body.acceleration;
                match is {
                    Is::Node(node) => tell(*node, acceleration),
                    Is::Cluster(place) => finer[*place].whole.acceleration = acceleration,
                }
            }
        }
    }
}

impl Cluster {
    /// Finds the accelerations of its members against it, and its own where it is no member.
    fn accelerate(&mut self, of_node: &impl Fn(NodeId) -> [DVec3; 2], held: &Held, finer: &[Self], sums: &mut Sums) {
        self.is_held = false;
        self.whole = Body { mass: self.whole.mass, ..Body::default() };
        let (mut momentum, mut together) = (DVec3::ZERO, 0.0);
        for Member { is, body } in &mut self.members {
            match is {
                Is::Node(node) => {
                    [body.force, body.velocity] = of_node(*node);
                    self.is_held |= held.holds(*node);
                }
                Is::Cluster(place) => {
                    let Self { whole, is_held, .. } = &finer[*place];
                    (body.force, body.velocity) = (whole.force, whole.velocity);
                    self.is_held |= is_held;
                }
            }
            self.whole.force += body.force;
            momentum += body.velocity * body.mass;
            together += body.mass;
        }
        self.whole.velocity = momentum / together;
        for Member { is, body } in &mut self.members {
            if self.is_held {
                // The members of a held member move by themselves already.
                let is_held = matches!(is, Is::Cluster(place) if finer[*place].is_held);
                if is_held { body.acceleration = DVec3::ZERO } else { body.accelerate(sums) }
            } else {
                body.force -= self.whole.force * (body.mass / together);
                body.velocity -= self.whole.velocity;
                body.accelerate(sums);
            }
        }
        if !self.is_member && !self.is_held {
            self.whole.accelerate(sums);
        }
    }
}

/// By node: the number of what all sides shorter than `longest` join it to, which is its first node; none of one that they
/// leave alone.
fn joined(model: &Model, longest: f64) -> Vec<Option<u32>> {
    fn first(before: &mut [usize], mut node: usize) -> usize {
        while before[node] != node {
            before[node] = before[before[node]];
            node = before[node];
        }
        node
    }
    let mut before: Vec<usize> = (0..model.node_count()).collect();
    for beam in model.beams.iter().filter(|beam| beam.rest_length < longest) {
        let [a, b] = beam.nodes.map(|node| first(&mut before, node.index()));
        before[a.max(b)] = a.min(b);
    }
    let firsts: Vec<usize> = (0..before.len()).map(|node| first(&mut before, node)).collect();
    let mut sizes = vec![0; firsts.len()];
    firsts.iter().for_each(|first| sizes[*first] += 1);
    firsts.iter().map(|first| (sizes[*first] > 1).then(|| NodeId::new(*first).0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forces::hessian::blocks;
    use crate::generate::miura;
    use crate::kernel::Bounds;
    use crate::model::Material;
    use crate::scene::{Axes, Scene, Support};
    use crate::solve::State;
    use crate::solve::row_sums::row_sums;
    use crate::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

    const STILL: Decision = Decision { step: 0.0, keep: 1.0, towards_force: 0.0, back: 0.0 };
    const FASTER: Decision = Decision { towards_force: 1.0, ..STILL };

    /// A Miura sheet with a narrow column, in which there is a narrower one.
    fn model() -> Model {
        let mut pattern = miura(6, 4).expect("a pattern");
        let plain = pattern.vertices.clone();
        for (vertex, position) in pattern.vertices.iter_mut().enumerate() {
            for (column, width) in [(2, 1e-2), (3, 1e-4)] {
                if vertex % 7 > column {
                    *position -= (1.0 - width) * (plain[column + 1] - plain[column]);
                }
            }
        }
        Model::new(&pattern, &Material::default()).expect("valid")
    }

    /// A sheet off its equilibrium, with forces from `positions`, and its masses.
    fn beginning(model: &Model, held: &Held) -> (Kernel<f64>, Clusters, Vec<[f64; 2]>) {
        let state = State::perturbed(model, 0.02, 3);
        let bounds = Bounds { farthest: FARTHEST, longest_move: LONGEST_MOVE };
        let mut kernel = Kernel::<f64>::new(model, false, bounds, &state.positions, &[], &state.fold_angles, 1);
        kernel.set_outside(model, held, false, std::iter::empty());
        kernel.set_targets(model.targets(30.0).into_iter());
        kernel.springs(false);
        let mut sums = vec![0.0; model.node_count()];
        row_sums(model, &state.positions, &mut sums);
        let mut masses: Vec<[f64; 2]> = sums.iter().map(|mass| [*mass, 1.0 / mass]).collect();
        let mut clusters = Clusters::new(model, 0.4);
        clusters.take((model, &OnTheWay::default(), &[]), &state.positions, &mut masses);
        (kernel, clusters, masses)
    }

    /// The velocities after one decision, from rest: the forces over the masses.
    fn accelerations(kernel: &mut Kernel<f64>, clusters: &mut Clusters, masses: &[[f64; 2]], held: &Held) -> Sums {
        let sums = kernel.reduce_forces(masses);
        let sums = clusters.add_to(kernel, held, sums);
        kernel.fire_move(masses, FASTER);
        clusters.shift(kernel, FASTER);
        sums
    }

    #[test]
    fn masses_are_one_symmetric_matrix() {
        let (model, held) = (model(), Held::default());
        let (mut kernel, mut clusters, masses) = beginning(&model, &held);
        assert!(clusters.clusters.iter().any(|cluster| cluster.is_member), "clusters of clusters");
        let sums = accelerations(&mut kernel, &mut clusters, &masses, &held);
        let mut velocities = Vec::new();
        kernel.read_velocities(&mut velocities);
        let forces: Vec<DVec3> = kernel.positions_and_forces().map(|[_, force]| force).collect();
        // With v = F / M both F v and v M v are what the sums say of F / M F.
        let work: f64 = forces.iter().zip(&velocities).map(|(f, v)| f.dot(*v)).sum();
        let again = kernel.reduce_forces(&masses);
        let again = clusters.add_to(&kernel, &held, again);
        for other in [work, again.power, again.speed, again.pull] {
            assert!((other / sums.pull - 1.0).abs() < 1e-9, "{other} is not {}", sums.pull);
        }
        let plain: f64 = forces.iter().map(|f| f.length_squared()).sum();
        assert!(sums.speed == 0.0 && sums.pull > 0.0 && plain > 0.0);
    }

    #[test]
    fn no_mode_is_stiffer_than_a_step_allows_and_clusters_are_light() {
        let model = model();
        let state = State::at_rest(&model);
        let mut sums = vec![0.0; model.node_count()];
        row_sums(&model, &model.rest, &mut sums);
        let mut masses: Vec<[f64; 2]> = sums.iter().map(|mass| [*mass, 1.0 / mass]).collect();
        let mut clusters = Clusters::new(&model, 0.4);
        clusters.take((&model, &OnTheWay::default(), &[]), &model.rest, &mut masses);
        // By the power method on the Hessian over the masses.
        let mut mode: Vec<DVec3> = (0..model.node_count()).map(|i| super::super::saddle::irregular(i as f64)).collect();
        let mut largest = 0.0;
        for _ in 0..300 {
            let mut force = vec![DVec3::ZERO; mode.len()];
            blocks(&model, &state.positions, &state.targets, &state.fold_angles, &mut |i, j, block| {
                force[i] += block * mode[j];
                if i != j {
                    force[j] += block.transpose() * mode[i];
                }
            });
            let mut next: Vec<DVec3> = force.iter().zip(&masses).map(|(f, [_, inverse])| *f * *inverse).collect();
            clusters.accelerate(&|node| [force[node.index()], DVec3::ZERO], &Held::default(), Sums::default());
            clusters.each_acceleration(&mut |node, acceleration| next[node.index()] = acceleration);
            let length = |v: &[DVec3]| v.iter().map(|v| v.length_squared()).sum::<f64>().sqrt();
            largest = length(&next) / length(&mode);
            let length = length(&next);
            mode = next.iter().map(|v| *v / length).collect();
        }
        let limit = 4.0 / crate::twins::fire_update::LONGEST_STEP.powi(2);
        assert!(largest > 0.1 && largest < limit, "{largest}");
        let heaviest = sums.iter().copied().fold(0.0, f64::max);
        let light = clusters.clusters.iter().filter(|cluster| !cluster.is_member).map(|cluster| cluster.whole.mass);
        assert!(light.fold(0.0, f64::max) < 1e-4 * heaviest);
    }

    #[test]
    fn held_nodes_stay_and_their_clusters_move_by_themselves() {
        let model = model();
        let clustered = Clusters::new(&model, 0.4).clusters.iter().find_map(|cluster| match cluster.members[0].is {
            Is::Node(node) if cluster.is_member => Some(node),
            _ => None,
        });
        let node = clustered.expect("a node in a cluster of a cluster");
        let scene = Scene::default().with_support(Support { node, axes: Axes::ALL, position: None });
        let held = Held::new(&model, &scene);
        let (mut kernel, mut clusters, masses) = beginning(&model, &held);
        let sums = accelerations(&mut kernel, &mut clusters, &masses, &held);
        let mut velocities = Vec::new();
        kernel.read_velocities(&mut velocities);
        assert_eq!(velocities[node.index()], DVec3::ZERO);
        let work: f64 =
            kernel.positions_and_forces().zip(&velocities).map(|([_, force], velocity)| force.dot(*velocity)).sum();
        assert!((work / sums.pull - 1.0).abs() < 1e-9);
    }
}
