//! Ends of strokes that are meant to meet.

use glam::DVec2;

use super::runs::Run;

/// Moves ends of strokes that are within `tolerance` of each other to one point, and ends of curves that are so near to a
/// straight line onto it; returns the strokes whose ends were moved. Pieces may be so far from their curves, so nothing is
/// told apart that is nearer.
pub(super) fn join(runs: &mut [Run], tolerance: f64) -> Vec<usize> {
    let mut moved = Vec::new();
    let ends = kept(runs);
    let at = |runs: &[Run], (run, node): (usize, usize)| runs[run].nodes[node].at;
    // Each end goes to the first, from left to right, that is near and has not moved itself.
    let mut settled: Vec<(usize, usize)> = Vec::new();
    for &end in &ends {
        let here = at(runs, end);
        let near = settled.iter().rev().take_while(|other| at(runs, **other).x >= here.x - tolerance);
        let home = near
            .copied()
            .filter(|other| at(runs, *other).distance(here) <= tolerance && !are_neighbours(end, *other))
            .last();
        match home {
            Some(other) if at(runs, other) == here => {}
            Some(other) => {
                runs[end.0].nodes[end.1].at = at(runs, other);
                moved.push(runs[end.0].stroke);
            }
            None => settled.push(end),
        }
    }
    let lines: Vec<[DVec2; 2]> = runs
        .iter()
        .filter(|run| !run.curved)
        .flat_map(|run| run.nodes.windows(2).map(|ends| [ends[0].at, ends[1].at]))
        .collect();
    for (run, node) in ends {
        if !runs[run].curved {
            continue;
        }
        let here = runs[run].nodes[node].at;
        let foot = |[a, b]: &[DVec2; 2]| {
            let part = (here - *a).dot(*b - *a) / a.distance_squared(*b);
            let foot = *a + part * (*b - *a);
            let inside = part > 0.0 && part < 1.0 && foot.distance(here) <= tolerance;
            // What is at an end, or on the line already, stays.
            (inside && here != *a && here != *b && foot.distance(here) > ON_LINE * tolerance).then_some(foot)
        };
        let nearest =
            lines.iter().filter_map(foot).min_by(|one, two| one.distance(here).total_cmp(&two.distance(here)));
        if let Some(foot) = nearest.filter(|_| lines.iter().flatten().all(|end| *end != here)) {
            runs[run].nodes[node].at = foot;
            moved.push(runs[run].stroke);
        }
    }
    runs.iter_mut().for_each(|run| {
        run.nodes.dedup_by(|next, before| {
            let same = next.at == before.at;
            before.kept |= same && next.kept;
            same
        })
    });
    moved
}

/// As far from a line as rounding leads, in tolerances.
const ON_LINE: f64 = 1e-6;

/// All kept points, from left to right.
fn kept(runs: &[Run]) -> Vec<(usize, usize)> {
    let all = runs.iter().enumerate().flat_map(|(run, of)| (0..of.nodes.len()).map(move |node| (run, node)));
    let mut kept: Vec<(usize, usize)> = all.filter(|(run, node)| runs[*run].nodes[*node].kept).collect();
    let x = |(run, node): (usize, usize)| runs[run].nodes[node].at.x;
    kept.sort_by(|&a, &b| x(a).total_cmp(&x(b)).then(a.cmp(&b)));
    kept
}

/// Whether they are the two ends of a short piece.
fn are_neighbours(one: (usize, usize), two: (usize, usize)) -> bool {
    one.0 == two.0 && one.1.abs_diff(two.1) == 1
}
