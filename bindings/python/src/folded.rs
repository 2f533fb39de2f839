//! `Folded`: the state that a solver arrived at, and what can be measured on it.

#[cfg(feature = "render")]
use numpy::PyArray3;
use numpy::{PyArray1, PyArray2};
use origami::forces::beams;
use origami::glam::DVec3;
use origami::measure::attitude::turned;
use origami::measure::{Strain, angle_error, edge_fold_angles, node_strains};
use origami::scene::{Reaction, Targets};
use origami::solve::{State, Stop};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use pythonize::{depythonize, pythonize};
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::arrays::{Numbers, Rows, degrees, rows, to_numbers, to_vectors, vectors};
use crate::errors::{OrRaise, refused};
use crate::form::folded_form;
use crate::model::{Model, Sheet};
use crate::notes::notes;
use crate::pattern::fold_dict;
#[cfg(feature = "render")]
use crate::picture::{Look, picture};
use crate::report::{ending, report, statistics, warnings};
use crate::run::Run;

/// A folded sheet: where it lies, and how it got there.
#[pyclass(frozen, module = "origami_sim._native", weakref)]
pub(crate) struct Folded {
    pub(crate) model: Py<Model>,
    pub(crate) folded: origami::Folded,
    run: Run,
}

/// Held vertices, of shape (held,), and the forces on them, of shape (held, 3).
pub(crate) type Reactions<'py> = (Bound<'py, PyArray1<u32>>, Bound<'py, PyArray2<f64>>);

/// What goes along with the arrays of a state when a sheet is pickled.
#[derive(Serialize, Deserialize)]
struct Told {
    targets: Targets,
    stop: Stop,
    steps: u64,
    time_step: f64,
    residual: f64,
    distance: f64,
    attempts: u32,
    saddles: u32,
    #[serde(default)]
    factorisations: u32,
    reactions: Vec<Reaction>,
    run: Run,
}

impl Folded {
    pub(crate) fn new(model: Py<Model>, folded: origami::Folded, run: Run) -> Self {
        Self { model, folded, run }
    }

    pub(crate) fn sheet(&self) -> &Sheet {
        &self.model.get().sheet
    }

    /// The state, for another fold of a sheet like this one.
    pub(crate) fn start_of(&self, sheet: &Sheet) -> PyResult<&State> {
        let (own, other) = (&self.sheet().model, &sheet.model);
        if own.node_count() == other.node_count() && own.creases.len() == other.creases.len() {
            return Ok(&self.folded.state);
        }
        let count =
            |model: &origami::Model| format!("{} vertices and {} creases", model.node_count(), model.creases.len());
        Err(refused("start", &format!("a sheet of {}", count(own)), &format!("one of {}", count(other))))
    }

    /// The state in the attitude that was asked for.
    pub(crate) fn turned(&self) -> PyResult<State> {
        turned(&self.sheet().model, &self.folded.state, self.run.hold()).or_raise()
    }

    /// A value for each vertex of the pattern; NaN for those that are no part of the sheet.
    fn by_vertex(&self, by_node: &[f64]) -> Vec<f64> {
        let mesh = &self.sheet().model.mesh;
        mesh.node_of_vertex.iter().map(|node| node.map_or(f64::NAN, |node| by_node[node.index()])).collect()
    }
}

#[pymethods]
impl Folded {
    /// The sheet.
    #[getter]
    fn model(&self, py: Python<'_>) -> Py<Model> {
        self.model.clone_ref(py)
    }

    /// The percentage of the fold angles that was asked for; None for other targets.
    #[getter]
    fn percent(&self) -> Option<f64> {
        self.folded.percent()
    }

    /// Whether the state is within the tolerance of the equilibrium.
    #[getter]
    fn converged(&self) -> bool {
        self.folded.converged()
    }

    /// Why the solver stopped: `converged`, `steps_done`, `step_limit` or `crushed`.
    #[getter]
    fn stop(&self) -> &'static str {
        ending(self.folded.stop)
    }

    /// Force evaluations, all attempts together.
    #[getter]
    fn steps(&self) -> u64 {
        self.folded.steps
    }

    /// The last step: model time for `Dynamics`, in units of each vertex's own step for `Relax`.
    #[getter]
    fn time_step(&self) -> f64 {
        self.folded.time_step
    }

    /// Largest force on a vertex, in the model's unit of force.
    #[getter]
    fn residual(&self) -> f64 {
        self.folded.residual
    }

    /// Estimated distance of the farthest vertex from the equilibrium, in radii; infinite where nothing tells.
    #[getter]
    fn distance(&self) -> f64 {
        self.folded.distance
    }

    /// More than 1 where the first attempt ended tangled, crushed or out of bounds.
    #[getter]
    fn attempts(&self) -> u32 {
        self.folded.attempts
    }

    /// Positions of the pattern's vertices, of shape (vertices, 3), in the file's unit; turned as `hold` said. A new array each
    /// time, which NumPy takes over without a copy.
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let sheet = self.sheet();
        let positions = py.detach(|| {
            let state = self.turned()?;
            Ok::<_, PyErr>(sheet.model.file_positions(sheet.pattern(), &state.positions))
        });
        vectors(py, positions?)
    }

    /// The angle reached by each edge, of shape (edges,), in degrees, valleys positive; NaN for boundaries.
    #[getter]
    fn fold_angles<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let sheet = self.sheet();
        degrees(py, edge_fold_angles(&sheet.model, sheet.pattern(), &self.folded.state).into_iter())
    }

    /// The angle reached by each crease of the model, of shape (creases,), in radians.
    #[getter]
    fn crease_angles<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.folded.state.fold_angles)
    }

    /// The angle asked of each crease of the model, of shape (creases,), in radians.
    #[getter]
    fn targets<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.folded.state.targets)
    }

    /// Strain of the beams, absolute, as a share: {mean, rms, max}.
    #[getter]
    fn strain<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let strain = Strain::of(&self.sheet().model, &self.folded.state.positions);
        Ok(pythonize(py, &statistics(strain.beams))?)
    }

    /// The strain of each beam, of shape (beams,), as a share; stretched ones positive.
    #[getter]
    fn beam_strains<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let model = &self.sheet().model;
        PyArray1::from_vec(py, beams::strains(model, &self.folded.state.positions).collect())
    }

    /// The mean absolute strain of the beams at each vertex, of shape (vertices,), as a share.
    #[getter]
    fn vertex_strains<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let strains = node_strains(&self.sheet().model, &self.folded.state.positions);
        PyArray1::from_vec(py, self.by_vertex(&strains))
    }

    /// Energy by kind of spring: {beams, creases, corner_angles, areas, total}, in the model's unit.
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let energy = self.folded.state.energy(&self.sheet().model);
        let parts = json!({
            "beams": energy.beams,
            "creases": energy.creases,
            "corner_angles": energy.corner_angles,
            "areas": energy.areas,
            "total": energy.total(),
        });
        Ok(pythonize(py, &parts)?)
    }

    /// Fold angles reached against those asked for, over all creases, in degrees: {mean, max}.
    #[getter]
    fn angle_error_deg<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let error = angle_error(&self.folded.state);
        Ok(pythonize(py, &json!({"mean": error.mean, "max": error.max}))?)
    }

    /// How many creases are folded past 200 degrees: layers have gone through each other.
    #[getter]
    fn tangled_creases(&self) -> usize {
        self.folded.state.tangled_creases()
    }

    /// What supports and fixed vertices bear: the vertices, of shape (held,), and the forces on them, of shape (held, 3).
    #[getter]
    fn reactions<'py>(&self, py: Python<'py>) -> PyResult<Reactions<'py>> {
        reactions(py, self.sheet(), &self.folded.reactions)
    }

    /// What was odd in the file, what is dangerous in the scene, what went wrong: dicts of `code`, `place`, `message` and `at`.
    #[getter]
    fn warnings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(pythonize(py, &notes(&warnings(self.sheet(), &self.folded)))?)
    }

    /// All that `origami fold --report` says, by the same keys (docs/REPORT.md) and to the same bits.
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let report = py.detach(|| report(self.sheet(), &self.folded, &self.run));
        Ok(pythonize(py, &report)?)
    }

    /// The folded sheet as a FOLD dict, as `origami fold` writes it: `json.dump` makes a file of it.
    fn to_fold<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let folded = origami::Folded { state: self.turned()?, ..self.folded.clone() };
        let document = py.detach(|| folded_form(self.sheet(), &folded)).or_raise()?;
        fold_dict(py, &document)
    }

    /// A picture of the sheet, of shape (height, width, 4): red, green, blue and alpha, 8 bits each, rows from the top.
    #[cfg(feature = "render")]
    #[pyo3(signature = (size=(1000, 800), *, camera=None, theme="paper", map=None, colours=None, clip=None, caption="", transparent=false))]
    #[expect(clippy::too_many_arguments, reason = "each can be left out, and has its name")]
    fn picture<'py>(
        &self,
        py: Python<'py>,
        size: (u32, u32),
        camera: Option<&str>,
        theme: &str,
        map: Option<&str>,
        colours: Option<&str>,
        clip: Option<f64>,
        caption: &str,
        transparent: bool,
    ) -> PyResult<Bound<'py, PyArray3<u8>>> {
        let look = Look { size, camera, theme, map, colours, clip, caption, transparent };
        picture(py, self.sheet(), &self.turned()?, look)
    }

    fn __repr__(&self) -> String {
        let percent =
            self.folded.percent().map_or_else(|| "other targets".to_owned(), |percent| format!("{percent} %"));
        format!("<Folded to {percent}: {} after {} steps>", ending(self.folded.stop), self.folded.steps)
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let py = this.py();
        let Self { model, folded, run } = this.get();
        let origami::Folded {
            state,
            targets,
            stop,
            steps,
            time_step,
            residual,
            distance,
            attempts,
            saddles,
            factorisations,
            reactions,
        } = folded;
        let told = Told {
            targets: targets.clone(),
            stop: *stop,
            steps: *steps,
            time_step: *time_step,
            residual: *residual,
            distance: *distance,
            attempts: *attempts,
            saddles: *saddles,
            factorisations: *factorisations,
            reactions: reactions.clone(),
            run: run.clone(),
        };
        let arrays = (
            vectors(py, state.positions.clone())?,
            vectors(py, state.velocities.clone())?,
            PyArray1::from_slice(py, &state.fold_angles),
            PyArray1::from_slice(py, &state.targets),
        );
        let refold = py.import("origami_sim._native")?.getattr("refold")?;
        (refold, (model.clone_ref(py), arrays, pythonize(py, &told)?)).into_pyobject(py)
    }
}

/// Makes a pickled sheet again.
#[pyfunction]
pub(crate) fn refold(
    model: &Bound<'_, Model>,
    arrays: (Rows<'_>, Rows<'_>, Numbers<'_>, Numbers<'_>),
    told: &Bound<'_, PyAny>,
) -> PyResult<Folded> {
    let (positions, velocities, fold_angles, targets) = arrays;
    let own = &model.get().sheet.model;
    let by_node = |name, array| -> PyResult<Vec<DVec3>> {
        let vectors = to_vectors(name, array)?;
        if vectors.len() == own.node_count() {
            return Ok(vectors);
        }
        Err(refused(
            name,
            &format!("{} rows", vectors.len()),
            &format!("one for each of {} vertices", own.node_count()),
        ))
    };
    let state = State {
        positions: by_node("positions", &positions)?,
        velocities: by_node("velocities", &velocities)?,
        fold_angles: to_numbers("fold_angles", &fold_angles, own.creases.len(), "creases")?,
        targets: to_numbers("targets", &targets, own.creases.len(), "creases")?,
    };
    let told: Told = depythonize(told)?;
    let folded = origami::Folded {
        state,
        targets: told.targets,
        stop: told.stop,
        steps: told.steps,
        time_step: told.time_step,
        residual: told.residual,
        distance: told.distance,
        attempts: told.attempts,
        saddles: told.saddles,
        factorisations: told.factorisations,
        reactions: told.reactions,
    };
    Ok(Folded::new(model.clone().unbind(), folded, told.run))
}

/// The held vertices and the forces on them.
pub(crate) fn reactions<'py>(py: Python<'py>, sheet: &Sheet, reactions: &[Reaction]) -> PyResult<Reactions<'py>> {
    let vertices = reactions.iter().map(|reaction| sheet.vertex(reaction.node)).collect();
    let forces = reactions.iter().map(|reaction| reaction.force.to_array()).collect();
    Ok((PyArray1::from_vec(py, vertices), rows(py, forces)?))
}
