//! Runs an engine: writes where its instances begin, lets many steps go between two reads, and reads where they end.

use std::collections::VecDeque;
use std::ops::ControlFlow;

use bytemuck::Pod;
use glam::DVec3;
use origami_core::Model;
use origami_core::scene::{Held, Load};
use origami_core::solve::{State, row_sums};
use origami_core::twins::fire_update;

use crate::engine::Engine;
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::{Control, CreaseState, NONE, Node, single};
use crate::mapped::Reading;
use crate::plan::batch;

/// Submissions that are under way before the oldest is reading at: the queue never stands still.
const AHEAD: usize = 2;

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

impl Engine {
    /// Runs the instances from where they begin; `observe` sees the control block of each now and then.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn run(
        &mut self,
        beginnings: &[Beginning<'_>],
        observe: &mut dyn FnMut(usize, &Control) -> ControlFlow<()>,
    ) -> Result<Vec<Ending>, GpuError> {
        assert!(beginnings.len() <= self.instances, "the engine was built for as many");
        self.load(beginnings)?;
        let limit = beginnings.iter().map(|b| b.limit).max().unwrap_or(0);
        let (_, broken_off) = self.advance(beginnings.len(), 0, limit, observe)?;
        self.endings(beginnings.len(), broken_off.is_break())
    }

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
    fn check_steps(&self, controls: &[Control], to: u64) -> Result<(), GpuError> {
        let behind = |c: &&Control| c.stop == 0 && c.bad_node == NONE && u64::from(c.step) < to.min(u64::from(c.limit));
        match controls.iter().find(behind) {
            Some(c) => Err(GpuError::Refused(format!(
                "after {to} steps were asked for it has made {}: its driver cuts long loops short",
                c.step
            ))),
            None => Ok(()),
        }
    }

    pub(crate) fn load(&self, beginnings: &[Beginning<'_>]) -> Result<(), GpuError> {
        let relaxing = self.variant.relaxing();
        let mut controls = Vec::with_capacity(beginnings.len());
        let mut nodes = Vec::with_capacity(beginnings.len() * self.variant.nodes);
        let mut creases = Vec::with_capacity(beginnings.len() * self.variant.creases);
        let mut softness: Vec<f32> = Vec::new();
        let mut of = None;
        for beginning in beginnings {
            controls.push(control(beginning));
            // Neighbours in an ensemble mostly share their model.
            if !of.is_some_and(|model| std::ptr::eq(model, beginning.model)) {
                softness = row_sums::soft_sums(beginning.model).into_iter().map(|sum| narrow(1.0 / sum)).collect();
                of = Some(beginning.model);
            }
            let start = &beginning.state;
            for ((position, velocity), softness) in start.positions.iter().zip(&start.velocities).zip(&softness) {
                let velocity = if relaxing { DVec3::ZERO } else { *velocity };
                let mut node = Node { mass: 1.0, softness: *softness, velocity: single(velocity), ..Node::default() };
                node.set_position(*position);
                nodes.push(node);
            }
            let first = nodes.len() - self.variant.nodes;
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
        self.gpu.scoped(|| {
            self.write(Binding::Control, &controls);
            self.write(Binding::Nodes, &nodes);
            // The start is the first good state.
            self.write(Binding::CheckpointNodes, &nodes);
            if let Some(copies) = &self.copies {
                let of_each = creases.chunks(copies.creases().max(1)).flat_map(|own| copies.spread(own));
                let (angles, targets): (Vec<f32>, Vec<[f32; 2]>) =
                    of_each.map(|c| (c.angle, [c.start_target, c.end_target])).unzip();
                self.write(Binding::Angles, &angles);
                self.write(Binding::Targets, &targets);
                self.write(Binding::CheckpointAngles, &angles);
            } else {
                let angles: Vec<f32> = creases.iter().map(|c: &CreaseState| c.angle).collect();
                self.write(Binding::CreaseStates, &creases);
                self.write(Binding::CheckpointAngles, &angles);
            }
            self.write_loads(beginnings.iter().map(|b| &b.loads[..]));
        })
    }

    /// Writes the loads of each instance, where there is room for any; the next step writes all other slots.
    pub(crate) fn write_loads<'l>(&self, of_instances: impl ExactSizeIterator<Item = &'l [Load]>) {
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
        self.write(binding, &slots);
    }

    pub(crate) fn write<T: Pod>(&self, binding: Binding, contents: &[T]) {
        if !contents.is_empty() {
            self.gpu.queue().write_buffer(&self.buffers[&binding], 0, bytemuck::cast_slice(contents));
        }
    }

    pub(crate) fn submit(&self, instances: usize, from: u64, to: u64) -> Result<Reading<Control>, GpuError> {
        #[expect(clippy::cast_possible_truncation, reason = "at most 65 535")]
        let count = instances as u32;
        self.gpu.scoped(|| {
            let mut encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                self.record(&mut pass, count, from, to);
                // The last good state: once a batch, in however many submissions its steps come.
                let batch = batch(self.variant.nodes * instances);
                if to / batch > from / batch {
                    self.record_checkpoint(&mut pass, count);
                }
            }
            self.start_reading(encoder, Binding::Control, instances)
        })
    }

    /// Copies the first `count` of a buffer for reading, after all that `encoder` has recorded.
    fn start_reading<T: Pod>(&self, encoder: wgpu::CommandEncoder, binding: Binding, count: usize) -> Reading<T> {
        Reading::new(&self.gpu, encoder, &self.buffers[&binding], count, binding.what())
    }

    /// All of a buffer's first `count`.
    pub(crate) fn read<T: Pod>(&self, binding: Binding, count: usize) -> Result<Vec<T>, GpuError> {
        let reading = self.gpu.scoped(|| {
            let encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            self.start_reading(encoder, binding, count)
        })?;
        reading.wait(&self.gpu)
    }

    /// The states of the creases of each instance. Blocks know the fold angles alone.
    fn read_creases(&self, instances: usize) -> Result<Vec<Vec<CreaseState>>, GpuError> {
        let each = self.variant.creases;
        let own = |i: usize| i * each..(i + 1) * each;
        if let Some(copies) = &self.copies {
            let angles: Vec<f32> = self.read(Binding::Angles, instances * each)?;
            let state = |angle| CreaseState { angle, ..CreaseState::default() };
            let of = |i| copies.collect(&angles[own(i)]).into_iter().map(state).collect();
            return Ok((0..instances).map(of).collect());
        }
        let creases: Vec<CreaseState> = self.read(Binding::CreaseStates, instances * each)?;
        Ok((0..instances).map(|i| creases[own(i)].to_vec()).collect())
    }

    pub(crate) fn endings(&self, instances: usize, cancelled: bool) -> Result<Vec<Ending>, GpuError> {
        let controls: Vec<Control> = self.read(Binding::Control, instances)?;
        let (node_count, crease_count) = (self.variant.nodes, self.variant.creases);
        let nodes: Vec<Node> = self.read(Binding::Nodes, instances * node_count)?;
        let creases = self.read_creases(instances)?;
        let diverged = controls.iter().any(|c| c.bad_node != NONE);
        let checkpoint_nodes: Vec<Node> =
            if diverged { self.read(Binding::CheckpointNodes, instances * node_count)? } else { Vec::new() };
        let checkpoint_angles: Vec<f32> =
            if diverged { self.read(Binding::CheckpointAngles, instances * crease_count)? } else { Vec::new() };
        let ending = |(i, control): (usize, Control)| {
            let own_nodes = i * node_count..(i + 1) * node_count;
            let own_creases = i * crease_count..(i + 1) * crease_count;
            let bad = control.bad_node != NONE;
            Ending {
                cancelled,
                control,
                nodes: nodes[own_nodes.clone()].to_vec(),
                creases: creases[i].clone(),
                checkpoint: bad.then(|| {
                    let angles = &checkpoint_angles[own_creases];
                    let angles = self.copies.as_ref().map_or(angles.to_vec(), |copies| copies.collect(angles));
                    (checkpoint_nodes[own_nodes].to_vec(), angles)
                }),
            }
        };
        Ok(controls.into_iter().enumerate().map(ending).collect())
    }
}

fn control(beginning: &Beginning<'_>) -> Control {
    let material = beginning.model.material;
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
        ..Control::default()
    }
}

#[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
fn narrow(x: f64) -> f32 {
    x as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::purpose::Dispatch;
    use crate::testing::bench::EULER;
    use crate::testing::cases::miura;
    use crate::testing::gpu;

    #[test]
    fn a_kernel_that_was_cut_short_is_noticed() {
        let Some(gpu) = gpu() else { return };
        let engine = Engine::bare(&gpu, &miura(), EULER, Dispatch::Passes).expect("it fits");
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
