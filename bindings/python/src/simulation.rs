//! `Simulation`: a sheet that is stepped, steered and watched.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use numpy::{PyArray1, PyArray2};
use origami::measure::attitude::Hold;
use origami::scene::Targets;
use origami::solve::{Failed, Pin, Report, Saved, Units};
use origami::{Dynamics, Relax, Scene, State};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use pythonize::{depythonize, pythonize};

use crate::arrays::{Numbers, rows, vectors};
use crate::backend::Computer;
use crate::errors::refused;
use crate::failures::failed;
use crate::folded::{Folded, Reactions, reactions};
use crate::model::{Model, model_of};
use crate::run::Run;
use crate::scene::{loads, scene, targets, vector};
use crate::settings::Method;
use crate::watch::Watch;

/// Python is asked between pieces of about this length.
const PIECE: Duration = Duration::from_millis(50);

/// A sheet in motion.
#[pyclass(module = "origami_sim._native", weakref)]
pub(crate) struct Simulation {
    model: Py<Model>,
    solver: Py<PyAny>,
    inner: Moved,
    /// Vertices that are pinned.
    pins: BTreeMap<usize, Pin>,
    /// Seconds that its steps took.
    seconds: f64,
}

/// A simulation by whichever method.
enum Moved {
    Relax(origami::Simulation<Relax>),
    Dynamics(origami::Simulation<Dynamics>),
}

/// The same call on either.
macro_rules! moved {
    ($moved:expr, $simulation:ident => $call:expr) => {
        match $moved {
            Moved::Relax($simulation) => $call,
            Moved::Dynamics($simulation) => $call,
        }
    };
}

impl Moved {
    /// Steps in pieces, between which Python is asked whether to go on.
    fn advance(&mut self, steps: u64, settle: bool, watch: &mut Watch) -> Result<Report, Failed> {
        let (mut left, mut piece) = (steps, 64);
        let mut report = moved!(self, simulation => simulation.report());
        while left > 0 {
            let begun = Instant::now();
            let now = left.min(piece);
            report = moved!(self, simulation => if settle { simulation.settle(now) } else { simulation.step(now) })?;
            left -= now;
            if begun.elapsed() < PIECE / 2 {
                piece *= 2;
            }
            if (settle && report.settled) || watch.ask_python().is_break() {
                break;
            }
        }
        Ok(report)
    }
}

impl Simulation {
    fn error(&self, py: Python<'_>, error: &Failed) -> PyErr {
        failed(&self.model.bind(py).get().sheet, error)
    }

    fn advance<'py>(&mut self, py: Python<'py>, steps: u64, settle: bool) -> PyResult<Bound<'py, PyDict>> {
        let begun = Instant::now();
        let mut watch = Watch::new(None);
        let moved = &mut self.inner;
        let report = py.detach(|| moved.advance(steps, settle, &mut watch));
        self.seconds += begun.elapsed().as_secs_f64();
        watch.finish()?;
        let report = report.map_err(|error| self.error(py, &error))?;
        to_dict(py, report)
    }

    fn pinned(&self, vertex: usize) -> PyResult<Pin> {
        let pins = self.pins.keys().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let expected =
            if pins.is_empty() { "one that is pinned; none is".to_owned() } else { format!("one of {pins}") };
        self.pins.get(&vertex).copied().ok_or_else(|| refused("vertex", &vertex.to_string(), &expected))
    }

    fn set(&mut self, py: Python<'_>, targets: Targets) -> PyResult<()> {
        let moved = &mut self.inner;
        py.detach(|| moved!(moved, simulation => simulation.set_targets(targets)))
            .map_err(|error| self.error(py, &error))
    }
}

#[pymethods]
impl Simulation {
    /// sheet: a `Model`, or a `Pattern`, which is then made of the default `Material`.
    /// solver: a `Dynamics` or a `Relax`. Default: `Dynamics()`.
    /// percent: how far the creases are asked to fold. Default: as they lie.
    /// start, supports, loads: as of `relax`.
    #[new]
    #[pyo3(signature = (sheet, solver=None, *, percent=None, start=None, supports=None, loads=None))]
    fn new(
        sheet: &Bound<'_, PyAny>,
        solver: Option<Bound<'_, PyAny>>,
        percent: Option<f64>,
        start: Option<&Bound<'_, Folded>>,
        supports: Option<&Bound<'_, PyDict>>,
        loads: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let py = sheet.py();
        let solver = solver.map_or_else(|| py.import("origami_sim.settings")?.call_method0("Dynamics"), Ok)?;
        let method = Method::of(&solver)?;
        let model = model_of(sheet, &method)?;
        let sheet = &model.get().sheet;
        let asked = percent.map_or_else(Targets::at_rest, Targets::percent);
        let scene = scene(sheet, asked, supports, loads)?;
        let start = match start {
            Some(folded) => folded.get().start_of(sheet)?.clone(),
            None => State::at_rest(&sheet.model),
        };
        let own = sheet.model.clone();
        let inner = match method {
            Method::Relax(relax) => {
                py.detach(|| origami::Simulation::in_scene(own, relax, &scene, start)).map(Moved::Relax)
            }
            Method::Dynamics(dynamics) => {
                py.detach(|| origami::Simulation::in_scene(own, dynamics, &scene, start)).map(Moved::Dynamics)
            }
            #[cfg(feature = "newton")]
            Method::Newton(_) => return Err(refused("solver", "Newton takes no steps", "Relax or Dynamics")),
        };
        let inner = inner.map_err(|error| failed(sheet, &error))?;
        Ok(Self { model: model.unbind(), solver: solver.unbind(), inner, pins: BTreeMap::new(), seconds: 0.0 })
    }

    /// The sheet.
    #[getter]
    fn model(&self, py: Python<'_>) -> Py<Model> {
        self.model.clone_ref(py)
    }

    /// What moves it.
    #[getter]
    fn solver(&self, py: Python<'_>) -> Py<PyAny> {
        self.solver.clone_ref(py)
    }

    /// Takes so many steps, settled or not: {steps, settled, distance, ramp}, as of `report`. Ctrl-C ends it.
    fn step<'py>(&mut self, py: Python<'py>, steps: u64) -> PyResult<Bound<'py, PyDict>> {
        self.advance(py, steps, false)
    }

    /// Steps until the sheet has settled, but at most so many times. The rest is as for `step`.
    #[pyo3(signature = (most_steps=100_000))]
    fn settle<'py>(&mut self, py: Python<'py>, most_steps: u64) -> PyResult<Bound<'py, PyDict>> {
        self.advance(py, most_steps, true)
    }

    /// How far it has come: {steps (so far), settled (within the tolerance of the equilibrium), distance (estimated, in radii),
    /// ramp (share of the way to the targets, 0 to 1)}.
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        to_dict(py, moved!(&self.inner, simulation => simulation.report()))
    }

    /// How far the creases are asked to fold; None for other targets. Setting it steers the sheet.
    #[getter]
    fn percent(&self) -> Option<f64> {
        moved!(&self.inner, simulation => simulation.targets().label())
    }

    #[setter]
    fn set_percent(&mut self, py: Python<'_>, percent: f64) -> PyResult<()> {
        self.set(py, Targets::percent(percent))
    }

    /// Asks each crease of the model for an angle, of shape (creases,), in radians.
    fn set_targets(&mut self, py: Python<'_>, angles: Numbers<'_>) -> PyResult<()> {
        let targets = targets(&self.model.bind(py).get().sheet, 0.0, Some(&angles))?;
        self.set(py, targets)
    }

    /// Holds a vertex where it is.
    fn pin(&mut self, py: Python<'_>, vertex: usize) -> PyResult<()> {
        let node = self.model.bind(py).get().sheet.node("vertex", vertex)?;
        let pin =
            moved!(&mut self.inner, simulation => simulation.pin(node)).map_err(|error| self.error(py, &error))?;
        self.pins.insert(vertex, pin);
        Ok(())
    }

    /// Puts a pinned vertex elsewhere: (x, y, z) in the file's unit.
    fn move_pin(&mut self, py: Python<'_>, vertex: usize, position: &Bound<'_, PyAny>) -> PyResult<()> {
        let pin = self.pinned(vertex)?;
        let place = self.model.bind(py).get().sheet.to_model(vector("position", position)?.to_array());
        moved!(&mut self.inner, simulation => simulation.move_pin(pin, place)).map_err(|error| self.error(py, &error))
    }

    /// Lets a pinned vertex go.
    fn unpin(&mut self, py: Python<'_>, vertex: usize) -> PyResult<()> {
        let pin = self.pinned(vertex)?;
        moved!(&mut self.inner, simulation => simulation.unpin(pin)).map_err(|error| self.error(py, &error))?;
        self.pins.remove(&vertex);
        Ok(())
    }

    /// Vertices that are pinned.
    #[getter]
    fn pins(&self) -> Vec<usize> {
        self.pins.keys().copied().collect()
    }

    /// Takes other dead loads: {vertex: (fx, fy, fz)}, in the model's unit of force.
    fn set_loads(&mut self, py: Python<'_>, loads: &Bound<'_, PyDict>) -> PyResult<()> {
        let loads = self::loads(&self.model.bind(py).get().sheet, loads)?;
        moved!(&mut self.inner, simulation => simulation.set_loads(loads)).map_err(|error| self.error(py, &error))
    }

    /// Positions of the pattern's vertices, of shape (vertices, 3), in the file's unit.
    #[getter]
    fn positions<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let state =
            moved!(&mut self.inner, simulation => simulation.state()).map_err(|error| self.error(py, &error))?;
        let sheet = &self.model.bind(py).get().sheet;
        vectors(py, sheet.model.file_positions(sheet.pattern(), &state.positions))
    }

    /// Positions of the vertices that are part of the sheet, of shape (nodes, 3), in the file's unit and single precision: what a
    /// viewer draws from.
    fn node_positions_f32<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let count = self.model.bind(py).get().sheet.model.node_count();
        let mut numbers = vec![[0.0_f32; 3]; count];
        let written = moved!(&mut self.inner, simulation => {
            simulation.positions().map(|positions| positions.write_f32(Units::File, numbers.as_flattened_mut()))
        });
        written.map_err(|error| self.error(py, &error))?;
        rows(py, numbers)
    }

    /// The angle reached by each crease of the model, of shape (creases,), in radians.
    #[getter]
    fn crease_angles<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let state =
            moved!(&mut self.inner, simulation => simulation.state()).map_err(|error| self.error(py, &error))?;
        Ok(PyArray1::from_vec(py, state.fold_angles))
    }

    /// What supports, pins and fixed vertices bear: the vertices, of shape (held,), and the forces on them, of shape (held, 3).
    #[getter]
    fn reactions<'py>(&mut self, py: Python<'py>) -> PyResult<Reactions<'py>> {
        let all =
            moved!(&mut self.inner, simulation => simulation.reactions()).map_err(|error| self.error(py, &error))?;
        reactions(py, &self.model.bind(py).get().sheet, &all)
    }

    /// The state that it came to, measured: a `Folded`. The simulation can go on.
    fn finish(&self, py: Python<'_>) -> PyResult<Folded> {
        let sheet = &self.model.bind(py).get().sheet;
        let method = Method::of(self.solver.bind(py))?;
        let computer = Computer::processor(&method);
        let folded =
            moved!(&self.inner, simulation => simulation.clone().finish()).map_err(|error| self.error(py, &error))?;
        let run = Run::new(&computer, sheet, &Scene::default(), Hold::Nothing, self.seconds);
        Ok(Folded::new(self.model.clone_ref(py), folded, run))
    }

    fn __repr__(&self) -> String {
        let report = moved!(&self.inner, simulation => simulation.report());
        format!("<Simulation after {} steps>", report.steps)
    }

    fn __reduce__<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        // What is saved takes pins for supports, which could not be let go: they are taken out, and put back by `resume`.
        let saved = moved!(&mut self.inner, simulation => {
            let mut free = simulation.clone();
            self.pins.values().try_for_each(|pin| free.unpin(*pin)).and_then(|()| free.save())
        });
        let saved = saved.map_err(|error| self.error(py, &error))?;
        let resume = py.import("origami_sim._native")?.getattr("resume")?;
        let pins: Vec<usize> = self.pins.keys().copied().collect();
        let parts = (self.model.clone_ref(py), self.solver.clone_ref(py), pythonize(py, &saved)?, pins);
        (resume, parts).into_pyobject(py)
    }
}

/// Goes on with a pickled `Simulation`, bit for bit; where it has pins, its estimate of the distance begins anew.
#[pyfunction]
pub(crate) fn resume(
    model: &Bound<'_, Model>,
    solver: Bound<'_, PyAny>,
    saved: &Bound<'_, PyAny>,
    pinned: Vec<usize>,
) -> PyResult<Simulation> {
    let py = model.py();
    let saved: Saved = depythonize(saved)?;
    let sheet = &model.get().sheet;
    let (own, scene) = (sheet.model.clone(), Scene::default());
    let inner = match Method::of(&solver)? {
        Method::Relax(relax) => origami::Simulation::restore(own, relax, &scene, &saved).map(Moved::Relax),
        Method::Dynamics(dynamics) => origami::Simulation::restore(own, dynamics, &scene, &saved).map(Moved::Dynamics),
        #[cfg(feature = "newton")]
        Method::Newton(_) => {
            return Err(crate::errors::refused_as("solver: Newton takes no steps; expected Relax or Dynamics"));
        }
    };
    let inner = inner.map_err(|error| failed(sheet, &error))?;
    let mut simulation = Simulation {
        model: model.clone().unbind(),
        solver: solver.unbind(),
        inner,
        pins: BTreeMap::new(),
        seconds: 0.0,
    };
    pinned.into_iter().try_for_each(|vertex| simulation.pin(py, vertex))?;
    Ok(simulation)
}

fn to_dict(py: Python<'_>, report: Report) -> PyResult<Bound<'_, PyDict>> {
    let Report { steps, settled, distance, ramp } = report;
    let dict = PyDict::new(py);
    dict.set_item("steps", steps)?;
    dict.set_item("settled", settled)?;
    dict.set_item("distance", distance)?;
    dict.set_item("ramp", ramp)?;
    Ok(dict)
}
