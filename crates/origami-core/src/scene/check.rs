//! What can be refused before the work is.

use std::fmt;

use glam::DVec3;

use super::{Needs, NotFlat, Scene};
use crate::ids::{FaceId, NodeId};
use crate::model::Model;

/// Why a scene cannot be run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// A percentage is not a number.
    #[error("targets: {0} %; expected a finite percentage")]
    Percent(f64),
    /// There are too few targets, or too many.
    #[error("targets: {given} angles; expected one for each of the model's {creases} creases")]
    TargetCount {
        /// How many there are.
        given: usize,
        /// How many creases have a spring.
        creases: usize,
    },
    /// A target is not a number.
    #[error("targets[{crease}]: {angle}; expected a finite angle in radians")]
    Target {
        /// Its index.
        crease: usize,
        /// The angle.
        angle: f64,
    },
    /// A support or a load is on a node that the sheet does not have.
    #[error("{what}[{index}]: node {}; expected one of the sheet's {nodes} nodes", node.0)]
    Node {
        /// `supports` or `loads`.
        what: &'static str,
        /// The index of the support or load.
        index: usize,
        /// The node.
        node: NodeId,
        /// How many nodes there are.
        nodes: usize,
    },
    /// A prescribed position or a load is not a number.
    #[error("{what}[{index}]: {vector}; expected finite numbers")]
    NotFinite {
        /// `supports` or `loads`.
        what: &'static str,
        /// The index of the support or load.
        index: usize,
        /// The vector.
        vector: DVec3,
    },
    /// Loads push a sheet that nothing holds: it has no equilibrium.
    #[error("loads: their sum is {sum}, and nothing holds the sheet; expected supports, or loads in balance")]
    Unbalanced {
        /// The sum of the loads.
        sum: DVec3,
    },
    /// A force of one's own lacks what the solver needs.
    #[error("force `{force}`: it has no {needs}, which {solver} needs; {instead}")]
    Lacks {
        /// The force's line in the inventory.
        force: &'static str,
        /// What it lacks.
        needs: Needs,
        /// What needs it.
        solver: &'static str,
        /// What can be done.
        instead: &'static str,
    },
    /// The flat-folded state is asked for where there is none.
    #[error(transparent)]
    NotFlat(#[from] NotFlat),
    /// A pin that was taken out.
    #[error("pin of node {}: it was taken out; expected one that still holds", .0.0)]
    NotPinned(NodeId),
    /// What was saved is of another sheet.
    #[error("saved simulation: it is of another sheet; expected one of {nodes} nodes and {creases} creases")]
    Saved {
        /// The nodes of the model.
        nodes: usize,
        /// Its creases.
        creases: usize,
    },
    /// A setting of contact is no length or stiffness.
    #[error("contact: {what} {value}; expected a finite number above 0")]
    Contact {
        /// `gap` or `stiffness`.
        what: &'static str,
        /// What it is.
        value: f64,
    },
    /// The sheet goes through itself before it is folded.
    #[error("contact: faces {} and {} of the sheet cross where it begins; expected a state without crossings", .faces[0].0, .faces[1].0)]
    Crossed {
        /// Two faces that cross.
        faces: [FaceId; 2],
    },
    /// Layers lie in one place before the sheet is folded.
    #[error("contact: layers have a gap of {gap:.1e} radii where the sheet begins; expected more than 0")]
    Closed {
        /// The least gap.
        gap: f64,
    },
    /// What computes cannot do that.
    #[error("{what}: {backend} cannot compute them; expected {expected}")]
    Unsupported {
        /// What the scene has, such as `forces`.
        what: &'static str,
        /// What was to compute it.
        backend: &'static str,
        /// What can.
        expected: &'static str,
    },
    /// A number is too large, or too small, for the numbers in which it is to be computed.
    #[error(
        "{what}: {value:e}; {backend} computes in f32 (expected {least:e} to {most:e} in size, or the same solver on the CPU)"
    )]
    TooWide {
        /// What the number is.
        what: String,
        /// The number.
        value: f64,
        /// What was to compute with it.
        backend: &'static str,
        /// The least size beside 0.
        least: f64,
        /// The largest.
        most: f64,
    },
}

impl fmt::Display for Needs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Energy => "energy",
            Self::RowSums => "bound on its row sums",
            Self::Hessian => "Hessian",
        })
    }
}

impl Scene {
    /// Whether supports and loads are on nodes that the sheet has, and all numbers are finite.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub fn check(&self, model: &Model) -> Result<(), Refusal> {
        self.targets.of(model)?;
        let nodes = model.node_count();
        let supports = self.supports.iter().map(|s| (s.node, s.position.unwrap_or_default()));
        let loads = self.loads.iter().map(|load| (load.node, load.force));
        let check = |what, index, (node, vector): (NodeId, DVec3)| {
            if node.index() >= nodes {
                return Err(Refusal::Node { what, index, node, nodes });
            }
            if !vector.is_finite() {
                return Err(Refusal::NotFinite { what, index, vector });
            }
            Ok(())
        };
        supports.enumerate().try_for_each(|(i, given)| check("supports", i, given))?;
        loads.enumerate().try_for_each(|(i, given)| check("loads", i, given))
    }

    /// Whether there can be an equilibrium: loads on a sheet that nothing holds must be in balance.
    ///
    /// # Errors
    /// [`Refusal::Unbalanced`].
    pub fn check_balance(&self, model: &Model) -> Result<(), Refusal> {
        let held = !(model.fixed.is_empty() && self.supports.is_empty() && self.forces.is_empty());
        let sum: DVec3 = self.loads.iter().map(|load| load.force).sum();
        let size: f64 = self.loads.iter().map(|load| load.force.length()).sum();
        if held || sum.length() <= 1e-12 * size { Ok(()) } else { Err(Refusal::Unbalanced { sum }) }
    }

    /// Whether each force of one's own has what `solver` needs; `instead` is what can be done.
    ///
    /// # Errors
    /// [`Refusal::Lacks`] of the first that does not.
    pub fn check_forces(
        &self,
        model: &Model,
        needs: &[Needs],
        solver: &'static str,
        instead: &'static str,
    ) -> Result<(), Refusal> {
        for force in &self.forces {
            let has = |needs: &Needs| match needs {
                Needs::Energy => force.energy(&model.rest).is_some(),
                Needs::RowSums => force.add_row_sums(&model.rest, &mut vec![0.0; model.node_count()]),
                Needs::Hessian => force.add_hessian(&model.rest, &mut |_, _, _| {}),
            };
            if let Some(lacking) = needs.iter().find(|needs| !has(needs)) {
                return Err(Refusal::Lacks { force: force.inventory().what, needs: *lacking, solver, instead });
            }
        }
        Ok(())
    }
}
