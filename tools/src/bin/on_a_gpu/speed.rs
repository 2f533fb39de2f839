//! The time of a step, from 9 vertices to 4 000 000: on every way that the library has, by the paper's own passes, and on
//! the processor.

use std::error::Error;
use std::sync::Arc;
use std::time::{Duration, Instant};

use origami::gpu::{Dispatch, GpuMethod, PaperDynamics, Traffic};
use origami::scene::Scene;
use origami::solve::{Method, Simulation, TimeStep};
use origami::{Model, Solver, State};

use crate::looks::Looks;
use crate::place::Place;
use crate::results::Row;
use crate::section::Ended;
use crate::sheets::{ENDLESS, PAPER, PERCENT, Processor, dynamics, relax, square, ways};

/// Panels along both sides: what is judged first, then what draws a curve, the largest last.
const PANELS: [usize; 12] = [999, 31, 315, 99, 9, 2, 177, 55, 17, 4, 562, 1999];
const REHEARSED: [usize; 2] = [2, 9];

/// Steps of the paper's passes between two reads of the state, which are in the time.
const READ_EVERY: u64 = 1000;

/// Measures sheet after sheet.
///
/// # Errors
/// If a sheet cannot be built or a figure not be written.
pub(crate) fn measure(place: &Place) -> Result<Ended, Box<dyn Error>> {
    let sizes = if place.rehearse { &REHEARSED[..] } else { &PANELS[..] };
    for panels in sizes {
        if place.is_over() {
            return Ok(Ended::Cut);
        }
        let model = Arc::new(square(*panels)?);
        // Both solvers can go the same ways.
        let of = Sheet { place, model: &model, ways: ways(&place.gpu, &relax(ENDLESS), &model) };
        of.on_gpu("dynamics", &dynamics(ENDLESS))?;
        of.on_gpu("relax", &relax(ENDLESS))?;
        of.by_the_papers_passes()?;
        for processor in Processor::ALL {
            of.on_processor("dynamics", processor, processor.dynamics(dynamics(ENDLESS)))?;
            of.on_processor("relax", processor, processor.relax(relax(ENDLESS)))?;
        }
    }
    Ok(if place.is_over() { Ended::Cut } else { Ended::Whole })
}

/// A sheet, and where it is measured.
struct Sheet<'a> {
    place: &'a Place,
    model: &'a Arc<Model>,
    ways: Vec<(String, Dispatch)>,
}

impl Sheet<'_> {
    fn add(&self, solver: &str, by: &str, quantity: &str, value: f64) -> Result<(), Box<dyn Error>> {
        self.place.add(Row {
            sheet: "miura".into(),
            vertices: self.model.node_count(),
            sheets: 1,
            solver: solver.to_owned(),
            by: by.to_owned(),
            quantity: quantity.to_owned(),
            value,
            ..Row::default()
        })
    }

    fn on_gpu<S: GpuMethod + Clone + 'static>(&self, solver: &str, method: &S) -> Result<(), Box<dyn Error>> {
        for (by, way) in &self.ways {
            if self.place.is_over() {
                return Ok(());
            }
            let on_gpu = self.place.gpu.with(method.clone()).dispatch(*way);
            let traffic = on_gpu.traffic(self.model);
            self.add(solver, by, "memory, bytes", traffic.memory() as f64)?;
            self.add(solver, by, "bytes a step", traffic.bytes_per_step())?;
            self.look(solver, by, &on_gpu)?;
        }
        Ok(())
    }

    fn by_the_papers_passes(&self) -> Result<(), Box<dyn Error>> {
        let paper = PaperDynamics {
            gpu: self.place.gpu.clone(),
            time_step: TimeStep::Paper,
            steps: ENDLESS,
            read_every: if self.place.rehearse { 100 } else { READ_EVERY },
        };
        self.add("dynamics", PAPER, "bytes a step", Traffic::of_paper(self.model).bytes_per_step())?;
        self.look("dynamics", PAPER, &paper)
    }

    /// Looks at a run of a solver on the GPU. A sheet that does not fit is told of, and left out.
    fn look(&self, solver: &str, by: &str, on_gpu: &dyn Solver) -> Result<(), Box<dyn Error>> {
        if self.place.is_over() {
            return Ok(());
        }
        let mut looks = Looks::new(self.place.lasting(), self.place.deadline);
        let (start, scene) = (State::at_rest(self.model), Scene::percent(PERCENT));
        let began = Instant::now();
        if let Err(error) = on_gpu.fold(self.model, &start, &scene, &mut |progress| looks.look(progress)) {
            println!("{} vertices, {solver}, {by}: {error}", self.model.node_count());
            return Ok(());
        }
        if let Some(seconds) = looks.seconds_a_step() {
            self.add(solver, by, "seconds a step", seconds)?;
            self.add(solver, by, "seconds, all of it", began.elapsed().as_secs_f64())?;
        }
        Ok(())
    }

    /// Asks a simulation for some steps at a time.
    fn on_processor<M: Method>(&self, solver: &str, processor: Processor, method: M) -> Result<(), Box<dyn Error>> {
        if self.place.is_over() {
            return Ok(());
        }
        let start = State::at_rest(self.model);
        let mut simulation = Simulation::in_scene(Arc::clone(self.model), method, &Scene::percent(PERCENT), start)?;
        // So many that a clock tells them, and that a deadline is noticed.
        let some = (300_000 / self.model.node_count() as u64).clamp(1, 1000);
        let (began, lasting) = (Instant::now(), self.place.lasting());
        while began.elapsed() < lasting.min(Duration::from_millis(100)) {
            simulation.step(some)?;
        }
        let (began, mut steps) = (Instant::now(), 0);
        while steps < 2 * some || began.elapsed() < lasting {
            simulation.step(some)?;
            steps += some;
        }
        self.add(solver, &processor.name(), "seconds a step", began.elapsed().as_secs_f64() / steps as f64)
    }
}
