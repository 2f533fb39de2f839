//! What can go wrong on a GPU.

use crate::limits::Lack;

/// What cannot compute a thing, as refusals call it.
pub(crate) const GPU: &str = "a GPU";

/// Why the GPU cannot be used, or stopped.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// There is no adapter.
    #[error(
        "no GPU adapter was found; `sudo apt-get install mesa-vulkan-drivers` on Debian and Ubuntu, \
         or `sudo dnf install mesa-vulkan-drivers` on Fedora, installs a software one"
    )]
    NoAdapter,
    /// There are adapters, but none that is known to be hardware.
    #[error("no GPU was found but {}; expected hardware", there.join(", "))]
    NoHardware {
        /// What is there, each as `name (backend)`.
        there: Vec<String>,
    },
    /// None of the adapters has this name.
    #[error("no GPU adapter is called {asked}; expected part of one of these: {}", there.join(", "))]
    NoSuchAdapter {
        /// What was asked for.
        asked: String,
        /// What is there, each as `name (backend)`.
        there: Vec<String>,
    },
    /// The adapter stays behind `wgpu::Limits::default()`.
    #[error("{adapter} cannot be used: {lack}")]
    Unfit {
        /// The adapter, as `name (backend)`.
        adapter: String,
        /// The limit.
        lack: Lack,
    },
    /// The adapter was taken away or crashed.
    #[error("the GPU was lost: {0}")]
    Lost(String),
    /// A buffer does not fit into its memory.
    #[error("the GPU has too little memory (expected a smaller sheet, another adapter, or the same solver on the CPU)")]
    OutOfMemory(#[source] Details),
    /// The sheet needs more than the adapter can do.
    #[error("{what} needs {needed} bytes; the adapter allows {allowed} (expected a smaller sheet or another adapter)")]
    TooLarge {
        /// The buffer.
        what: &'static str,
        /// Its size.
        needed: u64,
        /// The adapter's limit.
        allowed: u64,
    },
    /// The sheet has more elements of a kind than one dispatch can count.
    #[error("the sheet has {count} elements of a kind; one dispatch takes {allowed} (expected a smaller sheet)")]
    TooManyElements {
        /// How many there are.
        count: u64,
        /// How many are allowed.
        allowed: u64,
    },
    /// The exact test has found a state of contact that goes through itself.
    #[error(
        "after {step} evaluations under contact faces {} and {} cross, which f32 has not kept apart (expected a larger gap, or \
         the same solver on the CPU)", faces[0], faces[1]
    )]
    Crossed {
        /// Evaluations up to that state.
        step: u64,
        /// Two faces that cross, by their numbers.
        faces: [u32; 2],
    },
    /// It cannot be opened, or its driver does not do what it was asked for.
    #[error("the GPU refused: {0}")]
    Refused(String),
    /// wgpu found fault with a call of ours: no input should bring that about.
    #[error(
        "the GPU was asked for what it cannot do, which is a mistake of this program or of the GPU's driver (expected another \
         adapter, or the same solver on the CPU)"
    )]
    Mistake(#[source] Details),
}

/// What wgpu says, for whoever looks for a mistake: the source of an error, and no part of its message.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Details(pub String);

impl From<wgpu::Error> for GpuError {
    fn from(error: wgpu::Error) -> Self {
        match error {
            wgpu::Error::OutOfMemory { source } => Self::OutOfMemory(Details(one_line(&source.to_string()))),
            wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. } => {
                Self::Mistake(Details(one_line(&description)))
            }
        }
    }
}

/// wgpu tells of causes line by line, each further to the right.
pub(crate) fn one_line(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    lines.join(": ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_an_adapter_one_sentence_tells_what_to_install() {
        let text = GpuError::NoAdapter.to_string();
        for command in ["`sudo apt-get install mesa-vulkan-drivers`", "`sudo dnf install mesa-vulkan-drivers`"] {
            assert_eq!(text.matches(command).count(), 1, "{text}");
        }
        assert!(!text.contains('\n') && !text.contains("  "), "{text}");
    }

    #[test]
    fn what_wgpu_says_over_several_lines_becomes_one() {
        assert_eq!(one_line("In a buffer\n    it is\n\n      too large\n"), "In a buffer: it is: too large");
    }
}
