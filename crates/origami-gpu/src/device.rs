//! An adapter that has been opened.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, OnceLock};

use crate::adapter::{AdapterChoice, AdapterSummary, found};
use crate::error::{GpuError, one_line};

/// Bytes of workgroup memory that are asked for where the adapter has them; more would leave its processors idle.
const WORKGROUP_STORAGE: u32 = 32_768;

/// What of a device decides which way a sheet goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Abilities {
    /// Whether it is known to be hardware.
    pub(crate) hardware: bool,
    /// Bytes that a workgroup shares.
    pub(crate) workgroup_storage: usize,
}

/// An adapter that has been opened. Cloning it is cheap and opens nothing.
///
/// It needs no more than `wgpu::Limits::default()` and no optional feature. Larger buffers, and 32 KiB of workgroup
/// memory, are allowed where the adapter has them.
#[derive(Clone, Debug)]
pub struct Gpu {
    inner: Arc<Inner>,
}

#[derive(Debug)]
struct Inner {
    adapter: AdapterSummary,
    device: wgpu::Device,
    queue: wgpu::Queue,
    limits: wgpu::Limits,
    /// Whether a fragment can be looked at in each of its samples.
    #[cfg_attr(not(feature = "render"), expect(dead_code, reason = "only pictures ask for it"))]
    sample_shading: bool,
    /// The first thing that went wrong outside every error scope.
    fault: Arc<OnceLock<GpuError>>,
}

impl Gpu {
    /// Opens an adapter.
    ///
    /// # Errors
    /// [`GpuError::NoAdapter`], [`GpuError::NoHardware`] and [`GpuError::NoSuchAdapter`] where there is none to choose,
    /// [`GpuError::Unfit`] where it cannot do what is needed, [`GpuError::Refused`] where its driver fails.
    pub fn open(choice: &AdapterChoice) -> Result<Self, GpuError> {
        let (mut adapters, mut summaries): (Vec<_>, Vec<_>) = found().into_iter().unzip();
        let place = choice.pick(&summaries)?;
        let (adapter, summary) = (adapters.swap_remove(place), summaries.swap_remove(place));
        let theirs = adapter.limits();
        let limits = wgpu::Limits {
            max_storage_buffer_binding_size: theirs.max_storage_buffer_binding_size,
            max_buffer_size: theirs.max_buffer_size,
            max_compute_workgroup_storage_size: theirs.max_compute_workgroup_storage_size.min(WORKGROUP_STORAGE),
            ..wgpu::Limits::default()
        };
        let descriptor = wgpu::DeviceDescriptor { required_limits: limits.clone(), ..Default::default() };
        let opened = pollster::block_on(adapter.request_device(&descriptor));
        let (device, queue) = opened.map_err(|error| GpuError::Refused(format!("{summary}: {error}")))?;

        // Both callbacks replace panics. Only the first fault counts: others follow from it.
        let fault = Arc::new(OnceLock::new());
        let lost = Arc::clone(&fault);
        device.set_device_lost_callback(move |reason, message| {
            let _ = lost.set(GpuError::Lost(loss(reason, &message)));
        });
        let refused = Arc::clone(&fault);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            let _ = refused.set(error.into());
        }));
        let able = adapter.get_downlevel_capabilities().flags;
        let sample_shading = able.contains(wgpu::DownlevelFlags::MULTISAMPLED_SHADING);
        Ok(Self { inner: Arc::new(Inner { adapter: summary, device, queue, limits, sample_shading, fault }) })
    }

    /// Takes a device that the caller has opened: simulations and whatever else the caller does with it share its memory and
    /// its queue. The device needs `wgpu::Limits::default()` and no optional feature; where its buffers may be larger, sheets
    /// may.
    ///
    /// The device keeps its callbacks. What goes wrong in calls of this crate is caught in error scopes and comes back as an
    /// error; what the device reports outside of them goes to the caller's own `on_uncaptured_error` and
    /// `set_device_lost_callback`, or makes wgpu panic where there are none. Pictures are drawn without
    /// multisampling: a device does not tell whether it can shade single samples.
    ///
    /// # Errors
    /// [`GpuError::Unfit`] where the device's limits do not suffice.
    pub fn from_device(device: wgpu::Device, queue: wgpu::Queue) -> Result<Self, GpuError> {
        let limits = device.limits();
        let adapter = AdapterSummary::of(device.adapter_info(), &limits);
        match adapter.lacks {
            Some(lack) => Err(GpuError::Unfit { adapter: adapter.to_string(), lack }),
            None => {
                let fault = Arc::default();
                Ok(Self { inner: Arc::new(Inner { adapter, device, queue, limits, sample_shading: false, fault }) })
            }
        }
    }

    /// What was opened.
    #[must_use]
    pub fn adapter(&self) -> &AdapterSummary {
        &self.inner.adapter
    }

    pub(crate) fn device(&self) -> &wgpu::Device {
        &self.inner.device
    }

    pub(crate) fn queue(&self) -> &wgpu::Queue {
        &self.inner.queue
    }

    /// What the device was opened with.
    pub(crate) fn limits(&self) -> &wgpu::Limits {
        &self.inner.limits
    }

    /// What decides which way a sheet goes.
    pub(crate) fn abilities(&self) -> Abilities {
        Abilities {
            hardware: self.adapter().kind.is_hardware(),
            workgroup_storage: self.limits().max_compute_workgroup_storage_size as usize,
        }
    }

    /// Bytes that a buffer may have which shaders read and write.
    pub(crate) fn largest_buffer(&self) -> u64 {
        self.limits().max_storage_buffer_binding_size.min(self.limits().max_buffer_size)
    }

    /// Whether a buffer of `needed` bytes is no larger than that; `what` it holds, for people.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub(crate) fn fits(&self, what: &'static str, needed: u64) -> Result<(), GpuError> {
        match self.largest_buffer() {
            allowed if needed > allowed => Err(GpuError::TooLarge { what, needed, allowed }),
            _ => Ok(()),
        }
    }

    #[cfg(feature = "render")]
    pub(crate) fn has_sample_shading(&self) -> bool {
        self.inner.sample_shading
    }

    /// Whether both are one device: what is in the memory of one, the other can use.
    #[cfg(feature = "render")]
    pub(crate) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.inner, &other.inner)
    }

    /// Whether it has gone wrong so far; what was submitted goes on.
    ///
    /// # Errors
    /// The first fault outside every error scope.
    pub(crate) fn check(&self) -> Result<(), GpuError> {
        self.poll(wgpu::PollType::Poll)
    }

    /// Waits until all that was submitted is done and its callbacks have run.
    ///
    /// # Errors
    /// As [`Gpu::check`].
    pub(crate) fn wait(&self) -> Result<(), GpuError> {
        self.poll(wgpu::PollType::wait_indefinitely())
    }

    /// Waits until one submission is done.
    ///
    /// # Errors
    /// As [`Gpu::check`].
    pub(crate) fn wait_for(&self, submission: wgpu::SubmissionIndex) -> Result<(), GpuError> {
        self.poll(wgpu::PollType::Wait { submission_index: Some(submission), timeout: None })
    }

    /// Runs `f` and returns what it came to, unless wgpu refused anything in it. Only calls on this thread count.
    ///
    /// # Errors
    /// [`GpuError::Lost`] first of all, else the gravest of what was refused, else what [`Gpu::check`] knows of.
    pub(crate) fn scoped<T>(&self, f: impl FnOnce() -> T) -> Result<T, GpuError> {
        let device = self.device();
        let internal = device.push_error_scope(wgpu::ErrorFilter::Internal);
        let validation = device.push_error_scope(wgpu::ErrorFilter::Validation);
        let memory = device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let done = f();
        // Innermost first. Buffers that did not fit are refused later as invalid: their cause is what counts.
        let caught = [memory, validation, internal].map(|scope| pollster::block_on(scope.pop()));
        let Some(error) = caught.into_iter().flatten().next() else { return self.check().map(|()| done) };
        // On a lost device whatever follows is invalid too; that it is lost shows when what it was at has ended.
        match self.wait() {
            Err(lost @ GpuError::Lost(_)) => Err(lost),
            _ => Err(error.into()),
        }
    }

    /// wgpu panics where a wait finds that the device is lost. It has called back by then, so the fault is known.
    fn poll(&self, how: wgpu::PollType) -> Result<(), GpuError> {
        let polled = catch_unwind(AssertUnwindSafe(|| self.device().poll(how)));
        if let Some(fault) = self.inner.fault.get() {
            return Err(fault.clone());
        }
        match polled {
            Ok(Ok(_)) => Ok(()),
            Ok(Err(error)) => Err(GpuError::Refused(error.to_string())),
            Err(panic) => {
                let text = panic.downcast_ref::<String>().map_or("its driver failed", String::as_str);
                Err(GpuError::Lost(one_line(text)))
            }
        }
    }
}

fn loss(reason: wgpu::DeviceLostReason, message: &str) -> String {
    match (reason, one_line(message)) {
        (wgpu::DeviceLostReason::Destroyed, text) if text.is_empty() => "it was given back".to_owned(),
        (wgpu::DeviceLostReason::Unknown, text) if text.is_empty() => "its driver does not say why".to_owned(),
        (_, text) => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing;

    fn buffer(gpu: &Gpu, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        gpu.device().create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false })
    }

    /// One of its own: what is wrong with it must not reach the other tests.
    fn fresh() -> Option<Gpu> {
        testing::gpu().map(|shared| {
            let choice = AdapterChoice::Named(shared.adapter().to_string());
            Gpu::open(&choice).expect("opened before")
        })
    }

    #[test]
    fn a_destroyed_device_is_lost_and_nothing_panics() {
        let Some(gpu) = fresh() else { return };
        assert_eq!(gpu.check(), Ok(()));
        gpu.device().destroy();
        assert!(matches!(gpu.check(), Err(GpuError::Lost(_))), "{:?}", gpu.check());
        let made = gpu.scoped(|| buffer(&gpu, 256, wgpu::BufferUsages::STORAGE));
        assert!(matches!(made, Err(GpuError::Lost(_))), "{made:?}");
        gpu.queue().submit([gpu.device().create_command_encoder(&Default::default()).finish()]);
        assert!(matches!(gpu.wait(), Err(GpuError::Lost(_))));
    }

    #[test]
    fn a_device_of_the_callers_is_taken_where_its_limits_suffice() {
        let Some(gpu) = fresh() else { return };
        let (device, queue) = (gpu.device().clone(), gpu.queue().clone());
        let shared = Gpu::from_device(device, queue).expect("what we open ourselves suffices");
        assert_eq!(shared.adapter().to_string(), gpu.adapter().to_string());
        assert!(shared.scoped(|| buffer(&shared, 256, wgpu::BufferUsages::STORAGE)).is_ok());
        let wrong = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::STORAGE;
        assert!(matches!(shared.scoped(|| buffer(&shared, 256, wrong)), Err(GpuError::Mistake(_))));
        assert_eq!(gpu.check(), Ok(()), "it was caught, and the first owner hears nothing of it");
        let _ = buffer(&shared, 256, wrong);
        assert!(gpu.check().is_err(), "outside of every call of ours it is the owner who hears of it");

        let limits = wgpu::Limits::downlevel_defaults();
        assert!(crate::limits::Lack::of(&limits).is_some());
        let adapter = found().into_iter().find(|(_, summary)| summary.to_string() == gpu.adapter().to_string());
        let (adapter, _) = adapter.expect("it was there before");
        let small = wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() };
        let (device, queue) = pollster::block_on(adapter.request_device(&small)).expect("less than it can");
        assert!(matches!(Gpu::from_device(device, queue), Err(GpuError::Unfit { .. })));
    }

    /// A device that may use next to nothing of its memory, of an adapter that tells how much it has.
    fn scarce() -> Option<Gpu> {
        let name = testing::gpu()?.adapter().name.clone();
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN;
        descriptor.memory_budget_thresholds.for_resource_creation = Some(1);
        let instance = wgpu::Instance::new(descriptor);
        let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::VULKAN));
        let adapter = adapters.into_iter().find(|adapter| adapter.get_info().name == name)?;
        let limits = wgpu::Limits { max_buffer_size: adapter.limits().max_buffer_size, ..wgpu::Limits::default() };
        let descriptor = wgpu::DeviceDescriptor { required_limits: limits, ..Default::default() };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).ok()?;
        Gpu::from_device(device, queue).ok()
    }

    #[test]
    fn too_little_memory_is_an_error_and_nothing_panics() {
        let Some(gpu) = scarce() else { return };
        let mut made = Vec::new();
        // None of it is touched. A driver that keeps no account never comes to an end of its memory.
        let refused = (0..64).find_map(|_| match gpu.scoped(|| buffer(&gpu, 1 << 30, wgpu::BufferUsages::STORAGE)) {
            Ok(buffer) => {
                made.push(buffer);
                None
            }
            Err(error) => Some(error),
        });
        let Some(refused) = refused else { return };
        assert!(matches!(refused, GpuError::OutOfMemory(_)), "{refused:?}");
        assert!(refused.to_string().starts_with("the GPU has too little memory (expected "), "{refused}");
        drop(made);
        assert!(gpu.scoped(|| buffer(&gpu, 256, wgpu::BufferUsages::STORAGE)).is_ok(), "it can go on");
    }

    #[test]
    fn what_is_refused_comes_back() {
        let Some(gpu) = fresh() else { return };
        let refused = gpu.scoped(|| buffer(&gpu, gpu.limits().max_buffer_size + 1, wgpu::BufferUsages::STORAGE));
        assert!(matches!(refused, Err(GpuError::Mistake(_))), "{refused:?}");
        assert!(gpu.scoped(|| buffer(&gpu, 256, wgpu::BufferUsages::STORAGE)).is_ok(), "it can go on");
        assert_eq!(gpu.check(), Ok(()), "caught in its scope");

        // MAP_READ goes with COPY_DST only. Outside a scope it would panic by default.
        let wrong = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::STORAGE;
        let _ = buffer(&gpu, 256, wrong);
        assert!(matches!(gpu.check(), Err(GpuError::Mistake(_))), "{:?}", gpu.check());
        let _ = buffer(&gpu, u64::MAX, wgpu::BufferUsages::STORAGE);
        let error = gpu.check().expect_err("it stays");
        let details = std::error::Error::source(&error).expect("what wgpu says").to_string();
        assert!(!details.contains('\n') && details.contains("MAP_READ"), "the first is kept: {details}");
        assert!(!error.to_string().contains("MAP_READ"), "it is no text for people who fold paper: {error}");
    }

    #[test]
    fn only_buffers_are_larger_than_the_defaults() {
        let Some(gpu) = testing::gpu() else { return };
        let (limits, default) = (gpu.device().limits(), wgpu::Limits::default());
        assert_eq!(limits.max_buffer_size, gpu.adapter().limits.buffer);
        assert_eq!(limits.max_storage_buffer_binding_size, gpu.adapter().limits.storage_binding);
        assert_eq!(limits.max_storage_buffers_per_shader_stage, default.max_storage_buffers_per_shader_stage);
        assert_eq!(limits.max_compute_invocations_per_workgroup, default.max_compute_invocations_per_workgroup);
        assert!(gpu.device().features().is_empty(), "{:?}", gpu.device().features());
    }

    #[test]
    fn a_loss_has_a_reason() {
        use wgpu::DeviceLostReason::{Destroyed, Unknown};
        assert_eq!(loss(Destroyed, ""), "it was given back");
        assert_eq!(loss(Unknown, "\n"), "its driver does not say why");
        assert_eq!(loss(Unknown, "fell off\n  the bus"), "fell off: the bus");
    }

    #[test]
    fn an_unknown_name_opens_nothing() {
        let Some(_) = testing::gpu() else { return };
        let opened = Gpu::open(&AdapterChoice::Named("no such adapter".to_owned()));
        assert!(matches!(opened, Err(GpuError::NoSuchAdapter { .. })), "{opened:?}");
    }
}
