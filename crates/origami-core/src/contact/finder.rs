//! Which parts of a sheet may touch: its pairs, found by boxes around its triangles and edges.

use std::ops::Range;

use glam::DVec3;

use super::Contact;
use super::barrier::EASED;
use super::boxes::{Bounds, BoxTree};
use super::pairs::Pair;
use super::sieve::{Candidate, Sieve};
use super::wedge::{THICKEST, Wedges};
use crate::ids::NodeId;
use crate::mesh::{Mesh, Side};
use crate::parallel;

/// Pairs come no nearer than their gap begins at this share of their distance in the flat sheet: there nothing presses.
const OF_REST: f64 = 0.9;
/// Things that are nearer than this in the flat sheet, in radii, touch there, such as the two lips of a cut: nothing says on which
/// side of each other they are.
const TOUCHING: f64 = 1e-6;
/// Things that are farther apart in the flat sheet than so many gaps push from the whole gap on; a little more than the
/// inverse of [`OF_REST`].
const FAR: f64 = 1.2;

/// Points, or parts of a tree, that one task looks at.
const PART: usize = 256;

/// Where pairs are looked for.
struct At<'a> {
    positions: &'a [DVec3],
    reach: f64,
    triangles: Vec<Bounds>,
    /// Grown by half of how far apart edges may be.
    edges: Vec<Bounds>,
    tree_of_triangles: BoxTree,
    tree_of_edges: BoxTree,
}

/// Finds the pairs of one sheet.
#[derive(Clone, Debug)]
pub(super) struct Finder {
    /// Whether many threads look for them: they find the same in the same order.
    pub(super) shared: bool,
    /// Nodes of triangles.
    points: Vec<NodeId>,
    triangles: Vec<[NodeId; 3]>,
    /// Sides of triangles.
    edges: Vec<[NodeId; 2]>,
    rest: Vec<DVec3>,
    /// Trees of the triangles and of the edges at rest, whose order serves elsewhere too.
    tree_of_triangles: BoxTree,
    tree_of_edges: BoxTree,
    /// Balls around them at rest; the radius of an edge's is half its length.
    balls_of_triangles: Vec<Ball>,
    balls_of_edges: Vec<Ball>,
    /// The gap of a pair whose distance in the flat sheet is large enough.
    gap: f64,
    /// Of paper that has a thickness.
    wedges: Option<Wedges>,
    /// The farthest that a pair can be apart and closed, in radii.
    thickest: f64,
}

impl Finder {
    /// That of a sheet with its nodes at `rest`.
    pub(super) fn new(mesh: &Mesh, rest: &[DVec3], contact: Contact) -> Self {
        let points = (0..mesh.node_count()).filter(|n| !mesh.triangles_of_node.row(*n).is_empty());
        let paper = mesh.sides.iter().filter(|side| side.triangles.iter().any(Option::is_some));
        let paper: Vec<&Side> = paper.collect();
        let (gap, closed) = (contact.gap, contact.closed());
        let wedges = (closed > 0.0).then(|| Wedges::new(mesh, rest, &paper, closed));
        let edges: Vec<[NodeId; 2]> = paper.iter().map(|side| side.nodes).collect();
        Self {
            shared: false,
            points: points.map(NodeId::new).collect(),
            tree_of_triangles: BoxTree::new(&boxes(&mesh.triangles, rest)),
            tree_of_edges: BoxTree::new(&boxes(&edges, rest)),
            balls_of_triangles: mesh.triangles.iter().map(|nodes| Ball::around(nodes, rest)).collect(),
            balls_of_edges: edges.iter().map(|nodes| Ball::around(nodes, rest)).collect(),
            triangles: mesh.triangles.clone(),
            edges,
            rest: rest.to_vec(),
            gap,
            wedges,
            thickest: THICKEST * closed,
        }
    }

    /// The farthest that a pair can be apart and closed, in radii.
    pub(super) fn thickest(&self) -> f64 {
        self.thickest
    }

    /// The median length of the edges at rest.
    pub(super) fn median_edge(&self) -> f64 {
        let at = |n: NodeId| self.rest[n.index()];
        let mut lengths: Vec<f64> = self.edges.iter().map(|[a, b]| (at(*b) - at(*a)).length()).collect();
        lengths.sort_unstable_by(f64::total_cmp);
        lengths.get(lengths.len() / 2).copied().unwrap_or(1.0)
    }

    /// Replaces `pairs` by all whose gap at `positions` is below `reach`, with that gap in `gaps`; always in the same order.
    pub(super) fn find(&self, positions: &[DVec3], reach: f64, pairs: &mut Vec<Pair>, gaps: &mut Vec<f64>) {
        pairs.clear();
        gaps.clear();
        let at = self.at(positions, reach);
        let cut = |all: usize| (0..all).step_by(PART).map(move |from| from..all.min(from + PART));
        let points = cut(self.points.len()).map(|part| (1, part));
        let edges = cut(at.tree_of_edges.parts()).map(|part| (2, part));
        if self.shared {
            let parts: Vec<(usize, Range<usize>)> = points.chain(edges).collect();
            let found = parallel::map(&parts, |_, (split, part)| {
                let (mut pairs, mut gaps) = (Vec::new(), Vec::new());
                self.find_part(&at, *split, part.clone(), &mut |pair, gap| {
                    pairs.push(pair);
                    gaps.push(gap);
                });
                (pairs, gaps)
            });
            for (own_pairs, own_gaps) in found {
                pairs.extend(own_pairs);
                gaps.extend(own_gaps);
            }
        } else {
            for (split, part) in points.chain(edges) {
                self.find_part(&at, split, part, &mut |pair, gap| {
                    pairs.push(pair);
                    gaps.push(gap);
                });
            }
        }
    }

    /// The boxes with the nodes at `positions`, for what is within `reach` of each other.
    fn at<'a>(&self, positions: &'a [DVec3], reach: f64) -> At<'a> {
        let triangles = boxes(&self.triangles, positions);
        // Boxes that are so much larger meet where edges may be within reach.
        let half = 0.5 * (reach + self.thickest);
        let edges: Vec<Bounds> = boxes(&self.edges, positions).into_iter().map(|own| own.grown(half)).collect();
        At {
            positions,
            reach,
            tree_of_triangles: self.tree_of_triangles.moved(&triangles),
            tree_of_edges: self.tree_of_edges.moved(&edges),
            triangles,
            edges,
        }
    }

    /// Finds the pairs of some points, or of edges in some parts of their tree.
    fn find_part(&self, at: &At<'_>, split: usize, part: Range<usize>, take: &mut impl FnMut(Pair, f64)) {
        self.look(at, split, part, &mut |Candidate { nodes, numbers }: Candidate, distance: f64| {
            let mut pair = Pair::unmeasured(nodes, split);
            if self.measure(&mut pair, numbers) && distance - pair.closed < at.reach {
                take(pair, distance - pair.closed);
            }
        });
    }

    /// The pairs that touch in the flat sheet and so are none: the nodes of both things of each, and how many the first has.
    pub(super) fn touching(&self) -> Vec<([NodeId; 4], usize)> {
        let at = self.at(&self.rest, TOUCHING);
        let mut all = Vec::new();
        for (split, parts) in [(1, 0..self.points.len()), (2, 0..at.tree_of_edges.parts())] {
            self.look(&at, split, parts, &mut |candidate, distance| {
                if distance < TOUCHING {
                    all.push((candidate.nodes, split));
                }
            });
        }
        all
    }

    /// Tells `found` of all candidates that may be within reach, and their distances.
    fn look(&self, at: &At<'_>, split: usize, part: Range<usize>, found: &mut impl FnMut(Candidate, f64)) {
        let farthest = at.reach + self.thickest;
        let mut sieve = Sieve::new(split == 2, at.positions, farthest);
        if split == 1 {
            for &point in &self.points[part] {
                let own = Bounds::around([at.positions[point.index()]]).grown(farthest);
                at.tree_of_triangles.near(&own, |triangle| {
                    let [a, b, c] = self.triangles[triangle];
                    if at.triangles[triangle].meets(&own) && ![a, b, c].contains(&point) {
                        sieve.take(Candidate { nodes: [point, a, b, c], numbers: [0, triangle] }, found);
                    }
                });
            }
        } else {
            at.tree_of_edges.near_each_other(part, |[first, second]| {
                let ([p, q], [r, s]) = (self.edges[first], self.edges[second]);
                if at.edges[first].meets(&at.edges[second]) && ![r, s].contains(&p) && ![r, s].contains(&q) {
                    sieve.take(Candidate { nodes: [p, q, r, s], numbers: [first, second] }, found);
                }
            });
        }
        sieve.sift(found);
    }

    /// The gap and the thickness of a pair: less where it is narrow in the flat sheet. `numbers` are those of the triangle, or
    /// of both edges. False for one that touches there, such as the two lips of a cut: nothing can be said of it.
    fn measure(&self, pair: &mut Pair, numbers: [usize; 2]) -> bool {
        let far = match pair.split {
            1 => self.balls_of_triangles[numbers[1]]
                .is_apart(&Ball { at: self.rest[pair.nodes[0].index()], radius: 0.0 }, FAR * self.gap),
            _ => {
                let [one, other] = numbers.map(|edge| &self.balls_of_edges[edge]);
                pair.eased = 16.0 * EASED * one.radius.powi(2) * other.radius.powi(2);
                one.is_apart(other, FAR * self.gap)
            }
        };
        if self.wedges.is_none() && far {
            pair.width = self.gap;
            return true;
        }
        let points = pair.points(&self.rest);
        let at_rest = pair.nearest(&points).apart.length();
        if at_rest < TOUCHING {
            return false;
        }
        let thickness = self.wedges.as_ref().map_or(0.0, |wedges| match pair.split {
            1 => wedges.of_point(pair.nodes[0], numbers[1], &points),
            _ => wedges.of_edges(numbers, &points),
        });
        let scale = (OF_REST * at_rest / (thickness + self.gap)).min(1.0);
        pair.width = scale * self.gap;
        pair.closed = scale * thickness;
        true
    }
}

/// The boxes around things of so many nodes.
fn boxes<const N: usize>(things: &[[NodeId; N]], positions: &[DVec3]) -> Vec<Bounds> {
    let around = |nodes: &[NodeId; N]| Bounds::around(nodes.map(|n| positions[n.index()]));
    things.iter().map(around).collect()
}

/// A ball around a thing.
#[derive(Clone, Copy, Debug)]
struct Ball {
    at: DVec3,
    radius: f64,
}

impl Ball {
    /// About the middle of the first two of its nodes.
    fn around(nodes: &[NodeId], positions: &[DVec3]) -> Self {
        let place = |n: &NodeId| positions[n.index()];
        let at = 0.5 * (place(&nodes[0]) + place(&nodes[1]));
        Self { at, radius: nodes.iter().map(|n| (place(n) - at).length()).fold(0.0, f64::max) }
    }

    /// Whether two things are surely farther apart than that.
    fn is_apart(&self, other: &Self, distance: f64) -> bool {
        (self.at - other.at).length_squared() > (distance + self.radius + other.radius).powi(2)
    }
}
