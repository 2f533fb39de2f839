//! A build without the feature `analysis`.

use crate::args::{AnalyseArgs, DesignArgs};
use crate::exit::{Exit, Failure};

/// Refuses.
///
/// # Errors
/// Always.
pub(in crate::commands) fn run(_args: &AnalyseArgs) -> Result<Exit, Failure> {
    Err(absent("analyse"))
}

/// Refuses.
///
/// # Errors
/// Always.
pub(in crate::commands) fn design(_args: &DesignArgs) -> Result<Exit, Failure> {
    Err(absent("design"))
}

fn absent(command: &str) -> Failure {
    format!(
        "origami {command}: this build is without it (feature `analysis`); expected a build without \
         --no-default-features or with --features analysis"
    )
    .into()
}
