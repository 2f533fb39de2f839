//! From bytes to a document: of any format, or of FOLD alone without the feature `formats`.

use std::io::{self, Read};
use std::path::Path;

use origami::Error;
use origami::fold::Document;

use crate::args::ReadingArgs;

/// What was read, and what the file is, as people call it.
pub(crate) struct Opened {
    pub(crate) document: Document,
    pub(crate) format: String,
}

/// How files are read.
#[cfg(feature = "formats")]
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Reading {
    options: origami::formats::Options,
    join: Option<f64>,
}

#[cfg(feature = "formats")]
impl Reading {
    /// That of the arguments.
    ///
    /// # Errors
    /// What is wrong with them.
    pub(crate) fn new(args: &ReadingArgs) -> Result<Self, String> {
        let mut options = origami::formats::Options::default();
        if let Some(colours) = &args.letters {
            options.colours =
                colours.parse().map_err(|error: Error| error.to_string().replacen("colours", "--letters", 1))?;
        }
        options.curve_tolerance = args.curve_tolerance;
        Ok(Self { options, join: args.join })
    }

    /// The same for the files that a page opens.
    #[cfg(feature = "view")]
    pub(crate) fn of_a_page(&self) -> origami::session::Reading {
        origami::session::Reading { options: self.options.clone(), join: self.join }
    }

    /// The document in `bytes`; `name` is the file's, where it has one.
    pub(super) fn document(&self, bytes: &[u8], name: Option<&Path>) -> Result<Opened, Error> {
        let mut opened = origami::formats::open(bytes, name, &self.options)?;
        opened.document.join = self.join.or(opened.document.join);
        let packed = if opened.compressed { ", compressed by gzip" } else { "" };
        Ok(Opened { document: opened.document, format: format!("{}{packed}", opened.format) })
    }
}

/// All bytes of a stream; one without end is refused.
#[cfg(feature = "formats")]
pub(super) fn bytes_of(stream: impl Read) -> Result<io::Result<Vec<u8>>, Error> {
    origami::formats::bytes_of(stream)
}

/// How files are read.
#[cfg(not(feature = "formats"))]
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Reading {
    join: Option<f64>,
}

#[cfg(not(feature = "formats"))]
impl Reading {
    /// Refuses what this build has not.
    pub(crate) fn new(args: &ReadingArgs) -> Result<Self, String> {
        if args.letters.is_some() || args.curve_tolerance.is_some() {
            return Err("options of formats other than FOLD: this build has no feature `formats`".to_owned());
        }
        Ok(Self { join: args.join })
    }

    /// The document in `bytes`, which are FOLD.
    pub(super) fn document(&self, bytes: &[u8], name: Option<&Path>) -> Result<Opened, Error> {
        use origami::error::{ErrorCode, Place};
        let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace() && !b"\xef\xbb\xbf".contains(byte));
        let named = name.and_then(Path::extension).is_some_and(|extension| extension.eq_ignore_ascii_case("fold"));
        if !named && first.is_some_and(|first| !b"{[".contains(first)) {
            let problem = "is no FOLD file, and this build was made without the feature `formats`";
            return Err(Error::new(ErrorCode::NotAPattern, Place::key("the file"), problem, "FOLD, that is JSON"));
        }
        let mut document = Document::from_slice(bytes)?;
        document.join = self.join.or(document.join);
        Ok(Opened { document, format: "FOLD".to_owned() })
    }
}

/// All bytes of a stream; one without end is refused.
#[cfg(not(feature = "formats"))]
pub(super) fn bytes_of(stream: impl Read) -> Result<io::Result<Vec<u8>>, Error> {
    use origami::error::{ErrorCode, Place};
    /// As with the feature.
    const MOST: u64 = 1 << 30;
    let mut bytes = Vec::new();
    let read = stream.take(MOST + 1).read_to_end(&mut bytes);
    if bytes.len() as u64 > MOST {
        let problem = format!("is larger than {MOST} bytes, or without end");
        return Err(Error::new(ErrorCode::InputTooLarge, Place::key("the file"), problem, "a crease pattern"));
    }
    Ok(read.map(|_| bytes))
}
