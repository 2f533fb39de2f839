//! Why a structure cannot be analysed.

use super::Dof;

/// Why a structure cannot be analysed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// A number or a node is not what it may be.
    #[error("{place}: {problem}; expected {expected}")]
    Invalid {
        /// Where, such as `bars[3].nodes`.
        place: String,
        /// What is there.
        problem: String,
        /// What was expected.
        expected: String,
    },
    /// Two supports want one degree of freedom at two places.
    #[error("supports: node {} along {} is held at {one} and at {other}; expected one place", .dof.node.0, .dof.axis.name())]
    Contradiction {
        /// The degree of freedom.
        dof: Dof,
        /// Its displacement after one support, in the structure's unit of length.
        one: f64,
        /// That after the other.
        other: f64,
    },
    /// The supports leave the structure, or parts of it, free to move without being deformed.
    #[error("supports: they leave {free} rigid motions free; expected none")]
    RigidMotions {
        /// How many independent ones.
        free: usize,
    },
    /// Where it is drawn, it can be deformed without a force.
    #[error("structure: it has {count} mechanisms, motions that nothing resists; expected none")]
    Mechanisms {
        /// How many independent ones.
        count: usize,
    },
    /// There is nothing to follow.
    #[error("loads: nothing acts on a free degree of freedom; expected a load, a pressure or a moved support")]
    Unloaded,
    /// The factors do not fit into memory.
    #[error("the factors of a matrix of {rows} rows do not fit into memory")]
    OutOfMemory {
        /// The free degrees of freedom.
        rows: usize,
    },
    /// Solving a state's equations failed.
    #[error("{at}: no equilibrium was found within {iterations} iterations; expected one nearby")]
    NotFound {
        /// Where it was sought.
        at: String,
        /// How often was tried.
        iterations: u32,
    },
    /// The tangent is singular.
    #[error("{at}: the state is singular, a limit point or a bifurcation; expected one with a regular tangent")]
    Singular {
        /// Where.
        at: String,
    },
}

impl Refused {
    pub(crate) fn at(place: impl Into<String>, problem: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::Invalid { place: place.into(), problem: problem.into(), expected: expected.into() }
    }
}
