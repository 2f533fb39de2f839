//! What a run wrote, read again.

use std::collections::BTreeSet;
use std::error::Error;
use std::path::Path;

use serde_json::Value;

use crate::results::{self, Row};
use crate::{machine, run};

/// What a run wrote.
pub(crate) struct Run {
    /// The folder's own name.
    pub(crate) name: String,
    pub(crate) folder: String,
    pub(crate) rows: Vec<Row>,
    pub(crate) machine: Value,
    pub(crate) run: Value,
}

impl Run {
    /// Reads it from its folder.
    ///
    /// # Errors
    /// If the folder was not written by a run.
    pub(crate) fn read(folder: &Path) -> Result<Self, Box<dyn Error>> {
        let json = |name: &str| -> Result<Value, Box<dyn Error>> {
            let path = folder.join(name);
            let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
            Ok(serde_json::from_str(&text)?)
        };
        let name = folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let rows = results::read(folder)?;
        let folder = folder.display().to_string();
        let (machine, run) = (json(machine::FILE)?, json(run::FILE)?);
        Ok(Self { name, rows, machine, run, folder })
    }

    /// `name (interface)`, and whether it is software.
    pub(crate) fn adapter(&self) -> String {
        let of = |key: &str| self.machine["adapter"][key].as_str().unwrap_or("?");
        let software = if of("kind") == "software" { ", a software adapter" } else { "" };
        format!("{} ({}){software}", of("name"), of("backend"))
    }

    pub(crate) fn of<'r>(&'r self, section: &'r str, quantity: &'r str) -> impl Iterator<Item = &'r Row> {
        self.rows.iter().filter(move |row| row.section == section && row.quantity == quantity)
    }

    /// The figure of one row like `like`.
    pub(crate) fn value(&self, section: &str, quantity: &str, like: impl Fn(&Row) -> bool) -> Option<f64> {
        self.of(section, quantity).find(|row| like(row)).map(|row| row.value)
    }
}

/// Each once, in the order in which they come.
pub(crate) fn distinct<'r>(of: impl Iterator<Item = &'r str>) -> Vec<&'r str> {
    let mut seen = BTreeSet::new();
    of.filter(|name| seen.insert(*name)).collect()
}
