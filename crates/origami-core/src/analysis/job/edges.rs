//! Which edges an entry of a job means, and which members lie on them.

use serde::{Deserialize, Serialize};

use crate::error::{Error, ErrorCode, Place};
use crate::ids::SideId;
use crate::model::Model;
use crate::pattern::{Assignment, CreasePattern};

/// Edges of the file, by name or by number.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(untagged)]
pub enum Edges {
    /// All of a sort.
    Named(EdgesName),
    /// Numbers of edges, from 0.
    List(Vec<u32>),
}

/// Edges of a sort.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum EdgesName {
    /// All of them.
    All,
    /// Those that are creases: mountains, valleys, and those that nothing drives.
    Creases,
    /// Those that are flat, along which facets bend.
    Facets,
}

/// What lies on an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A bar.
    Bars,
    /// A hinge.
    Hinges,
}

/// A bar or hinge with its edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Member {
    pub(super) edge: u32,
    pub(super) index: usize,
}

impl Edges {
    /// The members on these edges, in the order of the edges; `place` is the entry's. At least one.
    pub(super) fn members(
        &self,
        place: &str,
        kind: Kind,
        pattern: &CreasePattern,
        model: &Model,
    ) -> Result<Vec<Member>, Error> {
        let on_edge = on_edges(kind, pattern, model);
        let is_meant = |edge: usize, name: EdgesName| match name {
            EdgesName::All => true,
            EdgesName::Facets => matches!(pattern.edges[edge].assignment, Assignment::Flat | Assignment::Join),
            EdgesName::Creases => matches!(
                pattern.edges[edge].assignment,
                Assignment::Mountain | Assignment::Valley | Assignment::Unassigned
            ),
        };
        let member = |edge: usize| on_edge.get(edge).copied().flatten();
        let found: Vec<Member> = match self {
            Self::Named(name) => {
                let all = (0..pattern.edges_in_file).filter(|edge| is_meant(*edge, *name));
                all.filter_map(|edge| member(edge).map(|index| Member { edge: edge as u32, index })).collect()
            }
            Self::List(list) => {
                let own = |(i, edge): (usize, &u32)| {
                    let index = member(*edge as usize).ok_or_else(|| {
                        let what = if kind == Kind::Bars { "an edge" } else { "an edge between two faces" };
                        let place = Place::key(format!("{place}[{i}]"));
                        let expected = format!("{what}, of the file's {}", pattern.edges_in_file);
                        Error::new(ErrorCode::WrongValue, place, format!("is edge {edge}"), expected)
                    })?;
                    Ok(Member { edge: *edge, index })
                };
                list.iter().enumerate().map(own).collect::<Result<_, Error>>()?
            }
        };
        if found.is_empty() {
            let place = Place::key(place.to_owned());
            return Err(Error::new(ErrorCode::WrongValue, place, "no edge of the file is meant", "one or more"));
        }
        Ok(found)
    }
}

/// For each edge of the file the bar or hinge that lies on it.
pub(super) fn on_edges(kind: Kind, pattern: &CreasePattern, model: &Model) -> Vec<Option<usize>> {
    let mut by_edge = vec![None; pattern.edges.len()];
    let mut enter = |side: SideId, index: usize| {
        if let Some(edge) = model.mesh.sides[side.index()].edge {
            by_edge[edge.index()] = Some(index);
        }
    };
    match kind {
        // Bars are numbered as sides.
        Kind::Bars => (0..model.mesh.sides.len()).for_each(|i| enter(SideId::new(i), i)),
        Kind::Hinges => model.creases.iter().enumerate().for_each(|(i, crease)| enter(crease.side, i)),
    }
    let stands = |edge: usize| pattern.edges[edge].alias_of.map_or(edge, |own| own.index());
    (0..pattern.edges_in_file).map(|edge| by_edge[stands(edge)]).collect()
}
