//! Which of the fine points of curves are kept: as many as the tolerance needs, and such that they face each other.

use std::collections::BTreeMap;

use glam::DVec2;

use super::faces::Face;
use super::key;
use super::rulings::slant;
use super::runs::{Node, Run};

/// Points nearer to each other than this, in distances that the tolerance allows, are as good as one.
const APART: f64 = 0.5;
/// Points face each other if the squared cosines of the angles between their ruling and the curves are not more than
/// this: 45 degrees at both ends.
const FACING: f64 = 1.0;
/// Gaps in a run are filled so often.
const PASSES: usize = 4;

/// What a point of a curve faces across a face.
enum Facing {
    /// A point of a curve: its corner of the face.
    Corner(usize),
    /// A place on a straight side.
    Foot(DVec2),
}

/// Marks the points of curved runs that are kept, and returns the places on straight lines that kept points face.
pub(super) fn choose(runs: &mut [Run], faces: &[Face], tolerance: f64) -> Vec<DVec2> {
    let mut chosen = Chosen::new(runs, faces, tolerance);
    let mut order: Vec<(usize, f64)> = (0..chosen.runs.len()).map(|run| (run, chosen.need(run))).collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    for (run, need) in order {
        if need > 0.0 {
            (0..PASSES).for_each(|_| chosen.fill(run));
        }
    }
    chosen.feet
}

struct Chosen<'a> {
    runs: &'a mut [Run],
    faces: &'a [Face],
    tolerance: f64,
    /// Nodes of curved runs and corners of faces by their places.
    nodes: BTreeMap<[u64; 2], Vec<(usize, usize)>>,
    corners: BTreeMap<[u64; 2], Vec<(usize, usize)>>,
    feet: Vec<DVec2>,
}

impl<'a> Chosen<'a> {
    fn new(runs: &'a mut [Run], faces: &'a [Face], tolerance: f64) -> Self {
        let mut nodes: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for (run, of) in runs.iter().enumerate().filter(|(_, run)| run.curved) {
            for (node, place) in of.nodes.iter().enumerate() {
                nodes.entry(key(place.at)).or_default().push((run, node));
            }
        }
        let mut corners: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for (face, of) in faces.iter().enumerate() {
            for (corner, place) in of.iter().enumerate() {
                corners.entry(key(place.at)).or_default().push((face, corner));
            }
        }
        Self { runs, faces, tolerance, nodes, corners, feet: Vec::new() }
    }

    /// How long a piece around a node may be: the chord of its curvature that is off by the tolerance.
    fn reach(&self, run: usize, node: usize) -> f64 {
        let nodes = &self.runs[run].nodes;
        let around = [node.saturating_sub(1), node, node + 1].map(|i| nodes[i.min(nodes.len() - 1)].at);
        let [one, two] = [around[1] - around[0], around[2] - around[1]];
        let turn = one.perp_dot(two).atan2(one.dot(two)).abs();
        let curvature = 2.0 * turn / (one.length() + two.length());
        if curvature > 0.0 { (8.0 * self.tolerance / curvature).sqrt() } else { f64::INFINITY }
    }

    /// About how many pieces a run needs.
    fn need(&self, run: usize) -> f64 {
        if !self.runs[run].curved {
            return 0.0;
        }
        let pieces = self.runs[run].nodes.windows(2).enumerate();
        pieces.map(|(index, ends)| ends[0].at.distance(ends[1].at) / self.reach(run, index.max(1))).sum()
    }

    /// Chooses points where kept ones are too far apart.
    fn fill(&mut self, run: usize) {
        let kept: Vec<usize> =
            (0..self.runs[run].nodes.len()).filter(|node| self.runs[run].nodes[*node].kept).collect();
        for gap in kept.windows(2) {
            let nodes = &self.runs[run].nodes[gap[0]..=gap[1]];
            let parts = (sagitta(nodes) / self.tolerance).sqrt().ceil() as usize;
            if parts < 2 {
                continue;
            }
            let lengths: Vec<f64> = nodes
                .windows(2)
                .scan(0.0, |length, ends| {
                    *length += ends[0].at.distance(ends[1].at);
                    Some(*length)
                })
                .collect();
            let whole = lengths.last().copied().unwrap_or(0.0);
            for part in 1..parts {
                let wanted = whole * part as f64 / parts as f64;
                let node = gap[0] + 1 + lengths.partition_point(|length| *length < wanted * (1.0 - 1e-9));
                if node < gap[1] && !self.runs[run].nodes[node].kept {
                    self.keep(run, node);
                }
            }
        }
    }

    /// Keeps a point, and those that face it, those that face these, and so on.
    fn keep(&mut self, run: usize, node: usize) {
        let mut waiting = vec![(run, node)];
        while let Some((run, node)) = waiting.pop() {
            self.runs[run].nodes[node].kept = true;
            let place = key(self.runs[run].nodes[node].at);
            let reach = self.reach(run, node);
            for &(face, corner) in self.corners.get(&place).into_iter().flatten() {
                match facing(&self.faces[face], corner) {
                    Some(Facing::Corner(other)) => {
                        let twins = self.nodes.get(&key(self.faces[face][other].at));
                        let free = |(run, node): &&(usize, usize)| !self.is_crowded(*run, *node);
                        waiting.extend(twins.into_iter().flatten().filter(free));
                    }
                    Some(Facing::Foot(foot)) => {
                        let near = APART * reach;
                        let corners = self.faces[face].iter().map(|corner| corner.at);
                        if self.feet.iter().copied().chain(corners).all(|other| other.distance(foot) > near) {
                            self.feet.push(foot);
                        }
                    }
                    None => {}
                }
            }
        }
    }

    /// Whether a node is kept or has a kept one near.
    fn is_crowded(&self, run: usize, node: usize) -> bool {
        let nodes = &self.runs[run].nodes;
        let near = APART * self.reach(run, node);
        let within = |other: &&Node| other.at.distance(nodes[node].at) <= near;
        nodes[node].kept
            || nodes[node + 1..].iter().take_while(within).any(|other| other.kept)
            || nodes[..node].iter().rev().take_while(within).any(|other| other.kept)
    }
}

/// How far points are from the line between the first and the last, or from the first if these are one.
fn sagitta(nodes: &[Node]) -> f64 {
    let [Some(first), Some(last)] = [nodes.first(), nodes.last()] else { return 0.0 };
    let along = (last.at - first.at).normalize_or_zero();
    let off = |node: &Node| {
        let from = node.at - first.at;
        if along == DVec2::ZERO { from.length() } else { from.perp_dot(along).abs() }
    };
    nodes.iter().map(off).fold(0.0, f64::max)
}

/// What a corner of a face faces: where the line at a right angle to its curve meets the outline first, or the point near
/// there whose line to the corner is most nearly at right angles to both curves.
fn facing(face: &Face, corner: usize) -> Option<Facing> {
    let from = face[corner];
    let normal = from.tangent?.perp();
    let count = face.len();
    let mut nearest: Option<(f64, usize, f64)> = None;
    for side in (0..count).filter(|side| *side != corner && (*side + 1) % count != corner) {
        let [a, b] = [face[side].at, face[(side + 1) % count].at];
        let turn = normal.perp_dot(b - a);
        let along = (a - from.at).perp_dot(b - a) / turn;
        let across = (a - from.at).perp_dot(normal) / turn;
        if turn != 0.0
            && along > 0.0
            && (0.0..=1.0).contains(&across)
            && nearest.is_none_or(|(least, ..)| along < least)
        {
            nearest = Some((along, side, across));
        }
    }
    let (along, side, across) = nearest?;
    let ends = [side, (side + 1) % count];
    if ends.iter().all(|end| face[*end].tangent.is_none()) {
        return Some(Facing::Foot(from.at + along * normal));
    }
    let to = |other: usize| {
        face[other].tangent?;
        Some(slant(&face[corner], &face[other]))
    };
    let mut best = ends[usize::from(across > 0.5)];
    if face[best].tangent.is_none() {
        best = ends[usize::from(across <= 0.5)];
    }
    let mut least = to(best)?;
    for step in [1, count - 1] {
        let mut at = (best + step) % count;
        while let Some(cost) = to(at).filter(|cost| *cost < least) {
            (best, least) = (at, cost);
            at = (at + step) % count;
        }
    }
    (least <= FACING && best != corner).then_some(Facing::Corner(best))
}

/// Splits straight runs where a foot lies on them.
pub(super) fn split(runs: &mut [Run], feet: &[DVec2], size: f64) {
    for run in runs.iter_mut().filter(|run| !run.curved) {
        let mut nodes = vec![run.nodes[0]];
        for ends in run.nodes.windows(2) {
            let [a, b] = [ends[0].at, ends[1].at];
            let fraction = |foot: DVec2| (foot - a).dot(b - a) / a.distance_squared(b);
            let on = |foot: &DVec2| {
                let at = fraction(*foot);
                at > 0.0 && at < 1.0 && (a + at * (b - a)).distance(*foot) <= ON_LINE * size
            };
            let mut here: Vec<DVec2> = feet.iter().copied().filter(on).collect();
            here.sort_by(|one, two| fraction(*one).total_cmp(&fraction(*two)));
            nodes.extend(here.into_iter().map(|at| Node { at, kept: true }));
            nodes.push(ends[1]);
        }
        run.nodes = nodes;
    }
}

/// Feet are on their line but for rounding.
const ON_LINE: f64 = 1e-9;
