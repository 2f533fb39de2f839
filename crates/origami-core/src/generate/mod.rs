//! Crease patterns made from parameters, without a file.
//!
//! Each family is a struct of parameters with a [`Default`]; its `pattern` method makes the sheet, at rest in the plane
//! z = 0 (the rings of [`Kresling::ring`] and [`Yoshimura::ring`] stand in space). Angles are in radians, valley
//! positive; [`catalog`] offers the same by name, with angles in degrees. Parameters that make no sheet give
//! [`Error::Invalid`](crate::Error::Invalid), whose place is `parameter NAME`.
//!
//! ```
//! use origami_core::generate::{Miura, catalog};
//!
//! let by_type = Miura { columns: 4, rows: 3, ..Miura::default() }.pattern()?;
//! let by_name = catalog::generate("miura", &[("columns".into(), 4.0), ("rows".into(), 3.0)])?;
//! assert_eq!(by_type, by_name);
//! # Ok::<(), origami_core::Error>(())
//! ```

mod bird_base;
mod builder;
pub mod catalog;
#[cfg(test)]
mod check;
mod crane;
mod curved_pleat;
mod degree4;
mod fan;
mod flat_fold;
mod hypar;
mod kresling;
mod miura;
mod rolled;
mod single_crease;
mod square_twist;
mod strip;
mod waterbomb;
mod waterbomb_vertex;
mod yoshimura;

pub use bird_base::BirdBase;
pub use crane::Crane;
pub use curved_pleat::CurvedPleat;
pub use degree4::Degree4;
pub use fan::Fan;
pub use hypar::Hypar;
pub use kresling::Kresling;
pub use miura::{Miura, miura};
pub use single_crease::SingleCrease;
pub use square_twist::SquareTwist;
pub use strip::Strip;
pub use waterbomb::Waterbomb;
pub use waterbomb_vertex::WaterbombVertex;
pub use yoshimura::Yoshimura;
