//! The native part of the Python package `origami_sim`: what computes, and the arrays that go in and out. What a reader of
//! the package sees first (settings, exceptions, sweeps over workers) is Python, in `python/origami_sim`.
//!
//! Everything that computes runs without Python's lock, looks for Ctrl-C now and then, and comes back as arrays that NumPy
//! owns, without a copy.
#![expect(
    clippy::doc_markdown,
    reason = "what is documented is shown by Python's `help`, which has names without backticks"
)]

mod adapter;
#[cfg(feature = "analysis")]
mod analysis;
mod arrays;
mod backend;
mod errors;
mod failures;
mod fold;
mod folded;
mod form;
#[cfg(feature = "gpu")]
mod gpu;
mod measure;
mod model;
mod notes;
mod pattern;
#[cfg(feature = "render")]
mod picture;
mod plan;
mod report;
mod run;
mod scene;
mod settings;
mod simulation;
mod source;
#[cfg(feature = "analysis")]
mod structure;
mod table;
mod watch;

/// Native part of `origami_sim`.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use crate::fold::{fold, fold_path};
    #[pymodule_export]
    use crate::folded::{Folded, refold};
    #[cfg(feature = "gpu")]
    #[pymodule_export]
    use crate::gpu::{Gpu, adapters};
    #[pymodule_export]
    use crate::measure::{align, flat_folding};
    #[pymodule_export]
    use crate::model::Model;
    #[pymodule_export]
    use crate::pattern::{Pattern, generators};
    #[pymodule_export]
    use crate::plan::{Plan, Stop};
    #[pymodule_export]
    use crate::settings::defaults;
    #[pymodule_export]
    use crate::simulation::{Simulation, resume};
    #[cfg(feature = "analysis")]
    #[pymodule_export]
    use crate::structure::{Configuration, Structure};
    #[pymodule_export]
    use crate::table::{columns, header};

    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        let features = [
            ("analysis", cfg!(feature = "analysis")),
            ("formats", cfg!(feature = "formats")),
            ("gpu", cfg!(feature = "gpu")),
            ("newton", cfg!(feature = "newton")),
            ("render", cfg!(feature = "render")),
        ];
        let built: Vec<&str> = features.iter().filter(|(_, built)| *built).map(|(name, _)| *name).collect();
        module.add("features", built)
    }
}
