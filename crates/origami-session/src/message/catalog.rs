//! What can be generated, as a page is told.

use serde::Serialize;

/// A generator.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CatalogEntry {
    /// Its name.
    pub name: &'static str,
    /// What it makes.
    pub summary: &'static str,
    /// Its parameters.
    pub parameters: Vec<CatalogParameter>,
    /// What it makes, seen from above.
    pub picture: Drawing,
}

/// The lines of a pattern.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Drawing {
    /// x and y of each vertex.
    pub points: Vec<f64>,
    /// Two vertices of each edge.
    pub ends: Vec<u32>,
    /// The letter of each edge in FOLD.
    pub letters: String,
}

/// A number that a generator takes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CatalogParameter {
    /// Its name.
    pub name: &'static str,
    /// Its value where none is given.
    pub default: f64,
    /// Meaning, unit and range.
    pub meaning: &'static str,
}
