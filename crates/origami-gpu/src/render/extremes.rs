//! The nodes that lie farthest out: all that is read of positions on the GPU so that a camera finds its place.

use std::f32::consts::PI;

use glam::Vec3;
use origami_core::Error;
use origami_picture::{Figure, Picture, Projection};
use origami_shaders::render::EXTREMES;

use super::DrawError;
use super::layout::Search;
use super::resolve::kernel;
use super::upload::{buffer, entries};
use crate::device::Gpu;
use crate::mapped::Reading;

/// Directions all around in which a perspective camera looks for nodes: whatever lies between reaches beyond those found
/// by 3 % of the sheet's radius at most (1 - cos of half the distance between two directions), less than the picture's
/// margins.
const AROUND: usize = 128;

/// The kernel that finds them.
#[derive(Debug)]
pub(super) struct Extremes {
    pipeline: wgpu::ComputePipeline,
}

impl Extremes {
    pub(super) fn new(gpu: &Gpu) -> Self {
        Self { pipeline: kernel(gpu, "find", EXTREMES, &[]) }
    }

    /// Those of `count` positions that the picture's camera has to see.
    pub(super) fn of(
        &self,
        gpu: &Gpu,
        picture: &Picture,
        positions: &wgpu::Buffer,
        count: usize,
    ) -> Result<Vec<[f32; 3]>, DrawError> {
        let directions: Vec<[f32; 4]> = directions(picture)?.into_iter().map(|d| d.extend(0.0).to_array()).collect();
        let search = Search { count: u32::try_from(count).unwrap_or(u32::MAX) };
        let reading = gpu.scoped(|| {
            let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
            let found = buffer(gpu, &vec![[0.0_f32; 4]; directions.len()], usage);
            let search = buffer(gpu, &[search], wgpu::BufferUsages::UNIFORM);
            let asked = buffer(gpu, &directions, wgpu::BufferUsages::STORAGE);
            let bindings = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("extremes"),
                layout: &self.pipeline.get_bind_group_layout(0),
                entries: &entries(&[&search, positions, &asked, &found]),
            });
            let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                pass.set_pipeline(&self.pipeline);
                pass.set_bind_group(0, &bindings, &[]);
                #[expect(clippy::cast_possible_truncation, reason = "at most 6 and AROUND")]
                pass.dispatch_workgroups(directions.len() as u32, 1, 1);
            }
            Reading::new(gpu, encoder, &found, &[0], directions.len(), "the outermost nodes")
        })?;
        let found: Vec<[f32; 4]> = reading.wait(gpu)?;
        if !found.as_flattened().iter().all(|x| x.is_finite() && x.abs() < 1e18) {
            return Err(Error::invalid("session", "a node is not at a sensible place", "finite coordinates").into());
        }
        Ok(found.into_iter().map(|[x, y, z, _]| [x, y, z]).collect())
    }
}

/// Along the camera's axes, which is all that an orthographic one depends on; and all around.
fn directions(picture: &Picture) -> Result<Vec<Vec3>, Error> {
    let anything = picture.view(&Figure::default(), [[0.0; 3], [1.0; 3]].into_iter())?;
    let [up, towards] = [anything.up, anything.towards].map(Vec3::from_array);
    let right = up.cross(towards);
    let mut directions = vec![right, -right, up, -up, towards, -towards];
    if picture.camera.projection != Projection::Orthographic {
        // A spiral on the sphere, turned by the golden angle from one to the next.
        let golden = PI * (3.0 - 5.0_f32.sqrt());
        directions.extend((0..AROUND).map(|i| {
            let z = 1.0 - (2 * i + 1) as f32 / AROUND as f32;
            let (sin, cos) = (i as f32 * golden).sin_cos();
            let flat = (1.0 - z * z).sqrt();
            Vec3::new(flat * cos, flat * sin, z)
        }));
    }
    Ok(directions)
}

#[cfg(test)]
mod tests {
    use super::*;
    use origami_picture::Camera;

    #[test]
    fn directions_leave_no_gap() {
        let camera = Camera { projection: Projection::Perspective(40.0), ..Camera::default() };
        let all = directions(&Picture { camera, ..Picture::default() }).unwrap();
        assert!(all.iter().all(|d| (d.length() - 1.0).abs() < 1e-5) && all.len() == 6 + AROUND);
        let mut farthest = 1.0_f32;
        for i in 0..2000 {
            let (a, b) = (i as f32 * 0.731, i as f32 * 1.913);
            let place = Vec3::new(a.cos() * b.sin(), a.sin() * b.sin(), b.cos());
            farthest = farthest.min(all.iter().map(|d| d.dot(place)).fold(-1.0, f32::max));
        }
        assert!(farthest > 0.97, "{farthest}");
        assert_eq!(directions(&Picture::default()).unwrap().len(), 6);
    }
}
