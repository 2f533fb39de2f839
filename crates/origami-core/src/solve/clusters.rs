//! Nodes so near to each other that they move as one.
//!
//! Short sides make the row sums of their ends large, with the square of their length for angles. On such masses the two ends
//! hardly move against each other, as they should, but they hardly move at all either: the rest of the sheet has to drag
//! them along. So clusters of near nodes have a mass of their own for what they do together, the row sum of the springs that
//! resist that, and clusters of clusters likewise: a preconditioner of several levels.
//!
//! With the masses `m_i` of the members of a cluster and its own, M, forces F and velocities v are split into what the members
//! do together, `F = sum F_i` on M and the mean `v = sum m_i v_i / sum m_i`, and the rest, `F_i - m_i F / sum m_i` on `m_i` and
//! `v_i - v`.

use glam::DVec3;

use super::row_sums::{OnTheWay, cluster_sums};
use crate::ids::NodeId;
use crate::kernel::{Compute, Kernel};
use crate::model::Model;
use crate::scene::Held;
use crate::twins::fire_update::{Decision, Sums};

/// Sides shorter than this share of the mean join their ends to a cluster, ...
const LONGEST: f64 = 0.4;
/// ... and within it those that are shorter by this, and so on.
const SHORTER: f64 = 0.25;
/// Masses of clusters over their row sums, which bound what each level does alone and not all of them together.
const HEAVIER: f64 = 2.0;

/// All clusters of a sheet.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Clusters {
    /// By level, the shortest sides first, and by node: the number of its cluster at that level.
    levels: Vec<Vec<Option<u32>>>,
    /// Those of the first level, then those of the next one.
    clusters: Vec<Cluster>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Cluster {
    level: usize,
    /// Among those of its level.
    number: u32,
    members: Vec<Member>,
    whole: Body,
    /// Whether it is a member of another.
    is_part: bool,
    /// Whether one of its nodes is held, so that it does not move as one.
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
    /// Moves by its own force; what it has of the sums is added.
    fn alone(&mut self, sums: &mut Sums) {
        self.acceleration = self.force / self.mass;
        sums.speed += self.mass * self.velocity.length_squared();
        sums.pull += self.force.dot(self.acceleration);
    }
}

fn envf(key: &str, or: f64) -> f64 {
    std::env::var(key).ok().and_then(|s| s.parse().ok()).unwrap_or(or)
}

impl Clusters {
    pub(super) fn new(model: &Model, near: f64) -> Self {
        let mean = model.beams.iter().map(|beam| beam.rest_length).sum::<f64>() / model.beams.len() as f64;
        let shortest = model.beams.iter().map(|beam| beam.rest_length).fold(f64::INFINITY, f64::min);
        let mut longest = vec![envf("TOP", near) * mean];
        while longest[longest.len() - 1] * envf("RATIO", SHORTER) > shortest && longest.len() < envf("MOST", 20.0) as usize {
            longest.push(longest[longest.len() - 1] * envf("RATIO", SHORTER));
        }
        let mut all = Self::default();
        if !(longest[0] > shortest) {
            return all;
        }
        // By node: what it is a part of at the last level.
        let mut part_of: Vec<Is> = (0..model.node_count()).map(|node| Is::Node(NodeId::new(node))).collect();
        for longest in longest.into_iter().rev() {
            all.add_level(model, longest, &mut part_of);
        }
        all
    }

    /// Whether they are of a sheet of so many nodes.
    pub(super) fn fits(&self, nodes: usize) -> bool {
        let sound = |(place, cluster): (usize, &Cluster)| {
            let is_known = |member: &Member| match member.is {
                Is::Node(node) => node.index() < nodes,
                Is::Cluster(part) => part < place,
            };
            cluster.level < self.levels.len()
                && (cluster.number as usize) < nodes
                && cluster.members.iter().all(is_known)
        };
        let numbers = |level: &Vec<Option<u32>>| {
            level.len() == nodes && level.iter().flatten().all(|number| (*number as usize) < nodes)
        };
        self.levels.iter().all(numbers) && self.clusters.iter().enumerate().all(sound)
    }

    /// The clusters of all sides shorter than that.
    fn add_level(&mut self, model: &Model, longest: f64, part_of: &mut [Is]) {
        let mut first: Vec<usize> = (0..model.node_count()).collect();
        fn root(first: &mut [usize], mut node: usize) -> usize {
            while first[node] != node {
                first[node] = first[first[node]];
                node = first[node];
            }
            node
        }
        for beam in model.beams.iter().filter(|beam| beam.rest_length < longest) {
            let [a, b] = beam.nodes.map(|node| root(&mut first, node.index()));
            first[a.max(b)] = a.min(b);
        }
        let roots: Vec<usize> = (0..first.len()).map(|node| root(&mut first, node)).collect();
        let mut sizes = vec![0; roots.len()];
        roots.iter().for_each(|root| sizes[*root] += 1);
        let level = self.levels.len();
        let of_node: Vec<Option<u32>> =
            roots.iter().map(|root| (sizes[*root] > 1).then_some(*root as u32)).collect();
        // Members in the order of their first nodes.
        let mut new: std::collections::BTreeMap<u32, Vec<Is>> = std::collections::BTreeMap::new();
        let mut seen = vec![false; self.clusters.len()];
        for (part, number) in part_of.iter().zip(&of_node) {
            let Some(number) = number else { continue };
            let known = if let Is::Cluster(cluster) = part { std::mem::replace(&mut seen[*cluster], true) } else { false };
            if !known {
                new.entry(*number).or_default().push(*part);
            }
        }
        for (number, members) in new {
            // One that is the same as at the level before.
            if members.len() < 2 {
                continue;
            }
            for member in &members {
                if let Is::Cluster(cluster) = member {
                    self.clusters[*cluster].is_part = true;
                }
            }
            let place = self.clusters.len();
            part_of.iter_mut().zip(&of_node).filter(|(_, own)| **own == Some(number)).for_each(|(part, _)| *part = Is::Cluster(place));
            let members = members.into_iter().map(|is| Member { is, body: Body::default() }).collect();
            self.clusters.push(Cluster { level, number, members, whole: Body::default(), is_part: false, is_held: false });
        }
        self.levels.push(of_node);
    }

    /// Takes the masses of the nodes in clusters, so that the passes leave these alone, and finds those of the clusters.
    pub(super) fn take(&mut self, (model, way): (&Model, &OnTheWay), positions: &[DVec3], masses: &mut [[f64; 2]]) {
        let mut sums = Vec::new();
        let mut level = usize::MAX;
        for i in 0..self.clusters.len() {
            let (finer, rest) = self.clusters.split_at_mut(i);
            let Some(cluster) = rest.first_mut() else { continue };
            if cluster.level != level {
                level = cluster.level;
                sums = vec![0.0; model.node_count()];
                cluster_sums((model, way), &self.levels[level], positions, &mut sums);
            }
            for member in &mut cluster.members {
                member.body.mass = match member.is {
                    Is::Node(node) => std::mem::take(&mut masses[node.index()])[0],
                    Is::Cluster(place) => finer[place].whole.mass,
                };
            }
            let together: f64 = cluster.members.iter().map(|member| member.body.mass).sum();
            let sum = envf("HEAVY", HEAVIER) * sums[cluster.number as usize];
            cluster.whole.mass = if sum > 0.0 { sum.min(together) } else { together };
        }
    }

    /// Adds what the clusters have of the sums to those of the other nodes.
    pub(super) fn add_to<R: Compute>(&mut self, kernel: &Kernel<R>, held: &Held, mut sums: Sums) -> Sums {
        for i in 0..self.clusters.len() {
            let (finer, rest) = self.clusters.split_at_mut(i);
            let Some(cluster) = rest.first_mut() else { continue };
            cluster.is_held = false;
            let (mut force, mut momentum, mut together) = (DVec3::ZERO, DVec3::ZERO, 0.0);
            for Member { is, body } in &mut cluster.members {
                match is {
                    Is::Node(node) => {
                        [body.force, body.velocity] = kernel.force_and_velocity(*node);
                        cluster.is_held |= !held.is_empty() && held.holds(*node);
                    }
                    Is::Cluster(place) => {
                        let Cluster { whole, is_held, .. } = &finer[*place];
                        (body.force, body.velocity) = (whole.force, whole.velocity);
                        cluster.is_held |= is_held;
                    }
                }
                force += body.force;
                momentum += body.velocity * body.mass;
                together += body.mass;
            }
            let velocity = momentum / together;
            (cluster.whole.force, cluster.whole.velocity) = (force, velocity);
            for member in &mut cluster.members {
                if cluster.is_held {
                    let is_held = if let Is::Cluster(place) = member.is { finer[place].is_held } else { false };
                    if is_held { member.body.acceleration = DVec3::ZERO } else { member.body.alone(&mut sums) }
                } else {
                    let body = &mut member.body;
                    let mut apart = Body { force: body.force - force * (body.mass / together), velocity: body.velocity - velocity, ..*body };
                    apart.alone(&mut sums);
                    body.acceleration = apart.acceleration;
                }
            }
            if !cluster.is_part && !cluster.is_held {
                cluster.whole.alone(&mut sums);
            } else {
                cluster.whole.acceleration = DVec3::ZERO;
            }
        }
        sums
    }

    /// Moves them, after the other nodes.
    pub(super) fn shift<R: Compute>(&mut self, kernel: &mut Kernel<R>, decision: Decision) {
        for i in (0..self.clusters.len()).rev() {
            let (finer, rest) = self.clusters.split_at_mut(i);
            let Some(cluster) = rest.first_mut() else { continue };
            for member in &cluster.members {
                let acceleration = cluster.whole.acceleration + member.body.acceleration;
                match member.is {
                    Is::Node(node) => {
                        let faster = acceleration * decision.towards_force;
                        kernel.shift(node, faster * decision.step, faster);
                    }
                    Is::Cluster(place) => finer[place].whole.acceleration = acceleration,
                }
            }
        }
    }
}
