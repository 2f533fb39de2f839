//! Many sheets at once: the time of a step of all, and the time until all are folded.

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::Instant;

use origami::scene::Scene;
use origami::solve::Instance;
use origami::{Model, Relax, Solver, State};

use crate::looks::Looks;
use crate::place::Place;
use crate::results::Row;
use crate::section::Ended;
use crate::sheets::{self, ENDLESS, on, square, ways};

const BIRDS: [usize; 7] = [1, 1024, 4096, 256, 64, 16, 4];
const MIURAS: [usize; 5] = [1, 256, 64, 16, 4];

/// Measures bird bases, then Miura sheets of 1 024 vertices.
///
/// # Errors
/// If a sheet cannot be built or a figure not be written.
pub(crate) fn measure(place: &Place) -> Result<Ended, Box<dyn Error>> {
    let bird = ("bird-base", sheets::model(("bird-base", &[]))?, &BIRDS[..]);
    let miura = ("miura", square(31)?, &MIURAS[..]);
    for (name, model, counts) in [bird, miura] {
        for count in counts {
            if place.is_over() {
                return Ok(Ended::Cut);
            }
            if !place.rehearse || *count * model.node_count() < 300 {
                Ensemble { place, name, model: &model, count: *count }.measure()?;
            }
        }
    }
    Ok(Ended::Whole)
}

/// So many sheets of a model.
struct Ensemble<'a> {
    place: &'a Place,
    name: &'a str,
    model: &'a Model,
    count: usize,
}

impl Ensemble<'_> {
    fn measure(&self) -> Result<(), Box<dyn Error>> {
        let relax = Relax::default();
        for (by, way) in ways(&self.place.gpu, &relax, self.model) {
            self.step(&by, &*on(&self.place.gpu, sheets::relax(ENDLESS), way))?;
            self.fold(&by, &*on(&self.place.gpu, relax.clone(), way))?;
        }
        self.fold("CPU, f64, all threads", &relax)
    }

    /// All the same but for how far they are to be folded.
    fn instances(&self) -> Vec<Instance<'_>> {
        let percent = |i: usize| 50.0 + 30.0 * i as f64 / self.count as f64;
        let start = State::at_rest(self.model);
        let instance = |i| Instance { model: self.model, start: start.clone(), scene: Scene::percent(percent(i)) };
        (0..self.count).map(instance).collect()
    }

    fn step(&self, by: &str, solver: &dyn Solver) -> Result<(), Box<dyn Error>> {
        let looks = Mutex::new(Looks::new(self.place.lasting(), self.place.deadline));
        // Who breaks one off breaks off all.
        solver.fold_all(&self.instances(), &|i, progress| match (i, looks.lock()) {
            (0, Ok(mut looks)) => looks.look(progress),
            _ => ControlFlow::Continue(()),
        });
        let looks = looks.into_inner().map_err(|_| "a look failed")?;
        looks.seconds_a_step().map_or(Ok(()), |seconds| self.add(by, "seconds a step of all", seconds))
    }

    fn fold(&self, by: &str, solver: &dyn Solver) -> Result<(), Box<dyn Error>> {
        if self.place.is_over() {
            return Ok(());
        }
        let (instances, began) = (self.instances(), Instant::now());
        let results = solver.fold_all(&instances, &|_, _| match self.place.is_over() {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        });
        let seconds = began.elapsed().as_secs_f64();
        let converged = results.iter().flatten().filter(|folded| folded.converged()).count();
        // What was broken off tells nothing.
        if self.place.is_over() {
            return Ok(());
        }
        self.add(by, "seconds until all are folded", seconds)?;
        self.add(by, "sheets converged", converged as f64)
    }

    fn add(&self, by: &str, quantity: &str, value: f64) -> Result<(), Box<dyn Error>> {
        self.place.add(Row {
            sheet: self.name.to_owned(),
            vertices: self.model.node_count(),
            sheets: self.count,
            solver: "relax".into(),
            by: by.to_owned(),
            quantity: quantity.to_owned(),
            value,
            ..Row::default()
        })
    }
}
