//! `origami pattern`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use origami::generate::catalog;

use super::values::key_value;

const EXAMPLES: &str = "\
Examples:
  origami pattern --list
  origami pattern miura --set columns=6 --set rows=4 -o miura.fold
  origami pattern bird-base -o - | origami fold - --percent 90 -o bird.obj";

/// Make a crease pattern from parameters.
#[derive(Args)]
#[command(
    after_help = EXAMPLES,
    override_usage = "origami pattern <NAME> [--set <KEY=VALUE>]... -o <OUT>\n       origami pattern --list"
)]
pub(crate) struct PatternArgs {
    /// Which pattern; --list names them
    #[arg(value_name = "NAME", required_unless_present = "list", value_parser = PossibleValuesParser::new(catalog::names()),
        hide_possible_values = true)]
    pub(crate) name: Option<String>,

    /// Set a parameter; angles are in degrees; can be given more than once
    #[arg(long = "set", value_name = "KEY=VALUE", value_parser = key_value)]
    pub(crate) parameters: Vec<(String, f64)>,

    /// Where to write: a .fold file, or `-` for standard output
    #[arg(short, long, value_name = "OUT", required_unless_present = "list")]
    pub(crate) output: Option<PathBuf>,

    /// List the patterns with their parameters and defaults
    #[arg(long, exclusive = true)]
    pub(crate) list: bool,
}
