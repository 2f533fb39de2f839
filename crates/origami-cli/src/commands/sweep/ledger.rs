//! The two tables as they grow: a row is written when all before it are, and what is written stays whatever comes.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use origami::Error;
use origami::export::write_whole;

use crate::report::{Head, Row, SceneFacts, Seconds, Tail, csv_line, csv_names, json_begin, json_end, json_row};

/// Bringing rows to the files takes at most this share of the time, where rows come faster than that allows.
const SHARE: u32 = 10;

/// Rows that have come, and the files that have them.
pub(super) struct Ledger {
    csv: Growing,
    json: Growing,
    rows: Vec<Row>,
    /// Rows that came before one ahead of them.
    waiting: BTreeMap<usize, Row>,
    /// How many rows the files have.
    written: usize,
    /// The place of the first row, and how many there are to be.
    first: usize,
    count: usize,
    begun: Instant,
    spent: Duration,
    /// What was built so far.
    pub(super) scenes: Vec<SceneFacts>,
    pub(super) seconds: Seconds,
}

impl Ledger {
    /// Replaces both tables by new ones that have `rows`, the first of those to be.
    ///
    /// # Errors
    /// [`Error::Io`] where the system refuses.
    pub(super) fn begin(
        paths: [PathBuf; 2],
        head: &Head,
        rows: Vec<Row>,
        places: Range<usize>,
        seconds: Seconds,
    ) -> Result<Self, Error> {
        let [csv, json] = paths;
        let csv = Growing::new(csv, &csv_names())?;
        let begin = json_begin(head).map_err(|error| json.failed(error.into()));
        let json = Growing::new(json.clone(), &begin?)?;
        let mut ledger = Self {
            csv,
            json,
            rows,
            waiting: BTreeMap::new(),
            written: 0,
            first: places.start,
            count: places.len(),
            begun: Instant::now(),
            spent: Duration::ZERO,
            scenes: Vec::new(),
            seconds,
        };
        ledger.flush()?;
        Ok(ledger)
    }

    /// Takes the row of a sheet.
    ///
    /// # Errors
    /// [`Error::Io`] where the system refuses; the files then have the rows that they had.
    pub(super) fn push(&mut self, row: Row) -> Result<(), Error> {
        self.waiting.insert(row.index, row);
        while let Some(row) = self.waiting.remove(&(self.first + self.rows.len())) {
            self.rows.push(row);
        }
        let is_due = self.spent * SHARE <= self.begun.elapsed();
        if is_due && self.written < self.rows.len() { self.flush() } else { Ok(()) }
    }

    /// Brings all rows to the files.
    ///
    /// # Errors
    /// As for [`Ledger::push`].
    pub(super) fn flush(&mut self) -> Result<(), Error> {
        let watch = Instant::now();
        let tail = Tail { complete: self.rows.len() == self.count, scenes: &self.scenes, seconds: self.seconds };
        let mut lines = String::new();
        let mut rows = String::new();
        let make = || {
            for (i, row) in self.rows.iter().enumerate().skip(self.written) {
                lines += &csv_line(row)?;
                rows += &json_row(row, i == 0)?;
            }
            json_end(tail, !self.rows.is_empty())
        };
        let end = make().map_err(|error| self.json.path.failed(error.into()))?;
        self.json.grow(&rows, &end)?;
        self.csv.grow(&lines, "")?;
        self.written = self.rows.len();
        self.spent += watch.elapsed();
        Ok(())
    }

    /// How many rows the files have.
    pub(super) fn written(&self) -> usize {
        self.written
    }

    /// All rows, and how long each part took.
    pub(super) fn into_rows(self) -> (Vec<Row>, Seconds) {
        (self.rows, self.seconds)
    }
}

/// A file that grows before its end.
struct Growing {
    path: PathBuf,
    file: File,
    /// Where the end begins.
    grown: u64,
    end: String,
}

impl Growing {
    fn new(path: PathBuf, begin: &str) -> Result<Self, Error> {
        let put = |source| path.failed(source);
        write_whole(&path, |writer| writer.write_all(begin.as_bytes()).map_err(put))?;
        let file = OpenOptions::new().write(true).open(&path).map_err(put)?;
        Ok(Self { file, grown: begin.len() as u64, end: String::new(), path })
    }

    /// Adds `text` before what is now the end. Where that fails the file is as it was.
    fn grow(&mut self, text: &str, end: &str) -> Result<(), Error> {
        if let Err(source) = self.put(&format!("{text}{end}")) {
            let before = std::mem::take(&mut self.end);
            // Its room is there; where even this fails nothing better can be done.
            let _ = self.put(&before);
            self.end = before;
            return Err(self.path.failed(source));
        }
        self.grown += text.len() as u64;
        end.clone_into(&mut self.end);
        Ok(())
    }

    /// In one piece, so that a program that is killed leaves all of it or nothing.
    fn put(&mut self, text: &str) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(self.grown))?;
        self.file.write_all(text.as_bytes())?;
        self.file.set_len(self.grown + text.len() as u64)
    }
}

/// Errors that name a file.
trait Named {
    fn failed(&self, source: io::Error) -> Error;
}

impl Named for Path {
    fn failed(&self, source: io::Error) -> Error {
        Error::Io { path: self.display().to_string(), source }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::commands::sweep::testing::{head, row};
    use crate::report::Ending;

    #[test]
    fn rows_are_in_the_files_as_soon_as_those_before_them_are() {
        let folder = tempfile::tempdir().expect("a folder");
        let paths = ["a.csv", "a.json"].map(|name| folder.path().join(name));
        let seen = || {
            let json: serde_json::Value =
                serde_json::from_slice(&std::fs::read(&paths[1]).expect("read")).expect("JSON at any time");
            let csv = std::fs::read_to_string(&paths[0]).expect("read");
            assert_eq!(csv.lines().count() - 1, json["instances"].as_array().expect("rows").len());
            (csv.lines().count() - 1, json["complete"].as_bool().expect("complete"))
        };
        let mut ledger = Ledger::begin(paths.clone(), &head(), Vec::new(), 0..3, Seconds::default()).expect("begun");
        assert_eq!(seen(), (0, false));
        ledger.push(row(1, Ending::Converged)).and_then(|()| ledger.flush()).expect("taken");
        assert_eq!(seen(), (0, false), "the first is missing");
        ledger.push(row(0, Ending::Converged)).and_then(|()| ledger.flush()).expect("taken");
        assert_eq!(seen(), (2, false));
        ledger.push(row(2, Ending::Diverged)).and_then(|()| ledger.flush()).expect("taken");
        assert_eq!(seen(), (3, true));
        assert_eq!(ledger.into_rows().0.iter().map(|row| row.index).collect::<Vec<_>>(), [0, 1, 2]);
    }

    #[test]
    fn a_file_that_ends_shorter_loses_what_was_there() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut growing = Growing::new(folder.path().join("a"), "begin ").expect("made");
        growing.grow("one ", "a long end").expect("grown");
        growing.grow("two ", "end").expect("grown");
        assert_eq!(std::fs::read_to_string(folder.path().join("a")).expect("read"), "begin one two end");
    }
}
