//! Crease patterns as the field writes them, read into FOLD [`Document`]s.
//!
//! [`read`] takes the bytes of any file that is known here, compressed by gzip or not; what it is follows from its content
//! ([`Format::of`]). All formats but FOLD and OBJ are lists of lines: each becomes an edge of the key frame, with its letter,
//! its fold angle and, under [`EDGES_SOURCE`](origami_core::pattern::keys::SOURCE), where in the file it stood, which errors
//! and warnings of the pattern then name. Lines are not cut or joined here; that is done, for all formats alike, where the
//! pattern is made. What of a file is no line of a pattern is left out, with a warning.
//!
//! [`mod@write`] has the other way: CP, SVG and DXF of a pattern.
//!
//! `docs/FORMATS.md` says what each format has, what of it is read, and whose conventions are followed.
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
pub mod dxf;
mod format;
mod gzip;
mod letters;
mod lines;
mod number;
pub mod obj;
pub mod opx;
pub mod orh;
pub mod ori;
pub mod svg;
mod text;
pub mod write;
mod xml;

use std::borrow::Cow;
use std::io::Read;
use std::path::Path;

use origami_core::Error;
use origami_core::error::{ErrorCode, Place, Warning, WarningCode};
use origami_core::fold::Document;

pub use colours::Colours;
pub use format::Format;
pub use lines::Lines;

/// The most bytes of a file, and the most that may come out of a compressed one: 1 GiB. Sheets of a million vertices have a
/// fifth of it; a stream without end is refused when it has been read so far.
pub const MOST_BYTES: u64 = 1 << 30;
/// The most bytes of a file that is not FOLD: 256 MiB, some ten million lines.
const MOST_TEXT: u64 = 1 << 28;

/// How files are read.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// Which colours stand for which letters, where colours do.
    pub colours: Colours,
    /// How far straight pieces may be from a curve that they stand for, in the file's unit of length. `None` takes
    /// 1/2000 of the longer side of the drawing.
    pub curve_tolerance: Option<f64>,
}

/// What was read.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Opened {
    /// The pattern, with warnings of what was left out and what is odd about the file.
    pub document: Document,
    /// What the file is.
    pub format: Format,
    /// Whether it was compressed by gzip.
    pub compressed: bool,
}

/// Reads a crease pattern of any format. `name` is the file's name, where it has one: it decides where the content does not.
///
/// # Errors
/// [`Error::Syntax`] with the line, and [`Error::Invalid`] for what can be read but means nothing: with the code
/// [`ErrorCode::NotAPattern`] and what the file is, where it is known to be something else.
pub fn read(bytes: &[u8], name: Option<&Path>, options: &Options) -> Result<Document, Error> {
    open(bytes, name, options).map(|opened| opened.document)
}

/// As [`read`], and says what the file is.
///
/// # Errors
/// As [`read`].
pub fn open(bytes: &[u8], name: Option<&Path>, options: &Options) -> Result<Opened, Error> {
    let compressed = gzip::is_gzip(bytes);
    let bytes = if compressed { Cow::Owned(gzip::unpacked(bytes, MOST_BYTES)?) } else { Cow::Borrowed(bytes) };
    let bytes = utf8(&bytes);
    let format = Format::of(&bytes, name)?;
    let most = if format == Format::Fold { MOST_BYTES } else { MOST_TEXT };
    if bytes.len() as u64 > most {
        return Err(too_large(most));
    }
    let mut document = match format {
        Format::Fold => Document::from_slice(&bytes)?,
        Format::Cp => cp::read(&bytes)?,
        Format::Opx => opx::read(&bytes)?,
        Format::Ori => ori::read(&bytes)?,
        Format::Orh => orh::read(&bytes)?,
        Format::Svg => svg::read(&bytes, options)?,
        Format::Obj => obj::read(&bytes, options)?,
        Format::Dxf => dxf::read(&bytes, options)?,
    };
    if document.key_frame.edges_vertices.as_ref().is_some_and(Vec::is_empty) && format != Format::Fold {
        let problem = format!("a {format} file without lines");
        return Err(Error::new(
            ErrorCode::NotAPattern,
            Place::key("the file"),
            problem,
            "the lines of a crease pattern",
        ));
    }
    if let Some(named) = name.and_then(Format::of_name).filter(|named| *named != format) {
        let message = format!("its name says {named}, its content is {format}; read as {format}");
        document.warnings.insert(0, Warning::new(WarningCode::OtherFormat, Place::key("the file"), message));
    }
    Ok(Opened { document, format, compressed })
}

/// Reads a file of any format.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read; otherwise as [`read`].
pub fn read_file(path: impl AsRef<Path>, options: &Options) -> Result<Document, Error> {
    let path = path.as_ref();
    let unreadable = |source| Error::Io { path: path.display().to_string(), source };
    let bytes = bytes_of(std::fs::File::open(path).map_err(unreadable)?)?.map_err(unreadable)?;
    read(&bytes, Some(path), options)
}

/// All bytes of a stream, up to [`MOST_BYTES`]; inside, what the system says.
///
/// # Errors
/// That there are more.
pub fn bytes_of(stream: impl Read) -> Result<std::io::Result<Vec<u8>>, Error> {
    let mut bytes = Vec::new();
    let read = stream.take(MOST_BYTES + 1).read_to_end(&mut bytes);
    if bytes.len() as u64 > MOST_BYTES { Err(too_large(MOST_BYTES)) } else { Ok(read.map(|_| bytes)) }
}

fn too_large(most: u64) -> Error {
    let problem = format!("is larger than {most} bytes, or without end");
    Error::new(ErrorCode::InputTooLarge, Place::key("the file"), problem, "a crease pattern")
}

/// Text in UTF-16 that says so, as UTF-8; all else as it is.
fn utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return text::decode(bytes).into_owned().into_bytes().into();
    }
    bytes.into()
}
