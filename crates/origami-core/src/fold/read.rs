//! From bytes to a [`Document`].

use std::io::Read;

use serde::de::DeserializeSeed;
use serde_json::Deserializer;
use serde_json::error::Category;
use serde_path_to_error::{Path, Segment, Track};

use super::Document;
use super::deserialize::KEY_TWICE;
use super::keys;
use super::visitors::Top;
use crate::error::{Error, ErrorCode, Place, Syntax};

impl Document {
    /// Reads a FOLD file. Needs the feature `files`.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read; otherwise as [`Document::from_slice`].
    #[cfg(feature = "files")]
    pub fn read(path: impl AsRef<std::path::Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let bytes = std::fs::read(path).map_err(|source| Error::Io { path: path.display().to_string(), source })?;
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
        let problem = "not UTF-8; expected a FOLD file, that is JSON in UTF-8";
        syntax(ErrorCode::NotUtf8, Place::Line { line, column: Some(column) }, [line, column], problem)
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim_ascii().is_empty() {
        let problem = "the file is empty; expected a FOLD file, that is one JSON object";
        return Err(syntax(ErrorCode::EmptyFile, Place::Line { line: 1, column: None }, [1, 1], problem));
    }
    Ok(text)
}

fn syntax(code: ErrorCode, place: Place, [line, column]: [usize; 2], problem: impl Into<String>) -> Error {
    Error::Syntax(Box::new(Syntax { code, place, line, column, problem: problem.into() }))
}

/// The error of parsing `text`, with its place. `error` is what the first pass said.
fn located(text: &str, error: serde_json::Error) -> Error {
    let mut track = Track::new();
    let mut deserializer = Deserializer::from_str(text);
    let error = match Top.deserialize(serde_path_to_error::Deserializer::new(&mut deserializer, &mut track)) {
        Ok(_) => error,
        Err(error) => error,
    };
    let (line, column) = (error.line(), error.column());
    let message = error.to_string();
    let message = message.strip_suffix(&format!(" at line {line} column {column}")).unwrap_or(&message);
    let (code, problem) = match (error.classify(), message) {
        (_, "number out of range") => {
            (ErrorCode::NumberTooLarge, "the number is too large; expected a finite one".to_owned())
        }
        (_, "recursion limit exceeded") => {
            (ErrorCode::NestedTooDeeply, "nested too deeply; expected fewer than 128 levels".to_owned())
        }
        (Category::Syntax | Category::Eof, message) => (ErrorCode::NotJson, format!("not JSON: {message}")),
        (_, KEY_TWICE) => (ErrorCode::KeyTwice, KEY_TWICE.to_owned()),
        (_, message) => (ErrorCode::WrongType, shortened(message)),
    };
    let place = place(&track.path()).unwrap_or(Place::Line { line, column: Some(column) });
    syntax(code, place, [line, column], problem)
}

/// Longer paths are shortened to so many parts.
const SEGMENTS: usize = 8;

/// The place at the end of a path, such as `file_frames[0].edges_vertices[3]`, as far as it is known where a key itself is
/// what cannot be parsed. `None` for the file as a whole.
fn place(path: &Path) -> Option<Place> {
    let segments: Vec<&Segment> =
        path.iter().take_while(|segment| matches!(segment, Segment::Seq { .. } | Segment::Map { .. })).collect();
    let (key, frame, before) = match segments.as_slice() {
        [Segment::Map { key: frames }, Segment::Seq { index }, Segment::Map { key }, ..]
            if frames == keys::FILE_FRAMES =>
        {
            (key, Some(index + 1), 3)
        }
        [Segment::Map { key }, ..] => (key, (!keys::is_metadata(key)).then_some(0), 1),
        _ => return None,
    };
    let key = printable(key);
    let mut place = match segments.get(before) {
        Some(Segment::Seq { index }) => Place::entry(key, *index).within(&rest(&segments, before + 1)),
        _ => Place::key(key).within(&rest(&segments, before)),
    };
    if let Some(frame) = frame {
        place = place.in_frame(frame);
    }
    Some(place)
}

/// The path from segment `from` on. Of deep nesting it has the start and the end.
fn rest(segments: &[&Segment], from: usize) -> String {
    let mut text = String::new();
    for (depth, segment) in segments.iter().enumerate().skip(from) {
        if segments.len() > SEGMENTS && depth == SEGMENTS / 2 {
            text.push_str("[…]");
        }
        if depth >= SEGMENTS / 2 && depth + SEGMENTS / 2 < segments.len() {
            continue;
        }
        match segment {
            Segment::Seq { index } => text.push_str(&format!("[{index}]")),
            Segment::Map { key } => text.extend([".", &printable(key)]),
            Segment::Enum { .. } | Segment::Unknown => {}
        }
    }
    text
}

/// A key may be anything: it is shortened, and a terminal should not obey it.
fn printable(key: &str) -> String {
    shortened(key).chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
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
