//! Studies of the solvers: error against run time, and what holds on stiff and extreme cases.
//!
//! A study runs cases and collects its rows in a [`Study`]: tables, plots and the text between them, which
//! [`Study::write`] makes files of.
#![forbid(unsafe_code)]

pub mod accuracy;
mod gpu_choice;
mod options;
mod plot;
pub mod stability;
mod study;
mod table;

pub use gpu_choice::GpuChoice;
pub use options::{Options, Watch};
pub use plot::{Axis, Mark, Plot, PlotError, Scale, Series};
pub use study::{Part, Study, StudyError};
pub use table::{Cell, Column, Table};
