//! `Model`: a pattern as a triangulated sheet with springs.

use std::sync::Arc;
use std::time::Instant;

use numpy::{PyArray1, PyArray2};
use origami::CreasePattern;
use origami::glam::DVec3;
use origami::ids::{EdgeId, NodeId, VertexId};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyTuple};
use serde_json::json;

use crate::arrays::{rows, vectors};
use crate::errors::{OrRaise, refused};
use crate::pattern::Pattern;
use crate::settings::{Method, material};
use crate::source::Read;

/// A pattern with a material, ready to be folded.
#[pyclass(frozen, module = "origami_sim._native", weakref)]
pub(crate) struct Model {
    pub(crate) sheet: Sheet,
    pub(crate) pattern: Py<Pattern>,
    material: Py<PyAny>,
}

/// What everything that folds works on.
#[derive(Clone)]
pub(crate) struct Sheet {
    pub(crate) read: Arc<Read>,
    pub(crate) model: Arc<origami::Model>,
    pub(crate) input: Option<String>,
    /// How long it took to build, in seconds.
    pub(crate) seconds: f64,
}

impl Sheet {
    pub(crate) fn pattern(&self) -> &CreasePattern {
        &self.read.pattern
    }

    /// The node of a vertex of the pattern; `name` is the argument's.
    pub(crate) fn node(&self, name: &str, vertex: usize) -> PyResult<NodeId> {
        let count = self.pattern().vertices.len();
        let known = u32::try_from(vertex).ok().filter(|_| vertex < count).map(VertexId);
        let known = known.ok_or_else(|| {
            refused(name, &format!("vertex {vertex}"), &format!("one from 0 to {}", count.saturating_sub(1)))
        })?;
        let stands_for = self.pattern().alias_of.get(vertex).copied().flatten().unwrap_or(known);
        self.model
            .node(stands_for)
            .ok_or_else(|| refused(name, &format!("vertex {vertex}, which no edge or face uses"), "one of the sheet"))
    }

    /// A place in the file's units, in radii of the sheet.
    pub(crate) fn to_model(&self, place: [f64; 3]) -> DVec3 {
        self.model.normalisation.to_model(DVec3::from_array(place))
    }

    /// The number of a node's vertex in the pattern.
    pub(crate) fn vertex(&self, node: NodeId) -> u32 {
        self.model.mesh.vertex_of_node[node.index()].0
    }
}

#[pymethods]
impl Model {
    /// pattern: what is folded.
    /// material: what it is made of. Default: `Material()`.
    ///
    /// Raises `Refused` for a material out of range, `PatternError` for a face that cannot be triangulated.
    #[new]
    #[pyo3(signature = (pattern, material=None))]
    fn new(py: Python<'_>, pattern: Bound<'_, Pattern>, material: Option<Bound<'_, PyAny>>) -> PyResult<Self> {
        let watch = Instant::now();
        let given = material.map_or_else(|| py.import("origami_sim.settings")?.call_method0("Material"), Ok)?;
        let made_of = self::material(&given)?;
        let read = Arc::clone(&pattern.get().read);
        let model = py.detach(|| origami::Model::new(&read.pattern, &made_of)).or_raise()?;
        let input = pattern.get().input();
        let sheet = Sheet { read, model: Arc::new(model), input, seconds: watch.elapsed().as_secs_f64() };
        Ok(Self { sheet, pattern: pattern.unbind(), material: given.unbind() })
    }

    /// What it was made of.
    #[getter]
    fn pattern(&self, py: Python<'_>) -> Py<Pattern> {
        self.pattern.clone_ref(py)
    }

    /// What the paper is.
    #[getter]
    fn material(&self, py: Python<'_>) -> Py<PyAny> {
        self.material.clone_ref(py)
    }

    /// Distance of the farthest vertex from `centre`, in the file's unit: the model's unit of length.
    #[getter]
    fn radius(&self) -> f64 {
        self.sheet.model.normalisation.radius
    }

    /// The centre of the sheet's bounding box, in the file's unit.
    #[getter]
    fn centre(&self) -> [f64; 3] {
        self.sheet.model.normalisation.centre.to_array()
    }

    /// The triangles that the faces are cut into, of shape (triangles, 3): vertices of the pattern, counterclockwise.
    #[getter]
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let corners = |triangle: &[NodeId; 3]| triangle.map(|node| self.sheet.vertex(node));
        rows(py, self.sheet.model.mesh.triangles.iter().map(corners).collect())
    }

    /// The face of each triangle, of shape (triangles,).
    #[getter]
    fn face_of_triangle<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        PyArray1::from_vec(py, self.sheet.model.mesh.face_of_triangle.iter().map(|face| face.0).collect())
    }

    /// The two vertices of each beam, of shape (beams, 2).
    #[getter]
    fn beams<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let ends = |beam: &origami::model::Beam| beam.nodes.map(|node| self.sheet.vertex(node));
        rows(py, self.sheet.model.beams.iter().map(ends).collect())
    }

    /// The two vertices of each crease with a spring, of shape (creases, 2): mountains, valleys, flat ones and the diagonals of
    /// faces.
    #[getter]
    fn creases<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let ends = |crease: &origami::model::Crease| [2, 3].map(|end: usize| self.sheet.vertex(crease.nodes[end]));
        rows(py, self.sheet.model.creases.iter().map(ends).collect())
    }

    /// The crease on each edge of the pattern, of shape (edges,); -1 where there is no spring.
    #[getter]
    fn crease_of_edge<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        let crease = |edge| self.sheet.model.crease_of(EdgeId::new(edge)).map_or(-1, |crease| i64::from(crease.0));
        PyArray1::from_vec(py, (0..self.sheet.pattern().edges.len()).map(crease).collect())
    }

    /// The angle asked of each crease at `percent`, of shape (creases,), in radians, valleys positive.
    #[pyo3(signature = (percent=100.0))]
    fn targets<'py>(&self, py: Python<'py>, percent: f64) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.sheet.model.targets(percent))
    }

    /// Positions at rest, of shape (vertices, 3), in the file's unit.
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        vectors(py, self.sheet.model.file_positions(self.sheet.pattern(), &self.sheet.model.rest))
    }

    /// What was built and what was left out, with why: {built: [{what, count}], left_out: [{what, count, why}]}.
    #[getter]
    fn inventory<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let inventory = &self.sheet.model.inventory;
        let built: Vec<_> =
            inventory.built.iter().map(|line| json!({"what": line.what, "count": line.count})).collect();
        let left_out = inventory.left_out.iter();
        let left_out: Vec<_> =
            left_out.map(|line| json!({"what": line.what, "count": line.count, "why": line.why})).collect();
        Ok(pythonize::pythonize(py, &json!({"built": built, "left_out": left_out}))?)
    }

    fn __repr__(&self) -> String {
        let model = &self.sheet.model;
        format!(
            "<Model of {} vertices, {} beams and {} creases>",
            model.node_count(),
            model.beams.len(),
            model.creases.len()
        )
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let py = this.py();
        let model = this.get();
        let parts = (model.pattern.clone_ref(py), model.material.clone_ref(py));
        (py.get_type::<Self>(), parts).into_pyobject(py)
    }
}

/// A model, or a pattern that a model of the default material is made of: for the paper's motion of the paper's.
pub(crate) fn model_of<'py>(sheet: &Bound<'py, PyAny>, method: &Method) -> PyResult<Bound<'py, Model>> {
    if let Ok(model) = sheet.cast::<Model>() {
        return Ok(model.clone());
    }
    let pattern = sheet.cast::<Pattern>().map_err(|_| {
        refused("sheet", &format!("{}", sheet.get_type()), "a Model, or a Pattern to be made of the default material")
    })?;
    let py = sheet.py();
    let material = match method {
        Method::Dynamics(_) => {
            let numbers = [("collapse", origami::Material::paper().collapse)].into_py_dict(py)?;
            Some(py.import("origami_sim.settings")?.getattr("Material")?.call((), Some(&numbers))?)
        }
        _ => None,
    };
    Bound::new(py, Model::new(py, pattern.clone(), material)?)
}
