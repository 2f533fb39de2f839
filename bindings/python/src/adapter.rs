//! GPUs as reports name them.

/// A GPU as reports name it.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub(crate) struct Adapter {
    pub(crate) name: String,
    pub(crate) kind: String,
    pub(crate) driver: String,
    pub(crate) backend: String,
}
