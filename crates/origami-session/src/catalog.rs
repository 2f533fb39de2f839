//! What can be generated, as a page shows it.

use origami_core::CreasePattern;
use origami_core::generate::catalog::{self, generate};

use crate::message::{CatalogEntry, CatalogParameter, Drawing, Reply};
use crate::packet::Packet;

/// All of it.
pub(crate) fn catalog() -> Packet {
    let entries = catalog::entries().iter().map(|entry| CatalogEntry {
        name: entry.name,
        summary: entry.summary,
        parameters: entry
            .parameters
            .iter()
            .map(|parameter| CatalogParameter {
                name: parameter.name,
                default: parameter.default,
                meaning: parameter.meaning,
            })
            .collect(),
        picture: generate(entry.name, &[]).map(|pattern| drawing(&pattern)).unwrap_or_default(),
    });
    Packet::new(&Reply::Catalog { entries: entries.collect() }, Vec::new())
}

fn drawing(pattern: &CreasePattern) -> Drawing {
    Drawing {
        points: pattern.vertices.iter().flat_map(|vertex| [vertex.x, vertex.y]).collect(),
        ends: pattern.edges.iter().flat_map(|edge| edge.vertices.map(|vertex| vertex.0)).collect(),
        letters: pattern.edges.iter().map(|edge| edge.assignment.letter()).collect(),
    }
}
