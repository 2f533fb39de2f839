//! Work shared out among threads: those of rayon's pools with the feature `parallel`, the calling thread alone without it.
//! Both have the same functions, and no bit of a result depends on which of them runs.

#[cfg(feature = "parallel")]
mod pool;
#[cfg(not(feature = "parallel"))]
mod serial;

#[cfg(feature = "parallel")]
pub(crate) use pool::*;
#[cfg(not(feature = "parallel"))]
pub(crate) use serial::*;
