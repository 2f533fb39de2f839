//! What a page may ask, and what it is told. Angles are in degrees here, as in files; positions are in radii of the sheet.

mod catalog;
mod frame;
mod opened;
mod reply;
mod request;
mod wishes;

pub use catalog::{CatalogEntry, CatalogParameter, Drawing};
pub use frame::{Crossed, FrameHead, MapWish, Recorded};
pub use opened::{Note, Opened};
pub use reply::Reply;
pub use request::{ExportFormat, Request, Way};
pub use wishes::{IntegratorName, Own, PrecisionName, SolverName, SolverWish, Wishes};
