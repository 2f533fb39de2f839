//! Warnings that are collected by kind: a file with ten thousand lower-case letters gets one line.

use crate::error::Warning;

/// Warnings so far; one entry for each kind, with its first place.
#[derive(Debug, Default)]
pub(super) struct Notes(Vec<Note>);

#[derive(Debug)]
struct Note {
    kind: &'static str,
    place: String,
    detail: String,
    more: usize,
}

impl Notes {
    /// Notes what holds of the whole array under `key`.
    pub(super) fn add_once(&mut self, key: &str, message: String) {
        self.0.push(Note { kind: "", place: key.into(), detail: message, more: 0 });
    }

    /// Notes that `kind` was met at `key[index]`.
    pub(super) fn add(&mut self, key: &str, index: usize, kind: &'static str) {
        self.add_with(kind, || (format!("{key}[{index}]"), String::new()));
    }

    /// Notes that `kind` was met; `first` gives the place and what stands there, and is called for the first one only.
    pub(super) fn add_with(&mut self, kind: &'static str, first: impl FnOnce() -> (String, String)) {
        if let Some(note) = self.0.iter_mut().find(|note| note.kind == kind) {
            note.more += 1;
        } else {
            let (place, detail) = first();
            self.0.push(Note { kind, place, detail, more: 0 });
        }
    }

    /// The warnings, in the order in which their kinds were first met.
    pub(super) fn into_warnings(self) -> Vec<Warning> {
        let text = |note: Note| {
            let gap = if note.detail.is_empty() || note.kind.is_empty() { "" } else { " " };
            let more = if note.more > 0 { format!(" (and {} more)", note.more) } else { String::new() };
            Warning::new(note.place, format!("{}{gap}{}{more}", note.detail, note.kind))
        };
        self.0.into_iter().map(text).collect()
    }
}
