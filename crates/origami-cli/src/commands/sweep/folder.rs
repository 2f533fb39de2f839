//! The folder of a sweep. All that can be refused is refused before any work.

use std::fs;
use std::path::{Path, PathBuf};

use origami::Error;

use crate::files::{Format, Input, is_same_file};

/// The two tables.
const CSV: &str = "sweep.csv";
const JSON: &str = "sweep.json";

/// Digits of a sheet's number; more where there are more sheets.
const DIGITS: usize = 4;

/// Where everything goes.
pub(super) struct Folder<'a> {
    path: &'a Path,
    /// Of the folded sheets.
    pub(super) formats: Vec<Format>,
    digits: usize,
}

impl<'a> Folder<'a> {
    /// For `count` sheets of `input`.
    ///
    /// # Errors
    /// What cannot be written, or would replace the input.
    pub(super) fn new(path: &'a Path, formats: &[Format], count: usize, input: &Input) -> Result<Self, String> {
        let shown = path.display();
        if path.as_os_str() == "-" || (path.exists() && !path.is_dir()) {
            return Err(format!("{shown}: is no folder; expected one, or a path where one can be made"));
        }
        let mut own = Vec::new();
        for format in formats {
            if own.contains(format) {
                return Err(format!("--folded: {} is named twice; expected different ones", format.extension()));
            }
            own.push(*format);
        }
        let digits = count.saturating_sub(1).to_string().len().max(DIGITS);
        let folder = Self { path, formats: own, digits };
        for file in fs::read_dir(path).into_iter().flatten().flatten().map(|entry| entry.path()) {
            folder.refuse_replacing(&file, count, input)?;
        }
        Ok(folder)
    }

    /// Of a file that lies there already.
    fn refuse_replacing(&self, file: &Path, count: usize, input: &Input) -> Result<(), String> {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        let number = name.split('.').next().and_then(|digits| digits.parse().ok()).filter(|n: &usize| *n < count);
        let sheets = number.iter().flat_map(|n| self.formats.iter().map(|format| self.sheet(*n, *format)));
        if ![self.csv(), self.json()].into_iter().chain(sheets).any(|written| written == file) {
            return Ok(());
        }
        let shown = file.display();
        if file.is_dir() {
            return Err(format!("{shown}: is a folder; expected a file or nothing there"));
        }
        if !file.is_file() && (file == self.csv() || file == self.json()) {
            return Err(format!("{shown}: is no file that can grow; expected one or nothing there"));
        }
        if input.file().is_some_and(|input| is_same_file(input, file)) {
            return Err(format!("{input}: would be replaced by the sweep; expected another folder"));
        }
        Ok(())
    }

    /// Makes it where it is missing.
    ///
    /// # Errors
    /// [`Error::Io`] where the system refuses.
    pub(super) fn make(&self) -> Result<(), Error> {
        fs::create_dir_all(self.path).map_err(|source| Error::Io { path: self.path.display().to_string(), source })
    }

    pub(super) fn csv(&self) -> PathBuf {
        self.path.join(CSV)
    }

    pub(super) fn json(&self) -> PathBuf {
        self.path.join(JSON)
    }

    /// The file of sheet `index`.
    pub(super) fn sheet(&self, index: usize, format: Format) -> PathBuf {
        self.path.join(format!("{index:0width$}.{}", format.extension(), width = self.digits))
    }
}
