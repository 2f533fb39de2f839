//! On the calling thread alone.

use std::ops::ControlFlow;

/// How many threads one piece of work may take.
pub(crate) fn free_threads() -> usize {
    1
}

/// Runs one after the other.
pub(crate) fn join<A, B>(one: impl FnOnce() -> A, other: impl FnOnce() -> B) -> (A, B) {
    (one(), other())
}

/// What `f` makes of each item and its index, in the order of `items`.
pub(crate) fn map<T, U>(items: &[T], f: impl Fn(usize, &T) -> U) -> Vec<U> {
    items.iter().enumerate().map(|(i, item)| f(i, item)).collect()
}

/// Replaces `results` by what `f` makes of each item.
pub(crate) fn map_into<T, U>(items: &[T], _least: usize, f: impl Fn(&T) -> U, results: &mut Vec<U>) {
    results.clear();
    results.extend(items.iter().map(f));
}

/// Does `f` for each item and its index in their order, until one breaks.
pub(crate) fn in_turn<T>(items: &[T], f: impl Fn(usize, &T) -> ControlFlow<()>) {
    let _ = items.iter().enumerate().try_for_each(|(i, item)| f(i, item));
}

/// Runs `work`.
pub(crate) fn on_pool<T>(work: impl FnOnce() -> T) -> T {
    work()
}

/// Runs `work`, which speaks to `listen` itself.
pub(crate) fn listen_to<M, T>(
    work: impl FnOnce(&mut dyn FnMut(M) -> ControlFlow<()>) -> T,
    listen: &mut dyn FnMut(M) -> ControlFlow<()>,
) -> T {
    work(listen)
}
