//! What is read and where it goes.

mod format;
mod input;
mod plan;
mod read;
mod write;

pub(crate) use format::Format;
pub(crate) use input::Input;
pub(crate) use plan::{Destination, Target, plan, plan_drawing, refuse_missing_folder, refuse_other_than_png};
pub(crate) use read::{Opened, Reading};
pub(crate) use write::{Sheet, whole, write, write_document};
