//! What is known of a state on a path.

use glam::DVec3;

use super::walker::{Direction, Stand, Walker};
use crate::analysis::{Configuration, Dof, Energies};

/// A state on a path.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Point {
    /// Where the structure is.
    pub configuration: Configuration,
    /// By how much its loads and the ways of its moved supports are multiplied.
    pub load_factor: f64,
    /// Length of the path so far, in the structure's unit of length: the root of the sum of all nodes' squared moves.
    pub arc: f64,
    /// What is stored in it.
    pub energies: Energies,
    /// Work of loads and moved supports since the path began, by the trapezoidal rule: it differs from the energy stored since
    /// by the square of the steps.
    pub work: f64,
    /// Independent directions in which the energy falls: 0 where it is stable under its loads. At a critical point rounding
    /// decides on which side of it this counts.
    pub negative: usize,
    /// The eigenvalue of the tangent that is nearest to 0, a force per length.
    pub nearest_eigenvalue: f64,
    /// What the supports do: a force for each degree of freedom that is held or moved, in order.
    pub reactions: Vec<(Dof, f64)>,
    /// Largest force out of balance.
    pub residual: f64,
    /// Iterations that it took.
    pub iterations: u32,
    /// The way on.
    pub onward: Onward,
    /// Why it is a point of the path.
    pub event: Event,
}

/// The direction of a path at a point: from here it can be taken up again.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Onward {
    /// By node.
    pub moves: Vec<DVec3>,
    /// How the load factor changes meanwhile.
    pub load_factor: f64,
}

/// Why a state is a point of a path.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Event {
    /// It is where a step led.
    Step,
    /// The load turns back here, or the displacement of the moved supports.
    LimitPoint {
        /// Negative eigenvalues shortly before it.
        before: usize,
        /// And shortly after.
        after: usize,
    },
    /// Other paths branch off here.
    Bifurcation {
        /// Negative eigenvalues shortly before it.
        before: usize,
        /// And shortly after.
        after: usize,
        /// Null vectors of the tangent, by node: into which directions they branch off.
        modes: Vec<Vec<DVec3>>,
    },
    /// Nothing acts here: an equilibrium of its own.
    ZeroLoad,
    /// Here the path was to end.
    End,
}

impl Event {
    /// Its name in tables.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::LimitPoint { .. } => "limit",
            Self::Bifurcation { .. } => "bifurcation",
            Self::ZeroLoad => "zero load",
            Self::End => "end",
        }
    }
}

impl Point {
    /// The point at `stand`, which comes after `before`.
    pub(super) fn new(walker: &mut Walker<'_>, stand: &Stand, before: Option<(&Self, &Stand)>, event: Event) -> Self {
        let structure = walker.structure();
        let moves = |from: &Stand| -> Vec<DVec3> {
            stand.at.positions.iter().zip(&from.at.positions).map(|(p, q)| *p - *q).collect()
        };
        let (mut arc, mut work) = (0.0, 0.0);
        if let Some((point, from)) = before {
            let moves = moves(from);
            arc = point.arc + moves.iter().map(|m| m.length_squared()).sum::<f64>().sqrt();
            let pulls = from.gradient.iter().zip(&stand.gradient);
            work = point.work + pulls.zip(&moves).map(|((f, g), m)| 0.5 * (*f + *g).dot(*m)).sum::<f64>();
        }
        // At the stand last, whose tangent the walker has.
        walker.tangent.set(&stand.at, stand.load_factor);
        let nearest = walker.nearest().first().map_or(f64::NAN, |(value, _)| *value);
        let equations = &walker.tangent.equations;
        let mut loads = vec![DVec3::ZERO; structure.nodes.len()];
        structure.loads.add_forces(&stand.at.positions, &mut loads);
        let reaction = |dof: Dof| (dof, dof.of(&stand.gradient) - stand.load_factor * dof.of(&loads));
        let mut onward = equations.rows.scatter(&stand.direction.rows);
        onward.iter_mut().zip(equations.way()).for_each(|(m, w)| *m += *w * stand.direction.load_factor);
        Self {
            configuration: stand.at.clone(),
            load_factor: stand.load_factor,
            arc,
            energies: structure.energies(&stand.at),
            work,
            negative: stand.negative,
            nearest_eigenvalue: nearest,
            reactions: equations.rows.held().map(reaction).collect(),
            residual: stand.residual,
            iterations: stand.iterations,
            onward: Onward { moves: onward, load_factor: stand.direction.load_factor },
            event,
        }
    }

    /// The displacement of a degree of freedom from where `drawn` has it.
    #[must_use]
    pub fn displacement(&self, drawn: &[DVec3], dof: Dof) -> f64 {
        dof.of(&self.configuration.positions) - dof.of(drawn)
    }
}

impl Onward {
    pub(super) fn direction(&self, walker: &Walker<'_>) -> Direction {
        Direction { rows: walker.tangent.equations.rows.gather(&self.moves), load_factor: self.load_factor }
    }
}
