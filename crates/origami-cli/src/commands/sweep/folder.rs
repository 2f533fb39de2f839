//! The folder of a sweep. All that can be refused is refused before any work.

use std::fs;
use std::path::{Path, PathBuf};

use origami::Error;

use crate::args::Shard;
use crate::files::{Format, Input, is_same_file};

/// What the two tables are called.
const NAME: &str = "sweep";

/// Between the number of a part and that of all.
const OF: &str = "-of-";

/// Digits of a sheet's number; more where there are more sheets.
const DIGITS: usize = 4;

/// Whether this is what the table of a part is called, as JSON.
pub(super) fn is_of_part(name: &str) -> bool {
    let number = name.strip_prefix(NAME).and_then(|name| name.strip_prefix('.')?.strip_suffix(".json"));
    let is_count = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    number.and_then(|number| number.split_once(OF)).is_some_and(|(i, n)| is_count(i) && is_count(n))
}

/// The tables of a whole sweep in this folder: CSV, then JSON.
pub(super) fn tables(path: &Path) -> [PathBuf; 2] {
    ["csv", "json"].map(|extension| path.join(format!("{NAME}.{extension}")))
}

/// Where everything goes.
pub(super) struct Folder<'a> {
    path: &'a Path,
    /// Of the folded sheets.
    pub(super) formats: Vec<Format>,
    digits: usize,
    shard: Option<Shard>,
}

impl<'a> Folder<'a> {
    /// For `count` sheets of `input`, or for a part of them.
    ///
    /// # Errors
    /// What cannot be written, or would replace the input.
    pub(super) fn new(
        path: &'a Path,
        formats: &[Format],
        count: usize,
        shard: Option<Shard>,
        input: &Input,
    ) -> Result<Self, String> {
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
        let folder = Self { path, formats: own, digits, shard };
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
        self.table("csv")
    }

    pub(super) fn json(&self) -> PathBuf {
        self.table("json")
    }

    /// Of a part it has a name of its own, so that all can go to one folder.
    fn table(&self, extension: &str) -> PathBuf {
        self.path.join(match self.shard {
            None => format!("{NAME}.{extension}"),
            Some(shard) => {
                let digits = shard.of.to_string().len();
                format!("{NAME}.{:0digits$}{OF}{}.{extension}", shard.number, shard.of)
            }
        })
    }

    /// The file of sheet `index`.
    pub(super) fn sheet(&self, index: usize, format: Format) -> PathBuf {
        self.path.join(format!("{index:0width$}.{}", format.extension(), width = self.digits))
    }
}
