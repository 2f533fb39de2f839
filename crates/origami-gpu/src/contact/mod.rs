//! Relaxation under contact on a GPU.

mod run;

use std::ops::ControlFlow;

use origami_core::contact::{Contact, Crossings, PairList};
use origami_core::model::{Inventory, Model};
use origami_core::scene::{Refusal, Scene};
use origami_core::solve::attempt::Attempt;
use origami_core::solve::{
    ContactRelax, Failed, Folded, Instance, Progress, Session, Solver, State, Touch, Touching, contact_patience,
};

use crate::device::Gpu;
use crate::engine::Engine;
use crate::error::{GPU, GpuError};
use crate::outcome::backend;
use crate::outside::Outside;
use crate::run::Beginning;
use crate::variant::InContact;
use crate::{inventory, relax, single};
use run::{End, Run};

/// The least gap that f32 bears, in radii. Distances come with an error of some 5e-8 where edges are as long as the sheet.
const LEAST_GAP: f64 = 1e-4;

impl Gpu {
    /// `method` computed here instead of on the processor.
    pub fn with_contact(&self, method: ContactRelax) -> ContactOnGpu {
        ContactOnGpu { gpu: self.clone(), method }
    }
}

/// [`ContactRelax`] on a GPU, with the same settings and the same result up to f32: a sheet that cannot go through itself.
///
/// It goes by passes over all elements, one sheet at a time. The processor lists the pairs that may touch, anew as often as it
/// would for itself; forces, moves and how they are shortened are the GPU's. Every state that is read, also for a list, goes
/// through the exact test for crossings in double precision, and one that is crossed is an error, [`GpuError::Crossed`].
///
/// [`Relax::precision`](origami_core::Relax::precision) and `threads` have no meaning here.
#[derive(Clone, Debug)]
pub struct ContactOnGpu {
    gpu: Gpu,
    method: ContactRelax,
}

impl ContactOnGpu {
    /// The solver's settings.
    pub fn method(&self) -> &ContactRelax {
        &self.method
    }

    /// The same with one model's buffers and pipelines kept, for more than one fold.
    pub fn on<'a>(&'a self, model: &'a Model) -> ContactOnModel<'a> {
        ContactOnModel { gpu: &self.gpu, method: self.method.clone(), model, engine: None }
    }
}

impl Solver for ContactOnGpu {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.fold_touching(model, start, scene, observe).map(|(folded, _)| folded)
    }

    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(self.on(model))
    }

    /// One after the other.
    fn fold_each(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
        take: &(dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync),
    ) {
        let _ = instances.iter().enumerate().try_for_each(|(i, instance)| {
            take(i, self.fold(instance.model, &instance.start, &instance.scene, &mut |progress| observe(i, progress)))
        });
    }

    fn inventory(&self, model: &Model) -> Inventory {
        inventory::in_contact(model, self.method.inventory(model), self.method.contact)
    }
}

impl Touching for ContactOnGpu {
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        self.on(model).fold_touching(start, scene, observe)
    }
}

/// A [`Session`] under contact on a GPU. The sheet is moved off every symmetry once, not at each fold.
#[derive(Debug)]
pub struct ContactOnModel<'a> {
    gpu: &'a Gpu,
    method: ContactRelax,
    model: &'a Model,
    engine: Option<Engine>,
}

impl Session for ContactOnModel<'_> {
    fn fold(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.fold_touching(start, scene, observe).map(|(folded, _)| folded)
    }
}

impl ContactOnModel<'_> {
    /// As [`Session::fold`], and what contact did.
    ///
    /// # Errors
    /// As [`Touching::fold_touching`].
    pub fn fold_touching(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        let instance = Instance { model: self.model, start: start.clone(), scene: scene.clone() };
        let refused = |refusal| Failed::refused(refusal, start);
        let beginning = self.beginning(&instance).map_err(refused)?;
        let mut list = PairList::new(&self.model.mesh, &self.model.rest, self.method.contact);
        list.list(&beginning.state.positions);
        if list.least_gap() <= 0.0 {
            return Err(refused(Refusal::Closed { gap: list.least_gap() }));
        }
        let longest_move = list.longest_move();
        let mut run = Run::new(&instance, &beginning, list);
        let steps_asked = self.method.relax.steps.is_some();
        let gone = self.engine(scene, longest_move).and_then(|engine| {
            engine.load(0, &[beginning])?;
            engine.forget_contact()?;
            let stands = run.go(engine, observe)?;
            run.end(engine, stands, steps_asked)
        });
        match gone {
            Ok(End::Came(came)) => {
                if start.targets != came.state.targets {
                    self.method.relax.perturbation = 0.0;
                }
                Ok(came.measured((self.model, scene), self.method.contact))
            }
            Ok(End::Diverged(failed)) => Err(*failed),
            Err(error) => Err(backend(error, &run.last, run.at)),
        }
    }

    /// Where the sheet begins, if this can fold it.
    fn beginning<'m>(&self, instance: &Instance<'m>) -> Result<Beginning<'m>, Refusal> {
        check(&self.method)?;
        let targets = relax::targets(instance)?;
        let relax = &self.method.relax;
        let attempt = relax.first_attempt((instance.model, &instance.scene), &instance.start, &targets);
        let beginning = relax::beginning(relax, instance, &targets, Attempt { softening: None, ..attempt });
        let crossings = Crossings::of(&instance.model.mesh, &beginning.state.positions);
        match crossings.faces.first() {
            Some([one, other]) => Err(Refusal::Crossed { faces: [*one, *other] }),
            None => Ok(beginning),
        }
    }

    /// The engine, built once more where a scene brings supports or loads for which it has no room.
    fn engine(&mut self, scene: &Scene, longest_move: f64) -> Result<&mut Engine, GpuError> {
        let before = self.engine.take();
        let engine = match before {
            Some(engine) if engine.outside().covers(scene) => engine,
            before => {
                let outside = before.map_or_else(Outside::default, |engine| engine.outside()).with(scene);
                let contact = InContact {
                    stiffness: self.method.contact.stiffness,
                    thick: self.method.contact.thickness > 0.0,
                    longest_move,
                    patience: contact_patience(self.model),
                };
                Engine::in_contact(self.gpu, self.model, &outside, contact)?
            }
        };
        Ok(self.engine.insert(engine))
    }
}

/// Whether f32 can compute with the settings.
fn check(method: &ContactRelax) -> Result<(), Refusal> {
    let Contact { gap, stiffness, thickness } = method.contact;
    for (what, value) in [("gap", gap), ("stiffness", stiffness)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(Refusal::Contact { what, value });
        }
    }
    if !(thickness.is_finite() && thickness >= 0.0) {
        return Err(Refusal::Contact { what: "thickness", value: thickness });
    }
    if gap < LEAST_GAP {
        let what = "contact gap in radii".to_owned();
        return Err(Refusal::TooWide { what, value: gap, backend: GPU, least: LEAST_GAP, most: 1e30 });
    }
    single::check("contact stiffness", stiffness)?;
    single::check("contact thickness", thickness)?;
    single::check("tolerance", method.relax.tolerance)
}

#[cfg(test)]
mod tests {
    use origami_core::solve::{Relax, Stop, unwatched};

    use super::*;
    use crate::testing::gpu;
    use crate::testing::layers::model;

    /// How far a fold angle may be from the processor's, in degrees: where layers touch, sheets slide a little.
    const ANGLE: f64 = 1.0;

    /// Largest difference between two lists of angles, in degrees.
    fn apart(a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - b).abs().to_degrees()).fold(0.0, f64::max)
    }

    #[test]
    fn sheets_come_to_the_states_of_the_processor_without_crossings() {
        let Some(gpu) = gpu() else { return };
        let solver = ContactRelax::default();
        let on_gpu = gpu.with_contact(solver.clone());
        for name in ["bird-base", "square-twist", "miura", "waterbomb"] {
            let model = model(name);
            let start = State::at_rest(&model);
            let mut session = on_gpu.on(&model);
            for percent in [60.0, 100.0] {
                let scene = Scene::percent(percent);
                // Each from rest, with the same buffers.
                session.method = solver.clone();
                let begun = std::time::Instant::now();
                let (own, touch) = session.fold_touching(&start, &scene, &mut unwatched).expect("it folds");
                let seconds = begun.elapsed().as_secs_f64();
                let (cpu, plain) = solver.fold_touching(&model, &start, &scene, &mut unwatched).expect("it folds");
                let far = apart(&own.state.fold_angles, &cpu.state.fold_angles);
                println!(
                    "{name} at {percent} %: {} and {} evaluations, angles {far:.4} degrees apart, gaps {:.1e} and {:.1e}, pairs {} and {}, {seconds:.2} s",
                    own.steps, cpu.steps, touch.least_gap, plain.least_gap, touch.most_pairs, plain.most_pairs,
                );
                assert_eq!((own.stop, cpu.stop), (Stop::Converged, Stop::Converged), "{name} at {percent} %");
                assert!(far < ANGLE, "{name} at {percent} %: {far} degrees");
                assert!(Crossings::of(&model.mesh, &own.state.positions).is_empty(), "{name} at {percent} %");
                assert_eq!(touch.least_gap.is_finite(), percent > 99.0, "{name} at {percent} %");
            }
        }
    }

    #[test]
    fn a_crane_is_blocked_by_the_faces_that_press() {
        let Some(gpu) = gpu() else { return };
        let model = model("crane");
        let solver = gpu.with_contact(ContactRelax::default());
        let begun = std::time::Instant::now();
        let folded = solver.fold_touching(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched);
        let (folded, touch) = folded.expect("it folds");
        println!(
            "crane: {} evaluations, {} limited, {:?} {:.1} s",
            folded.steps,
            touch.limited,
            touch.pressing.first(),
            begun.elapsed().as_secs_f64()
        );
        assert_eq!(folded.stop, Stop::Blocked);
        assert!(touch.pressing.first().is_some_and(|hardest| hardest.force > 0.0 && hardest.gap > 0.0));
        assert!(touch.first_limited.is_some_and(|share| share > 0.3 && share < 1.0), "{:?}", touch.first_limited);
        assert!(touch.farthest.is_some_and(|(_, off)| off > 10_f64.to_radians()));
    }

    #[test]
    fn equal_input_gives_equal_bits_whatever_is_submitted_at_once() {
        let Some(gpu) = gpu() else { return };
        let model = model("square-twist");
        let relax = Relax { steps: Some(700), ..Relax::default() };
        let solver = gpu.with_contact(ContactRelax { relax, ..ContactRelax::default() });
        let mut session = solver.on(&model);
        let fold = |session: &mut ContactOnModel<'_>| {
            session.method.relax.perturbation = 1e-2;
            let folded = session.fold_touching(&State::at_rest(&model), &Scene::percent(100.0), &mut unwatched);
            let (folded, touch) = folded.expect("it folds");
            assert_eq!((folded.stop, folded.steps), (Stop::StepsDone, 700));
            assert!(touch.limited > 0);
            (folded.state, touch)
        };
        assert_eq!(fold(&mut session), fold(&mut session));
    }

    #[test]
    fn what_f32_does_not_bear_is_refused_by_name() {
        let Some(gpu) = gpu() else { return };
        let model = model("bird-base");
        let told = |contact: Contact, start: &State| {
            let relax = Relax { perturbation: 0.0, ..Relax::default() };
            let solver = gpu.with_contact(ContactRelax { relax, contact });
            let failed =
                solver.fold_touching(&model, start, &Scene::percent(50.0), &mut unwatched).expect_err("refused");
            assert!(matches!(failed, Failed::Refused { .. }), "{failed}");
            failed.to_string()
        };
        let flat = State::at_rest(&model);
        let gap = told(Contact { gap: 1e-5, ..Contact::default() }, &flat);
        assert!(gap.contains("contact gap in radii: 1e-5") && gap.contains("f32"), "{gap}");
        let gap = told(Contact::thick(5e-4), &flat);
        assert!(gap.contains("contact gap"), "a tenth of the thickness: {gap}");
        let stiff = told(Contact { stiffness: 1e40, ..Contact::default() }, &flat);
        assert!(stiff.contains("contact stiffness: 1e40"), "{stiff}");
        assert!(told(Contact { gap: f64::NAN, ..Contact::default() }, &flat).contains("gap NaN"));
        // Folded as far as it goes without contact.
        let crossed = Relax::default().fold_from_rest(&model, 100.0).expect("it folds").state;
        assert!(told(Contact::default(), &crossed).contains("cross where it begins"));
    }

    #[test]
    fn sheets_with_thickness_keep_it() {
        let Some(gpu) = gpu() else { return };
        let model = model("strip");
        let contact = Contact::thick(0.01);
        let solver = ContactRelax { contact, ..ContactRelax::default() };
        let fold = |solver: &dyn Touching| {
            let folded = solver.fold_touching(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched);
            folded.expect("it folds")
        };
        let ((own, touch), (cpu, _)) = (fold(&gpu.with_contact(solver.clone())), fold(&solver));
        assert_eq!(own.stop, cpu.stop);
        let far = apart(&own.state.fold_angles, &cpu.state.fold_angles);
        println!(
            "strip, thick: {} {} evaluations, {far:.4} degrees apart, gap {:.1e}",
            own.steps, cpu.steps, touch.least_gap
        );
        assert!(far < ANGLE && touch.least_gap > 0.0, "{far}");
    }
}
