//! `origami adapters`.

use clap::Args;

const EXAMPLES: &str = "\
Examples:
  origami adapters
  origami adapters --json | jq -r '.[] | select(.kind != \"software\").name'
  origami fold crane.fold -o folded.fold --backend gpu --adapter llvmpipe";

/// List the GPU adapters of this machine.
///
/// Hardware comes first; `software` is a program on the processor that stands in for a GPU. An adapter that several
/// programming interfaces show is listed for each. `buffer` is its largest buffer; `bindings` says how many a kernel sees
/// at once and how much of each; `workgroup` how many invocations go together and the memory that they share.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct AdaptersArgs {
    /// As JSON; docs/REPORT.md has the keys
    #[arg(long)]
    pub(crate) json: bool,
}
