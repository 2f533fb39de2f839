//! FOLD 1.2 documents, as the file says it: nothing is interpreted here.
//! Specification: <https://github.com/edemaine/fold/blob/main/doc/spec.md>.
//!
//! [`Document::read`] parses, [`Document::frame`] resolves what a frame inherits, [`Document::write_to`] writes. Known
//! keys are typed; all others are kept in the order of the file and come out again. Lengths of arrays, ranges of
//! indices and letters are checked where they get a meaning, in [`crate::pattern`].

mod deserialize;
mod document;
mod frames;
mod keys;
mod near_keys;
mod read;
mod visitors;
mod write;

pub use document::{Coordinates, Document, Frame};
