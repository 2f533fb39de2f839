//! What is read and where it goes.

mod format;
mod input;
mod plan;
mod write;

pub(crate) use format::Format;
pub(crate) use input::Input;
pub(crate) use plan::{Destination, Target, plan, refuse_missing_folder};
pub(crate) use write::{Sheet, write, write_document};
