//! Warnings that are collected by kind: a file with ten thousand lower-case letters gets one line.

use crate::error::{Place, Warning, WarningCode};

/// Warnings so far; mostly one entry for each code, with its first place.
#[derive(Debug, Default)]
pub(super) struct Notes(Vec<Note>);

#[derive(Debug)]
struct Note {
    code: WarningCode,
    place: Place,
    /// The value at the first place; empty where the message does not need it.
    detail: String,
    message: String,
    more: usize,
}

impl Notes {
    /// Notes what holds of the whole array under `key`.
    pub(super) fn add_once(&mut self, code: WarningCode, key: &'static str, message: impl Into<String>) {
        let (place, message) = (Place::key(key), message.into());
        self.0.push(Note { code, place, detail: String::new(), message, more: 0 });
    }

    /// Notes that `message` holds of `key[index]`.
    pub(super) fn add(&mut self, code: WarningCode, key: &'static str, index: usize, message: &str) {
        self.add_with(code, message, || (Place::entry(key, index), String::new()));
    }

    /// Notes what shall be named even where others of its kind are.
    pub(super) fn add_one(&mut self, code: WarningCode, place: Place, message: String) {
        self.0.push(Note { code, place, detail: String::new(), message, more: 0 });
    }

    /// Notes that something of kind `code` was met; `first` gives the place and the value there, and is called for the
    /// first one only.
    pub(super) fn add_with(&mut self, code: WarningCode, message: &str, first: impl FnOnce() -> (Place, String)) {
        if let Some(note) = self.0.iter_mut().rfind(|note| note.code == code) {
            note.more += 1;
        } else {
            let (place, detail) = first();
            self.0.push(Note { code, place, detail, message: message.into(), more: 0 });
        }
    }

    /// The warnings, in the order in which their kinds were first met.
    pub(super) fn into_warnings(self) -> Vec<Warning> {
        let text = |note: Note| {
            let gap = if note.detail.is_empty() { "" } else { " " };
            let more = if note.more > 0 { format!(" (and {} more)", note.more) } else { String::new() };
            Warning::new(note.code, note.place, format!("{}{gap}{}{more}", note.detail, note.message))
        };
        self.0.into_iter().map(text).collect()
    }
}
