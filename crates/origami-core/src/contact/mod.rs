//! Paper does not go through paper: which faces of a state cross, and what keeps them from it.
//!
//! [`Crossings`] is the exact test of a state. Layers that touch do not cross. A sheet that is folded flat to the last bit has
//! all its layers in one plane: it has no crossing, and nothing in it says which layer is on top.
//!
//! [`Contact`] is what [`crate::solve::ContactRelax`] folds with: layers push each other away from a small gap on, and no move
//! takes anything through anything. `docs/CONTACT.md` in the repository says what that means and what it does not.
//! [`PairList`] is for those who compute contact elsewhere, as on a GPU.

mod barrier;
mod boxes;
mod crossings;
mod distance;
mod drift;
mod finder;
mod groups;
#[cfg(feature = "newton")]
pub(crate) mod hessian;
mod lanes;
mod layers;
mod limit;
mod lips;
mod list;
#[cfg(test)]
mod noise;
mod pairs;
mod pressing;
mod settings;
mod sieve;
mod soon;
mod stars;
mod stiff;
mod task;
mod wedge;

pub use crossings::{Crossing, Crossings};
pub use lips::touching_lips;
pub use list::{ListedPair, PairList};
#[doc(hidden)]
pub use list::{PlainContact, Pushing, constants};
pub use pressing::Pressing;
pub use settings::Contact;

pub(crate) use layers::Layers;
pub(crate) use pressing::pressing;
pub(crate) use stiff::Stiff;
