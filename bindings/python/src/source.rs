//! Where a pattern comes from: enough to make it again, bit for bit, in another process.

use std::path::PathBuf;
use std::time::Instant;

use origami::export::Template;
use origami::fold::Document;
use origami::{CreasePattern, Error};

/// What a pattern was made of, and how it was read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Source {
    /// The content of a file of any format.
    pub(crate) bytes: Vec<u8>,
    /// The file's name, which tells the format where the content does not.
    pub(crate) name: Option<PathBuf>,
    pub(crate) options: Options,
}

/// How a file is read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Options {
    /// Which frame of the file; none is the file's own choice.
    pub(crate) frame: Option<usize>,
    /// The distance within which lines are joined, in the file's unit.
    pub(crate) join: Option<f64>,
    /// What colours of a drawing stand for.
    pub(crate) letters: Option<String>,
    /// How far straight pieces may be from a curve, in the file's unit.
    pub(crate) curve_tolerance: Option<f64>,
}

/// A pattern with what its folded forms keep of the file.
pub(crate) struct Read {
    pub(crate) pattern: CreasePattern,
    pub(crate) template: Template,
    /// How long it took to read and to understand, in seconds.
    pub(crate) seconds: [f64; 2],
}

impl Source {
    /// Reads it.
    pub(crate) fn read(&self) -> Result<Read, Error> {
        let watch = Instant::now();
        let mut document = self.document()?;
        document.join = self.options.join.or(document.join);
        let read = watch.elapsed().as_secs_f64();
        let pattern = understood(&document, self.options.frame)?;
        Ok(Read { seconds: [read, pattern.seconds[1]], ..pattern })
    }

    #[cfg(feature = "formats")]
    pub(crate) fn document(&self) -> Result<Document, Error> {
        let Options { letters, curve_tolerance, .. } = &self.options;
        let mut options = origami::formats::Options::default();
        if let Some(letters) = letters {
            options.colours = letters.parse()?;
        }
        options.curve_tolerance = *curve_tolerance;
        origami::formats::read(&self.bytes, self.name.as_deref(), &options)
    }

    #[cfg(not(feature = "formats"))]
    pub(crate) fn document(&self) -> Result<Document, Error> {
        if self.options.letters.is_some() || self.options.curve_tolerance.is_some() {
            let problem = "this build has no feature `formats`";
            return Err(Error::invalid("letters and curve_tolerance", problem, "neither of them"));
        }
        Document::from_slice(&self.bytes)
    }
}

/// The pattern in a frame of a document.
pub(crate) fn understood(document: &Document, frame: Option<usize>) -> Result<Read, Error> {
    let watch = Instant::now();
    let frame = frame.map_or_else(|| document.pattern_frame(), Ok)?;
    let pattern = CreasePattern::from_document(document, frame)?;
    let template = Template::new(document, frame, &pattern)?;
    Ok(Read { pattern, template, seconds: [0.0, watch.elapsed().as_secs_f64()] })
}
