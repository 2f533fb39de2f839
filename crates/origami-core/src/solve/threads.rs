//! Threads for a single sheet: those of rayon's global pool. Equal bits for any number of them.

use super::Progress;
use crate::model::Model;
use crate::parallel;

/// Each thread has at least so many nodes: below twice as many one thread is alone. With two threads steps of 529 nodes gain
/// nothing, those of 1 024 up to a third (`cargo bench --bench cpu_step`); whether they do at the moment, a clock tells.
pub const NODES_A_THREAD: usize = 512;

/// How many threads fold `model`. One where this is already a thread of a pool, as in a batch: the others have sheets of
/// their own.
fn count(model: &Model) -> usize {
    let most = model.node_count() / NODES_A_THREAD;
    if most < 2 { 1 } else { most.min(parallel::free_threads()) }
}

/// Does `work`, which is told how many threads there are, and is one of them itself; the calling thread goes on telling
/// `observe` how far it has come.
pub(super) fn share<T: Send>(
    model: &Model,
    observe: &mut dyn FnMut(Progress),
    work: impl FnOnce(usize, &mut dyn FnMut(Progress)) -> T + Send,
) -> T {
    let threads = count(model);
    if threads == 1 {
        return work(1, observe);
    }
    parallel::listen_to(|tell| work(threads, tell), observe)
}
