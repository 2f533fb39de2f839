//! How files are read.

use std::path::Path;

use origami_core::Error;
use origami_core::fold::Document;
use origami_formats::Options;

/// What one may ask for when files are read, as the command line has it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// Colours and curves. Defaults: those of `origami-formats`.
    pub options: Options,
    /// Ends of lines that are nearer than this are joined, in the file's unit. Larger: more. Default: found from the file.
    pub join: Option<f64>,
}

impl Reading {
    /// The document in the bytes of a file of this name, and what the file is.
    pub(crate) fn document(&self, name: &str, bytes: &[u8]) -> Result<(Document, String), Error> {
        let mut opened = origami_formats::open(bytes, Some(Path::new(name)), &self.options)?;
        opened.document.join = self.join.or(opened.document.join);
        let packed = if opened.compressed { ", compressed by gzip" } else { "" };
        Ok((opened.document, format!("{}{packed}", opened.format)))
    }
}
