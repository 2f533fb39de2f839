//! Which edges of a pattern a step means.

use super::read::Selector;
use super::{Sequence, Step, wrong};
use crate::error::Error;
use crate::fold::Frame;
use crate::ids::EdgeId;
use crate::model::Model;
use crate::pattern::CreasePattern;

/// What a sequence is for.
#[derive(Clone, Copy)]
pub(super) struct Sheet<'a> {
    pub(super) pattern: &'a CreasePattern,
    /// The frame that the pattern was made from.
    pub(super) frame: &'a Frame,
    pub(super) model: &'a Model,
}

/// A step with its place.
#[derive(Clone, Copy)]
pub(super) struct At<'a> {
    pub(super) index: usize,
    pub(super) step: &'a Step,
}

impl At<'_> {
    pub(super) fn wrong(&self, problem: impl std::fmt::Display, expected: &str) -> Error {
        wrong(self.index, self.step, problem, expected)
    }
}

/// The edges of a step in ascending order, each once; at least one, unless it may be none. Lines that were merged into others stand for these.
pub(super) fn edges(sequence: &Sequence, at: At<'_>, sheet: Sheet<'_>) -> Result<Vec<EdgeId>, Error> {
    let own = of(sequence, &at.step.creases, at, sheet)?;
    if own.is_empty() && !at.step.may_be_empty {
        return Err(at.wrong("it names no crease", "at least one"));
    }
    Ok(own)
}

fn of(sequence: &Sequence, selector: &Selector, at: At<'_>, sheet: Sheet<'_>) -> Result<Vec<EdgeId>, Error> {
    let Sheet { pattern, model, .. } = sheet;
    let mut found = Vec::new();
    for &edge in &selector.edges {
        found.push(named(edge as usize, at, sheet)?);
    }
    for &[a, b] in &selector.vertices {
        found.push(named(between(a, b, sheet).ok_or_else(|| no_edge(a, b, at))?, at, sheet)?);
    }
    for group in &selector.groups {
        let before = found.len();
        for (edge, groups) in sequence.groups.iter().enumerate() {
            if groups.contains(group) {
                found.push(named(edge, at, sheet)?);
            }
        }
        if found.len() == before {
            return Err(at.wrong(format!("no edge is in group `{group}`"), "a name of edges_origami:group"));
        }
    }
    if let Some(letters) = &selector.assignment {
        if let Some(letter) = letters.chars().find(|letter| !"BMVFUJ".contains(*letter)) {
            return Err(at.wrong(format!("assignment `{letter}`"), "letters of B, M, V, F, U, J"));
        }
        let of_these = pattern.edges.iter().map(|edge| letters.contains(edge.assignment.letter()));
        found.extend(of_these.enumerate().filter(|(_, own)| *own).map(|(edge, _)| EdgeId::new(edge)));
    }
    if selector.all {
        let edges = (0..pattern.edges.len()).map(EdgeId::new);
        found.extend(edges.filter(|edge| model.crease_of(*edge).is_some()));
    }
    for edge in &mut found {
        *edge = pattern.edges[edge.index()].alias_of.unwrap_or(*edge);
    }
    found.sort_unstable();
    found.dedup();
    if let Some(except) = &selector.except {
        let without = of(sequence, except, at, sheet)?;
        found.retain(|edge| without.binary_search(edge).is_err());
    }
    Ok(found)
}

/// An edge that is named itself; it must be in the pattern as it is in the file.
fn named(edge: usize, at: At<'_>, Sheet { pattern, frame, .. }: Sheet<'_>) -> Result<EdgeId, Error> {
    if edge >= pattern.edges_in_file {
        let expected = format!("an edge from 0 to {}", pattern.edges_in_file.saturating_sub(1));
        return Err(at.wrong(format!("there is no edge {edge}"), &expected));
    }
    let written = frame.edges_vertices.as_ref().and_then(|edges| edges.get(edge).copied());
    let own = &pattern.edges[edge];
    let same = |written: [u32; 2]| {
        let stands = |v: usize| pattern.alias_of.get(v).copied().flatten().map_or(v, |alias| alias.index());
        let ends = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        ends(written.map(|v| stands(v as usize))) == ends(own.vertices.map(|v| stands(v.index())))
    };
    if own.alias_of.is_none() && !written.is_some_and(same) {
        let problem = format!("edge {edge} was split when the pattern was read");
        return Err(at.wrong(problem, "edges that end where they cross others: a fold at 0 % writes such a file"));
    }
    Ok(EdgeId::new(edge))
}

/// The edge between two vertices of the file.
fn between(a: u32, b: u32, Sheet { frame, .. }: Sheet<'_>) -> Option<usize> {
    let edges = frame.edges_vertices.as_deref().unwrap_or_default();
    edges.iter().position(|ends| *ends == [a, b] || *ends == [b, a])
}

fn no_edge(a: u32, b: u32, at: At<'_>) -> Error {
    at.wrong(format!("there is no edge between vertices {a} and {b}"), "the two ends of an edge")
}
