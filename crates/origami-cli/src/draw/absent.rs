//! A build without the feature `render`: what is to be drawn is refused before any work.

use std::io::Write;
use std::path::Path;

use origami::{CreasePattern, Error, Model, State};
use serde_json::Value;

use super::{Faults, Film, Subject};
use crate::args::PictureArgs;
use crate::backend::Backend;
use crate::files::Format;

const ABSENT: &str = "this build draws no pictures (feature `render`)";
const EXPECTED: &str = "a build without --no-default-features or with --features render";

/// How pictures look: nothing can be asked for.
#[derive(Clone, Default)]
pub(crate) struct Style(());

impl Style {
    /// # Errors
    /// Always.
    pub(crate) fn new(_args: &PictureArgs) -> Result<Self, String> {
        Err(format!("{ABSENT}; expected {EXPECTED}"))
    }
}

/// Draws nothing.
#[derive(Default)]
pub(crate) struct Artist(());

impl Artist {
    pub(crate) fn new(_style: Style, _backend: Option<&Backend>) -> Self {
        Self(())
    }

    pub(crate) fn trouble(&self) -> Option<String> {
        None
    }
}

pub(crate) fn oddities(_args: &PictureArgs) -> Vec<String> {
    Vec::new()
}

pub(crate) fn check_contact(_style: &Style, _states: usize) -> Result<(), String> {
    Ok(())
}

pub(crate) fn check_drawable(
    _format: Format,
    _style: &Style,
    _pattern: &CreasePattern,
    _model: &Model,
    _states: usize,
) -> Result<(), Error> {
    Ok(())
}

pub(crate) fn check_film(_path: &Path) -> Result<(), String> {
    Ok(())
}

/// Nobody knows them.
pub(crate) fn orders(_model: &Model, _state: &State) -> Option<Value> {
    None
}

fn absent() -> Error {
    Error::invalid("pictures", ABSENT, EXPECTED)
}

pub(crate) fn sheet(
    _format: Format,
    _artist: &Artist,
    _subject: Subject<'_>,
    _fps: Option<u16>,
    _writer: &mut dyn Write,
) -> Result<(), Error> {
    Err(absent())
}

pub(crate) fn pattern(
    _format: Format,
    _artist: &Artist,
    _pattern: &CreasePattern,
    _writer: &mut dyn Write,
) -> Result<(), Error> {
    Err(absent())
}

pub(crate) fn faulty_pattern(
    _format: Format,
    _artist: &Artist,
    _pattern: &CreasePattern,
    _faults: &Faults<'_>,
    _writer: &mut dyn Write,
) -> Result<(), Error> {
    Err(absent())
}

pub(crate) fn film(
    _artist: &Artist,
    _subject: Subject<'_>,
    _film: Film,
    _path: &Path,
    _drawn: &mut dyn FnMut(usize, usize),
) -> Result<Vec<String>, Error> {
    Err(absent())
}
