//! Copies on their way to the processor.

use std::marker::PhantomData;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use bytemuck::Pod;

use crate::device::Gpu;
use crate::error::GpuError;

/// How long a callback may take that another thread has found due: it is about to run.
const PATIENCE: Duration = Duration::from_secs(10);

/// Elements of a buffer, copied and asked for.
#[derive(Debug)]
pub(crate) struct Reading<T> {
    mapped: Mapped,
    size: u64,
    submission: wgpu::SubmissionIndex,
    what: &'static str,
    elements: PhantomData<T>,
}

impl<T: Pod> Reading<T> {
    /// Submits what `encoder` has recorded, and after it copies of rows of `from`, which are numbered and have `each` elements;
    /// `what` they are, for people. A refusal goes to the error scope that this is called in.
    pub(crate) fn new(
        gpu: &Gpu,
        mut encoder: wgpu::CommandEncoder,
        from: &wgpu::Buffer,
        rows: &[usize],
        each: usize,
        what: &'static str,
    ) -> Self {
        let row = (each * size_of::<T>()) as u64;
        let size = rows.len() as u64 * row;
        let copy = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("what is read"),
            size: size.max(4),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        if size > 0 {
            for (to, number) in (0..).zip(rows) {
                encoder.copy_buffer_to_buffer(from, *number as u64 * row, &copy, to * row, row);
            }
        }
        let submission = gpu.queue().submit([encoder.finish()]);
        Self { mapped: Mapped::new(copy), size, submission, what, elements: PhantomData }
    }

    /// The elements, when they have come.
    ///
    /// # Errors
    /// As [`Gpu::check`], and [`GpuError::Refused`] where they could not be read.
    pub(crate) fn wait(self, gpu: &Gpu) -> Result<Vec<T>, GpuError> {
        gpu.wait_for(self.submission)?;
        self.mapped.contents(gpu, self.what, self.size)
    }
}

/// A buffer that has been asked for.
#[derive(Debug)]
struct Mapped {
    buffer: wgpu::Buffer,
    answer: Receiver<Result<(), wgpu::BufferAsyncError>>,
}

impl Mapped {
    /// Asks for all of `buffer`, once what was submitted before is done. A refusal goes to the error scope that this is called
    /// in.
    fn new(buffer: wgpu::Buffer) -> Self {
        let (tell, answer) = channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // Nobody may be waiting any more.
            let _ = tell.send(result);
        });
        Self { buffer, answer }
    }

    /// Its first `size` bytes. To be called when what was submitted is done; `what` it holds, for people.
    ///
    /// The wait for the submission does not suffice: a thread that waits on the same device may have taken the callback on, and
    /// not have run it yet.
    ///
    /// # Errors
    /// As [`Gpu::check`], and [`GpuError::Refused`] where it could not be mapped.
    fn contents<T: Pod>(&self, gpu: &Gpu, what: &str, size: u64) -> Result<Vec<T>, GpuError> {
        let refused = |why: String| GpuError::Refused(format!("{what} could not be read: {why}"));
        let answer = self.answer.recv_timeout(PATIENCE);
        gpu.check()?;
        answer.map_err(|_| refused("it was not mapped".to_owned()))?.map_err(|error| refused(error.to_string()))?;
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

    fn buffer(gpu: &Gpu, numbers: &[u32]) -> wgpu::Buffer {
        let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: size_of_val(numbers) as u64,
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        gpu.queue().write_buffer(&buffer, 0, bytemuck::cast_slice(numbers));
        buffer
    }

    #[test]
    fn a_callback_that_another_thread_has_taken_on_is_waited_for() {
        let Some(gpu) = gpu() else { return };
        // In a device of its own no other test takes the callbacks on.
        let gpu = Gpu::open(&crate::AdapterChoice::Named(gpu.adapter().to_string())).expect("opened before");
        let (first, second) = (buffer(&gpu, &[1, 2]), buffer(&gpu, &[3, 4]));
        let submission = gpu.queue().submit([]);
        let (tell, begun) = channel();
        first.map_async(wgpu::MapMode::Read, .., move |_| {
            tell.send(()).expect("it is waited for");
            std::thread::sleep(Duration::from_millis(100));
        });
        let mapped = Mapped::new(second);
        std::thread::scope(|scope| {
            scope.spawn(|| gpu.wait().expect("it holds"));
            begun.recv().expect("the other thread has both callbacks, and is busy with the first");
            gpu.wait_for(submission).expect("done long ago");
            assert!(mapped.answer.try_recv().is_err(), "why waiting for the submission does not suffice");
            assert_eq!(mapped.contents(&gpu, "the numbers", 8), Ok(vec![3_u32, 4]));
        });
    }
}
