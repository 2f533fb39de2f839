//! Closed forms of folding with rigid facets: what generators set, and what a solver is checked against.
//!
//! Angles are in radians, fold angles valley positive; lengths are in any one unit.

mod hinge;
mod kresling;
mod miura;
mod vertex;
mod yoshimura;

pub use hinge::{single_crease_frequency, strip_buckling_load};
pub use kresling::KreslingFold;
pub use miura::MiuraFold;
pub use vertex::{Degree4Mode, degree4, loop_closure, waterbomb_folds, waterbomb_polar};
pub use yoshimura::YoshimuraFold;
