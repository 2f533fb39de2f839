//! A file or standard input.

use std::fmt;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use origami::Error;
use origami::fold::Document;

use super::read::{self, Opened, Reading};
use crate::nearest::nearest_file;

/// Where a pattern comes from, and how it is read.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Input {
    /// `None` is standard input, written `-`.
    path: Option<PathBuf>,
    reading: Reading,
}

impl Input {
    /// As named on the command line.
    pub(crate) fn new(path: &Path, reading: &Reading) -> Self {
        Self { path: (path.as_os_str() != "-").then(|| path.to_owned()), reading: reading.clone() }
    }

    /// The file; `None` for standard input.
    pub(crate) fn file(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Reads and parses it.
    ///
    /// # Errors
    /// That it cannot be read, is no crease pattern or a wrong one.
    pub(crate) fn read(&self) -> Result<Document, Error> {
        self.open().map(|opened| opened.document)
    }

    /// As [`read`](Self::read), and says what the file is.
    ///
    /// # Errors
    /// As for [`read`](Self::read).
    pub(crate) fn open(&self) -> Result<Opened, Error> {
        self.bytes().map(|(_, opened)| opened)
    }

    /// As [`open`](Self::open), with the bytes of the file.
    ///
    /// # Errors
    /// As for [`read`](Self::read).
    pub(crate) fn bytes(&self) -> Result<(Vec<u8>, Opened), Error> {
        let unreadable = |source| Error::Io { path: self.to_string(), source };
        let bytes = match &self.path {
            None => read::bytes_of(io::stdin().lock()),
            Some(path) => read::bytes_of(File::open(path).map_err(unreadable)?),
        };
        let bytes = bytes?.map_err(unreadable)?;
        let opened = self.reading.document(&bytes, self.file())?;
        Ok((bytes, opened))
    }

    /// The name of what is made from it, without folder and extensions.
    pub(crate) fn stem(&self) -> String {
        let Some(path) = &self.path else { return "stdin".to_owned() };
        let packed = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gz"));
        let name = Path::new(path.file_stem().unwrap_or_default());
        let name = if packed { name.file_stem().unwrap_or_default() } else { name.as_os_str() };
        name.to_string_lossy().into_owned()
    }

    /// An error in it, as a person is told; those of the system name the file already.
    pub(crate) fn describe(&self, error: &Error) -> String {
        match error {
            Error::Io { source, .. } if source.kind() == io::ErrorKind::NotFound => {
                match self.file().filter(|path| !path.exists()).and_then(nearest_file) {
                    Some(other) => format!("{error}; perhaps {other}"),
                    None => error.to_string(),
                }
            }
            Error::Io { .. } => error.to_string(),
            _ => format!("{self}: {error}"),
        }
    }
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.path {
            None => f.write_str("-"),
            Some(path) => path.display().fmt(f),
        }
    }
}
