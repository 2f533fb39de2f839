//! `Pattern`: a crease pattern, from a file, from arrays, from a FOLD dict or from a generator.

use std::borrow::Cow;
use std::path::PathBuf;
use std::sync::Arc;

use numpy::{PyArray1, PyArray2};
use origami::export::crease_pattern_document;
use origami::fold::{Coordinates, Document, Frame};
use origami::generate::catalog;
use origami::pattern::Assignment;
use origami::{CreasePattern, Error};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple, PyType};
use serde_json::json;

use crate::arrays::{Numbers, Rows, degrees, rows, to_numbers, to_vectors, vectors};
use crate::errors::{OrRaise, refused};
use crate::notes::notes;
use crate::source::{Options, Read, Source, understood};

/// A crease pattern: vertices, lettered edges, faces, as read and put right.
#[pyclass(frozen, module = "origami_sim._native", weakref)]
pub(crate) struct Pattern {
    pub(crate) read: Arc<Read>,
    origin: Arc<Origin>,
}

/// Enough to make the pattern again.
enum Origin {
    File(Source),
    Made(Box<Document>),
}

impl Pattern {
    fn of_file(py: Python<'_>, source: Source) -> PyResult<Self> {
        let read = Arc::new(py.detach(|| source.read()).or_raise()?);
        Ok(Self { read, origin: Arc::new(Origin::File(source)) })
    }

    fn made(py: Python<'_>, document: Document) -> PyResult<Self> {
        let read = Arc::new(py.detach(|| understood(&document, None)).or_raise()?);
        Ok(Self { read, origin: Arc::new(Origin::Made(Box::new(document))) })
    }

    pub(crate) fn pattern(&self) -> &CreasePattern {
        &self.read.pattern
    }

    /// The frame of a FOLD file that it was made of, read anew: what analysis asks stands there, and nothing else needs it.
    #[cfg(feature = "analysis")]
    pub(crate) fn frame(&self) -> Result<Frame, Error> {
        let (document, frame) = match &*self.origin {
            Origin::File(source) => (Cow::Owned(source.document()?), source.options.frame),
            Origin::Made(document) => (Cow::Borrowed(&**document), None),
        };
        document.frame(frame.map_or_else(|| document.pattern_frame(), Ok)?)
    }

    /// The file that it was read from.
    pub(crate) fn input(&self) -> Option<String> {
        match &*self.origin {
            Origin::File(source) => source.name.as_ref().map(|name| name.display().to_string()),
            Origin::Made(_) => None,
        }
    }
}

#[pymethods]
impl Pattern {
    /// Reads a file: FOLD, CP, OPX, ORI, ORH, SVG, OBJ or DXF, also compressed by gzip.
    ///
    /// path: the file.
    /// frame: which frame of a FOLD file; 0 is the key frame. Default: the first with vertex positions.
    /// join: the distance within which lines are joined, in the file's unit. Larger: more near misses are joined. Default:
    ///     found from the file.
    /// letters: what colours of a drawing stand for, as `red=M,blue=V`. Default: the field's own.
    /// curve_tolerance: how far straight pieces may be from a curve, in the file's unit. Smaller: more pieces. Default:
    ///     found from the drawing.
    ///
    /// Raises `OSError` where there is no such file, `PatternError` with the place where it is no crease pattern.
    #[classmethod]
    #[pyo3(signature = (path, *, frame=None, join=None, letters=None, curve_tolerance=None))]
    fn read(
        _class: &Bound<'_, PyType>,
        py: Python<'_>,
        path: PathBuf,
        frame: Option<usize>,
        join: Option<f64>,
        letters: Option<String>,
        curve_tolerance: Option<f64>,
    ) -> PyResult<Self> {
        let bytes =
            py.detach(|| std::fs::read(&path).map_err(|source| Error::Io { path: path.display().to_string(), source }));
        let options = Options { frame, join, letters, curve_tolerance };
        Self::of_file(py, Source { bytes: bytes.or_raise()?, name: Some(path), options })
    }

    /// Reads the content of a file; `name` tells the format where the content does not. The rest is as for `read`.
    #[classmethod]
    #[pyo3(signature = (data, name=None, frame=None, join=None, letters=None, curve_tolerance=None))]
    #[expect(clippy::too_many_arguments, reason = "as many as there are ways to read a file")]
    fn from_bytes(
        _class: &Bound<'_, PyType>,
        py: Python<'_>,
        data: &[u8],
        name: Option<PathBuf>,
        frame: Option<usize>,
        join: Option<f64>,
        letters: Option<String>,
        curve_tolerance: Option<f64>,
    ) -> PyResult<Self> {
        let options = Options { frame, join, letters, curve_tolerance };
        Self::of_file(py, Source { bytes: data.to_vec(), name, options })
    }

    /// Makes a pattern of a FOLD dict, as `json.load` has it; its values may be NumPy arrays.
    ///
    /// frame, join: as for `read`.
    #[classmethod]
    #[pyo3(signature = (fold, *, frame=None, join=None))]
    fn from_fold(
        class: &Bound<'_, PyType>,
        fold: &Bound<'_, PyDict>,
        frame: Option<usize>,
        join: Option<f64>,
    ) -> PyResult<Self> {
        let py = class.py();
        let text: String = py.import("origami_sim._fold")?.call_method1("dumps", (fold,))?.extract()?;
        let options = Options { frame, join, ..Options::default() };
        Self::of_file(py, Source { bytes: text.into_bytes(), name: None, options })
    }

    /// Makes a pattern of arrays.
    ///
    /// vertices: shape (vertices, 2) or (vertices, 3), in any unit.
    /// edges: shape (edges, 2): the two vertices of each, from 0.
    /// letters: one for each edge, a string or a list: B boundary, M mountain, V valley, F flat, U undriven, C cut, J join.
    /// fold_angles: shape (edges,), in degrees, valleys positive; NaN for an undriven edge. Default: 180 for V, -180 for M.
    /// faces: lists of vertices, counterclockwise. Default: found from the edges.
    /// join: the distance within which lines are joined, in the unit of `vertices`. Default: found from the vertices.
    #[classmethod]
    #[pyo3(signature = (vertices, edges, letters, *, fold_angles=None, faces=None, join=None))]
    fn from_arrays(
        class: &Bound<'_, PyType>,
        vertices: Rows<'_>,
        edges: &Bound<'_, PyAny>,
        letters: &Bound<'_, PyAny>,
        fold_angles: Option<Numbers<'_>>,
        faces: Option<Vec<Vec<u32>>>,
        join: Option<f64>,
    ) -> PyResult<Self> {
        let edges = edge_ends(edges)?;
        let letters = letters_of(letters)?;
        let angle = |angle: f64| (!angle.is_nan()).then_some(angle);
        let fold_angles = fold_angles
            .map(|angles| to_numbers("fold_angles", &angles, edges.len(), "edges"))
            .transpose()?
            .map(|angles| angles.into_iter().map(angle).collect());
        let vertices = to_vectors("vertices", &vertices)?;
        if let Some(i) = vertices.iter().position(|vertex| !vertex.is_finite()) {
            return Err(refused(format!("vertices[{i}]"), &vertices[i].to_string(), "finite numbers"));
        }
        let key_frame = Frame {
            vertices_coords: Some(vertices.into_iter().map(Coordinates::planar).collect()),
            edges_vertices: Some(edges),
            edges_assignment: Some(letters.into_iter().map(Cow::Owned).collect()),
            edges_fold_angle: fold_angles,
            faces_vertices: faces,
            ..Frame::default()
        };
        Self::made(class.py(), Document { key_frame, join, ..Document::default() })
    }

    /// Makes a pattern from parameters; `generators()` has the names and what their parameters mean.
    ///
    /// >>> Pattern.generate("miura", columns=6, rows=4)
    #[classmethod]
    #[pyo3(signature = (name, **parameters))]
    fn generate(class: &Bound<'_, PyType>, name: &str, parameters: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let given =
            parameters.map(|parameters| parameters.extract::<Vec<(String, f64)>>().or_else(|_| items(parameters)));
        let given = given.transpose()?.unwrap_or_default();
        let title = given.iter().fold(name.to_owned(), |title, (key, value)| format!("{title}, {key} {value}"));
        let made = class
            .py()
            .detach(|| catalog::generate(name, &given).map(|pattern| crease_pattern_document(&pattern, &title)));
        Self::made(class.py(), made.or_raise()?)
    }

    /// Positions at rest, of shape (vertices, 3), in the file's unit.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        vectors(py, self.pattern().vertices.clone())
    }

    /// The two vertices of each edge, of shape (edges, 2).
    #[getter]
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        rows(py, self.pattern().edges.iter().map(|edge| edge.vertices.map(|vertex| vertex.0)).collect())
    }

    /// The letter of each edge, in one string.
    #[getter]
    fn letters(&self) -> String {
        self.pattern().edges.iter().map(|edge| edge.assignment.letter()).collect()
    }

    /// The fold angle asked of each edge at 100 %, of shape (edges,), in degrees, valleys positive; NaN where there is none.
    #[getter]
    fn fold_angles<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let asked = |edge: &origami::pattern::PatternEdge| match edge.assignment {
            Assignment::Boundary => None,
            _ => edge.fold_angle,
        };
        degrees(py, self.pattern().edges.iter().map(asked))
    }

    /// The vertices of each face, counterclockwise.
    #[getter]
    fn faces(&self) -> Vec<Vec<u32>> {
        self.pattern().faces.iter().map(|face| face.iter().map(|vertex| vertex.0).collect()).collect()
    }

    /// Vertices that the file fixes, of shape (fixed,).
    #[getter]
    fn fixed<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        PyArray1::from_vec(py, self.pattern().fixed.iter().map(|vertex| vertex.0).collect())
    }

    /// The longest side of the box, along the axes, that holds all vertices, in the file's unit.
    #[getter]
    fn size(&self) -> f64 {
        self.pattern().size()
    }

    /// Whether all vertices lie in one plane of constant z.
    #[getter]
    fn is_flat(&self) -> bool {
        self.pattern().is_flat()
    }

    /// What was odd in the file and put right: dicts of `code`, `place`, `message` and `at` (docs/REPORT.md).
    #[getter]
    fn warnings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(pythonize::pythonize(py, &notes(&self.pattern().warnings))?)
    }

    /// The pattern as a FOLD dict, as it was cleaned: `json.dump` makes a file of it.
    fn to_fold<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        fold_dict(py, &self.read.template.crease_pattern(self.pattern()))
    }

    fn __repr__(&self) -> String {
        let CreasePattern { vertices, edges, faces, .. } = self.pattern();
        format!("<Pattern of {} vertices, {} edges and {} faces>", vertices.len(), edges.len(), faces.len())
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let py = this.py();
        let from_bytes = py.get_type::<Self>().getattr("from_bytes")?;
        let made;
        let Source { bytes, name, options } = match &*this.get().origin {
            Origin::File(source) => source,
            Origin::Made(document) => {
                let text = document.to_string().or_raise()?;
                let options = Options { join: document.join, ..Options::default() };
                made = Source { bytes: text.into_bytes(), name: None, options };
                &made
            }
        };
        let Options { frame, join, letters, curve_tolerance } = options;
        let how = (PyBytes::new(py, bytes), name, frame, join, letters, curve_tolerance);
        (from_bytes, how).into_pyobject(py)
    }
}

/// What a generator's parameters are given as.
fn items(parameters: &Bound<'_, PyDict>) -> PyResult<Vec<(String, f64)>> {
    parameters.iter().map(|(name, value)| Ok((name.extract()?, value.extract()?))).collect()
}

/// A string with a letter for each edge, or a list of letters.
fn letters_of(letters: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    let one_string: Option<String> = letters.extract().ok();
    let letters = one_string.map_or_else(|| letters.extract(), |all| Ok(all.chars().map(String::from).collect()));
    letters.map_err(|_| refused("letters", "not letters", "a string or a list with a letter for each edge"))
}

/// Ends of edges, from anything that NumPy can make a table of whole numbers of.
fn edge_ends(edges: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 2]>> {
    let expected = "an array of whole numbers of shape (n, 2), none below 0";
    let wrong = |problem: &str| refused("edges", problem, expected);
    let edges: Rows<'_> = edges.extract().map_err(|_| wrong("not an array of numbers"))?;
    let edges = edges.as_array();
    if edges.ncols() != 2 {
        return Err(wrong(&format!("an array of shape ({}, {})", edges.nrows(), edges.ncols())));
    }
    let index = |(row, column): (usize, usize)| {
        let number = edges[[row, column]];
        let whole = number >= 0.0 && number <= f64::from(u32::MAX) && number.fract() == 0.0;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number in range")]
        let index = number as u32;
        if whole { Ok(index) } else { Err(refused(format!("edges[{row}][{column}]"), &number.to_string(), expected)) }
    };
    (0..edges.nrows()).map(|row| Ok([index((row, 0))?, index((row, 1))?])).collect()
}

/// A document as the dict that `json.load` would make of its file.
pub(crate) fn fold_dict<'py>(py: Python<'py>, document: &Document) -> PyResult<Bound<'py, PyAny>> {
    let text = py.detach(|| document.to_string()).or_raise()?;
    py.import("json")?.call_method1("loads", (text,))
}

/// The patterns that `Pattern.generate` can make: {name: {summary, parameters: [{name, default, meaning}]}}.
#[pyfunction]
pub(crate) fn generators(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let entries: serde_json::Map<String, serde_json::Value> = catalog::entries()
        .iter()
        .map(|entry| {
            let parameters: Vec<_> = entry
                .parameters
                .iter()
                .map(|parameter| json!({"name": parameter.name, "default": parameter.default, "meaning": parameter.meaning}))
                .collect();
            (entry.name.to_owned(), json!({"summary": entry.summary, "parameters": parameters}))
        })
        .collect();
    Ok(pythonize::pythonize(py, &entries)?)
}
