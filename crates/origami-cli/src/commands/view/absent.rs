//! A build without the feature `view`.

use crate::args::ViewArgs;
use crate::exit::{Exit, Failure};

/// Refuses.
///
/// # Errors
/// Always.
pub(in crate::commands) fn run(_args: &ViewArgs) -> Result<Exit, Failure> {
    Err("origami view: this build is without it (feature `view`); expected a build without --no-default-features or with \
         --features view"
        .to_owned()
        .into())
}
