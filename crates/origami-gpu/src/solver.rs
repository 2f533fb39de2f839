//! The solvers of the core, computed on a GPU.

use std::ops::ControlFlow;

use origami_core::model::{Inventory, Model};
use origami_core::scene::Scene;
use origami_core::solve::{Failed, Folded, Instance, Progress, Session, Solver, State};

use crate::device::Gpu;
use crate::engine::Engine;
use crate::error::GpuError;
use crate::method::GpuMethod;
use crate::outcome::backend;
use crate::outside::Outside;
use crate::purpose::{Dispatch, Purpose};
use crate::route::Route;
use crate::sheet_arrays::SheetArrays;
use crate::stream::Asked;
use crate::traffic::Traffic;
use crate::{ensemble, inventory};

impl Gpu {
    /// `method` ([`Relax`](origami_core::Relax) or [`Dynamics`](origami_core::Dynamics)) computed here instead of on the
    /// processor.
    pub fn with<S: GpuMethod>(&self, method: S) -> OnGpu<S> {
        OnGpu { gpu: self.clone(), method, dispatch: Dispatch::Auto }
    }
}

/// A solver of the core that computes on a GPU. The settings are those of the core's solver, and mean the same.
#[derive(Clone, Debug)]
pub struct OnGpu<S> {
    pub(crate) gpu: Gpu,
    pub(crate) method: S,
    dispatch: Dispatch,
}

impl<S: GpuMethod> OnGpu<S> {
    /// The solver's settings.
    pub fn method(&self) -> &S {
        &self.method
    }

    /// Another way for the passes of a step to reach the GPU. Results differ by rounding only. Default:
    /// [`Dispatch::Auto`].
    #[must_use]
    pub fn dispatch(self, dispatch: Dispatch) -> Self {
        Self { dispatch, ..self }
    }

    /// The way that the passes of a step reach the GPU for `model`: one of [`Dispatch::WAYS`], and not the one asked for
    /// where the sheet is too large for it or has something that it cannot do.
    pub fn way(&self, model: &Model) -> Dispatch {
        let purpose = self.purpose([model].into_iter());
        let arrays = SheetArrays::new(model);
        Route::new(&arrays, purpose, self.gpu.abilities()).dispatch()
    }

    /// What a step moves and what the buffers take on the way that `model` goes, counted: nothing is asked of the GPU.
    pub fn traffic(&self, model: &Model) -> Traffic {
        let purpose = self.purpose([model].into_iter());
        Traffic::of(model, purpose, self.gpu.abilities())
    }

    /// What [`Solver::session`] gives, by its own name.
    pub fn on<'a>(&'a self, model: &'a Model) -> OnModel<'a, S> {
        let purpose = self.purpose([model].into_iter());
        let engine = Engine::new(&self.gpu, model, &Outside::default(), purpose);
        OnModel { on: self, model, purpose, engine }
    }

    /// What an engine for `models` has to do.
    pub(crate) fn purpose<'m>(&self, models: impl Iterator<Item = &'m Model>) -> Purpose {
        self.method.method().purpose(self.dispatch, models)
    }
}

impl<S: GpuMethod> Solver for OnGpu<S> {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.on(model).fold(start, scene, observe)
    }

    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(self.on(model))
    }

    fn fold_each(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
        take: &(dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync),
    ) {
        let purpose = self.purpose(instances.iter().map(|i| i.model));
        ensemble::fold_each(&self.gpu, self.method.method(), purpose, instances, observe, take);
    }

    fn inventory(&self, model: &Model) -> Inventory {
        inventory::of(model, self.method.inventory(model), self.purpose([model].into_iter()), self.gpu.abilities())
    }
}

/// A [`Session`] on a GPU: the buffers and pipelines of one model stay from one percentage to the next. With the feature
/// `render` a `Renderer` can draw the sheet where the session has left it.
#[derive(Debug)]
pub struct OnModel<'a, S> {
    on: &'a OnGpu<S>,
    model: &'a Model,
    purpose: Purpose,
    engine: Result<Engine, GpuError>,
}

#[cfg(feature = "render")]
impl<S> OnModel<'_, S> {
    /// # Errors
    /// Why it could not be built.
    pub(crate) fn engine(&self) -> Result<&Engine, GpuError> {
        self.engine.as_ref().map_err(Clone::clone)
    }
}

impl<S: GpuMethod> Session for OnModel<'_, S> {
    fn fold(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let instance = Instance { model: self.model, start: start.clone(), scene: scene.clone() };
        // Before whatever came of building an engine for it.
        self.on.method.method().check(&instance).map_err(|refusal| Failed::refused(refusal, start))?;
        // Supports and loads need room: where a scene brings some, the engine is built once more.
        if let Ok(engine) = &self.engine
            && !engine.outside().covers(scene)
        {
            self.engine = Engine::new(&self.on.gpu, self.model, &engine.outside().with(scene), self.purpose);
        }
        let engine = self.engine.as_ref().map_err(|error| backend(error.clone(), start, 0))?;
        let mut result = None;
        let asked = Asked {
            instances: &[&instance],
            observe: &mut |_, progress| observe(progress),
            take: &mut |_, came_to| {
                result = Some(came_to);
                ControlFlow::Continue(())
            },
        };
        self.on.method.method().run(engine, asked);
        result.expect("one result for one instance")
    }
}

#[cfg(test)]
mod tests {
    use origami_core::{Dynamics, Relax};

    use super::*;
    use crate::AdapterChoice;
    use crate::testing::cases::miura;
    use crate::testing::gpu;

    /// An adapter of its own: it is going to be lost.
    fn fresh() -> Option<Gpu> {
        let choice = AdapterChoice::Named(gpu()?.adapter().to_string());
        Some(Gpu::open(&choice).expect("opened before"))
    }

    /// A fold on an adapter that is lost after so many reports of progress; how many there were.
    fn lost_after<S: GpuMethod + Clone>(method: &S, reports: usize) -> Option<(Failed, usize)> {
        let gpu = fresh()?;
        let (solver, model) = (gpu.with(method.clone()), miura());
        let start = State::perturbed(&model, 1e-3, 7);
        if reports == 0 {
            gpu.device().destroy();
        }
        let mut reported = 0;
        let scene = Scene::percent(60.0);
        let failed = solver.fold(&model, &start, &scene, &mut |_| {
            reported += 1;
            if reported == reports {
                gpu.device().destroy();
            }
            ControlFlow::Continue(())
        });
        let failed = failed.expect_err("it was lost");
        assert_eq!(failed.last_state(), &start, "what it began with is all that is known");
        let all = solver
            .fold_all(&[Instance { model: &model, start: start.clone(), scene }], &|_, _| ControlFlow::Continue(()));
        assert!(matches!(all[0], Err(Failed::Backend { .. })), "it stays lost");
        Some((failed, reported))
    }

    #[test]
    fn each_way_is_taken_by_some_sheet_and_told_by_its_name() {
        let Some(gpu) = gpu() else { return };
        let (plain, loose) = (miura(), crate::testing::sheets::loose_beams());
        let pattern = origami_core::generate::miura(20, 20).expect("valid");
        let large = Model::new(&pattern, &origami_core::Material::default()).expect("a generated pattern");
        let on = |dispatch| gpu.with(Relax::default()).dispatch(dispatch);
        for way in Dispatch::WAYS {
            assert_eq!(on(*way).way(&plain), *way, "{way}");
        }
        let bytes = |way| on(way).traffic(&plain).bytes_per_step();
        assert_eq!(bytes(Dispatch::Passes), Traffic::of_relax(&plain).bytes_per_step());
        assert_eq!(bytes(Dispatch::Blocks), Traffic::of_relax_in_blocks(&plain).bytes_per_step());
        assert_eq!(on(Dispatch::Workgroup).way(&loose), Dispatch::Workgroup, "loose beams are no hindrance");
        assert_eq!(on(Dispatch::Workgroup).way(&large), Dispatch::Passes, "no workgroup's memory holds it");
        assert!(bytes(Dispatch::Workgroup) < bytes(Dispatch::Blocks) / 10.0, "read once in many steps");
        assert!(Dispatch::WAYS.contains(&on(Dispatch::Auto).way(&plain)));
        let mut names: Vec<String> = Dispatch::WAYS.iter().map(ToString::to_string).collect();
        names.dedup();
        assert_eq!(names.len(), Dispatch::WAYS.len());
    }

    #[test]
    fn a_lost_device_is_an_error_with_the_last_state() {
        let methods =
            (Relax { steps: Some(5000), ..Relax::default() }, Dynamics { steps: Some(5000), ..Default::default() });
        for reports in [0, 1, 3] {
            for failed in [lost_after(&methods.0, reports), lost_after(&methods.1, reports)] {
                let Some((failed, reported)) = failed else { return };
                assert!(matches!(failed, Failed::Backend { last_read_step: 0, .. }), "{failed}");
                assert!(failed.to_string().starts_with("the GPU was lost"), "{failed}");
                assert!(reported < 40, "it did not run on: {reported} reports");
            }
        }
    }
}
