//! `Structure`: a sheet as bars and hinges that are held and loaded, with gradients of its states.

use numpy::{PyArray1, PyArray2};
use origami::Relax;
use origami::analysis::job::{Job, Setup};
use origami::analysis::{Refused, Structure as Members, Trace};
use origami::glam::DVec3;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use serde_json::Value;

use crate::analysis::{self, Table};
use crate::arrays::{Numbers, Rows, rows, to_numbers, to_vectors, vectors};
use crate::errors::{OrRaise, refused, refused_as};
use crate::folded::Folded;
use crate::model::{Model, model_of};
use crate::settings::Method;
use crate::watch::Watch;

/// Bars and hinges with supports and loads, in the units of the job: a sheet for structural analysis (docs/ANALYSIS.md).
///
/// Nodes, bars and hinges are numbered as the vertices, beams and creases of the model; `vertices` has the vertex of each node.
#[pyclass(frozen, module = "origami_sim._native", weakref)]
pub(crate) struct Structure {
    model: Py<Model>,
    job: Job,
    setup: Setup,
}

/// Where a structure is: positions of its nodes, and the angles of its hinges, which know whole turns.
#[pyclass(frozen, module = "origami_sim._native", weakref)]
pub(crate) struct Configuration {
    at: origami::analysis::Configuration,
    load_factor: f64,
}

#[pymethods]
impl Configuration {
    /// positions: shape (nodes, 3), in the structure's unit of length.
    /// fold_angles: shape (hinges,), in radians, valleys positive.
    /// load_factor: by how much the loads are multiplied there. Default 0.
    #[new]
    #[pyo3(signature = (positions, fold_angles, load_factor=0.0))]
    fn new(positions: Rows<'_>, fold_angles: Numbers<'_>, load_factor: f64) -> PyResult<Self> {
        let positions = to_vectors("positions", &positions)?;
        let fold_angles = fold_angles.as_array().to_vec();
        Ok(Self { at: origami::analysis::Configuration { positions, fold_angles }, load_factor })
    }

    /// Positions of the nodes, of shape (nodes, 3), in the structure's unit of length. A new array each time.
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        vectors(py, self.at.positions.clone())
    }

    /// Angles of the hinges, of shape (hinges,), in radians, valleys positive. A new array each time.
    #[getter]
    fn fold_angles<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.at.fold_angles)
    }

    /// By how much the loads, and the ways of moved supports, are multiplied here.
    #[getter]
    fn load_factor(&self) -> f64 {
        self.load_factor
    }

    fn __repr__(&self) -> String {
        format!("<Configuration of {} nodes at load factor {}>", self.at.positions.len(), self.load_factor)
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let py = this.py();
        let own = this.get();
        (py.get_type::<Self>(), (own.positions(py)?, own.fold_angles(py), own.load_factor)).into_pyobject(py)
    }
}

impl Structure {
    fn members(&self) -> &Members {
        &self.setup.structure
    }

    /// The argument `at` as a configuration with its load factor; none: as drawn.
    fn place(&self, at: Option<&Bound<'_, PyAny>>) -> PyResult<(origami::analysis::Configuration, f64)> {
        let Some(at) = at else { return Ok((self.members().as_drawn(), 0.0)) };
        let (configuration, load_factor) = if let Ok(own) = at.cast::<Configuration>() {
            (own.get().at.clone(), own.get().load_factor)
        } else if let Ok(folded) = at.cast::<Folded>() {
            let state = folded.get().start_of(&self.model.get().sheet)?;
            let positions = state.positions.iter().map(|p| *p * self.setup.radius).collect();
            (origami::analysis::Configuration { positions, fold_angles: state.fold_angles.clone() }, 0.0)
        } else {
            return Err(refused("at", &format!("{}", at.get_type()), "a Configuration, or a Folded of the same sheet"));
        };
        let (nodes, hinges) = (self.members().nodes.len(), self.members().hinges.len());
        if configuration.positions.len() == nodes && configuration.fold_angles.len() == hinges {
            return Ok((configuration, load_factor));
        }
        let problem =
            format!("{} positions and {} fold angles", configuration.positions.len(), configuration.fold_angles.len());
        Err(refused("at", &problem, &format!("{nodes} and {hinges}")))
    }
}

#[pymethods]
impl Structure {
    /// sheet: a `Model`, or a `Pattern` to be made of the default material.
    /// job: what it is made of, how it is held and loaded and which path is followed: a dict, as docs/ANALYSIS.md has it.
    ///     Default: what the pattern's file says under `origami:analysis`.
    ///
    /// Raises `Refused` or `PatternError` with the key that is wrong.
    #[new]
    #[pyo3(signature = (sheet, job=None))]
    fn new(sheet: &Bound<'_, PyAny>, job: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let py = sheet.py();
        let model = model_of(sheet, &Method::Relax(Relax::default()))?.unbind();
        let frame = model.get().pattern.get().frame().or_raise()?;
        let job = match job {
            Some(job) => {
                let text: String = py.import("origami_sim._fold")?.call_method1("dumps", (job,))?.extract()?;
                Job::from_slice(text.as_bytes()).or_raise()?
            }
            None => Job::in_frame(&frame).or_raise()?,
        };
        let sheet = &model.get().sheet;
        let setup = job.setup(&frame, sheet.pattern(), &sheet.model).or_raise()?;
        Ok(Self { model, job, setup })
    }

    /// The sheet.
    #[getter]
    fn model(&self, py: Python<'_>) -> Py<Model> {
        self.model.clone_ref(py)
    }

    /// The job, with all that it left out.
    #[getter]
    fn job<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(pythonize::pythonize(py, &self.job)?)
    }

    /// The units of length and of force, in words.
    #[getter]
    fn units(&self) -> (&str, &str) {
        (&self.setup.length, &self.setup.force)
    }

    /// The pattern's vertex of each node, of shape (nodes,).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        let of_node = self.model.get().sheet.model.mesh.vertex_of_node.iter();
        PyArray1::from_vec(py, of_node.map(|vertex| vertex.0).collect())
    }

    /// Where the nodes are drawn, of shape (nodes, 3).
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        vectors(py, self.members().nodes.clone())
    }

    /// The two nodes of each bar, of shape (bars, 2).
    #[getter]
    fn bars<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        rows(py, self.members().bars.iter().map(|bar| bar.nodes.map(|node| node.0)).collect())
    }

    /// The four nodes of each hinge, of shape (hinges, 4): the apexes, then the ends of the line between.
    #[getter]
    fn hinges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        rows(py, self.members().hinges.iter().map(|hinge| hinge.nodes.map(|node| node.0)).collect())
    }

    /// Length of each bar without tension, of shape (bars,).
    #[getter]
    fn rest_lengths<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.members().bars.iter().map(|bar| bar.rest_length).collect())
    }

    /// Axial rigidity of each bar, of shape (bars,). Larger: less strain.
    #[getter]
    fn rigidities<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.members().bars.iter().map(|bar| bar.rigidity).collect())
    }

    /// Angle of each hinge without moment, of shape (hinges,), in radians, valleys positive.
    #[getter]
    fn rest_angles<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.members().hinges.iter().map(|hinge| hinge.rest_angle).collect())
    }

    /// Stiffness of each whole hinge, of shape (hinges,), a moment per radian. Larger: it turns less.
    #[getter]
    fn hinge_stiffnesses<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.members().hinges.iter().map(|hinge| hinge.stiffness).collect())
    }

    /// The same structure with other numbers, all of them optional and of the shapes of the attributes of the same names.
    #[pyo3(signature = (*, positions=None, rest_lengths=None, rigidities=None, rest_angles=None, hinge_stiffnesses=None))]
    fn replace(
        &self,
        py: Python<'_>,
        positions: Option<Rows<'_>>,
        rest_lengths: Option<Numbers<'_>>,
        rigidities: Option<Numbers<'_>>,
        rest_angles: Option<Numbers<'_>>,
        hinge_stiffnesses: Option<Numbers<'_>>,
    ) -> PyResult<Self> {
        let mut setup = self.setup.clone();
        let Members { nodes, bars, hinges, .. } = &mut setup.structure;
        if let Some(positions) = positions {
            let given = to_vectors("positions", &positions)?;
            if given.len() != nodes.len() {
                let expected = format!("one for each of the {} nodes", nodes.len());
                return Err(refused("positions", &format!("{} rows", given.len()), &expected));
            }
            *nodes = given;
        }
        let (bar_count, hinge_count) = (bars.len(), hinges.len());
        let of_bars = |name, given| given_numbers(name, given, bar_count, "bars");
        let of_hinges = |name, given| given_numbers(name, given, hinge_count, "hinges");
        bars.iter_mut().zip(of_bars("rest_lengths", rest_lengths)?).for_each(|(bar, x)| bar.rest_length = x);
        bars.iter_mut().zip(of_bars("rigidities", rigidities)?).for_each(|(bar, x)| bar.rigidity = x);
        hinges.iter_mut().zip(of_hinges("rest_angles", rest_angles)?).for_each(|(hinge, x)| hinge.rest_angle = x);
        let stiffnesses = of_hinges("hinge_stiffnesses", hinge_stiffnesses)?;
        hinges.iter_mut().zip(stiffnesses).for_each(|(hinge, x)| hinge.stiffness = x);
        setup.structure.check().map_err(raised)?;
        Ok(Self { model: self.model.clone_ref(py), job: self.job.clone(), setup })
    }

    /// The state of a folded sheet, in the structure's units.
    ///
    /// folded: a `Folded` of the same sheet. Default: as drawn.
    #[pyo3(signature = (folded=None))]
    fn configuration(&self, folded: Option<&Bound<'_, PyAny>>) -> PyResult<Configuration> {
        let (at, load_factor) = self.place(folded)?;
        Ok(Configuration { at, load_factor })
    }

    /// The equilibrium near a state.
    ///
    /// at: a `Configuration`, or a `Folded` of the same sheet. Default: as drawn.
    /// load_factor: by how much the loads are multiplied. Default: that of `at`.
    ///
    /// Raises `Refused` where none is found nearby, or a rigid motion is left free.
    #[pyo3(signature = (at=None, load_factor=None))]
    fn equilibrium(
        &self,
        py: Python<'_>,
        at: Option<&Bound<'_, PyAny>>,
        load_factor: Option<f64>,
    ) -> PyResult<Configuration> {
        let (start, own) = self.place(at)?;
        let load_factor = load_factor.unwrap_or(own);
        let at = py.detach(|| self.members().equilibrium(&start, load_factor)).map_err(raised)?;
        Ok(Configuration { at, load_factor })
    }

    /// How a result of an equilibrium changes with what the structure is made of, by the adjoint: one solve for all numbers.
    ///
    /// at: an equilibrium.
    /// by_positions: the derivative of the result by the positions of the nodes, of shape (nodes, 3).
    ///
    /// A dict of arrays: `rest_angles`, `hinge_stiffnesses`, `rest_lengths`, `rigidities` as the attributes of these names,
    /// `loads` and `held` of shape (nodes, 3), and the number `load_factor`.
    ///
    /// Raises `Refused` at limit points and bifurcations.
    fn gradient<'py>(
        &self,
        py: Python<'py>,
        at: &Bound<'_, PyAny>,
        by_positions: Rows<'_>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (at, load_factor) = self.place(Some(at))?;
        let by_positions = to_vectors("by_positions", &by_positions)?;
        let gradient = py.detach(|| self.members().gradient(&at, load_factor, &by_positions)).map_err(raised)?;
        analysis::gradient(py, gradient)
    }

    /// The path of equilibria that the job asks for, as a dict of arrays with one entry for each point: `load_factor`, `arc`,
    /// `energy`, `work`, `negative` (0 where it is stable), `nearest_eigenvalue`, `residual`, `event` (`step`, `limit`,
    /// `bifurcation`, `zero load` or `end`), `positions` of shape (points, nodes, 3) and `fold_angles` of shape
    /// (points, hinges). Besides: `ended`, why it ended, and `equilibria`, the states without load: a list of dicts with
    /// `point`, `energy`, `index` and `barrier`.
    ///
    /// start: where it begins, a `Configuration`. Default: as drawn.
    /// progress: called with the number of each point and its load factor.
    ///
    /// Raises `Refused` where nothing acts, or a rigid motion is left free.
    #[pyo3(signature = (start=None, *, progress=None))]
    fn path<'py>(
        &self,
        py: Python<'py>,
        start: Option<&Bound<'_, PyAny>>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let mut from = origami::analysis::Start::default();
        if start.is_some() {
            let (at, load_factor) = self.place(start)?;
            from.configuration = Some(at);
            from.load_factor = load_factor;
        }
        let mut watch = Watch::new(progress);
        let mut count = 0_u64;
        let trace: Result<Trace, Refused> = py.detach(|| {
            self.members().trace(&from, &self.setup.path, &mut |point| {
                count += 1;
                watch.point(count, point.load_factor)
            })
        });
        watch.finish()?;
        analysis::path(py, &trace.map_err(raised)?)
    }

    /// The lowest vibrations about an equilibrium, as a dict: `eigenvalue` of shape (modes,), `frequency_hz` the same where
    /// the job has units and masses, else None, `kind` (`free`, `creases`, `facets` or `bars`: what stores most), and `shape`
    /// of shape (modes, nodes, 3).
    ///
    /// at: an equilibrium. Default: as drawn.
    /// count: how many. Default 6.
    #[pyo3(signature = (at=None, count=6))]
    fn modes<'py>(&self, py: Python<'py>, at: Option<&Bound<'_, PyAny>>, count: usize) -> PyResult<Bound<'py, PyDict>> {
        let (at, load_factor) = self.place(at)?;
        let modes = py.detach(|| self.members().modes(&at, load_factor, count)).map_err(raised)?;
        analysis::modes(py, &modes, self.setup.hertz)
    }

    /// The first answer to the loads, for each unit of the load factor, as a dict: `displacements` of shape (nodes, 3),
    /// `compliance` (smaller: stiffer), and `reactions` of shape (nodes, 3), the forces of the supports.
    ///
    /// at: an equilibrium. Default: as drawn, which is linear analysis.
    #[pyo3(signature = (at=None))]
    fn stiffness<'py>(&self, py: Python<'py>, at: Option<&Bound<'_, PyAny>>) -> PyResult<Bound<'py, PyDict>> {
        let (at, load_factor) = self.place(at)?;
        let answer = py.detach(|| self.members().first_order(&at, load_factor)).map_err(raised)?;
        let mut reactions = vec![DVec3::ZERO; self.members().nodes.len()];
        for (dof, force) in answer.reactions {
            reactions[dof.node.index()][dof.axis.index()] += force;
        }
        Table::new(py)
            .with("displacements", vectors(py, answer.displacements)?)?
            .with("compliance", answer.compliance)?
            .with("reactions", vectors(py, reactions)?)
            .map(Table::finish)
    }

    /// At which load factors it buckles by linear analysis, as a dict: `load_factor` of shape (modes,), nearest to 0 first, and
    /// `shape` of shape (modes, nodes, 3).
    ///
    /// count: how many. Default 4.
    #[pyo3(signature = (count=4))]
    fn buckling<'py>(&self, py: Python<'py>, count: usize) -> PyResult<Bound<'py, PyDict>> {
        let found = py.detach(|| self.members().buckling(count)).map_err(raised)?;
        let factors: Vec<f64> = found.iter().map(|mode| mode.load_factor).collect();
        Table::new(py)
            .with("load_factor", PyArray1::from_vec(py, factors))?
            .with("shape", analysis::blocks(py, found.iter().map(|mode| mode.shape.as_slice()))?)
            .map(Table::finish)
    }

    fn __repr__(&self) -> String {
        let Members { nodes, bars, hinges, .. } = self.members();
        format!("<Structure of {} nodes, {} bars and {} hinges>", nodes.len(), bars.len(), hinges.len())
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let py = this.py();
        let own = this.get();
        let numbers = Table::new(py)
            .with("positions", own.positions(py)?)?
            .with("rest_lengths", own.rest_lengths(py))?
            .with("rigidities", own.rigidities(py))?
            .with("rest_angles", own.rest_angles(py))?
            .with("hinge_stiffnesses", own.hinge_stiffnesses(py))?
            .finish();
        let job: Value = serde_json::to_value(&own.job).map_err(|error| refused("job", &error.to_string(), "JSON"))?;
        let again = py.import("origami_sim.analysis")?.getattr("_again")?;
        (again, (own.model.clone_ref(py), pythonize::pythonize(py, &job)?, numbers)).into_pyobject(py)
    }
}

/// The numbers of an argument; none where it was left out.
fn given_numbers(name: &'static str, given: Option<Numbers<'_>>, count: usize, things: &str) -> PyResult<Vec<f64>> {
    given.map_or_else(|| Ok(Vec::new()), |numbers| to_numbers(name, &numbers, count, things))
}

/// Why a structure cannot be analysed.
#[expect(clippy::needless_pass_by_value, reason = "it is what `map_err` gives")]
fn raised(why: Refused) -> PyErr {
    match &why {
        Refused::Invalid { place, problem, expected } => refused(place.as_str(), problem, expected),
        other => refused_as(&other.to_string()),
    }
}
