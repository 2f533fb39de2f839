//! What is read and where it goes.

mod format;
mod input;
mod page;
mod plan;
mod read;
mod refuse;
mod write;

pub(crate) use format::Format;
pub(crate) use input::Input;
pub(crate) use plan::{Destination, Target, plan, plan_drawing, refuse_missing_folder, refuse_other_than_png};
pub(crate) use read::{Opened, Reading};
pub(crate) use refuse::{is_same_file, refuse_beforehand, refuse_unwritable, tidy};
pub(crate) use write::{Sheet, make_folder, whole, write, write_document};
