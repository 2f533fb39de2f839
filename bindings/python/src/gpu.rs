//! `Gpu`: an adapter on which sheets are folded.

use origami::gpu::{self, AdapterChoice, AdapterSummary};
use origami::solve::Solver;
use pyo3::prelude::*;

use crate::adapter::Adapter;
use crate::errors::{backend_error, refused};
use crate::settings::Method;

/// A GPU that has been opened.
#[pyclass(frozen, module = "origami_sim._native")]
pub(crate) struct Gpu(gpu::Gpu);

impl Gpu {
    pub(crate) fn adapter(&self) -> Adapter {
        summary(self.0.adapter())
    }
}

#[pymethods]
impl Gpu {
    #[new]
    #[pyo3(signature = (name=None))]
    fn new(py: Python<'_>, name: Option<String>) -> PyResult<Self> {
        let choice = name.map_or(AdapterChoice::Any, AdapterChoice::Named);
        py.detach(|| gpu::Gpu::open(&choice)).map(Self).map_err(|error| backend_error(&error.to_string()))
    }

    fn __repr__(&self) -> String {
        format!("<Gpu {}>", self.0.adapter())
    }
}

/// The method on a GPU.
pub(crate) fn on_gpu(gpu: &Gpu, method: &Method) -> PyResult<Box<dyn Solver>> {
    match method {
        Method::Relax(relax) => Ok(Box::new(gpu.0.with(relax.clone()))),
        Method::Dynamics(dynamics) => Ok(Box::new(gpu.0.with(dynamics.clone()))),
        #[cfg(feature = "newton")]
        Method::Newton(_) => Err(refused("gpu", "Newton runs on the processor", "None, or another solver")),
    }
}

fn summary(adapter: &AdapterSummary) -> Adapter {
    let AdapterSummary { name, kind, driver, backend, .. } = adapter;
    Adapter { name: name.clone(), kind: kind.to_string(), driver: driver.clone(), backend: (*backend).to_owned() }
}

/// The adapters that there are, hardware first, as dicts of `name`, `kind`, `driver` and `backend`.
#[pyfunction]
pub(crate) fn adapters(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let all: Vec<Adapter> = py.detach(|| gpu::adapters().iter().map(summary).collect());
    Ok(pythonize::pythonize(py, &all)?)
}
