//! A build without the feature `study`.

use crate::args::StudyArgs;
use crate::exit::{Exit, Failure};

/// Refuses.
///
/// # Errors
/// Always.
pub(in crate::commands) fn run(_args: &StudyArgs) -> Result<Exit, Failure> {
    Err("origami study: this build is without it (feature `study`); expected a build without --no-default-features or \
         with --features study"
        .to_owned()
        .into())
}
