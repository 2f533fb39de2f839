//! Studies of the solvers: error against run time, and what holds on stiff and extreme cases.
//!
//! A study runs cases and collects its rows in a [`Study`]: tables, plots and the text between them, which
//! [`Study::write`] makes files of (CSV, JSON, SVG, Markdown). [`accuracy::study`] measures the distance of each solver from
//! the equilibrium against the time that it took; [`stability::study`] finds the longest time step that holds and compares
//! what each solver claims with a reference; [`flat::study`] folds patterns to their flat-folded states; [`contact::study`] tells where sheets go
//! through themselves, and what keeping them from it costs; [`backwards::study`] finds motions to flat-folded states from these.
//!
//! ```no_run
//! use origami_core::generate::BirdBase;
//! use origami_study::{Options, accuracy};
//!
//! let pattern = BirdBase::default().pattern()?;
//! let options = Options { patterns: vec![("bird-base".into(), pattern)], quick: true, ..Options::default() };
//! // `()` watches nothing; a `Watch` of one's own can show how far it has come.
//! let study = accuracy::study(&options, &mut ())?;
//! for file in study.write("out".as_ref())? {
//!     println!("{}", file.display());
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`Table`] and [`Plot`] stand on their own: a table is written as CSV, JSON or Markdown, a plot as SVG without fonts or
//! bitmaps.
#![forbid(unsafe_code)]

pub mod accuracy;
pub mod backwards;
pub mod contact;
mod crossings;
pub mod flat;
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
