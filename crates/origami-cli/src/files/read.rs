//! From bytes to a document: of any format, or of FOLD alone without the feature `formats`.

use std::path::Path;

use origami::Error;
use origami::fold::Document;

/// The document in `bytes`; `name` is the file's, where it has one.
#[cfg(feature = "formats")]
pub(super) fn document(bytes: &[u8], name: Option<&Path>) -> Result<Document, Error> {
    origami::formats::read(bytes, name, &origami::formats::Options::default())
}

/// The document in `bytes`.
#[cfg(not(feature = "formats"))]
pub(super) fn document(bytes: &[u8], _name: Option<&Path>) -> Result<Document, Error> {
    Document::from_slice(bytes)
}
