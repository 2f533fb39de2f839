//! A build without the feature `render`.

use std::io::Write;
use std::path::Path;

use origami::{CreasePattern, Error};

use super::{Artist, Film, Subject};
use crate::args::PictureArgs;

const ABSENT: &str = "this build draws no pictures (feature `render`)";
const EXPECTED: &str = "a build without --no-default-features or with --features render";

/// Lines to draw, as they are written.
pub(crate) type LineSet = String;
/// A colour, as it is written.
pub(crate) type Rgb = String;

/// Nothing can be asked of it.
#[derive(Clone, Default)]
pub(crate) struct Style(());

/// Draws nothing.
#[derive(Default)]
pub(crate) struct Brush(());

impl Style {
    /// # Errors
    /// Always.
    pub(crate) fn new(_args: &PictureArgs) -> Result<Self, String> {
        Err(format!("{ABSENT}; expected {EXPECTED}"))
    }
}

impl Brush {
    pub(crate) fn trouble(&self) -> Option<String> {
        None
    }
}

/// Any size; what draws refuses all.
pub(crate) fn check_size(_size: [u32; 2]) -> Result<(), String> {
    Ok(())
}

pub(crate) fn check_contact(_style: &Style, _states: usize) -> Result<(), String> {
    Ok(())
}

pub(crate) fn check_film(_path: &Path) -> Result<(), String> {
    Ok(())
}

fn absent() -> Error {
    Error::invalid("pictures", ABSENT, EXPECTED)
}

pub(crate) fn png(_artist: &Artist, _subject: Subject<'_>, _writer: &mut dyn Write) -> Result<(), Error> {
    Err(absent())
}

pub(crate) fn pattern_png(_artist: &Artist, _pattern: &CreasePattern, _writer: &mut dyn Write) -> Result<(), Error> {
    Err(absent())
}

pub(crate) fn svg(_artist: &Artist, _pattern: &CreasePattern, _writer: &mut dyn Write) -> Result<(), Error> {
    Err(absent())
}

pub(crate) fn glb(
    _artist: &Artist,
    _subject: Subject<'_>,
    _fps: Option<u16>,
    _writer: &mut dyn Write,
) -> Result<(), Error> {
    Err(absent())
}

pub(crate) fn contact(_artist: &Artist, _subject: Subject<'_>, _writer: &mut dyn Write) -> Result<(), Error> {
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
