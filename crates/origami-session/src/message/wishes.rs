//! What is asked of a sheet: angles, pins, material and solver.

use std::collections::BTreeMap;

use origami_core::model::Material;
use origami_core::solve::DEFAULT_TOLERANCE;
use serde::{Deserialize, Serialize};

/// All that is asked of a sheet: what marks remember, what is saved, and what a page shows beside the sheet.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Wishes {
    /// Per cent of the pattern's angles.
    pub percent: f64,
    /// Edges with a wish of their own.
    pub creases: BTreeMap<u32, Own>,
    /// Nodes that are held, and where, in radii.
    pub pins: BTreeMap<u32, [f64; 3]>,
    /// What the sheet is made of.
    pub material: Material,
    /// What moves it.
    pub solver: SolverWish,
}

/// What becomes of a crease.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Own {
    /// It folds to this angle, whatever the percentage; valleys are positive.
    Angle(f64),
    /// It turns without a spring.
    Free,
}

/// What moves the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SolverWish {
    /// Which.
    pub name: SolverName,
    /// Distance from the equilibrium at which the sheet has settled, in radii. Smaller: more steps. Default 1e-4.
    pub tolerance: f64,
    /// For dynamics. Default Euler's, the paper's.
    pub integrator: IntegratorName,
    /// The processor's numbers. Default f64.
    pub precision: PrecisionName,
}

impl Default for SolverWish {
    fn default() -> Self {
        Self {
            name: SolverName::Relax,
            tolerance: DEFAULT_TOLERANCE,
            integrator: IntegratorName::Euler,
            precision: PrecisionName::F64,
        }
    }
}

/// A solver that goes by steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolverName {
    /// Straight to the folded state.
    #[default]
    Relax,
    /// Through the damped motion of the paper.
    Dynamics,
}

/// How dynamics goes from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum IntegratorName {
    /// The paper's.
    #[default]
    Euler,
    /// Verlet's.
    Verlet,
}

/// The numbers that the processor computes in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PrecisionName {
    /// 64 bits.
    #[default]
    F64,
    /// 32 bits where they will do: faster on large sheets.
    Mixed,
}
