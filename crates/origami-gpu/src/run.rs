//! Runs an engine: writes where its instances begin, and lets many steps go between two reads.

use std::collections::VecDeque;
use std::ops::ControlFlow;

use bytemuck::Pod;
use glam::DVec3;
use origami_core::Model;
use origami_core::model::Softening;
use origami_core::scene::{Held, Load};
use origami_core::solve::{State, row_sums};
use origami_core::twins::fire_update;

use crate::engine::Engine;
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::{Control, CreaseState, LIMITED, NONE, Node, single};
use crate::mapped::Reading;
use crate::plan::batch;

/// Submissions that are under way before the oldest is reading at: the queue never stands still.
pub(crate) const AHEAD: usize = 2;

/// Where an instance begins, and how far it is to go.
pub(crate) struct Beginning<'m> {
    pub(crate) model: &'m Model,
    pub(crate) state: State,
    /// The nodes that are held.
    pub(crate) held: Held,
    pub(crate) loads: Vec<Load>,
    /// Target angles at the end of the ramp, by crease; it begins at those of `state`.
    pub(crate) targets: Vec<f64>,
    pub(crate) ramp: u32,
    /// How soft the sheet is while the target angles rise.
    pub(crate) softening: Option<Softening>,
    pub(crate) limit: u64,
    pub(crate) tolerance: f64,
    /// Whether it stops when it has settled, or runs all its steps.
    pub(crate) stops_when_settled: bool,
    /// Of dynamics.
    pub(crate) time_step: f64,
    pub(crate) damping_sum: f64,
}

/// Where an instance ended.
#[derive(Clone, Debug)]
pub(crate) struct Ending {
    pub(crate) control: Control,
    pub(crate) nodes: Vec<Node>,
    pub(crate) creases: Vec<CreaseState>,
    /// The last good state, where it has diverged.
    pub(crate) checkpoint: Option<(Vec<Node>, Vec<f32>)>,
    /// Whether it was broken off.
    pub(crate) cancelled: bool,
}

impl Ending {
    /// Of a sheet that has taken no step.
    pub(crate) fn not_begun(beginning: &Beginning<'_>) -> Self {
        let Written { mut controls, nodes, creases } = Written::of(std::slice::from_ref(beginning), false);
        let control = controls.pop().unwrap_or_default();
        Self { control, nodes, creases, checkpoint: None, cancelled: true }
    }
}

/// Beginnings as they lie in the buffers.
struct Written {
    controls: Vec<Control>,
    nodes: Vec<Node>,
    creases: Vec<CreaseState>,
}

impl Written {
    /// `relaxing`: whether velocities have no meaning.
    fn of(beginnings: &[Beginning<'_>], relaxing: bool) -> Self {
        let mut controls = Vec::with_capacity(beginnings.len());
        let (mut nodes, mut creases) = (Vec::new(), Vec::new());
        let mut softness: Vec<f32> = Vec::new();
        let mut of = None;
        for beginning in beginnings {
            controls.push(control(beginning));
            // Neighbours in an ensemble mostly share their model.
            if !of.is_some_and(|model| std::ptr::eq(model, beginning.model)) {
                softness = row_sums::soft_sums(beginning.model).into_iter().map(|sum| narrow(1.0 / sum)).collect();
                of = Some(beginning.model);
            }
            let (start, first) = (&beginning.state, nodes.len());
            for ((position, velocity), softness) in start.positions.iter().zip(&start.velocities).zip(&softness) {
                let velocity = if relaxing { DVec3::ZERO } else { *velocity };
                let mut node = Node { mass: 1.0, softness: *softness, velocity: single(velocity), ..Node::default() };
                node.set_position(*position);
                nodes.push(node);
            }
            for (node, axes) in beginning.held.iter() {
                nodes[first + node.index()].hold(axes);
            }
            let angles = start.fold_angles.iter().zip(&start.targets).zip(&beginning.targets);
            creases.extend(angles.map(|((angle, start), end)| CreaseState {
                angle: narrow(*angle),
                moment: 0.0,
                start_target: narrow(*start),
                end_target: narrow(*end),
            }));
        }
        Self { controls, nodes, creases }
    }
}

impl Engine {
    /// Takes the steps `from..to` of its first instances, or fewer where all of them stop or `observe` breaks them off; hands
    /// back where they stand, and whether they were broken off.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn advance(
        &self,
        instances: usize,
        from: u64,
        to: u64,
        observe: &mut dyn FnMut(usize, &Control) -> ControlFlow<()>,
    ) -> Result<(Vec<Control>, ControlFlow<()>), GpuError> {
        let batch = batch(self.variant.nodes * instances);
        let (mut under_way, mut controls) = (VecDeque::new(), Vec::new());
        let mut step = from;
        let (mut running, mut cancelled) = (true, false);
        while running && (step < to || !under_way.is_empty()) {
            if step < to {
                let next = (step + batch).min(to);
                under_way.push_back((next, self.submit(instances, step, next)?));
                step = next;
            }
            if under_way.len() > AHEAD || step == to {
                let Some((asked, reading)) = under_way.pop_front() else { break };
                controls = reading.wait(&self.gpu)?;
                // Instances run together: who breaks one off breaks off all.
                for (i, control) in controls.iter().enumerate() {
                    cancelled |= observe(i, control).is_break();
                }
                self.check_steps(&controls, asked)?;
                running = !cancelled && controls.iter().any(|c| c.stop == 0 && c.bad_node == NONE);
            }
        }
        // What still is under way finds all instances standing still, or takes them a little farther.
        for (_, reading) in under_way {
            controls = reading.wait(&self.gpu)?;
        }
        Ok((controls, if cancelled { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }))
    }

    /// A kernel that was cut short would go unnoticed: a running instance has made all steps that were asked for.
    pub(crate) fn check_steps(&self, controls: &[Control], to: u64) -> Result<(), GpuError> {
        let behind = |c: &&Control| c.stop == 0 && c.bad_node == NONE && u64::from(c.step) < to.min(u64::from(c.limit));
        match controls.iter().find(behind) {
            Some(c) => Err(GpuError::Refused(format!(
                "after {to} steps were asked for it has made {}: its driver cuts long loops short",
                c.step
            ))),
            None => Ok(()),
        }
    }

    /// Writes where the instances from `first` on begin.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn load(&self, first: usize, beginnings: &[Beginning<'_>]) -> Result<(), GpuError> {
        if beginnings.is_empty() {
            return Ok(());
        }
        let Written { controls, nodes, creases } = Written::of(beginnings, self.variant.relaxing());
        let (node_count, crease_count) = (self.variant.nodes, self.variant.creases);
        self.gpu.scoped(|| {
            self.write_from(first, 1, Binding::Control, &controls);
            self.write_from(first, node_count, Binding::Nodes, &nodes);
            // The start is the first good state.
            self.write_from(first, node_count, Binding::CheckpointNodes, &nodes);
            if let Some(copies) = &self.copies {
                let of_each = creases.chunks(copies.creases().max(1)).flat_map(|own| copies.spread(own));
                let (angles, targets): (Vec<f32>, Vec<[f32; 2]>) =
                    of_each.map(|c| (c.angle, [c.start_target, c.end_target])).unzip();
                self.write_from(first, crease_count, Binding::Angles, &angles);
                self.write_from(first, crease_count, Binding::Targets, &targets);
                self.write_from(first, crease_count, Binding::CheckpointAngles, &angles);
            } else {
                let angles: Vec<f32> = creases.iter().map(|c: &CreaseState| c.angle).collect();
                self.write_from(first, crease_count, Binding::CreaseStates, &creases);
                self.write_from(first, crease_count, Binding::CheckpointAngles, &angles);
            }
            self.write_loads(first, beginnings.iter().map(|b| &b.loads[..]));
        })
    }

    /// Writes the loads of each instance from `first` on, where there is room for any; the next step writes all other slots.
    pub(crate) fn write_loads<'l>(&self, first: usize, of_instances: impl ExactSizeIterator<Item = &'l [Load]>) {
        if self.load_slots.is_empty() {
            return;
        }
        // Passes have one more slot for each load, blocks a load for each node.
        let (binding, each) = match self.copies {
            Some(_) => (Binding::Loads, self.variant.nodes),
            None => (Binding::Slots, self.variant.slots),
        };
        let mut slots = vec![[0.0_f32; 4]; each * of_instances.len()];
        for (loads, slots) in of_instances.zip(slots.chunks_exact_mut(each)) {
            let mut forces = vec![DVec3::ZERO; self.load_slots.len()];
            for load in loads {
                if let Ok(i) = self.load_slots.binary_search_by_key(&load.node, |(node, _)| *node) {
                    forces[i] += load.force;
                }
            }
            for ((node, slot), force) in self.load_slots.iter().zip(forces) {
                let at = if self.copies.is_some() { node.index() } else { *slot as usize };
                slots[at][..3].copy_from_slice(&single(force));
            }
        }
        self.write_from(first, each, binding, &slots);
    }

    /// Writes the beginning of a buffer.
    pub(crate) fn write<T: Pod>(&self, binding: Binding, contents: &[T]) {
        self.write_from(0, 0, binding, contents);
    }

    /// Writes a buffer that has `each` elements for an instance, from those of the instance `first` on.
    fn write_from<T: Pod>(&self, first: usize, each: usize, binding: Binding, contents: &[T]) {
        if !contents.is_empty() {
            let from = (first * each * size_of::<T>()) as u64;
            self.gpu.queue().write_buffer(&self.buffers[&binding], from, bytemuck::cast_slice(contents));
        }
    }

    /// Lets an instance stand still, after all that has been submitted.
    pub(crate) fn stand_still(&self, instance: usize) {
        // The first word of its control block.
        self.write_from(instance, size_of::<Control>() / size_of::<u32>(), Binding::Control, &[LIMITED]);
    }

    pub(crate) fn submit(&self, instances: usize, from: u64, to: u64) -> Result<Reading<Control>, GpuError> {
        #[expect(clippy::cast_possible_truncation, reason = "at most 65 535")]
        let count = instances as u32;
        self.gpu.scoped(|| {
            let mut encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                self.record(&mut pass, count, from, to);
                // The last good state: once a batch of one sheet, in however many submissions its steps come, and with however
                // many others.
                let batch = batch(self.variant.nodes);
                if to / batch > from / batch {
                    self.record_checkpoint(&mut pass, count);
                }
            }
            Reading::new(&self.gpu, encoder, &self.buffers[&Binding::Control], &[0], instances, Binding::Control.what())
        })
    }

    /// Copies, of a buffer that has `each` elements for an instance, those of some instances for reading. A refusal goes to the
    /// error scope that this is called in.
    pub(crate) fn start_reading<T: Pod>(&self, binding: Binding, instances: &[usize], each: usize) -> Reading<T> {
        let encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        Reading::new(&self.gpu, encoder, &self.buffers[&binding], instances, each, binding.what())
    }

    /// All of a buffer's first `count`.
    pub(crate) fn read<T: Pod>(&self, binding: Binding, count: usize) -> Result<Vec<T>, GpuError> {
        self.gpu.scoped(|| self.start_reading(binding, &[0], count))?.wait(&self.gpu)
    }
}

fn control(beginning: &Beginning<'_>) -> Control {
    let material = beginning.model.material;
    let soft = beginning.softening.map(|softening| softened(beginning.model, softening));
    let (soft_ea, soft_corners, wrong_side) = soft.unwrap_or_default();
    let ramp = if beginning.targets == beginning.state.targets { 0 } else { beginning.ramp };
    Control {
        limit: u32::try_from(beginning.limit).unwrap_or(u32::MAX),
        bad_node: NONE,
        // The first evaluation is one part of the way.
        ramp_step: ramp.min(1),
        ramp_length: ramp,
        stops_when_settled: u32::from(beginning.stops_when_settled),
        distance: f32::INFINITY,
        tolerance: narrow(beginning.tolerance),
        fire_step: narrow(fire_update::FIRST_STEP),
        mixing: narrow(fire_update::MIXING),
        next_step: narrow(beginning.time_step),
        damping_sum: narrow(beginning.damping_sum),
        ea: narrow(material.ea),
        k_fold: narrow(material.k_fold),
        k_facet: narrow(material.k_facet),
        k_face: narrow(material.k_face),
        zeta: narrow(material.zeta),
        k_area: narrow(beginning.model.k_area()),
        soft_ea,
        soft_corners,
        wrong_side,
        ..Control::default()
    }
}

/// How soft a sheet is, as its control block says it: the most rigid beam, the share of the corner angles' stiffness, and what
/// pulls a crease back.
pub(crate) fn softened(model: &Model, softening: Softening) -> (f32, f32, f32) {
    let most_rigid = softening.beams * model.stiffest_crease;
    (narrow(most_rigid), narrow(softening.corner_angles), narrow(softening.wrong_side))
}

#[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
fn narrow(x: f64) -> f32 {
    x as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::purpose::{Dispatch, Purpose};
    use crate::testing::bench::EULER;
    use crate::testing::cases::miura;
    use crate::testing::gpu;

    #[test]
    fn a_kernel_that_was_cut_short_is_noticed() {
        let Some(gpu) = gpu() else { return };
        let purpose = Purpose { scheme: EULER, safe: false, softens: false, dispatch: Dispatch::Passes };
        let engine = Engine::bare(&gpu, &miura(), purpose).expect("it fits");
        let at = |step: u32| Control { step, limit: 250, bad_node: NONE, ..Control::default() };
        assert_eq!(engine.check_steps(&[at(100), at(100)], 100), Ok(()));
        assert_eq!(engine.check_steps(&[at(250)], 300), Ok(()), "the limit came first");
        let text = engine.check_steps(&[at(100), at(87)], 100).expect_err("13 are missing").to_string();
        assert!(text.contains("after 100 steps") && text.contains("made 87"), "{text}");
        assert!(engine.check_steps(&[at(249)], 300).is_err());
        // Who has stopped for a reason of its own is not behind.
        assert_eq!(
            engine.check_steps(&[Control { stop: 1, ..at(40) }, Control { bad_node: 3, ..at(40) }], 100),
            Ok(())
        );
    }
}
