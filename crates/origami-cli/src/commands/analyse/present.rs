//! A build with the feature `analysis`.

use super::{buckling, equilibria, modes, path, stiffness};
use crate::args::{AnalyseArgs, Analysis};
use crate::exit::{Exit, Failure};

/// Finds out what is asked.
pub(in crate::commands) fn run(args: &AnalyseArgs) -> Result<Exit, Failure> {
    match &args.analysis {
        Analysis::Path(args) => path::run(args),
        Analysis::Equilibria(args) => equilibria::run(args),
        Analysis::Stiffness(args) => stiffness::run(args),
        Analysis::Modes(args) => modes::run(args),
        Analysis::Buckling(args) => buckling::run(args),
    }
}
