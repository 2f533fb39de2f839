//! Threads for a single sheet: those of rayon's global pool. Equal bits for any number of them.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;

use super::Progress;
use crate::model::Model;
use crate::parallel;

/// Each thread has at least so many nodes: below twice as many one thread is alone. With two threads steps of 529 nodes gain
/// nothing, those of 1 024 up to a third (`cargo bench --bench cpu_step`); whether they do at the moment, a clock tells.
pub const NODES_A_THREAD: usize = 512;

/// How many threads step `model`: as many as `asked`, or as the pool has. One where this is already a thread of a pool, as in
/// a batch: the others have sheets of their own.
pub(super) fn count(model: &Model, asked: Option<NonZeroUsize>) -> usize {
    let most = model.node_count() / NODES_A_THREAD;
    asked.map_or_else(|| if most < 2 { 1 } else { most.min(parallel::free_threads()) }, NonZeroUsize::get)
}

/// Does `work` on the threads of the pool, of which the calling one may be none; without them where one is enough.
pub(super) fn in_pool<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    if threads == 1 { work() } else { parallel::on_pool(work) }
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
    parallel::listen_to(|tell| work(threads, tell), observe)
}
