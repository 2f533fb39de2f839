//! What of a structure a design may change.

use glam::{DQuat, DVec3};

use crate::analysis::{Gradient, Refused, Structure};
use crate::ids::NodeId;

/// A number that a design may change, for all members that it names alike.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Of which members, and what of them.
    pub members: Members,
    /// The least value and the largest. They also tell how far is far: narrower ones make for smaller steps.
    pub bounds: [f64; 2],
}

/// Numbers that are changed together, by the indices of hinges, bars or nodes. Moves and turns draw the structure elsewhere, as
/// [`Structure::redrawn`] does; they are 0 as it is drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Members {
    /// Rest angles of hinges, in radians.
    RestAngles(Vec<usize>),
    /// Stiffnesses of whole hinges.
    HingeStiffnesses(Vec<usize>),
    /// Rest lengths of bars.
    RestLengths(Vec<usize>),
    /// Rigidities of bars.
    Rigidities(Vec<usize>),
    /// How often nodes are drawn farther by a vector.
    Moved {
        /// The nodes.
        nodes: Vec<NodeId>,
        /// The vector, in the structure's unit of length.
        along: DVec3,
    },
    /// Through which angle nodes are turned about an axis before they are moved, in radians.
    Turned {
        /// The nodes.
        nodes: Vec<NodeId>,
        /// A point on the axis.
        about: DVec3,
        /// Its direction, of length 1; counterclockwise seen from where it points to.
        axis: DVec3,
    },
}

impl Members {
    /// The indices of hinges or bars; of nodes none.
    fn indices(&self) -> &[usize] {
        match self {
            Self::RestAngles(all) | Self::HingeStiffnesses(all) | Self::RestLengths(all) | Self::Rigidities(all) => all,
            Self::Moved { .. } | Self::Turned { .. } => &[],
        }
    }

    fn nodes(&self) -> &[NodeId] {
        match self {
            Self::Moved { nodes, .. } | Self::Turned { nodes, .. } => nodes,
            _ => &[],
        }
    }

    fn number<'s>(&self, structure: &'s mut Structure, i: usize) -> Option<&'s mut f64> {
        match self {
            Self::RestAngles(_) => structure.hinges.get_mut(i).map(|hinge| &mut hinge.rest_angle),
            Self::HingeStiffnesses(_) => structure.hinges.get_mut(i).map(|hinge| &mut hinge.stiffness),
            Self::RestLengths(_) => structure.bars.get_mut(i).map(|bar| &mut bar.rest_length),
            Self::Rigidities(_) => structure.bars.get_mut(i).map(|bar| &mut bar.rigidity),
            Self::Moved { .. } | Self::Turned { .. } => None,
        }
    }
}

/// The variables of a design with the structure that it begins with.
#[derive(Debug)]
pub(super) struct Variables<'a> {
    original: &'a Structure,
    all: &'a [Variable],
}

impl<'a> Variables<'a> {
    /// Them, with the values that they begin with: the mean of the members' numbers, 0 of moves and turns.
    pub(super) fn new(original: &'a Structure, all: &'a [Variable]) -> Result<(Self, Vec<f64>), Refused> {
        let mut scratch = original.clone();
        let mut values = Vec::new();
        let mut turned = vec![false; original.nodes.len()];
        for (k, Variable { members, bounds }) in all.iter().enumerate() {
            let place = format!("variables[{k}]");
            let mut sum = 0.0;
            for i in members.indices() {
                let number = members.number(&mut scratch, *i).map(|own| *own);
                sum += number.ok_or_else(|| {
                    Refused::at(format!("{place}.members"), format!("member {i}"), "a hinge or bar of the structure")
                })?;
            }
            for node in members.nodes() {
                let Some(turned) = turned.get_mut(node.index()) else {
                    let expected = "a node of the structure";
                    return Err(Refused::at(format!("{place}.members"), format!("node {}", node.0), expected));
                };
                if let Members::Turned { .. } = members
                    && std::mem::replace(turned, true)
                {
                    let problem = format!("node {} is turned by two variables", node.0);
                    return Err(Refused::at(format!("{place}.members"), problem, "one turn of each node"));
                }
            }
            let count = members.indices().len() + members.nodes().len();
            let in_order = bounds[0] <= bounds[1];
            if count == 0 || !in_order {
                let problem = format!("{count} members between {} and {}", bounds[0], bounds[1]);
                return Err(Refused::at(place, problem, "one or more, and bounds in order"));
            }
            values.push(sum / count as f64);
        }
        Ok((Self { original, all }, values))
    }

    pub(super) fn bounds(&self) -> Vec<[f64; 2]> {
        self.all.iter().map(|variable| variable.bounds).collect()
    }

    /// The structure with these values.
    pub(super) fn structure(&self, values: &[f64]) -> Structure {
        let drawn = || self.all.iter().any(|variable| !variable.members.nodes().is_empty());
        let mut structure = if drawn() {
            let mut nodes = self.turned(values);
            for (Variable { members, .. }, value) in self.all.iter().zip(values) {
                if let Members::Moved { nodes: own, along } = members {
                    own.iter().for_each(|n| nodes[n.index()] += *along * *value);
                }
            }
            self.original.redrawn(nodes)
        } else {
            self.original.clone()
        };
        for (Variable { members, .. }, value) in self.all.iter().zip(values) {
            for i in members.indices() {
                if let Some(own) = members.number(&mut structure, *i) {
                    *own = *value;
                }
            }
        }
        structure
    }

    /// Where the nodes are drawn before they are moved.
    fn turned(&self, values: &[f64]) -> Vec<DVec3> {
        let mut nodes = self.original.nodes.clone();
        for (Variable { members, .. }, value) in self.all.iter().zip(values) {
            if let Members::Turned { nodes: own, about, axis } = members {
                let turn = DQuat::from_axis_angle(*axis, *value);
                own.iter().for_each(|n| nodes[n.index()] = *about + turn * (nodes[n.index()] - *about));
            }
        }
        nodes
    }

    /// How a result changes with each, by its gradient at `structure`, which has these values, and by its own slopes by where
    /// the nodes are drawn.
    pub(super) fn slopes(
        &self,
        structure: &Structure,
        values: &[f64],
        gradient: &Gradient,
        drawn: &[DVec3],
    ) -> Result<Vec<f64>, Refused> {
        let mut by_position = vec![DVec3::ZERO; structure.nodes.len()];
        let mut turned = Vec::new();
        if self.all.iter().any(|variable| !variable.members.nodes().is_empty()) {
            // Numbers that have variables of their own do not follow the drawing.
            let mut following = gradient.clone();
            for Variable { members, .. } in self.all {
                let numbers = match members {
                    Members::RestAngles(_) => &mut following.rest_angles,
                    Members::HingeStiffnesses(_) => &mut following.hinge_stiffnesses,
                    Members::RestLengths(_) => &mut following.rest_lengths,
                    _ => continue,
                };
                members.indices().iter().for_each(|i| numbers[*i] = 0.0);
            }
            by_position = following.by_drawn_positions(structure)?;
            by_position.iter_mut().zip(drawn).for_each(|(own, d)| *own += *d);
            turned = self.turned(values);
        }
        let slope = |Variable { members, .. }: &Variable| -> f64 {
            let sum = |all: &[f64]| members.indices().iter().map(|i| all[*i]).sum();
            let sum_at = |along: &dyn Fn(usize) -> DVec3| {
                members.nodes().iter().map(|n| by_position[n.index()].dot(along(n.index()))).sum()
            };
            match members {
                Members::RestAngles(_) => sum(&gradient.rest_angles),
                Members::HingeStiffnesses(_) => sum(&gradient.hinge_stiffnesses),
                Members::RestLengths(_) => sum(&gradient.rest_lengths),
                Members::Rigidities(_) => sum(&gradient.rigidities),
                Members::Moved { along, .. } => sum_at(&|_| *along),
                Members::Turned { about, axis, .. } => sum_at(&|n| axis.cross(turned[n] - *about)),
            }
        };
        Ok(self.all.iter().map(slope).collect())
    }
}
