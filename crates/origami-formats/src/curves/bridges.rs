//! Lines that tie together what hangs in a face without touching its outline, such as circles around each other: rulings are
//! found in faces without holes.

use std::collections::BTreeMap;

use glam::DVec2;

use super::key;
use super::runs::Run;

/// How many points of a curve are tried.
const TRIED: usize = 8;
/// How many curves of a group are tried.
const CURVES: usize = 4;

/// For each group of runs that touches no other, a line at a right angle to one of its curves to the nearest of another
/// group, if one lies there. Ends on curves are kept.
pub(super) fn find(runs: &mut [Run]) -> Vec<[DVec2; 2]> {
    let mut group = groups(runs);
    let mut bridges = Vec::new();
    let mut failed = vec![0; runs.len()];
    for run in 0..runs.len() {
        if !runs[run].curved || failed[group[run]] == CURVES || group.iter().all(|other| *other == group[run]) {
            continue;
        }
        let nodes = runs[run].nodes.len();
        let tried = (0..TRIED).map(|i| i * (nodes - 1) / TRIED);
        let found = tried.flat_map(|node| [-1.0, 1.0].map(|side| (node, side))).find_map(|(node, side)| {
            let (to, other) = across(runs, run, node, side)?;
            (group[other] != group[run]).then_some((node, to, other))
        });
        if let Some((node, to, other)) = found {
            runs[run].nodes[node].kept = true;
            bridges.push([runs[run].nodes[node].at, landed(&mut runs[other], to)]);
            let (old, new) = (group[other], group[run]);
            group.iter_mut().filter(|group| **group == old).for_each(|group| *group = new);
        } else {
            failed[group[run]] += 1;
        }
    }
    bridges
}

/// Runs that touch, directly or by others, have one number.
fn groups(runs: &[Run]) -> Vec<usize> {
    let mut group: Vec<usize> = (0..runs.len()).collect();
    let mut first: BTreeMap<[u64; 2], usize> = BTreeMap::new();
    for (run, of) in runs.iter().enumerate() {
        for node in of.nodes.iter().filter(|node| node.kept) {
            let other = *first.entry(key(node.at)).or_insert(run);
            let (old, new) = (group[run].max(group[other]), group[run].min(group[other]));
            if old != new {
                group.iter_mut().filter(|group| **group == old).for_each(|group| *group = new);
            }
        }
    }
    group
}

/// Where the line at a right angle to a curve first meets a run, to its left (1) or right (-1).
fn across(runs: &[Run], run: usize, node: usize, side: f64) -> Option<(DVec2, usize)> {
    let nodes = &runs[run].nodes;
    let from = nodes[node].at;
    let normal = side * (nodes.get(node + 1)?.at - nodes[node.saturating_sub(1)].at).try_normalize()?.perp();
    let mut nearest: Option<(f64, usize)> = None;
    for (other, of) in runs.iter().enumerate() {
        for ends in of.nodes.windows(2).filter(|ends| ends[0].at != from && ends[1].at != from) {
            let piece = ends[1].at - ends[0].at;
            let turn = normal.perp_dot(piece);
            let along = (ends[0].at - from).perp_dot(piece) / turn;
            let at = (ends[0].at - from).perp_dot(normal) / turn;
            if turn != 0.0 && along > 0.0 && (0.0..=1.0).contains(&at) && nearest.is_none_or(|(least, _)| along < least)
            {
                nearest = Some((along, other));
            }
        }
    }
    nearest.map(|(along, other)| (from + along * normal, other))
}

/// The end of a bridge: on a curve its nearest point, which is kept from now on.
fn landed(run: &mut Run, to: DVec2) -> DVec2 {
    if !run.curved {
        return to;
    }
    let nearest = run.nodes.iter_mut().min_by(|a, b| a.at.distance(to).total_cmp(&b.at.distance(to)));
    nearest.map_or(to, |node| {
        node.kept = true;
        node.at
    })
}
