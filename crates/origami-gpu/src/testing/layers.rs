//! Passes over pairs on their own: a crumpled sheet goes up, some kernels run, buffers come back.

use bytemuck::Pod;
use glam::DVec3;
use origami_core::contact::{Contact, PairList};
use origami_core::generate::catalog;
use origami_core::scene::{Held, Scene};
use origami_core::solve::{State, contact_patience};
use origami_core::{Material, Model};

use crate::Gpu;
use crate::engine::Engine;
use crate::kernels::{Binding, Kernel};
use crate::layout::{Control, Node, Pair};
use crate::outside::Outside;
use crate::pair_arrays::PairArrays;
use crate::pipeline::Pass;
use crate::run::Beginning;
use crate::testing::cases::Random;
use crate::variant::InContact;

/// A pattern of the catalog as a model.
pub(crate) fn model(name: &str) -> Model {
    Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

/// A sheet of which every node has been moved by up to `size`, at places that buffers hold.
pub(crate) fn crumpled(model: &Model, size: f64, seed: u64) -> Vec<DVec3> {
    let mut random = Random(seed);
    model.rest.iter().map(|p| as_held(*p + random.vector(size))).collect()
}

/// A position as buffers hold it, so that both sides see the same.
pub(crate) fn as_held(position: DVec3) -> DVec3 {
    let mut node = Node::default();
    node.set_position(position);
    node.position()
}

/// A sheet under contact on a GPU.
pub(crate) struct Layers {
    pub(crate) engine: Engine,
    pub(crate) list: PairList,
    pub(crate) arrays: PairArrays,
}

impl Layers {
    pub(crate) fn new(gpu: &Gpu, model: &Model, positions: &[DVec3], contact: Contact) -> Self {
        let mut list = PairList::new(&model.mesh, &model.rest, contact);
        list.list(positions);
        let built = InContact {
            stiffness: contact.stiffness,
            thick: contact.thickness > 0.0,
            longest_move: list.longest_move(),
            patience: contact_patience(model),
        };
        let mut engine = Engine::in_contact(gpu, model, &Outside::default(), built).expect("it fits");
        let state = State { positions: positions.to_vec(), ..State::at_rest(model) };
        let targets = state.targets.clone();
        let held = Held::new(model, &Scene::default());
        let beginning = Beginning {
            model,
            state,
            held,
            loads: Vec::new(),
            targets,
            ramp: 0,
            softening: None,
            limit: 1_000_000,
            tolerance: 1e-4,
            stops_when_settled: true,
            time_step: 0.0,
            damping_sum: 0.0,
        };
        engine.load(0, &[beginning]).expect("written");
        let arrays = PairArrays::new(model.node_count(), &list);
        engine.list(&arrays).expect("written");
        Self { engine, list, arrays }
    }

    /// Lists the pairs anew.
    pub(crate) fn list(&mut self, positions: &[DVec3]) {
        self.list.list(positions);
        self.arrays = PairArrays::new(positions.len(), &self.list);
        self.engine.list(&self.arrays).expect("written");
    }

    /// Runs kernels one after the other.
    pub(crate) fn run(&self, passes: &[Pass]) {
        let gpu = &self.engine.gpu;
        let done = gpu.scoped(|| {
            let mut encoder = gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                passes.iter().for_each(|own| own.record(&mut pass, 1));
            }
            gpu.queue().submit([encoder.finish()]);
        });
        done.expect("they run");
    }

    /// Kernels for the list at hand.
    pub(crate) fn passes(&self, kernels: &[&Kernel]) -> Vec<Pass> {
        let Engine { gpu, variant, buffers, .. } = &self.engine;
        let pairs = u32::try_from(self.arrays.pairs.len()).expect("few");
        let pass = |kernel: &&Kernel| {
            let mut pass = Pass::new(gpu, kernel, variant, false, buffers);
            pass.set_pairs(pairs);
            pass
        };
        gpu.scoped(|| kernels.iter().map(pass).collect()).expect("they are valid")
    }

    pub(crate) fn read<T: Pod>(&self, binding: Binding, count: usize) -> Vec<T> {
        self.engine.read(binding, count).expect("read")
    }

    pub(crate) fn nodes(&self) -> Vec<Node> {
        self.read(Binding::Nodes, self.engine.variant.nodes)
    }

    pub(crate) fn positions(&self) -> Vec<DVec3> {
        self.nodes().iter().map(Node::position).collect()
    }

    pub(crate) fn control(&self) -> Control {
        self.read(Binding::Control, 1)[0]
    }

    pub(crate) fn pairs(&self) -> &[Pair] {
        &self.arrays.pairs
    }

    /// What lies in the slots of each node, in their order.
    pub(crate) fn rows<T: Pod>(&self, binding: Binding) -> Vec<Vec<T>> {
        let slots: Vec<T> = self.read(binding, 4 * self.arrays.pairs.len());
        self.arrays.rows.windows(2).map(|row| slots[row[0] as usize..row[1] as usize].to_vec()).collect()
    }
}
