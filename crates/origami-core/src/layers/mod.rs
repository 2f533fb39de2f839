//! Layers of a sheet that is folded flat: which lies on which.
//!
//! A valley lays its second face on the front of its first, and paper does not go through paper: the taco and tortilla conditions
//! of J. Justin (1994), as E. Demaine and J. O'Rourke, Geometric Folding Algorithms (2007), chapter 12, name them. [`face_orders`]
//! has what they and the positions say of a state, [`Stacking`] an order of the exact flat-folded sheet that obeys them all, [`Agreement`]
//! whether a state has it.

mod agreement;
#[doc(hidden)]
pub mod conditions;
mod face_orders;
#[doc(hidden)]
pub mod order;
mod overlap;
#[doc(hidden)]
pub mod pairs;
mod search;
mod stacking;

pub use agreement::Agreement;
pub use face_orders::{FaceOrder, face_orders};
pub use search::NoOrder;
pub use stacking::Stacking;
