//! From bytes to a [`Document`].

use std::fs;
use std::io::Read;

use serde::de::DeserializeSeed;
use serde_json::Deserializer;
use serde_json::error::Category;
use serde_path_to_error::{Path, Segment, Track};

use super::Document;
use super::visitors::Top;
use crate::error::Error;

impl Document {
    /// Reads a FOLD file.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read; otherwise as [`Document::from_slice`].
    pub fn read(path: impl AsRef<std::path::Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let bytes = fs::read(path).map_err(|source| Error::Io { path: path.display().to_string(), source })?;
        Self::from_slice(&bytes)
    }

    /// Reads a FOLD file from a stream, to its end.
    ///
    /// # Errors
    /// [`Error::Io`] with path `-` if reading fails; otherwise as [`Document::from_slice`].
    pub fn from_reader(mut reader: impl Read) -> Result<Self, Error> {
        let mut bytes = Vec::new();
        reader.read_to_end(&mut bytes).map_err(|source| Error::Io { path: "-".into(), source })?;
        Self::from_slice(&bytes)
    }

    /// Parses a FOLD file: JSON in UTF-8, with or without a byte-order mark.
    ///
    /// # Errors
    /// [`Error::Syntax`] with the key and index (`edges_vertices[3][0]`) or the line and column, if the text is not
    /// JSON, if a value has the wrong type or is out of range for its type, or if an object has a key twice.
    pub fn from_slice(bytes: &[u8]) -> Result<Self, Error> {
        let text = text(bytes)?;
        let mut deserializer = Deserializer::from_str(text);
        let document = Top.deserialize(&mut deserializer);
        // Keeping track of the path costs time, so it is done only once it is known that there is an error to place.
        document.and_then(|document| deserializer.end().map(|()| document)).map_err(|error| located(text, error))
    }
}

fn text(bytes: &[u8]) -> Result<&str, Error> {
    let text = str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        let column = 1 + before.iter().rev().take_while(|&&byte| byte != b'\n').count();
        let problem = "not UTF-8; expected a FOLD file, that is JSON in UTF-8".into();
        Error::Syntax { place: format!("line {line} column {column}"), problem }
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim_ascii().is_empty() {
        let problem = "the file is empty; expected a FOLD file, that is one JSON object".into();
        return Err(Error::Syntax { place: "line 1".into(), problem });
    }
    Ok(text)
}

/// The error of parsing `text`, with its place. `error` is what the first pass said.
fn located(text: &str, error: serde_json::Error) -> Error {
    let mut track = Track::new();
    let mut deserializer = Deserializer::from_str(text);
    let error = match Top.deserialize(serde_path_to_error::Deserializer::new(&mut deserializer, &mut track)) {
        Ok(_) => error,
        Err(error) => error,
    };
    let path = written(&track.path());
    let position = format!("line {} column {}", error.line(), error.column());
    let message = error.to_string();
    let message = message.strip_suffix(&format!(" at {position}")).unwrap_or(&message);
    let problem = match (error.classify(), message) {
        (_, "number out of range") => "the number is too large; expected a finite one".to_owned(),
        (_, "recursion limit exceeded") => "nested too deeply; expected fewer than 128 levels".to_owned(),
        (Category::Syntax | Category::Eof, message) => format!("not JSON: {message}"),
        (_, message) => shortened(message),
    };
    if path.is_empty() {
        Error::Syntax { place: position, problem }
    } else {
        Error::Syntax { place: path, problem: format!("{problem} ({position})") }
    }
}

/// Longer paths are shortened to so many parts.
const SEGMENTS: usize = 8;

/// Such as `file_frames[0].edges_vertices[3]`; as far as it is known where a key itself is what cannot be parsed.
fn written(path: &Path) -> String {
    let mut text = String::new();
    // Deep nesting is told by its start and its end.
    let count = path.iter().count();
    for (depth, segment) in path.iter().enumerate() {
        if count > SEGMENTS && depth == SEGMENTS / 2 {
            text.push_str("[…]");
        }
        if depth >= SEGMENTS / 2 && depth + SEGMENTS / 2 < count {
            continue;
        }
        match segment {
            Segment::Seq { index } => text.push_str(&format!("[{index}]")),
            Segment::Map { key } => {
                text.push_str(if text.is_empty() { "" } else { "." });
                // A key may be anything; a terminal should not obey it.
                text.extend(shortened(key).chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }));
            }
            Segment::Enum { .. } | Segment::Unknown => break,
        }
    }
    text
}

/// Without its middle if it is long: messages quote what they met, which may be a whole file.
fn shortened(message: &str) -> String {
    const END: usize = 100;
    let count = message.chars().count();
    if count <= 3 * END {
        return message.to_owned();
    }
    let (start, end) = (message.chars().take(END), message.chars().skip(count - END));
    start.chain(" … ".chars()).chain(end).collect()
}
