//! A build without the feature `analysis`.

use crate::args::AnalyseArgs;
use crate::exit::{Exit, Failure};

/// Refuses.
///
/// # Errors
/// Always.
pub(in crate::commands) fn run(_args: &AnalyseArgs) -> Result<Exit, Failure> {
    Err("origami analyse: this build is without it (feature `analysis`); expected a build without --no-default-features \
         or with --features analysis"
        .to_owned()
        .into())
}
