//! Crease patterns as the field writes them, read into FOLD [`Document`]s.
//!
//! [`read`] takes the bytes of any file that is known here; what it is follows from its content ([`Format::of`]). All
//! formats but FOLD are lists of lines: each becomes an edge of the key frame, with its letter, its fold angle and, under
//! [`EDGES_SOURCE`](origami_core::pattern::keys::SOURCE), where in the file it stood, which errors and warnings of the
//! pattern then name. Lines are not cut or joined here; that is done, for all formats alike, where the pattern is made.
//!
//! ```
//! use origami_core::CreasePattern;
//!
//! let square = "1 0 0 1 0\n1 1 0 1 1\n1 1 1 0 1\n1 0 1 0 0\n3 0 0 1 1\n";
//! let document = origami_formats::read(square.as_bytes(), None, &origami_formats::Options::default())?;
//! let pattern = CreasePattern::from_document(&document, 0)?;
//! assert_eq!(pattern.faces.len(), 2);
//! # Ok::<(), origami_core::Error>(())
//! ```
#![forbid(unsafe_code)]

mod colours;
pub mod cp;
mod curves;
mod format;
mod lines;
pub mod svg;

use std::path::Path;

use origami_core::Error;
use origami_core::fold::Document;

pub use colours::Colours;
pub use format::Format;
pub use lines::Lines;

/// How files are read.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// Which colours stand for which letters, where colours do.
    pub colours: Colours,
    /// How far straight pieces may be from a curve that they stand for, in the file's unit of length. `None` takes a share of
    /// the pattern's size.
    pub curve_tolerance: Option<f64>,
}

/// Reads a crease pattern of any format. `name` is the file's name, where it has one: it decides where the content does not.
///
/// # Errors
/// [`Error::Syntax`] with the line, and [`Error::Invalid`] for what can be read but means nothing.
pub fn read(bytes: &[u8], name: Option<&Path>, options: &Options) -> Result<Document, Error> {
    match Format::of(bytes, name) {
        Format::Fold => Document::from_slice(bytes),
        Format::Cp => cp::read(bytes),
        Format::Svg => svg::read(bytes, options),
    }
}

/// Reads a file of any format.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read; otherwise as [`read`].
pub fn read_file(path: impl AsRef<Path>, options: &Options) -> Result<Document, Error> {
    let path = path.as_ref();
    let bytes = std::fs::read(path).map_err(|source| Error::Io { path: path.display().to_string(), source })?;
    read(&bytes, Some(path), options)
}
