//! What the device's memory is: how fast, and how much of it a sheet takes.

use std::error::Error;
use std::time::Instant;

use origami::Relax;
use origami::gpu::{Gpu, wgpu};

use crate::place::Place;
use crate::results::Row;
use crate::section::Ended;
use crate::sheets::square;

/// Panels along both sides of the sheet that is put into memory: 1 000 000 vertices.
const PANELS: usize = 999;
const REHEARSED: usize = 9;

/// Bytes of a buffer that is copied.
const LARGE: u64 = 1 << 30;
const SMALL: u64 = 1 << 24;

/// Copies a buffer, then puts a sheet beside it.
///
/// # Errors
/// If the adapter cannot be opened once more, or a figure not be written.
pub(crate) fn measure(place: &Place) -> Result<Ended, Box<dyn Error>> {
    // The library keeps its device to itself; what it computes on a device of ours can be counted.
    let (device, queue) = open(&place.gpu)?;
    let add = |sheet: &str, vertices: usize, by: &str, quantity: &str, value: f64| {
        let (sheet, by, quantity) = (sheet.to_owned(), by.to_owned(), quantity.to_owned());
        place.add(Row { sheet, vertices, sheets: 1, by, quantity, value, ..Row::default() })
    };
    let size = device.limits().max_buffer_size.min(if place.rehearse { SMALL } else { LARGE });
    add("", 0, "GPU", "bytes read and written in a second by copies", copies(&device, &queue, size, place)?)?;

    let taken =
        || device.generate_allocator_report().map(|report| (report.total_allocated_bytes, report.total_reserved_bytes));
    let model = square(if place.rehearse { REHEARSED } else { PANELS })?;
    let gpu = Gpu::from_device(device.clone(), queue.clone())?;
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let before = taken();
    let solver = gpu.with(Relax::default());
    let session = solver.on(&model);
    let after = taken();
    drop(session);
    let vertices = model.node_count();
    let by = format!("GPU, {}", solver.way(&model));
    add("miura", vertices, &by, "bytes of buffers, counted", solver.traffic(&model).memory() as f64)?;
    if let (Some(before), Some(after)) = (before, after) {
        add("miura", vertices, &by, "bytes allocated", after.0.saturating_sub(before.0) as f64)?;
        add("miura", vertices, &by, "bytes reserved", after.1.saturating_sub(before.1) as f64)?;
    }
    Ok(Ended::Whole)
}

/// A device of our own on the adapter of `gpu`.
fn open(gpu: &Gpu) -> Result<(wgpu::Device, wgpu::Queue), Box<dyn Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    let same = |adapter: &&wgpu::Adapter| {
        let info = adapter.get_info();
        info.name == gpu.adapter().name && format!("{:?}", info.backend).eq_ignore_ascii_case(gpu.adapter().backend)
    };
    let adapter = adapters.iter().find(same).ok_or(format!("{} is not there any more", gpu.adapter()))?;
    let theirs = adapter.limits();
    let required_limits = wgpu::Limits {
        max_storage_buffer_binding_size: theirs.max_storage_buffer_binding_size,
        max_buffer_size: theirs.max_buffer_size,
        ..wgpu::Limits::default()
    };
    let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
    Ok(pollster::block_on(adapter.request_device(&descriptor))?)
}

/// Bytes that copies of a buffer read and write in a second.
fn copies(device: &wgpu::Device, queue: &wgpu::Queue, size: u64, place: &Place) -> Result<f64, Box<dyn Error>> {
    let usage = wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
    let buffer =
        || device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false });
    let [from, to] = [buffer(), buffer()];
    let copy = |times: u32| -> Result<f64, Box<dyn Error>> {
        let began = Instant::now();
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        (0..times).for_each(|_| encoder.copy_buffer_to_buffer(&from, 0, &to, 0, size));
        queue.submit([encoder.finish()]);
        device.poll(wgpu::PollType::wait_indefinitely())?;
        Ok(began.elapsed().as_secs_f64())
    };
    // The first fills both with zeros too.
    copy(1)?;
    let mut times = 1;
    loop {
        let seconds = copy(times)?;
        if seconds >= place.lasting().as_secs_f64() || place.is_over() || times >= 4096 {
            return Ok(2.0 * size as f64 * f64::from(times) / seconds);
        }
        times *= 2;
    }
}
