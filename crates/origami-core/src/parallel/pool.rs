//! On the threads of rayon's current pool.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;

use rayon::prelude::*;

/// How many threads one piece of work may take: those of the pool, but one where this is already a thread of a pool, as in
/// a batch, whose other threads have work of their own.
pub(crate) fn free_threads() -> usize {
    if rayon::current_thread_index().is_some() { 1 } else { rayon::current_num_threads() }
}

/// Runs both, at the same time where a thread is free.
pub(crate) fn join<A: Send, B: Send>(one: impl FnOnce() -> A + Send, other: impl FnOnce() -> B + Send) -> (A, B) {
    rayon::join(one, other)
}

/// What `f` makes of each item and its index, in the order of `items`. Each item is a task of its own: some may take a
/// hundred times as long as others.
pub(crate) fn map<T: Sync, U: Send>(items: &[T], f: impl Fn(usize, &T) -> U + Send + Sync) -> Vec<U> {
    items.par_iter().enumerate().with_max_len(1).map(|(i, item)| f(i, item)).collect()
}

/// Replaces `results` by what `f` makes of each item, in tasks of at least `least` items.
pub(crate) fn map_into<T: Sync, U: Send>(
    items: &[T],
    least: usize,
    f: impl Fn(&T) -> U + Send + Sync,
    results: &mut Vec<U>,
) {
    items.par_iter().with_min_len(least).map(f).collect_into_vec(results);
}

/// Does `f` for each item and its index, until one breaks: then no others are begun. They are begun in their order.
pub(crate) fn in_turn<T: Sync>(items: &[T], f: impl Fn(usize, &T) -> ControlFlow<()> + Send + Sync) {
    // A thread takes the next item when it has done one, and no batch of them.
    let _ = items.iter().enumerate().par_bridge().try_for_each(|(i, item)| f(i, item));
}

/// Runs `work` on a thread of the pool, so that it can share out what it does.
pub(crate) fn on_pool<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    rayon::scope(|_| work())
}

/// Runs `work` on a thread of the pool. The calling thread hands to `listen` what `work` says meanwhile; where that breaks,
/// the next thing that `work` says is answered so.
pub(crate) fn listen_to<M: Send, T: Send>(
    work: impl FnOnce(&mut dyn FnMut(M) -> ControlFlow<()>) -> T + Send,
    listen: &mut dyn FnMut(M) -> ControlFlow<()>,
) -> T {
    let (sender, receiver) = mpsc::channel();
    let broken = AtomicBool::new(false);
    let mut result = None;
    rayon::in_place_scope(|scope| {
        scope.spawn(|_| {
            let sender = sender;
            let mut say = |message| {
                // Nobody listens where `listen` panicked, which is seen when the work is done.
                let _ = sender.send(message);
                if broken.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            result = Some(work(&mut say));
        });
        for message in &receiver {
            if listen(message).is_break() {
                broken.store(true, Ordering::Relaxed);
            }
        }
    });
    result.expect("a scope ends when all that it spawned has ended")
}
