//! A sheet in the memory of a GPU.

use bytemuck::Pod;
use glam::{DVec3, Vec3};
use origami_core::State;
use origami_core::model::Model;

use super::kernel::{Each, Kernel, Pass, WORKGROUP};
use super::layout::{Motion, NONE, Settings, Slot, Spring, Status};
use super::lists::Lists;
use super::passes::PASSES;
use crate::mapped::Reading;
use crate::{Gpu, GpuError};

/// A sheet in the memory of a GPU, with the passes bound to it.
pub(super) struct Sheet {
    gpu: Gpu,
    buffers: Vec<wgpu::Buffer>,
    passes: Vec<Pass>,
    settings: Settings,
}

impl Sheet {
    /// All state is zero: [`Sheet::write`] comes next.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] where a list does not fit one binding, [`GpuError::OutOfMemory`], and whatever else
    /// [`Gpu::scoped`] returns.
    pub(super) fn new(gpu: &Gpu, model: &Model, time_step: f64) -> Result<Self, GpuError> {
        let lists = Lists::new(model, time_step);
        let size = |slot| lists.size(slot);
        for slot in Slot::ALL {
            gpu.fits(slot.what(), size(slot) as u64)?;
        }
        let counts = [
            (lists.nodes.len(), Slot::Nodes),
            (lists.triangles.len(), Slot::Triangles),
            (lists.creases.len(), Slot::Creases),
        ];
        for (count, what) in counts {
            let most = u64::from(gpu.limits().max_compute_workgroups_per_dimension) * u64::from(WORKGROUP);
            let bytes_each = (size(what) / count.max(1)) as u64;
            check(gpu, what.what(), size(what) as u64, most * bytes_each.max(1))?;
        }
        gpu.scoped(|| {
            let buffers: Vec<wgpu::Buffer> = Slot::ALL.map(|slot| buffer(gpu, slot, size(slot) as u64)).into();
            for slot in Slot::ALL {
                gpu.queue().write_buffer(&buffers[slot as usize], 0, lists.bytes(slot));
            }
            let passes = PASSES.map(|kernel| kernel.bound(gpu, &buffers)).into();
            Self { gpu: gpu.clone(), buffers, passes, settings: lists.settings }
        })
    }

    /// Writes a state.
    pub(super) fn write(&self, model: &Model, state: &State) -> Result<(), GpuError> {
        self.fill(Slot::Motions, &motions(model, state))?;
        self.fill(Slot::Springs, &springs(model, state))
    }

    /// Reads the state back.
    pub(super) fn read(&self, model: &Model, targets: &[f64]) -> Result<State, GpuError> {
        let wide = |v: [f32; 3]| Vec3::from_array(v).as_dvec3();
        let motions = self.contents::<Motion>(Slot::Motions, model.node_count())?;
        let springs = self.contents::<Spring>(Slot::Springs, model.creases.len())?;
        Ok(State {
            positions: motions.iter().zip(&model.rest).map(|(m, rest)| *rest + wide(m.displacement)).collect(),
            velocities: motions.iter().map(|m| wide(m.velocity)).collect(),
            fold_angles: springs.iter().map(|spring| f64::from(spring.angle)).collect(),
            targets: targets.to_vec(),
        })
    }

    /// Takes up to `steps` steps and waits for them; tells how many it took, and where it stopped short of them.
    pub(super) fn advance(&self, steps: u32) -> Result<Status, GpuError> {
        self.fill(Slot::Status, &[Status { bad_node: NONE, steps: 0, running: 1 }])?;
        self.run(&PASSES, steps)?;
        let status = self.contents::<Status>(Slot::Status, 1)?;
        status.first().copied().ok_or_else(|| GpuError::Refused("the status could not be read".to_owned()))
    }

    /// Runs the passes so many times, all in one submission.
    pub(super) fn run(&self, kernels: &[&Kernel], times: u32) -> Result<(), GpuError> {
        self.gpu.scoped(|| {
            let mut encoder = self.gpu.device().create_command_encoder(&Default::default());
            {
                let mut recorded = encoder.begin_compute_pass(&Default::default());
                for _ in 0..times {
                    for (kernel, pass) in PASSES.iter().zip(&self.passes) {
                        if kernels.iter().any(|wanted| wanted.name == kernel.name) {
                            recorded.set_pipeline(&pass.pipeline);
                            recorded.set_bind_group(0, &pass.bindings, &[]);
                            recorded.dispatch_workgroups(self.groups(kernel.each), 1, 1);
                        }
                    }
                }
            }
            self.gpu.queue().submit([encoder.finish()]);
        })
    }

    /// At least one: the first pass counts the steps, even of a sheet without triangles.
    fn groups(&self, each: Each) -> u32 {
        let count = match each {
            Each::Triangle => self.settings.triangles,
            Each::Crease => self.settings.creases,
            Each::Node => self.settings.nodes,
        };
        count.div_ceil(WORKGROUP).max(1)
    }

    /// Overwrites a buffer.
    pub(super) fn fill<T: Pod>(&self, slot: Slot, content: &[T]) -> Result<(), GpuError> {
        let write = || self.gpu.queue().write_buffer(&self.buffers[slot as usize], 0, bytemuck::cast_slice(content));
        self.gpu.scoped(write)
    }

    /// The first `count` elements of a buffer, once all that was submitted is done.
    pub(super) fn contents<T: Pod>(&self, slot: Slot, count: usize) -> Result<Vec<T>, GpuError> {
        let reading = self.gpu.scoped(|| {
            let encoder = self.gpu.device().create_command_encoder(&Default::default());
            Reading::new(&self.gpu, encoder, &self.buffers[slot as usize], count, slot.what())
        })?;
        reading.wait(&self.gpu)
    }
}

fn check(gpu: &Gpu, what: &'static str, needed: u64, allowed: u64) -> Result<(), GpuError> {
    let allowed = allowed.min(gpu.limits().max_buffer_size);
    if needed > allowed { Err(GpuError::TooLarge { what, needed, allowed }) } else { Ok(()) }
}

/// At least one element long: a binding cannot be empty.
fn buffer(gpu: &Gpu, slot: Slot, size: u64) -> wgpu::Buffer {
    const LONGEST_ELEMENT: u64 = size_of::<super::layout::Triangle>() as u64;
    gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some(slot.what()),
        size: size.max(LONGEST_ELEMENT),
        usage: wgpu::BufferUsages::COPY_DST
            | wgpu::BufferUsages::COPY_SRC
            | match slot.binding_type() {
                wgpu::BufferBindingType::Uniform => wgpu::BufferUsages::UNIFORM,
                wgpu::BufferBindingType::Storage { .. } => wgpu::BufferUsages::STORAGE,
            },
        mapped_at_creation: false,
    })
}

/// Displacements from rest, and velocities.
pub(super) fn motions(model: &Model, state: &State) -> Vec<Motion> {
    let rounded = |v: DVec3| v.as_vec3().to_array();
    let nodes = state.positions.iter().zip(&model.rest).zip(&state.velocities);
    nodes
        .map(|((position, rest), velocity)| Motion {
            displacement: rounded(*position - *rest),
            padding: 0.0,
            velocity: rounded(*velocity),
            padding_too: 0.0,
        })
        .collect()
}

/// Springs at the state's angles, on their way to its targets.
pub(super) fn springs(model: &Model, state: &State) -> Vec<Spring> {
    let angles = state.fold_angles.iter().zip(&state.targets);
    let springs = model.creases.iter().zip(angles);
    springs
        .map(|(crease, (angle, target_angle))| Spring {
            angle: *angle as f32,
            target_angle: *target_angle as f32,
            stiffness: crease.stiffness as f32,
            padding: 0.0,
            per_height: [0.0; 2],
            foot: [0.0; 2],
        })
        .collect()
}
