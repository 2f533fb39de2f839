//! Arrays in and out. What goes out is handed over as it lies: NumPy owns the memory from then on, and nothing is copied.

use numpy::{AllowTypeChange, Element, PyArray1, PyArray2, PyArrayLike1, PyArrayLike2, PyArrayMethods};
use origami::glam::DVec3;
use pyo3::prelude::*;

use crate::errors::refused;

/// Anything that NumPy can make a list of numbers of.
pub(crate) type Numbers<'py> = PyArrayLike1<'py, f64, AllowTypeChange>;
/// Anything that NumPy can make a table of numbers of.
pub(crate) type Rows<'py> = PyArrayLike2<'py, f64, AllowTypeChange>;

/// Vectors as an array of shape (n, 3).
pub(crate) fn vectors(py: Python<'_>, vectors: Vec<DVec3>) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let rows = vectors.len();
    let numbers: Vec<f64> = bytemuck::allocation::cast_vec(vectors);
    PyArray1::from_vec(py, numbers).reshape([rows, 3])
}

/// Rows of `N` numbers as an array of shape (n, N).
pub(crate) fn rows<T: Element, const N: usize>(py: Python<'_>, rows: Vec<[T; N]>) -> PyResult<Bound<'_, PyArray2<T>>> {
    let count = rows.len();
    PyArray1::from_vec(py, rows.into_flattened()).reshape([count, N])
}

/// Numbers of several things in turn, of shape (things, `columns`).
#[cfg(feature = "analysis")]
pub(crate) fn table(py: Python<'_>, numbers: Vec<f64>, columns: usize) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let rows = numbers.len().checked_div(columns).unwrap_or(0);
    PyArray1::from_vec(py, numbers).reshape([rows, columns])
}

/// Angles in degrees; where there is none, NaN.
pub(crate) fn degrees(py: Python<'_>, radians: impl Iterator<Item = Option<f64>>) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_vec(py, radians.map(|angle| angle.map_or(f64::NAN, f64::to_degrees)).collect())
}

/// The rows of an array of shape (n, 3), or (n, 2) for z = 0; `name` is the argument's.
pub(crate) fn to_vectors(name: &'static str, array: &Rows<'_>) -> PyResult<Vec<DVec3>> {
    let array = array.as_array();
    let columns = array.ncols();
    if !(2..=3).contains(&columns) {
        return Err(refused(
            name,
            &format!("an array of shape ({}, {columns})", array.nrows()),
            "shape (n, 2) or (n, 3)",
        ));
    }
    let z = |row: usize| if columns == 3 { array[[row, 2]] } else { 0.0 };
    Ok((0..array.nrows()).map(|row| DVec3::new(array[[row, 0]], array[[row, 1]], z(row))).collect())
}

/// One number for each of `count` things.
pub(crate) fn to_numbers(name: &'static str, array: &Numbers<'_>, count: usize, things: &str) -> PyResult<Vec<f64>> {
    let numbers = array.as_array().to_vec();
    if numbers.len() == count {
        return Ok(numbers);
    }
    Err(refused(name, &format!("{} numbers", numbers.len()), &format!("one for each of the {count} {things}")))
}
