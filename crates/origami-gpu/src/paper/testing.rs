//! One pass of the five on its own.

use origami_core::solve::time_step;

use super::normals;
use super::sheet::Sheet;
use crate::Gpu;
use crate::engine::Engine;
use crate::kernels::{Binding, Kernel};
use crate::pipeline::Pass;
use crate::testing::cases::Case;

/// The case's state on a GPU, with normals and springs as the CPU has them.
pub(super) fn sheet(gpu: &Gpu, case: &Case) -> Sheet {
    let sheet = Sheet::new(gpu, &case.model, time_step::paper(&case.model)).expect("it fits");
    sheet.write(&case.model, &case.state).expect("written");
    let normals: Vec<[f32; 4]> = normals::on_cpu(case).iter().map(|n| n.as_vec4().to_array()).collect();
    sheet.engine.write(Binding::FaceNormals, &normals);
    sheet
}

/// Runs a pass so many times.
pub(super) fn run(sheet: &Sheet, kernel: &Kernel, times: u32) {
    let Engine { gpu, variant, buffers, .. } = &sheet.engine;
    let done = gpu.scoped(|| {
        let own = Pass::new(gpu, kernel, variant, false, buffers);
        let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            (0..times).for_each(|_| own.record(&mut pass, 1));
        }
        gpu.queue().submit([encoder.finish()]);
    });
    done.expect("it runs");
}
