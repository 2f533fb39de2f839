//! A sheet in the memory of a GPU.

use glam::{DVec3, Vec3};
use origami_core::State;
use origami_core::model::Model;

use super::layout::{Motion, Spring};
use super::lists::Lists;
use super::passes::PASSES;
use crate::device::Gpu;
use crate::engine::{Engine, check_counts};
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::{Control, NONE};
use crate::pipeline::{Buffers, Pass, buffer};
use crate::sheet_arrays::SheetArrays;
use crate::variant::{Scheme, Variant};

/// A sheet in the memory of a GPU: an engine of which a step is the five passes.
pub(super) struct Sheet {
    pub(super) engine: Engine,
}

impl Sheet {
    /// All state is zero: [`Sheet::write`] comes next.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] and [`GpuError::TooManyElements`] where the sheet is too large, or what the device says.
    pub(super) fn new(gpu: &Gpu, model: &Model, time_step: f64) -> Result<Self, GpuError> {
        let variant = variant(model);
        check_counts(&variant)?;
        let lists = Lists::new(model, time_step);
        let engine = gpu.scoped(|| {
            let mut buffers = Buffers::new();
            for (binding, size, contents) in lists.buffers() {
                buffers.insert(binding, buffer(gpu, binding, size, contents)?);
            }
            let passes = PASSES.map(|kernel| Pass::new(gpu, kernel, &variant, false, &buffers)).into();
            Ok::<_, GpuError>(Engine::plain(gpu, variant, buffers, passes))
        });
        Ok(Self { engine: engine?? })
    }

    /// Writes a state, at step 0.
    pub(super) fn write(&self, model: &Model, state: &State) -> Result<(), GpuError> {
        self.engine.gpu.scoped(|| {
            self.engine.write(Binding::Control, &[Control { bad_node: NONE, limit: u32::MAX, ..Control::default() }]);
            self.engine.write(Binding::Motions, &motions(model, state));
            self.engine.write(Binding::Springs, &springs(model, state));
        })
    }

    /// Reads the state back.
    pub(super) fn read(&self, model: &Model, targets: &[f64]) -> Result<State, GpuError> {
        let wide = |v: [f32; 3]| Vec3::from_array(v).as_dvec3();
        let motions: Vec<Motion> = self.engine.read(Binding::Motions, model.node_count())?;
        let springs: Vec<Spring> = self.engine.read(Binding::Springs, model.creases.len())?;
        Ok(State {
            positions: motions.iter().zip(&model.rest).map(|(m, rest)| *rest + wide(m.displacement)).collect(),
            velocities: motions.iter().map(|m| wide(m.velocity)).collect(),
            fold_angles: springs.iter().map(|spring| f64::from(spring.angle)).collect(),
            targets: targets.to_vec(),
        })
    }

    /// Takes the steps `from..to` and waits for them; the control block tells where it stopped short of them.
    pub(super) fn advance(&self, from: u64, to: u64) -> Result<Control, GpuError> {
        let controls = self.engine.submit(1, from, to)?.wait(&self.engine.gpu)?;
        controls.first().copied().ok_or_else(|| GpuError::Refused("the control block could not be read".to_owned()))
    }
}

/// What the constants of the five passes are taken from.
pub(super) fn variant(model: &Model) -> Variant {
    let scheme = Scheme::Dynamics { verlet: false, damped: true };
    Variant::new(&SheetArrays::new(model), scheme, Some(model.material))
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
