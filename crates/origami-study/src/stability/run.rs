//! All rows, as many at once as there are processors, in a fixed order.

use std::sync::mpsc;

use super::cases::Case;
use super::found::Budget;
use super::row::{self, CaseResult};
use crate::Watch;
use crate::options::Deadline;

/// Runs the cases, the largest first, and returns their results in the order of the cases.
pub(super) fn all(cases: &[Case], budget: Budget, deadline: Deadline, watch: &mut dyn Watch) -> Vec<CaseResult> {
    let mut order: Vec<usize> = (0..cases.len()).collect();
    let nodes = |i: &usize| cases[*i].pattern.as_ref().map_or(0, |pattern| pattern.vertices.len());
    order.sort_by_key(|i| std::cmp::Reverse(nodes(i)));
    let mut results = vec![CaseResult::LeftOut; cases.len()];
    let (done, finished) = mpsc::channel();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            rayon::scope_fifo(|rows| {
                for i in order {
                    let done = done.clone();
                    rows.spawn_fifo(move |_| {
                        let result = if deadline.passed() { CaseResult::LeftOut } else { row::run(&cases[i], budget) };
                        // Whoever listens does so until the last row.
                        let _ = done.send((i, result));
                    });
                }
            });
            drop(done);
        });
        for (i, result) in finished {
            watch.ran(&cases[i].name());
            results[i] = result;
        }
    });
    results
}
