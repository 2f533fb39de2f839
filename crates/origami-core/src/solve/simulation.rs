//! A sheet that can be stepped, steered and watched.

use std::sync::Arc;

use glam::DVec3;

use super::engine::{Engine, Method, Report};
use super::{Failed, Folded, Positions, Saved, State};
use crate::ids::NodeId;
use crate::model::Model;
use crate::scene::{Axes, Held, Load, Reaction, Refusal, Scene, Support, Targets};

/// A sheet in motion: where it is now, and what moves it. Nothing is built anew, perturbed again or forgotten when its
/// targets, pins or loads change.
///
/// ```
/// use origami_core::generate::BirdBase;
/// use origami_core::scene::Targets;
/// use origami_core::solve::{Dynamics, Simulation};
/// use origami_core::{Material, Model};
///
/// let model = Model::new(&BirdBase::default().pattern()?, &Material::default())?;
/// let mut simulation = Simulation::new(model, Dynamics::default())?;
/// simulation.set_targets(Targets::percent(60.0))?;
/// let report = simulation.step(40)?;
/// assert_eq!(report.steps, 40);
/// let farthest = simulation.positions()?.iter().map(|p| p.length()).fold(0.0, f64::max);
/// assert!(farthest < 2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simulation<M: Method> {
    model: Arc<Model>,
    engine: M::Engine,
    targets: Targets,
    /// Nodes that the pattern fixes and the scene supports.
    supports: Held,
    loads: Vec<Load>,
    pins: Vec<NodeId>,
    /// What a refusal hands back: the state in which it began.
    start: Arc<State>,
}

/// A node that is pinned: [`Simulation::move_pin`] drags it, [`Simulation::unpin`] lets it go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pin(NodeId);

impl Pin {
    /// The node.
    #[must_use]
    pub fn node(self) -> NodeId {
        self.0
    }
}

impl<M: Method> Simulation<M> {
    /// A sheet at rest, asked to stay as it is, moved by `method`.
    ///
    /// # Errors
    /// [`Failed::Refused`] where the method cannot run the model, [`Failed::Backend`] where what computes gives up.
    pub fn new(model: impl Into<Arc<Model>>, method: M) -> Result<Self, Failed> {
        let model = model.into();
        let start = State::at_rest(&model);
        Self::in_scene(model, method, &Scene::default(), start)
    }

    /// A sheet in the state `start`, in `scene`.
    ///
    /// # Errors
    /// [`Failed::Refused`] where the scene does not fit the model or the method, [`Failed::Backend`] where what computes gives
    /// up.
    pub fn in_scene(model: impl Into<Arc<Model>>, method: M, scene: &Scene, start: State) -> Result<Self, Failed> {
        let model = model.into();
        let engine = method.engine(&model, scene, &start)?;
        Ok(Self {
            engine,
            targets: scene.targets.clone(),
            supports: Held::new(&model, scene),
            loads: scene.loads.clone(),
            pins: Vec::new(),
            start: Arc::new(start),
            model,
        })
    }

    /// Goes on from what [`Simulation::save`] set aside, bit for bit where model, method and the forces of `scene` are the
    /// same. Targets, supports and loads are those that were saved; pins have become supports.
    ///
    /// # Errors
    /// [`Failed::Refused`] where what was saved does not fit the model.
    pub fn restore(model: impl Into<Arc<Model>>, method: M, scene: &Scene, saved: &Saved) -> Result<Self, Failed> {
        let model = model.into();
        let start = State::at_rest(&model);
        let mut simulation = Self::in_scene(model, method, scene, start)?;
        simulation.engine.restore(saved)?;
        simulation.supports = saved.held().clone();
        simulation.loads = saved.loads().to_vec();
        simulation.targets = saved.targets();
        Ok(simulation)
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &Arc<Model> {
        &self.model
    }

    /// What computes it.
    #[must_use]
    pub fn engine(&self) -> &M::Engine {
        &self.engine
    }

    /// What is asked of the creases.
    #[must_use]
    pub fn targets(&self) -> &Targets {
        &self.targets
    }

    /// Asks the creases for other angles. The way there is as the method's `ramp` says: a relaxation takes a share of its
    /// ramp, dynamics jumps by default.
    ///
    /// # Errors
    /// [`Failed::Refused`] where the targets do not fit the model, [`Failed::Backend`] where what computes gives up.
    pub fn set_targets(&mut self, targets: Targets) -> Result<(), Failed> {
        let angles = targets.of(&self.model).map_err(|refusal| self.refused(refusal))?;
        self.engine.set_targets(angles)?;
        self.targets = targets;
        Ok(())
    }

    /// Holds a node where it is, in every direction.
    ///
    /// # Errors
    /// [`Failed::Refused`] where the sheet has no such node, [`Failed::Backend`] where what computes gives up.
    pub fn pin(&mut self, node: NodeId) -> Result<Pin, Failed> {
        Scene::default()
            .with_support(Support::fixed(node))
            .check(&self.model)
            .map_err(|refusal| self.refused(refusal))?;
        if !self.pins.contains(&node) {
            let pins = self.pins.iter().copied().chain([node]).collect();
            self.hold(pins, self.loads.clone())?;
        }
        Ok(Pin(node))
    }

    /// Puts a pinned node elsewhere, in radii of the sheet ([`Normalisation::to_model`](crate::model::Normalisation::to_model)).
    ///
    /// # Errors
    /// [`Failed::Refused`] where the position is not finite or the pin was taken out, [`Failed::Backend`] where what computes
    /// gives up.
    pub fn move_pin(&mut self, pin: Pin, position: DVec3) -> Result<(), Failed> {
        let scene = Scene::default().with_support(Support::fixed(pin.0).at(position));
        scene.check(&self.model).map_err(|refusal| self.refused(refusal))?;
        if !self.pins.contains(&pin.0) {
            return Err(self.refused(Refusal::NotPinned(pin.0)));
        }
        self.engine.place(pin.0, Axes::ALL, position)
    }

    /// Lets a pinned node go; it begins at rest. Supports stay.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    pub fn unpin(&mut self, pin: Pin) -> Result<(), Failed> {
        let pins = self.pins.iter().copied().filter(|node| *node != pin.0).collect();
        self.hold(pins, self.loads.clone())
    }

    /// Takes other dead loads.
    ///
    /// # Errors
    /// [`Failed::Refused`] where one is not finite or on a node that the sheet does not have, or where the engine has no
    /// loads; [`Failed::Backend`] where what computes gives up.
    pub fn set_loads(&mut self, loads: Vec<Load>) -> Result<(), Failed> {
        let scene = Scene { loads, ..Scene::default() };
        scene.check(&self.model).map_err(|refusal| self.refused(refusal))?;
        self.hold(self.pins.clone(), scene.loads)
    }

    /// Takes so many steps, settled or not.
    ///
    /// # Errors
    /// [`Failed::Diverged`] where the state leaves all bounds, [`Failed::Backend`] where what computes gives up.
    pub fn step(&mut self, steps: u64) -> Result<Report, Failed> {
        self.engine.advance(steps, false)
    }

    /// Steps until the sheet has settled, but at most so many times.
    ///
    /// # Errors
    /// As [`Simulation::step`].
    pub fn settle(&mut self, most_steps: u64) -> Result<Report, Failed> {
        self.engine.advance(most_steps, true)
    }

    /// How far it has come.
    #[must_use]
    pub fn report(&self) -> Report {
        self.engine.report()
    }

    /// Where the nodes are. On the CPU nothing is copied or allocated; from a GPU they are read.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    pub fn positions(&mut self) -> Result<Positions<'_>, Failed> {
        self.engine.positions()
    }

    /// A copy of all that moves.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    pub fn state(&mut self) -> Result<State, Failed> {
        self.engine.state()
    }

    /// What supports and pins did to the nodes that they hold, at the last step; in the order of the nodes.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    pub fn reactions(&mut self) -> Result<Vec<Reaction>, Failed> {
        self.engine.reactions()
    }

    /// All that it takes to go on bit for bit ([`Simulation::restore`]).
    ///
    /// # Errors
    /// [`Failed::Refused`] where the engine cannot be saved, [`Failed::Backend`] where what computes gives up.
    pub fn save(&mut self) -> Result<Saved, Failed> {
        let targets = self.targets.clone();
        Ok(self.engine.save()?.with_targets(targets))
    }

    /// The state that it came to, measured: [`Stop::Converged`](super::Stop::Converged) where it has settled.
    ///
    /// # Errors
    /// [`Failed::Backend`] where what computes gives up.
    pub fn finish(self) -> Result<Folded, Failed> {
        self.engine.finish(self.targets)
    }

    /// Takes other pins and loads, once the engine has.
    fn hold(&mut self, pins: Vec<NodeId>, loads: Vec<Load>) -> Result<(), Failed> {
        let mut held = self.supports.clone();
        pins.iter().for_each(|node| held.hold(*node, Axes::ALL));
        self.engine.set_surroundings(held, loads.clone())?;
        (self.pins, self.loads) = (pins, loads);
        Ok(())
    }

    fn refused(&self, refusal: Refusal) -> Failed {
        Failed::refused(refusal, &self.start)
    }
}
