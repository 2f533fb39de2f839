//! `origami view`.

use std::path::PathBuf;

use clap::Args;

use super::{ADAPTER_VARIABLE, BackendName, ReadingArgs};

const EXAMPLES: &str = "\
Examples:
  origami view crane.fold                                  Fold it by hand, in a browser
  origami view                                             Choose a pattern there
  origami view crane.fold --no-open --port 8123            On a far machine, through a tunnel:
                                                           ssh -L 8123:localhost:8123 far.example
Exit codes: 0 stopped (Ctrl-C), 1 bad input or usage.";

/// See a sheet fold, and touch it: a page in the browser, with the solver of this program behind it.
///
/// Prints an address and opens it. Whoever has the address can fold; nobody else can: only this machine is listened to, and
/// the address holds a secret of this run. Several pages at once each have a sheet of their own. docs/VIEW.md tells all that
/// the page can do.
#[derive(Args)]
#[command(after_help = EXAMPLES, override_usage = "origami view [OPTIONS] [FILE]")]
pub(crate) struct ViewArgs {
    /// A crease pattern: FOLD, CP, OPX, ORI, SVG, OBJ or another [default: the page offers some]
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,

    /// The port to listen at; 0: any that is free
    #[arg(long, value_name = "P", default_value_t = 0)]
    pub(crate) port: u16,

    /// Open no browser; only print the address
    #[arg(long)]
    pub(crate) no_open: bool,

    /// What folds: cpu or gpu; auto is the processor
    #[arg(long, value_enum, value_name = "BACKEND", default_value_t = BackendName::Auto, hide_possible_values = true)]
    pub(crate) backend: BackendName,

    /// The GPU adapter to use with --backend gpu: part of a name that `origami adapters` lists [default: the first]
    #[arg(long, value_name = "NAME", env = ADAPTER_VARIABLE, hide_env_values = true)]
    pub(crate) adapter: Option<String>,

    #[command(flatten)]
    pub(crate) reading: ReadingArgs,
}
