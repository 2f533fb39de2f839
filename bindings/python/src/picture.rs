//! A picture as an array.

use numpy::{PyArray1, PyArray3, PyArrayMethods};
use origami::State;
use origami::picture::{Camera, ColourMap, DrawError, Figure, Map, Picture, Processor, Quantity, Renderer, Theme};
use pyo3::prelude::*;

use crate::errors::{OrRaise, refused};
use crate::model::Sheet;

/// How a picture shall look.
pub(crate) struct Look<'a> {
    /// Pixels across and down.
    pub(crate) size: (u32, u32),
    /// The name of a camera; none is the one that suits the sheet.
    pub(crate) camera: Option<&'a str>,
    pub(crate) theme: &'a str,
    /// The name of what is shown as colours.
    pub(crate) map: Option<&'a str>,
    pub(crate) colours: Option<&'a str>,
    /// What the last colour stands for; none is the largest value.
    pub(crate) clip: Option<f64>,
    pub(crate) caption: &'a str,
    pub(crate) transparent: bool,
}

/// Draws a sheet in a state.
pub(crate) fn picture<'py>(
    py: Python<'py>,
    sheet: &Sheet,
    state: &State,
    look: Look<'_>,
) -> PyResult<Bound<'py, PyArray3<u8>>> {
    let mut theme = named("theme", look.theme, Theme::named, &Theme::NAMES)?;
    if look.transparent {
        theme.background = None;
    }
    let camera = look.camera.map(|name| named("camera", name, Camera::named, &Camera::NAMES)).transpose()?;
    let quantity = look.map.map(|name| named("map", name, Quantity::named, &Quantity::NAMES)).transpose()?;
    let colours = look.colours.map(|name| named("colours", name, ColourMap::named, &ColourMap::NAMES)).transpose()?;
    let ((width, height), caption, clip) = (look.size, look.caption.to_owned(), look.clip);
    let image = py.detach(|| {
        let mut figure = Figure::of_state(sheet.pattern(), &sheet.model, state);
        figure.shade();
        let colours = colours.unwrap_or_default();
        figure.map = quantity.map(|quantity| Map::new(quantity, &sheet.model, state, colours, clip));
        let camera = camera.unwrap_or_else(|| figure.camera());
        let picture = Picture { width, height, camera, theme, caption, ..Picture::default() };
        Processor.draw(&picture, &figure).map_err(|error| match error {
            DrawError::Invalid(error) => error,
            other => origami::Error::invalid("picture", other.to_string(), "a picture by the processor"),
        })
    });
    let image = image.or_raise()?;
    PyArray1::from_vec(py, image.pixels).reshape([image.height as usize, image.width as usize, 4])
}

/// What has a name.
fn named<T>(what: &str, name: &str, find: impl Fn(&str) -> Option<T>, names: &[&str]) -> PyResult<T> {
    find(name).ok_or_else(|| refused(what, &format!("`{name}`"), &format!("one of {}", names.join(", "))))
}
