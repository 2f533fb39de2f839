//! All rows, as many at once as there are processors, in a fixed order.

use std::sync::mpsc;

use super::row::{Answer, Budget, answer};
use super::scenes::Scene;
use crate::Watch;
use crate::options::Deadline;

/// Runs the scenes, the largest first, and returns their answers in the order of the scenes.
pub(super) fn all(scenes: &[Scene], budget: Budget, deadline: Deadline, watch: &mut dyn Watch) -> Vec<Answer> {
    let mut order: Vec<usize> = (0..scenes.len()).collect();
    let nodes = |i: &usize| scenes[*i].pattern.as_ref().map_or(0, |pattern| pattern.vertices.len());
    order.sort_by_key(|i| std::cmp::Reverse(nodes(i)));
    let mut answers = vec![Answer::LeftOut; scenes.len()];
    let (done, answered) = mpsc::channel();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            rayon::scope_fifo(|rows| {
                for i in order {
                    let done = done.clone();
                    rows.spawn_fifo(move |_| {
                        let row = if deadline.passed() { Answer::LeftOut } else { answer(&scenes[i], budget) };
                        // Whoever listens does so until the last row.
                        let _ = done.send((i, row));
                    });
                }
            });
            drop(done);
        });
        for (i, row) in answered {
            watch.ran(&scenes[i].name());
            answers[i] = row;
        }
    });
    answers
}
