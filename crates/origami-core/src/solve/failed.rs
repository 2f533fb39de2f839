//! Why a solver has no result.

use std::error::Error;
use std::sync::Arc;

use super::{Diverged, State};
use crate::scene::Refusal;

/// Why a solver has no result.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Failed {
    /// The scene cannot be run: nothing was done.
    #[error("{refusal}")]
    Refused {
        /// What is wrong with it.
        refusal: Refusal,
        /// The state that it was to begin with.
        start: Box<State>,
    },
    /// The state left all bounds.
    #[error(transparent)]
    Diverged(#[from] Diverged),
    /// What computes gave up: a GPU was lost or has too little memory.
    #[error("{source}")]
    Backend {
        /// What it said.
        source: Arc<dyn Error + Send + Sync>,
        /// The last state that was read from it, or the one that it began with.
        last_read: Box<State>,
        /// The step of that state.
        last_read_step: u64,
    },
}

impl Failed {
    /// A scene that cannot be run from `start`.
    #[must_use]
    pub fn refused(refusal: Refusal, start: &State) -> Self {
        Self::Refused { refusal, start: Box::new(start.clone()) }
    }

    /// The last state that is known to be sound.
    #[must_use]
    pub fn last_state(&self) -> &State {
        match self {
            Self::Refused { start, .. } => start,
            Self::Diverged(diverged) => &diverged.last_good,
            Self::Backend { last_read, .. } => last_read,
        }
    }
}
