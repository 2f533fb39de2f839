//! Folds origami crease patterns.
pub use origami_core::*;
