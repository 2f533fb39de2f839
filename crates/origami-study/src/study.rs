//! What comes of a study, and the files that it becomes.

use std::path::{Path, PathBuf};

use crate::{Plot, PlotError, Table};

/// A piece of a study's document.
#[derive(Clone, Debug)]
pub enum Part {
    /// A heading of the second level.
    Heading(String),
    /// A paragraph of Markdown.
    Text(String),
    /// A table: whole as FILE.csv and FILE.json, and in the document with some of its columns and rows.
    Table {
        /// Name of its files, without an ending.
        file: String,
        /// The table.
        table: Table,
        /// Keys of the columns that the document shows; none: only a line with the names of the files.
        shown: Vec<&'static str>,
    },
    /// A plot, as FILE.svg and in the document.
    Plot {
        /// Name of its file, without an ending.
        file: String,
        /// The plot.
        plot: Plot,
    },
}

/// A study, done.
#[derive(Clone, Debug)]
pub struct Study {
    /// Name of its document: NAME.md.
    pub name: &'static str,
    /// Title of its document.
    pub title: String,
    /// What it holds, in order.
    pub parts: Vec<Part>,
}

/// A study could not be run or written.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// A plot could not be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// A file could not be written, or a pattern makes no model.
    #[error(transparent)]
    Core(#[from] origami_core::Error),
}

impl Study {
    /// Writes the document, tables and plots into `folder`, each file whole or not at all, and returns their paths.
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, StudyError> {
        let _ = folder;
        Ok(Vec::new())
    }
}
