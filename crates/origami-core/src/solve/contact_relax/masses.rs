//! What moves under contact: a mass of each node, but for pairs that press hard.
//!
//! The mass of a node is a bound on its row of the stiffness matrix, so that each moves at its own local step. A pair that is
//! pressed together is a thousand times stiffer than springs, and only across: nodes that were as heavy as that would hardly
//! turn or slide. So its stiffness is taken whole: masses are D + sum of k u u^T, a number for each node and a vector u over
//! the nodes of each such pair. Forces are divided by that as by numbers, after what the pairs hold back of them has been taken
//! off (the formula of Sherman, Morrison and Woodbury).

use glam::DVec3;

use crate::contact::Stiff;

/// Of pairs that share nodes so many are taken whole, the stiffest; what others do is added to the masses of their nodes. More:
/// they move with more freedom, and their equations are dearer.
const MOST: usize = 24;

/// Masses of all nodes.
#[derive(Clone, Debug, Default)]
pub(super) struct Masses {
    /// By node: the number, and its inverse.
    pub(super) nodes: Vec<[f64; 2]>,
    /// Pairs that share nodes lie one after the other, ...
    stiff: Vec<Stiff>,
    /// ... so many each time.
    parts: Vec<usize>,
    /// By node: which pair it was met in first. Kept for its memory, as what follows.
    met: Vec<u32>,
    matrix: Vec<f64>,
    holds: Vec<f64>,
    left: Vec<DVec3>,
}

/// No pair.
const NONE: u32 = u32::MAX;

impl Masses {
    /// The masses of all nodes but for what stiff pairs add.
    pub(super) fn weigh(&mut self, sums: impl Iterator<Item = f64>) {
        self.nodes.clear();
        self.nodes.extend(sums.map(|sum| [sum, 1.0 / sum]));
        self.stiff.clear();
    }

    /// Takes these pairs whole, and off the forces what they hold back.
    pub(super) fn hold(&mut self, stiff: impl Iterator<Item = Stiff>, forces: &[DVec3]) {
        self.stiff.extend(stiff);
        self.part();
        self.take_off(forces);
    }

    /// Sorts the pairs into parts that have no node in common.
    fn part(&mut self) {
        self.parts.clear();
        if self.stiff.is_empty() {
            return;
        }
        self.met.resize(self.nodes.len(), NONE);
        let mut leads: Vec<u32> = (0..).take(self.stiff.len()).collect();
        let lead = |leads: &[u32], mut of: u32| {
            while leads[of as usize] != of {
                of = leads[of as usize];
            }
            of
        };
        for (own, pair) in (0..).zip(&self.stiff) {
            for (node, _) in counting(pair) {
                let met = &mut self.met[node];
                if *met == NONE {
                    *met = own;
                }
                let (one, other) = (lead(&leads, *met), lead(&leads, own));
                leads[one.max(other) as usize] = one.min(other);
            }
        }
        self.stiff.iter().flat_map(counting).for_each(|(node, _)| self.met[node] = NONE);
        let mut sorted: Vec<(u32, Stiff)> = (0..).map(|own| lead(&leads, own)).zip(self.stiff.drain(..)).collect();
        sorted.sort_by(|(part, one), (other_part, other)| {
            part.cmp(other_part).then(other.stiffness.total_cmp(&one.stiffness)).then(one.nodes.cmp(&other.nodes))
        });
        for part in sorted.chunk_by(|(one, _), (other, _)| one == other) {
            let (whole, others) = part.split_at(part.len().min(MOST));
            self.stiff.extend(whole.iter().map(|(_, pair)| pair));
            self.parts.push(whole.len());
            for (_, pair) in others {
                for (node, weight) in counting(pair) {
                    let sum = self.nodes[node][0] + 2.0 * pair.stiffness * weight.abs();
                    self.nodes[node] = [sum, 1.0 / sum];
                }
            }
        }
    }

    /// What is left of `forces` when the pairs have held back their part: divided by the number of each node it is the force
    /// divided by all of the masses.
    pub(super) fn left<'a>(&'a self, forces: &'a [DVec3]) -> &'a [DVec3] {
        if self.stiff.is_empty() { forces } else { &self.left }
    }

    fn take_off(&mut self, forces: &[DVec3]) {
        if self.stiff.is_empty() {
            return;
        }
        let Self { nodes, stiff, parts, matrix, holds, left, .. } = self;
        left.clear();
        left.extend_from_slice(forces);
        let mut rest = stiff.as_slice();
        for count in parts.iter() {
            let (part, others) = rest.split_at(*count);
            rest = others;
            holds.clear();
            matrix.clear();
            for (i, one) in part.iter().enumerate() {
                let by = |(node, weight): (usize, f64)| weight * nodes[node][1] * one.normal.dot(forces[node]);
                holds.push(counting(one).map(by).sum());
                matrix.extend(part[..i].iter().map(|other| shared(one, other, nodes)));
                matrix.push(shared(one, one, nodes) + 1.0 / one.stiffness);
            }
            solve(matrix, holds);
            for (pair, hold) in part.iter().zip(&*holds) {
                pair.pulls().for_each(|(node, pull)| left[node.index()] -= pull * *hold);
            }
        }
    }

    /// What the pairs add to mass times velocity squared.
    pub(super) fn speed(&self, velocities: &[DVec3]) -> f64 {
        self.stiff.iter().map(|pair| pair.stiffness * pair.apart(velocities).powi(2)).sum()
    }
}

/// The nodes of a pair that count, and their weights.
fn counting(pair: &Stiff) -> impl Iterator<Item = (usize, f64)> {
    pair.nodes.iter().map(|node| node.index()).zip(pair.weights).filter(|(_, weight)| *weight != 0.0)
}

/// How much what one pair holds takes the nearest points of another apart.
fn shared(one: &Stiff, other: &Stiff, nodes: &[[f64; 2]]) -> f64 {
    let mut sum = 0.0;
    for (node, weight) in counting(one) {
        for (_, theirs) in counting(other).filter(|(own, _)| *own == node) {
            sum += weight * theirs * nodes[node][1];
        }
    }
    sum * one.normal.dot(other.normal)
}

/// Solves the equations of a positive definite matrix, of which the lower triangle is told row by row, after Cholesky.
fn solve(matrix: &mut [f64], x: &mut [f64]) {
    let row = |i: usize| i * (i + 1) / 2;
    for i in 0..x.len() {
        for j in 0..=i {
            let products: f64 = (0..j).map(|k| matrix[row(i) + k] * matrix[row(j) + k]).sum();
            let left = matrix[row(i) + j] - products;
            matrix[row(i) + j] = if i == j { left.sqrt() } else { left / matrix[row(j) + j] };
        }
        let known: f64 = (0..i).map(|k| matrix[row(i) + k] * x[k]).sum();
        x[i] = (x[i] - known) / matrix[row(i) + i];
    }
    for i in (0..x.len()).rev() {
        let known: f64 = (i + 1..x.len()).map(|k| matrix[row(k) + i] * x[k]).sum();
        x[i] = (x[i] - known) / matrix[row(i) + i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ids::NodeId;

    /// A pair of four of twelve nodes, somehow.
    fn pair(seed: f64, nodes: [u32; 4]) -> Stiff {
        let part = |x: f64| 0.5 + 0.4 * (seed * x).sin();
        let (a, b) = (part(3.1), part(5.3));
        let normal = DVec3::new((seed * 1.3).sin(), (seed * 2.7).cos(), (seed * 4.9).sin()).normalize();
        Stiff { nodes: nodes.map(NodeId), weights: [a, 1.0 - a, -b, b - 1.0], normal, stiffness: 1e4 * part(7.7) }
    }

    /// The product of all masses and velocities, by node.
    fn product(masses: &Masses, velocities: &[DVec3]) -> Vec<DVec3> {
        let mut all: Vec<DVec3> = masses.nodes.iter().zip(velocities).map(|([mass, _], v)| *mass * *v).collect();
        for pair in &masses.stiff {
            let by = pair.stiffness * pair.apart(velocities);
            pair.pulls().for_each(|(node, pull)| all[node.index()] += by * pull);
        }
        all
    }

    fn forces() -> Vec<DVec3> {
        (0..12).map(f64::from).map(|x| DVec3::new(x.sin(), (2.0 * x).cos(), x.cos())).collect()
    }

    fn masses(pairs: &[Stiff]) -> Masses {
        let mut masses = Masses::default();
        masses.weigh((0..12).map(|i| 20.0 + f64::from(i)));
        masses.hold(pairs.iter().copied(), &forces());
        masses
    }

    #[test]
    fn forces_divided_by_masses_are_what_masses_times_that_give() {
        let forces = forces();
        // Three parts: two pairs that share a node, one alone, and one of a node twice.
        let pairs =
            [pair(1.0, [0, 1, 2, 3]), pair(2.0, [8, 9, 10, 11]), pair(3.0, [3, 4, 5, 1]), pair(4.0, [6, 7, 7, 7])];
        let mut masses = masses(&pairs);
        assert_eq!(masses.parts, [2, 1, 1]);
        let left = masses.left(&forces).to_vec();
        let quotient: Vec<DVec3> = left.iter().zip(&masses.nodes).map(|(f, [_, inverse])| *f * *inverse).collect();
        let error = |with: &Masses| {
            let back = product(with, &quotient);
            back.iter().zip(&forces).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max)
        };
        assert!(error(&masses) < 1e-11, "{}", error(&masses));
        let speed: f64 = masses.nodes.iter().zip(&quotient).map(|([mass, _], v)| mass * v.length_squared()).sum();
        let power: f64 = quotient.iter().zip(&forces).map(|(v, f)| v.dot(*f)).sum();
        assert!((speed + masses.speed(&quotient) - power).abs() < 1e-11, "twice the energy of motion");
        masses.stiff[0].stiffness *= 1.001;
        assert!(error(&masses) > 1e-6, "another stiffness is seen");
    }

    #[test]
    fn of_too_many_pairs_the_stiffest_are_taken_whole() {
        let all: Vec<Stiff> = (0..60).map(|i| pair(f64::from(i), [i % 11, 11, (i + 3) % 11, (i + 5) % 11])).collect();
        let masses = masses(&all);
        assert_eq!((masses.parts.as_slice(), masses.stiff.len()), (&[MOST][..], MOST));
        let least = masses.stiff.iter().map(|pair| pair.stiffness).fold(f64::INFINITY, f64::min);
        let others: f64 = all.iter().map(|pair| pair.stiffness).filter(|own| *own < least).map(|own| 4.0 * own).sum();
        let added: f64 = masses.nodes.iter().zip(0..).map(|([mass, _], i)| mass - 20.0 - f64::from(i)).sum();
        assert!((added - others).abs() < 1e-9 * others && others > 0.0, "{added} {others}");
    }

    #[test]
    fn without_stiff_pairs_forces_are_left_as_they_are() {
        let masses = masses(&[]);
        assert_eq!(masses.left(&forces()), forces());
        assert_eq!(masses.speed(&forces()), 0.0);
    }
}
