//! The file that every figure is written to: one row each, in the same columns.

use std::error::Error;
use std::fs::OpenOptions;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// The name of the file.
pub(crate) const FILE: &str = "results.csv";

/// One figure.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    /// Which part of the run took it.
    pub(crate) section: String,
    /// The pattern.
    pub(crate) sheet: String,
    /// Of one sheet.
    pub(crate) vertices: usize,
    /// How many sheets at once.
    pub(crate) sheets: usize,
    /// `dynamics` or `relax`; empty where no solver has a part in it.
    pub(crate) solver: String,
    /// What computed: a way on the GPU, or the processor with its numbers and threads.
    pub(crate) by: String,
    /// What was measured, with its unit.
    pub(crate) quantity: String,
    /// The figure; yes is 1 and no is 0.
    pub(crate) value: f64,
}

/// Adds rows to the file of a folder, each at once: whatever comes next, it is kept.
pub(crate) struct Results {
    path: PathBuf,
    section: String,
}

impl Results {
    pub(crate) fn new(folder: &Path, section: &str) -> Self {
        Self { path: folder.join(FILE), section: section.to_owned() }
    }

    /// Adds one figure.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn add(&self, row: Row) -> Result<(), Box<dyn Error>> {
        let begun = self.path.exists();
        let file = OpenOptions::new().create(true).append(true).open(&self.path)?;
        let mut writer = csv::WriterBuilder::new().has_headers(!begun).from_writer(file);
        writer.serialize(Row { section: self.section.clone(), ..row })?;
        writer.flush()?;
        Ok(())
    }
}

/// The rows of a folder; none where there is no file.
///
/// # Errors
/// If the file is not one of ours.
pub(crate) fn read(folder: &Path) -> Result<Vec<Row>, Box<dyn Error>> {
    let path = folder.join(FILE);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let rows = csv::Reader::from_path(&path)?.into_deserialize().collect::<Result<_, _>>();
    rows.map_err(|error| format!("{}: {error}", path.display()).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_back_as_they_were_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let row = |vertices, value| Row {
            section: "speed".into(),
            sheet: "miura, \"large\"".into(),
            vertices,
            quantity: "seconds a step".into(),
            value,
            ..Row::default()
        };
        let rows = [row(9, 1.0 / 3.0), row(100, f64::INFINITY), row(4, 2.5e-300)];
        assert_eq!(read(folder.path()).expect("nothing"), []);
        for row in &rows {
            // As each section opens the file anew.
            Results::new(folder.path(), "speed").add(row.clone()).expect("written");
        }
        assert_eq!(read(folder.path()).expect("read"), rows);
    }
}
