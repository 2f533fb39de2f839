//! What can be said of a GPU.

use serde::Serialize;

/// What decides where a sheet is folded. Reports tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum By {
    /// The command line names it.
    Asked,
    /// The size of the sheet, by measurements.
    #[cfg(feature = "gpu")]
    Size,
    /// The size of the sheet, by an estimate that no measurement has confirmed.
    #[cfg(feature = "gpu")]
    Estimate,
    /// This build has nothing else.
    #[cfg(not(feature = "gpu"))]
    Only,
}

/// The GPU that has folded a sheet.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Adapter {
    /// As its driver calls it.
    pub(crate) name: String,
    /// `discrete`, `integrated`, `virtual`, `other` or `software`.
    pub(crate) kind: String,
    /// The driver and its version.
    pub(crate) driver: String,
    /// `Vulkan`, `Metal`, `DX12` or `GL`.
    pub(crate) backend: &'static str,
}

impl Adapter {
    /// Whether it is a program on the processor.
    pub(crate) fn is_software(&self) -> bool {
        self.kind == "software"
    }
}

/// One of those that are there. Sizes are in bytes.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct AdapterDetails {
    #[serde(flatten)]
    pub(crate) adapter: Adapter,
    pub(crate) storage_buffers_per_stage: u32,
    pub(crate) invocations_per_workgroup: u32,
    pub(crate) workgroup_storage: u32,
    pub(crate) storage_binding: u64,
    pub(crate) buffer: u64,
    /// Why it cannot be used; null where it can.
    pub(crate) unfit: Option<String>,
}
