//! What a file is: by its content first, by its name where the content does not tell.

mod foreign;
mod sniff;

use std::fmt;
use std::path::Path;

use origami_core::error::{Error, ErrorCode, Place};

/// A format that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// FOLD: JSON.
    Fold,
    /// CP: a line a crease, of ORIPA, Orihime, Oriedita, CP Editor and Box Pleating Studio.
    Cp,
    /// OPX: XML, of ORIPA.
    Opx,
    /// ORI: JSON, of Oriedita.
    Ori,
    /// ORH: text, of Orihime.
    Orh,
    /// SVG: strokes whose colours are letters.
    Svg,
    /// Wavefront OBJ: faces, and lines for creases.
    Obj,
    /// DXF as text: lines and curves whose layers and colours are letters.
    Dxf,
}

impl Format {
    /// All of them.
    pub const ALL: &[Self] = &[Self::Fold, Self::Cp, Self::Opx, Self::Ori, Self::Orh, Self::Svg, Self::Obj, Self::Dxf];

    /// The format of a file that is not compressed, by its content; `name` is the file's, and decides where the content
    /// does not.
    ///
    /// # Errors
    /// [`ErrorCode::NotAPattern`] with what the file is, where that is known to be something else.
    pub fn of(bytes: &[u8], name: Option<&Path>) -> Result<Self, Error> {
        let by_name = name.and_then(Self::of_name);
        match sniff::sniff(bytes) {
            sniff::Content::Known(format) => Ok(format),
            sniff::Content::Foreign(what) => Err(not_a_pattern(&what)),
            sniff::Content::Unknown => by_name.ok_or_else(|| not_a_pattern("a file of unknown kind")),
            // FOLD's reader says what is wrong with it.
            sniff::Content::Empty => Ok(Self::Fold),
        }
    }

    /// The format that a name's extension stands for, in upper or lower case and without a further `.gz`.
    #[must_use]
    pub fn of_name(name: &Path) -> Option<Self> {
        let extension = |name: &Path| Some(name.extension()?.to_str()?.to_ascii_lowercase());
        let own = match extension(name)?.as_str() {
            "gz" => extension(Path::new(name.file_stem()?))?,
            own => own.to_owned(),
        };
        Self::ALL.iter().copied().find(|format| format.extension() == own)
    }

    /// The extension of its files, without the dot.
    #[must_use]
    pub fn extension(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Cp => "cp",
            Self::Opx => "opx",
            Self::Ori => "ori",
            Self::Orh => "orh",
            Self::Svg => "svg",
            Self::Obj => "obj",
            Self::Dxf => "dxf",
        }
    }
}

impl fmt::Display for Format {
    /// As people call it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Fold => "FOLD",
            Self::Cp => "CP",
            Self::Opx => "OPX (ORIPA)",
            Self::Ori => "ORI (Oriedita)",
            Self::Orh => "ORH (Orihime)",
            Self::Svg => "SVG",
            Self::Obj => "OBJ",
            Self::Dxf => "DXF",
        })
    }
}

fn not_a_pattern(what: &str) -> Error {
    let names: Vec<String> = Format::ALL.iter().map(|format| format.extension().to_ascii_uppercase()).collect();
    let expected = format!("a crease pattern: {}, or one of these compressed by gzip", names.join(", "));
    Error::new(ErrorCode::NotAPattern, Place::key("the file"), format!("is {what}"), expected)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_formats() {
        for (name, format) in [
            ("a.fold", Some(Format::Fold)),
            ("b/A.CP", Some(Format::Cp)),
            ("a.opx.gz", Some(Format::Opx)),
            ("a.gz", None),
            ("a", None),
            ("a.txt", None),
        ] {
            assert_eq!(Format::of_name(Path::new(name)), format, "{name}");
        }
    }

    #[test]
    fn content_goes_before_names() {
        let of = |text: &str, name: &str| Format::of(text.as_bytes(), Some(Path::new(name))).map_err(|e| e.to_string());
        assert_eq!(of("1 0 0 1 1\n", "a.fold"), Ok(Format::Cp));
        assert_eq!(of("{\"vertices_coords\": []}", "a.cp"), Ok(Format::Fold));
        assert_eq!(of("v 0 0 0\nv 1 0 0\n", "a.cp"), Ok(Format::Obj));
        assert_eq!(of("what is this", "a.cp"), Ok(Format::Cp), "whose reader says what is wrong");
        let told = of("what is this", "a.txt").unwrap_err();
        assert!(
            told.starts_with("the file: is a file of unknown kind; expected a crease pattern: FOLD, CP, "),
            "{told}"
        );
        assert!(of("\u{89}PNG", "a.fold").is_ok(), "no picture: its first bytes are others");
        assert!(of("<html><body>", "a.cp").unwrap_err().starts_with("the file: is an HTML page"));
    }
}
