//! A file or standard input.

use std::fmt;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use origami::Error;
use origami::fold::Document;

use super::read;
use crate::nearest::nearest_file;

/// Where a pattern comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Input {
    /// Written `-`.
    Stdin,
    /// A file.
    File(PathBuf),
}

impl Input {
    /// As named on the command line.
    pub(crate) fn new(path: &Path) -> Self {
        if path.as_os_str() == "-" { Self::Stdin } else { Self::File(path.to_owned()) }
    }

    /// Reads and parses it.
    ///
    /// # Errors
    /// As for [`Document::read`].
    pub(crate) fn read(&self) -> Result<Document, Error> {
        let (bytes, name) = match self {
            Self::Stdin => {
                let mut bytes = Vec::new();
                (io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes), None)
            }
            Self::File(path) => (std::fs::read(path), Some(path.as_path())),
        };
        let bytes = bytes.map_err(|source| Error::Io { path: self.to_string(), source })?;
        read::document(&bytes, name)
    }

    /// The name of what is made from it, without folder and extension.
    pub(crate) fn stem(&self) -> String {
        match self {
            Self::Stdin => "stdin".to_owned(),
            Self::File(path) => path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        }
    }

    /// An error in it, as a person is told; those of the system name the file already.
    pub(crate) fn describe(&self, error: &Error) -> String {
        match error {
            Error::Io { source, .. } if source.kind() == io::ErrorKind::NotFound => match self {
                Self::File(path) if !path.exists() => match nearest_file(path) {
                    Some(other) => format!("{error}; perhaps {other}"),
                    None => error.to_string(),
                },
                _ => error.to_string(),
            },
            Error::Io { .. } => error.to_string(),
            _ => format!("{self}: {error}"),
        }
    }
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stdin => f.write_str("-"),
            Self::File(path) => path.display().fmt(f),
        }
    }
}
