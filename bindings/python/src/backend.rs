//! Where it is computed: on the processor, or on a GPU.

use origami::solve::Solver;
use pyo3::prelude::*;

use crate::adapter::Adapter;
#[cfg(not(feature = "gpu"))]
use crate::errors::refused;
#[cfg(feature = "gpu")]
use crate::gpu::{Gpu, on_gpu};
use crate::settings::Method;

/// A solver with the place where it computes.
pub(crate) struct Computer<'m> {
    pub(crate) method: &'m Method,
    #[cfg(feature = "gpu")]
    on_gpu: Option<Box<dyn Solver>>,
    pub(crate) adapter: Option<Adapter>,
}

impl<'m> Computer<'m> {
    /// The method on the processor.
    pub(crate) fn processor(method: &'m Method) -> Self {
        Self {
            method,
            #[cfg(feature = "gpu")]
            on_gpu: None,
            adapter: None,
        }
    }

    /// The method on the processor, or on the `Gpu` that is given.
    #[cfg(feature = "gpu")]
    pub(crate) fn new(method: &'m Method, gpu: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let Some(gpu) = gpu else { return Ok(Self::processor(method)) };
        let gpu = gpu.cast::<Gpu>()?.get();
        Ok(Self { method, on_gpu: Some(on_gpu(gpu, method)?), adapter: Some(gpu.adapter()) })
    }

    /// The method on the processor: this build knows no GPU.
    #[cfg(not(feature = "gpu"))]
    pub(crate) fn new(method: &'m Method, gpu: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        match gpu {
            None => Ok(Self::processor(method)),
            Some(_) => Err(refused("gpu", "this build has no feature `gpu`", "None")),
        }
    }

    /// What computes.
    pub(crate) fn solver(&self) -> &dyn Solver {
        #[cfg(feature = "gpu")]
        if let Some(solver) = &self.on_gpu {
            return solver.as_ref();
        }
        self.method.solver()
    }
}
