//! Copies on their way to the processor.

use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use bytemuck::Pod;

use crate::device::Gpu;
use crate::error::GpuError;

/// How long a callback may take that another thread has found due: it is about to run.
const PATIENCE: Duration = Duration::from_secs(10);

/// A buffer that has been asked for.
#[derive(Debug)]
pub(crate) struct Mapped {
    buffer: wgpu::Buffer,
    told: Receiver<Result<(), wgpu::BufferAsyncError>>,
}

impl Mapped {
    /// Asks for all of `buffer`, once what was submitted before is done. A refusal goes to the error scope that this is called
    /// in.
    pub(crate) fn new(buffer: wgpu::Buffer) -> Self {
        let (tell, told) = channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // Nobody may be waiting any more.
            let _ = tell.send(result);
        });
        Self { buffer, told }
    }

    /// Its first `size` bytes. To be called when what was submitted is done; `what` it holds, for people.
    ///
    /// The wait for the submission does not suffice: a thread that waits on the same device may have taken the callback on, and
    /// not have run it yet.
    ///
    /// # Errors
    /// As [`Gpu::check`], and [`GpuError::Refused`] where it could not be mapped.
    pub(crate) fn contents<T: Pod>(&self, gpu: &Gpu, what: &str, size: u64) -> Result<Vec<T>, GpuError> {
        let refused = |why: String| GpuError::Refused(format!("{what} could not be read: {why}"));
        let told = self.told.recv_timeout(PATIENCE);
        gpu.check()?;
        told.map_err(|_| refused("it was not mapped".to_owned()))?.map_err(|error| refused(error.to_string()))?;
        let view = self.buffer.get_mapped_range(..).map_err(|error| refused(error.to_string()))?;
        // A mapped buffer need not be aligned as the contents are.
        let size = usize::try_from(size).unwrap_or(usize::MAX).min(view.len());
        Ok(bytemuck::pod_collect_to_vec(&view[..size]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::gpu;

    /// A buffer that holds the numbers from `first` on, read back.
    fn read_back(gpu: &Gpu, first: u32) -> Result<Vec<u32>, GpuError> {
        let numbers: Vec<u32> = (first..first + 16).collect();
        let mapped = gpu.scoped(|| {
            let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: 128,
                usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            gpu.queue().write_buffer(&buffer, 0, bytemuck::cast_slice(&numbers));
            let submission = gpu.queue().submit([]);
            (Mapped::new(buffer), submission)
        });
        let (mapped, submission) = mapped?;
        gpu.wait_for(submission)?;
        mapped.contents(gpu, "the numbers", 64)
    }

    #[test]
    fn threads_do_not_disturb_each_other() {
        let Some(gpu) = gpu() else { return };
        std::thread::scope(|scope| {
            for thread in 0..8 {
                let gpu = &gpu;
                scope.spawn(move || {
                    for round in 0..100 {
                        let first = 1000 * thread + round;
                        assert_eq!(read_back(gpu, first), Ok((first..first + 16).collect()));
                    }
                });
            }
        });
    }
}
