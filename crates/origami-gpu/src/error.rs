//! What can go wrong on a GPU.

/// Why the GPU cannot be used, or stopped.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// There is no adapter.
    #[error("no GPU adapter was found")]
    NoAdapter,
    /// The adapter was taken away or crashed.
    #[error("the GPU was lost: {0}")]
    Lost(String),
    /// A buffer does not fit into its memory.
    #[error("the GPU has too little memory: {0}")]
    OutOfMemory(String),
    /// The scene needs more than the adapter can do.
    #[error("{what} needs {needed} bytes; the adapter allows {allowed} (expected a smaller sheet or another adapter)")]
    TooLarge {
        /// The buffer.
        what: &'static str,
        /// Its size.
        needed: u64,
        /// The adapter's limit.
        allowed: u64,
    },
    /// A mistake of ours that wgpu refused.
    #[error("the GPU refused: {0}")]
    Refused(String),
}
