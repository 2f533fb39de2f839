//! How many threads.

use std::num::NonZeroUsize;
use std::thread::available_parallelism;

/// As many as ever, whatever the number of processors: starting threads takes the square of their number.
const MOST: usize = 64;

/// As many as were asked for, but at most [`MOST`] or one for each processor; 0 leaves it to rayon.
pub(crate) fn count(asked: Option<NonZeroUsize>) -> usize {
    asked.map_or(0, |asked| usize::from(asked).min(most()))
}

/// What is odd about the number asked for.
pub(crate) fn oddity(asked: Option<NonZeroUsize>) -> Option<String> {
    let most = most();
    let asked = asked.filter(|asked| usize::from(*asked) > most)?;
    Some(format!("--threads {asked}: more than help; {most} are used, and outputs do not depend on it"))
}

fn most() -> usize {
    available_parallelism().map_or(1, usize::from).max(MOST)
}
