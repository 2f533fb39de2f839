//! What a design is to achieve, with the slopes that its gradient is made of.

use glam::DVec3;

use crate::analysis::{Axis, Configuration, Gradient, Refused, Structure};
use crate::forces::{creases, unwrapped};
use crate::ids::NodeId;

/// Something wanted of the first equilibrium that a design watches, and of [`Goal::Barrier`] of the first two. As a value, that is to be
/// small: half the square of how far it is from being so.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// Nodes at places: the value is half the mean square of their distances.
    Shape(Vec<(NodeId, DVec3)>),
    /// A height: the mean coordinate of some nodes above that of others.
    Height {
        /// The upper nodes.
        of: Vec<NodeId>,
        /// The lower ones; none: above 0.
        above: Vec<NodeId>,
        /// Along which axis.
        axis: Axis,
        /// How much of it.
        wanted: f64,
    },
    /// A fold angle.
    FoldAngle {
        /// The hinge.
        hinge: usize,
        /// In radians.
        wanted: f64,
    },
    /// As small a compliance as can be: the value is the work of the dead loads, at the watched load factor, on displacements
    /// from where the nodes are drawn. Pressures do not count.
    Compliance,
    /// How much more is stored in the second state, a saddle, than in the first: both without loads.
    Barrier {
        /// The difference of the energies.
        wanted: f64,
    },
}

/// What a design has come to, and how that depends on the equilibria.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judgement {
    /// What is to be small.
    pub value: f64,
    /// Its slope by the positions in each equilibrium, by node; empty: 0.
    pub positions: Vec<Vec<DVec3>>,
    /// Its slope by the energy stored in each equilibrium; empty: 0.
    pub energies: Vec<f64>,
    /// Its slope by where the nodes are drawn, apart from what their places do to the equilibria; empty: 0.
    pub drawn: Vec<DVec3>,
}

impl Judgement {
    /// That of the first equilibrium alone.
    #[must_use]
    pub fn of_positions(value: f64, slope: Vec<DVec3>) -> Self {
        Self { value, positions: vec![slope], ..Self::default() }
    }

    /// Adds the gradient that comes of equilibrium `i`.
    pub(super) fn add_gradient(
        &self,
        i: usize,
        structure: &Structure,
        (at, load_factor): (&Configuration, f64),
        gradient: &mut Gradient,
    ) -> Result<(), Refused> {
        let mut by_positions = self.positions.get(i).cloned().unwrap_or_default();
        by_positions.resize(structure.nodes.len(), DVec3::ZERO);
        let energy = self.energies.get(i).copied().unwrap_or_default();
        if energy != 0.0 {
            let slope = structure.unbalanced(at, 0.0)?;
            by_positions.iter_mut().zip(slope).for_each(|(own, s)| *own += s * energy);
            gradient.add(energy, &structure.energy_slopes(at));
        }
        if by_positions.iter().any(|slope| *slope != DVec3::ZERO) {
            gradient.add(1.0, &structure.gradient(at, load_factor, &by_positions)?);
        }
        Ok(())
    }

    fn add(&mut self, weight: f64, other: Self) {
        let add = |own: &mut Vec<DVec3>, other: Vec<DVec3>| {
            own.resize(own.len().max(other.len()), DVec3::ZERO);
            own.iter_mut().zip(other).for_each(|(own, slope)| *own += slope * weight);
        };
        self.value += weight * other.value;
        self.positions.resize(self.positions.len().max(other.positions.len()), Vec::new());
        self.positions.iter_mut().zip(other.positions).for_each(|(own, slopes)| add(own, slopes));
        self.energies.resize(self.energies.len().max(other.energies.len()), 0.0);
        self.energies.iter_mut().zip(other.energies).for_each(|(own, slope)| *own += weight * slope);
        add(&mut self.drawn, other.drawn);
    }
}

impl Goal {
    /// What is measured of the equilibria `states` of `structure` under `load_factor` times its loads: the root of the mean
    /// squared distance, a height, an angle in radians, a compliance, a barrier.
    #[must_use]
    pub fn measure(&self, structure: &Structure, states: &[Configuration], load_factor: f64) -> f64 {
        let judged = self.judge(structure, states, load_factor);
        let Some(at) = states.first() else { return f64::NAN };
        match self {
            Self::Shape(_) => (2.0 * judged.value).sqrt(),
            Self::Height { of, above, axis, .. } => mean(of, at, *axis) - mean(above, at, *axis),
            Self::FoldAngle { hinge, .. } => at.fold_angles.get(*hinge).copied().unwrap_or(f64::NAN),
            Self::Compliance => judged.value,
            Self::Barrier { .. } => barrier(structure, states),
        }
    }

    /// How far it is from being reached, with its slopes.
    #[must_use]
    pub fn judge(&self, structure: &Structure, states: &[Configuration], load_factor: f64) -> Judgement {
        let Some(at) = states.first() else { return Judgement { value: f64::NAN, ..Judgement::default() } };
        let mut slope = vec![DVec3::ZERO; structure.nodes.len()];
        match self {
            Self::Shape(places) => {
                let share = 1.0 / places.len().max(1) as f64;
                let mut value = 0.0;
                for (node, place) in places {
                    let apart = at.positions[node.index()] - *place;
                    value += 0.5 * share * apart.length_squared();
                    slope[node.index()] += apart * share;
                }
                Judgement::of_positions(value, slope)
            }
            Self::Height { of, above, axis, wanted } => {
                let off = mean(of, at, *axis) - mean(above, at, *axis) - wanted;
                for (nodes, sign) in [(of, 1.0), (above, -1.0)] {
                    let each = sign * off / nodes.len().max(1) as f64;
                    nodes.iter().for_each(|n| slope[n.index()][axis.index()] += each);
                }
                Judgement::of_positions(0.5 * off * off, slope)
            }
            Self::FoldAngle { hinge, wanted } => {
                let (Some(own), Some(angle)) = (structure.hinges.get(*hinge), at.fold_angles.get(*hinge)) else {
                    return Judgement { value: f64::NAN, ..Judgement::default() };
                };
                let size = structure.size();
                let mut off = angle - wanted;
                if let Some(geometry) = creases::hinge(own.nodes.map(|n| at.positions[n.index()] / size)) {
                    off = unwrapped(geometry.angle(), *angle) - wanted;
                    for (n, by_node) in own.nodes.iter().zip(geometry.gradient) {
                        slope[n.index()] += by_node * (off / size);
                    }
                }
                Judgement::of_positions(0.5 * off * off, slope)
            }
            Self::Compliance => {
                let mut work = 0.0;
                for (node, force) in &structure.loads.points {
                    let acting = *force * load_factor;
                    work += acting.dot(at.positions[node.index()] - structure.nodes[node.index()]);
                    slope[node.index()] += acting;
                }
                let drawn = slope.iter().map(|s| -*s).collect();
                Judgement { drawn, ..Judgement::of_positions(work, slope) }
            }
            Self::Barrier { wanted } => {
                let off = barrier(structure, states) - wanted;
                Judgement { value: 0.5 * off * off, energies: vec![-off, off], ..Judgement::default() }
            }
        }
    }

    /// The sum of several goals, each with a weight.
    #[must_use]
    pub fn judge_all(
        goals: &[(f64, Self)],
        structure: &Structure,
        states: &[Configuration],
        load_factor: f64,
    ) -> Judgement {
        let mut sum = Judgement::default();
        goals.iter().for_each(|(weight, goal)| sum.add(*weight, goal.judge(structure, states, load_factor)));
        sum
    }
}

/// The mean coordinate of nodes, 0 of none.
fn mean(nodes: &[NodeId], at: &Configuration, axis: Axis) -> f64 {
    nodes.iter().map(|n| at.positions[n.index()][axis.index()]).sum::<f64>() / nodes.len().max(1) as f64
}

/// How much more is stored in the second state than in the first.
fn barrier(structure: &Structure, states: &[Configuration]) -> f64 {
    let energy = |i: usize| states.get(i).map_or(f64::NAN, |at| structure.energies(at).total());
    energy(1) - energy(0)
}
