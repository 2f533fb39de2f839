//! A build with the feature `gpu`.

use std::sync::OnceLock;

use origami::Warning;
use origami::error::WarningCode;
#[cfg(feature = "render")]
use origami::gpu::render::GpuRenderer;
use origami::gpu::{self, AUTO_NODES, AUTO_NODES_MEASURED, AdapterChoice, AdapterSummary, Gpu, GpuError};
#[cfg(feature = "render")]
use origami::picture::Renderer;
use origami::solve::{ContactRelax, Solver, Touching};

use super::{Computer, Method};
use crate::args::{BackendName, is_named};
use crate::report::{Adapter, AdapterDetails, By};

/// The processor and a GPU, which is opened at most once, and only when it is needed.
pub(crate) struct Backend {
    wanted: BackendName,
    /// Part of the name of an adapter.
    named: Option<String>,
    opened: OnceLock<Result<Gpu, GpuError>>,
}

impl Backend {
    /// Opens the GPU if that is what is wanted.
    ///
    /// # Errors
    /// Why there is none.
    pub(crate) fn new(wanted: BackendName, adapter: Option<&str>) -> Result<Self, String> {
        let named = adapter.map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned);
        let backend = Self { wanted, named, opened: OnceLock::new() };
        if wanted == BackendName::Gpu
            && let Err(error) = backend.open()
        {
            return Err(format!("--backend gpu: {error}"));
        }
        // Of all that may be wrong with it, a name that no adapter has is a slip of the hand.
        if wanted == BackendName::Auto
            && is_named(adapter)
            && let Err(error @ GpuError::NoSuchAdapter { .. }) = backend.open()
        {
            return Err(format!("--adapter: {error}"));
        }
        Ok(backend)
    }

    /// Where a sheet of so many nodes is folded.
    pub(crate) fn choose(&self, method: &Method, nodes: usize) -> Computer {
        let worth_it = match self.wanted {
            BackendName::Cpu => false,
            BackendName::Gpu => true,
            BackendName::Auto => nodes >= AUTO_NODES && (self.named.is_some() || may_have_hardware()),
        };
        if !worth_it {
            return Computer::processor(method, self.by());
        }
        match self.open() {
            Ok(gpu) if self.wanted == BackendName::Gpu || gpu.adapter().kind.is_hardware() => {
                on_gpu(gpu, method, self.by())
            }
            Ok(gpu) => self.passed_over(method, &format!("{} is not hardware; --backend gpu takes it", gpu.adapter())),
            Err(error) => self.passed_over(method, &error.to_string()),
        }
    }

    /// What folds under contact: the GPU only where it is asked for.
    pub(crate) fn in_contact(&self, solver: ContactRelax) -> Box<dyn Touching> {
        match self.open_if_wanted() {
            Some(gpu) => Box::new(gpu.with_contact(solver)),
            None => Box::new(solver),
        }
    }

    /// What draws on the GPU, or why it cannot; `None` without a GPU.
    #[cfg(feature = "render")]
    pub(crate) fn renderer(&self) -> Option<Result<Box<dyn Renderer>, String>> {
        let gpu = self.open().ok()?;
        Some(
            GpuRenderer::new(gpu)
                .map(|renderer| Box::new(renderer) as Box<dyn Renderer>)
                .map_err(|why| why.to_string()),
        )
    }

    /// The GPU that studies repeat their runs on, if one is wanted.
    #[cfg(feature = "study")]
    pub(crate) fn studied(&self) -> origami::study::GpuChoice {
        self.open_if_wanted().map_or_else(Default::default, |gpu| origami::study::GpuChoice::new(gpu.clone()))
    }

    fn open_if_wanted(&self) -> Option<&Gpu> {
        (self.wanted == BackendName::Gpu).then(|| self.open().ok()).flatten()
    }

    fn open(&self) -> Result<&Gpu, &GpuError> {
        let open = || {
            Gpu::open(&match (&self.named, self.wanted) {
                (Some(name), _) => AdapterChoice::Named(name.clone()),
                (None, BackendName::Auto) => AdapterChoice::Hardware,
                (None, _) => AdapterChoice::Any,
            })
        };
        self.opened.get_or_init(open).as_ref()
    }

    fn by(&self) -> By {
        match self.wanted {
            BackendName::Cpu | BackendName::Gpu => By::Asked,
            BackendName::Auto if AUTO_NODES_MEASURED => By::Size,
            BackendName::Auto => By::Estimate,
        }
    }

    /// The processor, which is a surprise only to those who have named an adapter.
    fn passed_over(&self, method: &Method, why: &str) -> Computer {
        let warning = self
            .named
            .as_ref()
            .map(|_| Warning::new(WarningCode::Fallback, "--backend auto", format!("the processor, since {why}")));
        Computer { warning, ..Computer::processor(method, self.by()) }
    }
}

fn on_gpu(gpu: &Gpu, method: &Method, by: By) -> Computer {
    let solver: Box<dyn Solver> = match method {
        Method::Relax(relax) => Box::new(gpu.with(relax.clone())),
        Method::Dynamics(dynamics) => Box::new(gpu.with(dynamics.clone())),
        #[cfg(feature = "newton")]
        Method::Newton(_) => return Computer::processor(method, by),
        Method::Reflect(_) => return Computer::processor(method, by),
    };
    Computer { solver, adapter: Some(Adapter::from(gpu.adapter())), by, warning: None }
}

impl From<&AdapterSummary> for Adapter {
    fn from(adapter: &AdapterSummary) -> Self {
        let AdapterSummary { name, kind, driver, backend, .. } = adapter;
        Self { name: name.clone(), kind: kind.to_string(), driver: driver.clone(), backend }
    }
}

impl From<&AdapterSummary> for AdapterDetails {
    fn from(summary: &AdapterSummary) -> Self {
        let limits = summary.limits;
        Self {
            adapter: Adapter::from(summary),
            storage_buffers_per_stage: limits.storage_buffers_per_stage,
            invocations_per_workgroup: limits.invocations_per_workgroup,
            workgroup_storage: limits.workgroup_storage,
            storage_binding: limits.storage_binding,
            buffer: limits.buffer,
            unfit: summary.lacks.map(|lack| lack.to_string()),
        }
    }
}

/// Whether this machine may have a GPU: drivers are not loaded, which takes time and may complain, where Linux has no
/// device that one could be behind.
pub(crate) fn may_have_hardware() -> bool {
    const DEVICES: [&str; 6] = ["/dev/dri", "/dev/nvidiactl", "/dev/dxg", "/dev/kfd", "/dev/mali0", "/dev/kgsl-3d0"];
    cfg!(not(target_os = "linux")) || DEVICES.iter().any(|device| std::path::Path::new(device).exists())
}

/// All that there are, hardware first.
///
/// # Errors
/// None; a build without GPUs has one.
#[expect(clippy::unnecessary_wraps, reason = "a build without GPUs has nothing to list")]
pub(crate) fn adapters() -> Result<Vec<AdapterDetails>, String> {
    Ok(gpu::adapters().iter().map(AdapterDetails::from).collect())
}

/// What to do where there is none.
pub(crate) fn none() -> String {
    GpuError::NoAdapter.to_string()
}
