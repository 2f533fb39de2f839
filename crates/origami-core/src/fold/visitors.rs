//! Objects of a FOLD file: the top level and its frames.

use std::collections::HashSet;
use std::fmt;
use std::marker::PhantomData;

use serde::de::{DeserializeSeed, Deserializer, MapAccess, Visitor};

use super::deserialize::{Any, Finite, Index, Items, Letter, Optional, Pair, Point, Twice};
use super::keys::*;
use super::{Document, Frame, near_keys};
use crate::error::{Place, Warning, WarningCode};

const STRINGS: Items<PhantomData<String>> = Items { expected: "an array of strings", item: PhantomData };
const INDICES: Items<Index> = Items { expected: "an array of vertex indices", item: Index };

/// The whole file.
pub(super) struct Top;

impl<'de> DeserializeSeed<'de> for Top {
    type Value = Document;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Document, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Top {
    type Value = Document;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a FOLD file, that is one JSON object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Document, A::Error> {
        let mut document = Document::default();
        let mut names = Names::default();
        let mut key_frame = RawFrame::default();
        let mut frames = Vec::new();
        while let Some(key) = names.next(&mut object)? {
            match key.as_str() {
                FILE_SPEC => document.spec = object.next_value_seed(Optional(Any))?,
                FILE_CLASSES => document.classes = object.next_value_seed(Optional(STRINGS))?.unwrap_or_default(),
                FILE_FRAMES => {
                    let seed = Optional(Items { expected: "an array of frames", item: One });
                    frames = object.next_value_seed(seed)?.unwrap_or_default();
                }
                _ if is_metadata(&key) => {
                    let value = object.next_value_seed(Any)?;
                    document.metadata.insert(key, value);
                }
                _ => key_frame.take(key, &mut object)?,
            }
        }
        document.key_frame = key_frame.settle(0, &mut document.warnings);
        document.frames = (1..).zip(frames).map(|(index, frame)| frame.settle(index, &mut document.warnings)).collect();
        for key in document.metadata.keys() {
            document.warnings.extend(unknown(key, None));
        }
        document.warnings.extend(document.other_frame());
        Ok(document)
    }
}

/// One element of `file_frames`.
#[derive(Clone, Copy)]
struct One;

impl<'de> DeserializeSeed<'de> for One {
    type Value = RawFrame;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<RawFrame, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for One {
    type Value = RawFrame;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a frame, that is an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<RawFrame, A::Error> {
        let mut frame = RawFrame::default();
        let mut names = Names::default();
        while let Some(key) = names.next(&mut object)? {
            frame.take(key, &mut object)?;
        }
        Ok(frame)
    }
}

/// The keys of one object, each of which may come once.
#[derive(Default)]
struct Names(HashSet<String>);

impl Names {
    fn next<'de, A: MapAccess<'de>>(&mut self, object: &mut A) -> Result<Option<String>, A::Error> {
        let Some(key) = object.next_key::<String>()? else { return Ok(None) };
        if !self.0.insert(key.clone()) {
            object.next_value_seed(Twice)?;
        }
        Ok(Some(key))
    }
}

/// A frame of which all keys but FOLD 1.0's are where they belong.
#[derive(Default)]
struct RawFrame {
    frame: Frame,
    fold_angles_1_0: Option<Vec<Option<f64>>>,
}

impl RawFrame {
    fn take<'de, A: MapAccess<'de>>(&mut self, key: String, object: &mut A) -> Result<(), A::Error> {
        const POINTS: Items<Point> = Items { expected: "an array of coordinates", item: Point };
        const PAIRS: Items<Pair> = Items { expected: "an array of pairs of vertex indices", item: Pair };
        const LETTERS: Items<Letter> = Items { expected: "an array of letters", item: Letter };
        const ANGLES: Items<Optional<Finite>> =
            Items { expected: "an array of angles in degrees", item: Optional(Finite) };
        const LOOPS: Items<Items<Index>> = Items { expected: "an array of arrays of vertex indices", item: INDICES };

        let frame = &mut self.frame;
        match key.as_str() {
            FRAME_PARENT => frame.parent = object.next_value_seed(Optional(Index))?,
            FRAME_INHERIT => frame.inherit = object.next_value::<Option<bool>>()?.unwrap_or_default(),
            FRAME_CLASSES => frame.classes = object.next_value_seed(Optional(STRINGS))?,
            VERTICES_COORDS => frame.vertices_coords = object.next_value_seed(Optional(POINTS))?,
            EDGES_VERTICES => frame.edges_vertices = object.next_value_seed(Optional(PAIRS))?,
            EDGES_ASSIGNMENT => frame.edges_assignment = object.next_value_seed(Optional(LETTERS))?,
            EDGES_FOLD_ANGLE => frame.edges_fold_angle = object.next_value_seed(Optional(ANGLES))?,
            EDGES_FOLD_ANGLES => self.fold_angles_1_0 = object.next_value_seed(Optional(ANGLES))?,
            FACES_VERTICES => frame.faces_vertices = object.next_value_seed(Optional(LOOPS))?,
            _ => {
                let value = object.next_value_seed(Any)?;
                frame.extra.insert(key, value);
            }
        }
        Ok(())
    }

    /// The frame, after a look at what needs more than one key.
    fn settle(self, index: usize, warnings: &mut Vec<Warning>) -> Frame {
        let mut frame = self.frame;
        let place = |key: &'static str| Place::key(key).in_frame(index);
        if let Some(angles) = self.fold_angles_1_0 {
            let message = if frame.edges_fold_angle.is_none() {
                frame.edges_fold_angle = Some(angles);
                "FOLD 1.0's name; read as edges_foldAngle"
            } else {
                "FOLD 1.0's name, ignored because edges_foldAngle is there too"
            };
            warnings.push(Warning::new(WarningCode::OldKey, place(EDGES_FOLD_ANGLES), message));
        }
        for key in frame.extra.keys() {
            warnings.extend(unknown(key, Some(index)));
        }
        if frame.inherit && index == 0 {
            let message = "the key frame has no parent; ignored";
            warnings.push(Warning::new(WarningCode::KeyFrameInherits, place(FRAME_INHERIT), message));
        } else if frame.inherit && frame.parent.is_none() {
            let message = "true, but there is no frame_parent; inherits from the key frame";
            warnings.push(Warning::new(WarningCode::NoParent, place(FRAME_INHERIT), message));
        }
        frame
    }
}

/// A warning of a key that was meant to be another one.
fn unknown(key: &str, frame: Option<usize>) -> Option<Warning> {
    let meant = near_keys::meant(key)?;
    // A terminal should not obey it.
    let shown: String = key.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect();
    let place = Place::key(shown);
    let place = frame.map_or(place.clone(), |frame| place.in_frame(frame));
    let message = format!("is no key of FOLD and was not read; is {meant} meant?");
    Some(Warning::new(WarningCode::UnknownKey, place, message))
}
