//! Straight lines that are drawn in pieces.

use std::collections::BTreeMap;

use super::runs::{Node, Run};
use super::{Stroke, key};

/// A point between two pieces may be so far off the line through both, in sizes of the pattern: as far as points may be from
/// lines that they are on.
const OFF: f64 = 1e-6;

/// Nor may it turn the shorter piece by more than this, in radians: pieces of a curve stay.
const BEND: f64 = 1e-3;

/// Makes one line of pieces that meet end to end in one direction, where no other line ends and letter and angle are the
/// same. Whatever crosses there still does.
pub(super) fn join(runs: &mut Vec<Run>, strokes: &[Stroke], size: f64) {
    // Pieces by their ends. `None`: joined to another.
    let mut pieces: Vec<Option<(usize, [Node; 2])>> =
        runs.iter().flat_map(|run| run.nodes.windows(2).map(|ends| Some((run.stroke, [ends[0], ends[1]])))).collect();
    let mut at: BTreeMap<[u64; 2], Vec<usize>> = BTreeMap::new();
    for (index, (_, ends)) in pieces.iter().flatten().enumerate() {
        ends.iter().for_each(|end| at.entry(key(end.at)).or_default().push(index));
    }
    let places: Vec<[u64; 2]> = at.keys().copied().collect();
    for place in places {
        let [one, two] = at[&place][..] else { continue };
        let (Some((stroke, first)), Some((other, second))) = (pieces[one], pieces[two]) else { continue };
        let alike = strokes[stroke].letter == strokes[other].letter && strokes[stroke].angle == strokes[other].angle;
        let turned = |ends: [Node; 2], to_end: bool| {
            if (key(ends[1].at) == place) == to_end { ends } else { [ends[1], ends[0]] }
        };
        let ([from, middle], [_, to]) = (turned(first, true), turned(second, false));
        let whole = to.at - from.at;
        let part = (middle.at - from.at).dot(whole) / whole.length_squared();
        let off = (middle.at - from.at).perp_dot(whole).abs() / whole.length();
        if one == two
            || !alike
            || !(part > 0.0 && part < 1.0)
            || off.is_nan()
            || off > OFF * size
            || off > BEND * (middle.at - from.at).length().min((to.at - middle.at).length())
        {
            continue;
        }
        pieces[one] = Some((stroke, [from, to]));
        pieces[two] = None;
        let moved = at.entry(key(to.at)).or_default();
        moved.iter_mut().filter(|piece| **piece == two).for_each(|piece| *piece = one);
    }
    // Each piece is a run of its own; those of a stroke that still follow each other are one.
    let mut joined: Vec<Run> = Vec::new();
    for (stroke, ends) in pieces.into_iter().flatten() {
        match joined.last_mut() {
            Some(run) if run.stroke == stroke && run.nodes.last().map(|node| node.at) == Some(ends[0].at) => {
                run.nodes.push(ends[1]);
            }
            _ => joined.push(Run { stroke, curved: false, nodes: ends.to_vec() }),
        }
    }
    *runs = joined;
}
