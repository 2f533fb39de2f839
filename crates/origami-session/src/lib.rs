//! A sheet that a page steers: what is asked and told, as types, and the session that answers.
//!
//! A [`Session`] knows neither sockets nor clocks nor threads. Whoever carries the messages hands in each [`Request`] with
//! [`Session::answer`], lets the sheet move with [`Session::advance`] while [`Session::has_work`], and passes on the
//! [`Packet`]s that come out. A picture of the sheet goes out once for each [`Request::Frame`], never unasked, and only when
//! something has changed since the last one: a page that does not look costs nothing.
//!
//! ```
//! use origami_session::{Processor, Request, Session};
//!
//! let mut session = Session::new(Box::new(Processor::default()));
//! session.answer(Request::Generate { name: "miura".into(), parameters: vec![] }, &[]);
//! session.answer(Request::Fold { percent: 50.0 }, &[]);
//! session.answer(Request::Frame { map: Default::default() }, &[]);
//! let mut frames = 0;
//! while session.has_work() {
//!     session.advance(100);
//!     if session.take_frame().is_some() {
//!         frames += 1;
//!         session.answer(Request::Frame { map: Default::default() }, &[]);
//!     }
//! }
//! assert!(frames > 1);
//! ```
#![forbid(unsafe_code)]

mod catalog;
pub mod computer;
mod crossed;
mod export;
mod film;
pub mod message;
mod numbers;
mod open;
mod packet;
mod places;
mod reading;
mod recording;
mod refused;
mod saved;
mod sequence;
mod session;
mod sheet;
mod undo;

pub use computer::{Computer, Mover, Processor};
pub use film::film;
pub use message::{Reply, Request, Wishes};
pub use packet::{Malformed, Packet};
pub use reading::Reading;
pub use session::Session;
