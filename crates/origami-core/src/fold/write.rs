//! From a [`Document`] to text: one line per key, arrays compact, the shortest numbers that read back as they were.

use std::io::{self, BufWriter, Write};

use serde::{Serialize, Serializer};

use super::{Coordinates, Document, Frame, keys};
use crate::error::{Error, ErrorCode, Place};

/// Keys without a field that come before the arrays, because a person looks for them there.
const HEAD: [&str; 5] = ["frame_title", "frame_author", "frame_description", "frame_attributes", "frame_unit"];

impl Document {
    /// Writes the document as a FOLD file. Nothing is held in memory but a buffer.
    ///
    /// # Errors
    /// [`Error::Invalid`] if a coordinate or an angle is not finite (then nothing is written); [`Error::Io`] with
    /// path `-` if writing fails.
    pub fn write_to(&self, writer: impl Write) -> Result<(), Error> {
        for index in 0..self.frame_count() {
            let frame = index.checked_sub(1).map_or(&self.key_frame, |index| &self.frames[index]);
            check_finite(frame, index)?;
        }
        self.write(BufWriter::new(writer)).map_err(|source| Error::Io { path: "-".into(), source })
    }

    /// The document as the text of a FOLD file.
    ///
    /// # Errors
    /// As [`Document::write_to`].
    pub fn to_string(&self) -> Result<String, Error> {
        let mut bytes = Vec::new();
        self.write_to(&mut bytes)?;
        Ok(String::from_utf8(bytes).expect("JSON is UTF-8"))
    }

    fn write(&self, mut writer: impl Write) -> io::Result<()> {
        let mut object = Object::begin(&mut writer, "")?;
        if let Some(spec) = &self.spec {
            object.entry(keys::FILE_SPEC, spec)?;
        }
        if let Some(creator) = self.metadata.get(keys::FILE_CREATOR) {
            object.entry(keys::FILE_CREATOR, creator)?;
        }
        if !self.classes.is_empty() {
            object.entry(keys::FILE_CLASSES, &self.classes)?;
        }
        const WRITTEN: [&str; 4] = [keys::FILE_SPEC, keys::FILE_CREATOR, keys::FILE_CLASSES, keys::FILE_FRAMES];
        for (key, value) in &self.metadata {
            if keys::is_metadata(key) && !WRITTEN.contains(&key.as_str()) {
                object.entry(key, value)?;
            }
        }
        write_frame(&mut object, &self.key_frame, |key| !keys::is_metadata(key))?;
        if !self.frames.is_empty() {
            object.key(keys::FILE_FRAMES)?;
            for (index, frame) in self.frames.iter().enumerate() {
                object.writer.write_all(if index == 0 { b"[\n  " } else { b",\n  " })?;
                let mut inner = Object::begin(&mut *object.writer, "  ")?;
                write_frame(&mut inner, frame, |_| true)?;
                inner.end()?;
            }
            object.writer.write_all(b"\n]")?;
        }
        object.end()?;
        writer.write_all(b"\n")?;
        writer.flush()
    }
}

fn write_frame<W: Write>(object: &mut Object<W>, frame: &Frame, wanted: impl Fn(&str) -> bool) -> io::Result<()> {
    for key in HEAD {
        if let Some(value) = frame.extra.get(key) {
            object.entry(key, value)?;
        }
    }
    object.optional(keys::FRAME_CLASSES, frame.classes.as_ref())?;
    object.optional(keys::FRAME_PARENT, frame.parent)?;
    object.optional(keys::FRAME_INHERIT, frame.inherit.then_some(true))?;
    object.optional(keys::VERTICES_COORDS, frame.vertices_coords.as_deref().map(Points))?;
    object.optional(keys::EDGES_VERTICES, frame.edges_vertices.as_ref())?;
    object.optional(keys::EDGES_ASSIGNMENT, frame.edges_assignment.as_ref())?;
    object.optional(keys::EDGES_FOLD_ANGLE, frame.edges_fold_angle.as_deref().map(Angles))?;
    object.optional(keys::FACES_VERTICES, frame.faces_vertices.as_ref())?;
    for (key, value) in &frame.extra {
        if wanted(key) && !keys::is_frame_field(key) && !HEAD.contains(&key.as_str()) {
            object.entry(key, value)?;
        }
    }
    Ok(())
}

fn check_finite(frame: &Frame, index: usize) -> Result<(), Error> {
    let refuse = |key: &'static str, i, what| {
        let problem = format!("{what}, which JSON cannot hold");
        let place = Place::entry(key, i).in_frame(index);
        Err(Error::new(ErrorCode::NotFinite, place, problem, "finite numbers"))
    };
    let points = frame.vertices_coords.as_deref().unwrap_or_default();
    if let Some(i) = points.iter().position(|point| !point.position.is_finite()) {
        return refuse(keys::VERTICES_COORDS, i, points[i].position.to_string());
    }
    let angles = frame.edges_fold_angle.as_deref().unwrap_or_default();
    match angles.iter().position(|angle| angle.is_some_and(|angle| !angle.is_finite())) {
        Some(i) => refuse(keys::EDGES_FOLD_ANGLE, i, format!("{:?}", angles[i].unwrap_or_default())),
        None => Ok(()),
    }
}

/// An object being written.
struct Object<'a, W: Write> {
    writer: &'a mut W,
    indent: &'static str,
    empty: bool,
}

impl<'a, W: Write> Object<'a, W> {
    fn begin(writer: &'a mut W, indent: &'static str) -> io::Result<Self> {
        writer.write_all(b"{")?;
        Ok(Self { writer, indent, empty: true })
    }

    fn key(&mut self, key: &str) -> io::Result<()> {
        self.writer.write_all(if self.empty { b"\n" } else { b",\n" })?;
        self.writer.write_all(self.indent.as_bytes())?;
        serde_json::to_writer(&mut *self.writer, key)?;
        self.empty = false;
        self.writer.write_all(b": ")
    }

    fn entry(&mut self, key: &str, value: &(impl Serialize + ?Sized)) -> io::Result<()> {
        self.key(key)?;
        Ok(serde_json::to_writer(&mut *self.writer, value)?)
    }

    fn optional(&mut self, key: &str, value: Option<impl Serialize>) -> io::Result<()> {
        value.map_or(Ok(()), |value| self.entry(key, &value))
    }

    fn end(self) -> io::Result<()> {
        self.writer.write_all(b"\n")?;
        self.writer.write_all(self.indent.as_bytes())?;
        self.writer.write_all(b"}")
    }
}

struct Points<'a>(&'a [Coordinates]);

impl Serialize for Points<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(Point))
    }
}

struct Point<'a>(&'a Coordinates);

impl Serialize for Point<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let [x, y, z] = self.0.position.to_array().map(Short);
        if self.0.dimension == 2 && z.0 == 0.0 { [x, y].serialize(serializer) } else { [x, y, z].serialize(serializer) }
    }
}

struct Angles<'a>(&'a [Option<f64>]);

impl Serialize for Angles<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(|angle| angle.map(Short)))
    }
}

/// A number without `.0` where it is whole.
struct Short(f64);

impl Serialize for Short {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // Up to here every whole number is exact in both types. -0 keeps its sign.
        const EXACT: f64 = 9_007_199_254_740_992.0;
        let Self(number) = *self;
        if number.trunc() == number && number.abs() < EXACT && (number != 0.0 || number.is_sign_positive()) {
            serializer.serialize_i64(number as i64)
        } else {
            serializer.serialize_f64(number)
        }
    }
}
