//! Candidates for pairs, measured side by side, of which most are too far apart.

use glam::DVec3;

use super::distance::of_edges;
use super::lanes::{Given, Measured, WIDTH, measure_edges, measure_points};
use crate::ids::NodeId;

/// A point and a triangle, or two edges, by their nodes and by the number of the triangle or of both edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) nodes: [NodeId; 4],
    pub(super) numbers: [usize; 2],
}

/// Candidates of one kind, which wait until there are as many as lie side by side.
pub(super) struct Sieve<'a> {
    positions: &'a [DVec3],
    edges: bool,
    /// Those that are farther apart are none.
    farthest: f64,
    waiting: Vec<Candidate>,
    given: Given,
    measured: Measured,
}

impl<'a> Sieve<'a> {
    pub(super) fn new(edges: bool, positions: &'a [DVec3], farthest: f64) -> Self {
        let (given, measured) = (Given::new(), Measured::new());
        Self { positions, edges, farthest, waiting: Vec::with_capacity(WIDTH), given, measured }
    }

    /// Takes a candidate. `found` is told of all that are near enough, sooner or later, in their order, and their distance.
    pub(super) fn take(&mut self, candidate: Candidate, found: &mut impl FnMut(Candidate, f64)) {
        self.waiting.push(candidate);
        if self.waiting.len() == WIDTH {
            self.sift(found);
        }
    }

    /// No more are coming.
    pub(super) fn sift(&mut self, found: &mut impl FnMut(Candidate, f64)) {
        pulp::Arch::new().dispatch(Work(self));
        for (i, candidate) in self.waiting.drain(..).enumerate() {
            let parallel = self.edges && self.measured.is_parallel(i);
            let distance = if parallel {
                of_edges(&candidate.nodes.map(|n| self.positions[n.index()])).apart.length()
            } else {
                self.measured.gap[i]
            };
            if distance < self.farthest {
                found(candidate, distance);
            }
        }
    }
}

/// Measures all that wait, compiled for each set of instructions.
struct Work<'a, 'b>(&'a mut Sieve<'b>);

impl pulp::NullaryFnOnce for Work<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Sieve { positions, edges, waiting, given, measured, .. } = self.0;
        for (i, candidate) in waiting.iter().enumerate() {
            given.place(i, &candidate.nodes, positions);
        }
        if *edges {
            measure_edges(given, measured);
        } else {
            measure_points(given, measured);
        }
    }
}
