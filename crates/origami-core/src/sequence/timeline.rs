//! The short form: when each crease folds, without steps.

use serde_json::Value;

use super::read::{Selector, Step, To};
use super::{Sequence, TIMELINE};
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;

impl Sequence {
    /// The order under `edges_origami:timeline`, to a percentage of the pattern's fold angles: for each edge the shares of the
    /// whole between which it folds, or `null` for all of it. `None` where the frame has none.
    ///
    /// # Errors
    /// [`Error::Invalid`] that names the entry.
    pub fn of_timeline(frame: &Frame, percent: f64) -> Result<Option<Self>, Error> {
        let Some(value) = frame.extra.get(TIMELINE).filter(|value| !value.is_null()) else { return Ok(None) };
        let entries = value
            .as_array()
            .ok_or_else(|| Error::new(ErrorCode::WrongType, Place::key(TIMELINE), "is no array", "an array"))?;
        let edges = frame.edges_vertices.as_ref().map_or(0, Vec::len);
        if entries.len() != edges {
            let problem = format!("has {} entries where edges_vertices has {edges}", entries.len());
            return Err(Error::new(ErrorCode::WrongLength, Place::key(TIMELINE), problem, "one entry for each edge"));
        }
        // Edges by when they fold, in the order in which files name them first.
        let mut spans: Vec<([f64; 2], Vec<u32>)> = Vec::new();
        for (edge, (index, entry)) in (0..).zip(entries.iter().enumerate()) {
            let Some(span) = span(index, entry)? else { continue };
            match spans.iter_mut().find(|(known, _)| *known == span) {
                Some((_, edges)) => edges.push(edge),
                None => spans.push((span, vec![edge])),
            }
        }
        let timed: Vec<u32> = spans.iter().flat_map(|(_, edges)| edges.clone()).collect();
        let rest = Selector { all: true, except: Some(Box::new(Selector::of_edges(timed))), ..Selector::default() };
        let untimed = entries.iter().any(Value::is_null);
        let steps = untimed.then_some(([0.0, 1.0], rest)).into_iter();
        let steps = steps.chain(spans.into_iter().map(|(span, edges)| (span, Selector::of_edges(edges))));
        let steps = steps.enumerate().map(|(index, ([start, end], creases))| {
            let step = Step::drive(format!("{start} to {end}"), creases, To::Percent(percent));
            let step = Step { start, end, may_be_empty: untimed && index == 0, ..step };
            if index == 0 { step } else { step.put_beside() }
        });
        Ok(Some(Self { steps: steps.collect(), groups: Vec::new() }))
    }
}

impl Selector {
    /// These edges of the file.
    pub(super) fn of_edges(edges: Vec<u32>) -> Self {
        Self { edges, ..Self::default() }
    }
}

/// When an edge folds.
fn span(index: usize, entry: &Value) -> Result<Option<[f64; 2]>, Error> {
    let numbers = |entries: &Vec<Value>| match entries.as_slice() {
        [start, end] => Some([start.as_f64()?, end.as_f64()?]),
        _ => None,
    };
    if entry.is_null() {
        return Ok(None);
    }
    let span = entry.as_array().and_then(numbers).filter(|[start, end]| 0.0 <= *start && start < end && *end <= 1.0);
    span.map(Some).ok_or_else(|| {
        let shown: String = entry.to_string().chars().take(24).collect();
        let expected = "null, or [start, end] with 0 <= start < end <= 1";
        Error::new(ErrorCode::WrongValue, Place::entry(TIMELINE, index), format!("is {shown}"), expected)
    })
}
