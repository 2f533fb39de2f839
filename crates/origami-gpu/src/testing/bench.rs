//! Passes on their own: a state goes up, some kernels run, buffers come back.

use std::cell::RefCell;
use std::collections::BTreeMap;

use bytemuck::Pod;
use origami_core::model::Softening;
use origami_core::scene::{Held, Scene};
use origami_core::solve::{Integrator, time_step};
use origami_core::{Model, State};

use crate::Gpu;
use crate::engine::Engine;
use crate::kernels::{Binding, Kernel, loose_beams};
use crate::layout::{Control, Node};
use crate::pipeline::Pass;
use crate::purpose::{Dispatch, Purpose};
use crate::run::{Beginning, softened};
use crate::sheet_arrays::SheetArrays;
use crate::testing::cases::Case;
use crate::variant::Scheme;

pub(crate) const EULER: Scheme = Scheme::Dynamics { verlet: false, damped: true };
pub(crate) const VERLET: Scheme = Scheme::Dynamics { verlet: true, damped: true };

/// The case as buffers hold it, so that both sides see the same.
pub(crate) fn held(case: &Case) -> Case {
    let position = |p: &glam::DVec3| {
        let mut node = Node::default();
        node.set_position(*p);
        node.position()
    };
    let positions = case.state.positions.iter().map(position).collect();
    Case { state: State { positions, ..case.state.clone() }, ..case.clone() }
}

/// A case on a GPU.
pub(crate) struct Bench {
    engine: Engine,
    pub(crate) arrays: SheetArrays,
    passes: RefCell<BTreeMap<(&'static str, bool), Pass>>,
}

impl Bench {
    /// With the velocities of the case even in a relaxation, and its targets at once.
    pub(crate) fn new(gpu: &Gpu, case: &Case, scheme: Scheme) -> Self {
        Self::by(gpu, case, scheme, Dispatch::Passes)
    }

    /// The same with the buffers of another way.
    pub(crate) fn by(gpu: &Gpu, case: &Case, scheme: Scheme, dispatch: Dispatch) -> Self {
        let purpose = Purpose { scheme, safe: false, softens: scheme == Scheme::Relax, dispatch };
        let engine = Engine::bare(gpu, &case.model, purpose).expect("it fits");
        let integrator = match scheme {
            Scheme::Dynamics { verlet: true, .. } => Integrator::Verlet,
            _ => Integrator::Euler,
        };
        let beginning = Beginning {
            model: &case.model,
            state: case.state.clone(),
            held: Held::new(&case.model, &Scene::default()),
            loads: Vec::new(),
            targets: case.state.targets.clone(),
            ramp: 0,
            softening: None,
            limit: 1000,
            tolerance: 1e-4,
            stops_when_settled: true,
            time_step: time_step::paper(&case.model),
            damping_sum: time_step::damping_sum(&case.model, integrator),
        };
        engine.load(0, &[beginning]).expect("written");
        let bench = Self { engine, arrays: SheetArrays::new(&case.model), passes: RefCell::default() };
        bench.change_nodes(|i, node| node.velocity = crate::layout::single(case.state.velocities[i]));
        bench
    }

    /// Runs kernels one after the other. The pass over the triangles keeps the time of dynamics where `advances_clock`.
    pub(crate) fn run(&self, kernels: &[&Kernel], advances_clock: bool) {
        let Engine { gpu, variant, buffers, .. } = &self.engine;
        let done = gpu.scoped(|| {
            let mut passes = self.passes.borrow_mut();
            for kernel in kernels {
                let pass = || Pass::new(gpu, kernel, variant, advances_clock, buffers);
                passes.entry((kernel.name, advances_clock)).or_insert_with(pass);
            }
            let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                kernels.iter().for_each(|kernel| passes[&(kernel.name, advances_clock)].record(&mut pass, 1));
            }
            gpu.queue().submit([encoder.finish()]);
        });
        done.expect("they run");
    }

    /// The kernels, and that of loose beams where there are some.
    pub(crate) fn with_loose<'k>(&self, kernels: &[&'k Kernel]) -> Vec<&'k Kernel> {
        let loose: &[&Kernel] = if self.arrays.loose_beams.is_empty() { &[] } else { &[&loose_beams::KERNEL] };
        [kernels, loose].concat()
    }

    pub(crate) fn read<T: Pod>(&self, binding: Binding, count: usize) -> Vec<T> {
        self.engine.read(binding, count).expect("read")
    }

    pub(crate) fn write<T: Pod>(&self, binding: Binding, contents: &[T]) {
        self.engine.write(binding, contents);
    }

    pub(crate) fn control(&self) -> Control {
        self.read(Binding::Control, 1)[0]
    }

    pub(crate) fn change_control(&self, change: impl FnOnce(&mut Control)) {
        let mut control = self.control();
        change(&mut control);
        self.write(Binding::Control, &[control]);
    }

    /// On the way, so soft.
    pub(crate) fn soften(&self, model: &Model, softening: Softening) {
        self.change_control(|c| {
            (c.ramp_step, c.ramp_length) = (1, 2);
            (c.soft_ea, c.soft_corners, c.wrong_side) = softened(model, softening);
        });
    }

    pub(crate) fn nodes(&self) -> Vec<Node> {
        self.read(Binding::Nodes, self.arrays.nodes)
    }

    pub(crate) fn change_nodes(&self, mut change: impl FnMut(usize, &mut Node)) {
        let mut nodes = self.nodes();
        nodes.iter_mut().enumerate().for_each(|(i, node)| change(i, node));
        self.write(Binding::Nodes, &nodes);
    }

    /// What the slots of each node sum to, in double precision.
    pub(crate) fn gathered(&self) -> Vec<glam::DVec4> {
        let slots: Vec<[f32; 4]> = self.read(Binding::Slots, self.arrays.slot_count());
        let sum = |row: &[u32]| {
            let own = &slots[row[0] as usize..row[1] as usize];
            own.iter().map(|slot| glam::DVec4::from_array(slot.map(f64::from))).sum()
        };
        self.arrays.rows.windows(2).map(sum).collect()
    }

    /// How many workgroups hand over partial sums.
    pub(crate) fn groups(&self) -> usize {
        self.engine.variant.groups(self.arrays.nodes)
    }
}
