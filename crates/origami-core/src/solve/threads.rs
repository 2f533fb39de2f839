//! Threads for a single sheet: those of rayon's global pool. Equal bits for any number of them.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;

use super::Progress;
use crate::model::Model;

/// Each thread has at least so many nodes: below twice as many one thread is alone. With two threads steps of 529 nodes gain
/// nothing, those of 1 024 up to a third (`cargo bench --bench cpu_step`); whether they do at the moment, a clock tells.
pub const NODES_A_THREAD: usize = 512;

/// How many threads step `model`: as many as `asked`, or as the pool has. One where this is already a thread of a pool, as in
/// a batch: the others have sheets of their own.
pub(super) fn count(model: &Model, asked: Option<NonZeroUsize>) -> usize {
    if let Some(asked) = asked {
        return asked.get();
    }
    let most = model.node_count() / NODES_A_THREAD;
    if most < 2 || rayon::current_thread_index().is_some() {
        return 1;
    }
    most.min(rayon::current_num_threads())
}

/// Does `work` on the threads of the pool, of which the calling one may be none; without them where one is enough.
pub(super) fn in_pool<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    if threads == 1 { work() } else { rayon::scope(|_| work()) }
}

/// Does `work`, which is told how many threads there are, and is one of them itself; the calling thread goes on telling
/// `observe` how far it has come, and breaks it off where that does.
pub(super) fn share<T: Send>(
    threads: usize,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    work: impl FnOnce(usize, &mut dyn FnMut(Progress) -> ControlFlow<()>) -> T + Send,
) -> T {
    if threads == 1 {
        return work(1, observe);
    }
    let (sender, receiver) = mpsc::channel();
    let broken = AtomicBool::new(false);
    let mut result = None;
    rayon::in_place_scope(|scope| {
        scope.spawn(|_| {
            let sender = sender;
            let mut tell = |progress| {
                // Nobody listens where `observe` panicked, which is seen when the work is done.
                let _ = sender.send(progress);
                if broken.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            result = Some(work(threads, &mut tell));
        });
        for progress in &receiver {
            if observe(progress).is_break() {
                broken.store(true, Ordering::Relaxed);
            }
        }
    });
    result.expect("a scope ends when all that it spawned has ended")
}
