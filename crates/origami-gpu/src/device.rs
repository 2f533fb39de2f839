//! An adapter that has been opened.

use std::sync::Arc;

use crate::error::GpuError;
use crate::solver::OnGpu;

/// An adapter that has been opened. Cloning it is cheap and opens nothing.
#[derive(Clone, Debug)]
pub struct Gpu {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Gpu {
    /// Opens the first adapter that there is.
    ///
    /// # Errors
    /// [`GpuError::NoAdapter`].
    pub fn open() -> Result<Self, GpuError> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
        let adapter = adapter.map_err(|_| GpuError::NoAdapter)?;
        let descriptor = wgpu::DeviceDescriptor::default();
        let opened = pollster::block_on(adapter.request_device(&descriptor));
        let (device, queue) = opened.map_err(|error| GpuError::Refused(error.to_string()))?;
        Ok(Self { inner: Arc::new(Inner { device, queue }) })
    }

    pub(crate) fn device(&self) -> &wgpu::Device {
        &self.inner.device
    }

    pub(crate) fn queue(&self) -> &wgpu::Queue {
        &self.inner.queue
    }

    /// `method` (a `Relax` or a `Dynamics`) computed here instead of on the processor.
    pub fn with<S>(&self, method: S) -> OnGpu<S> {
        OnGpu { gpu: self.clone(), method }
    }
}
