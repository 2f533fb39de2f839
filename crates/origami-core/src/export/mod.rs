//! Files from folded sheets: FOLD, Wavefront OBJ, STL; written whole or not at all.
//!
//! FOLD and OBJ keep the vertices, edges and faces of the input, in its numbering and its unit of length; what the
//! pattern added (crossings, lips of cuts) follows behind. STL holds the triangles that were simulated, or plates of a
//! thickness.

#[cfg(feature = "files")]
mod atomic;
mod folded;
mod obj;
mod plates;
mod sheet;
mod stl;
mod template;
mod texture;

#[cfg(feature = "files")]
pub use atomic::{check_writable, remove_unfinished, write_whole};
pub use folded::{Pose, animation, crease_pattern_document, folded_form};
pub use obj::write_obj;
pub use plates::plates;
pub use stl::write_stl;
pub use template::Template;
pub use texture::texture_coordinates;

/// The creator named in files.
const CREATOR: &str = concat!("origami ", env!("CARGO_PKG_VERSION"));

/// Names the output by `-` until `write_whole` knows better.
fn unwritable(source: std::io::Error) -> crate::Error {
    crate::Error::Io { path: "-".into(), source }
}
