//! What came of one kind of figures.

use super::asked::Asked;
use crate::Part;
use crate::table::Table;

/// A piece of the document, and the figures in it that are asked for.
pub(super) struct Found {
    pub(super) parts: Vec<Part>,
    pub(super) asked: Vec<Asked>,
}

impl Found {
    /// One table under a heading, shown whole.
    pub(super) fn one(heading: &str, text: &str, (file, table): (&str, Table), asked: Vec<Asked>) -> Self {
        let shown = table.columns.iter().map(|column| column.key).collect();
        let table = Part::Table { file: file.into(), table, shown };
        Self { parts: vec![Part::Heading(heading.into()), Part::Text(text.into()), table], asked }
    }
}
