//! A folder of its own for each test, and the program run in it.

use std::path::PathBuf;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

/// A square with a diagonal that folds to 90 degrees.
pub(crate) const SQUARE: &str = r#"{
"file_spec": 1.2,
"vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]],
"edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
"edges_assignment": ["B", "B", "B", "B", "V"],
"edges_foldAngle": [0, 0, 0, 0, 90],
"faces_vertices": [[0, 1, 2], [0, 2, 3]]
}
"#;

/// A folder that is deleted in the end.
pub(crate) struct Place(TempDir);

/// What the program did.
pub(crate) struct Ran {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Place {
    /// With `square.fold`.
    pub(crate) fn new() -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        place.put("square.fold", SQUARE);
        place
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn put(&self, name: &str, content: &str) {
        std::fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    pub(crate) fn json(&self, name: &str) -> Value {
        serde_json::from_str(&self.text(name)).unwrap()
    }

    pub(crate) fn has(&self, name: &str) -> bool {
        self.path(name).exists()
    }

    /// Names of everything in the folder, in order.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    pub(crate) fn command(&self) -> Command {
        let mut command = Command::cargo_bin("origami").unwrap();
        command.current_dir(self.0.path());
        // Mesa's drivers tell standard error where they do not like the environment.
        command.env_remove("ORIGAMI_ADAPTER").env("NODEVICE_SELECT", "1");
        command
    }

    /// Runs the program with words separated by spaces.
    pub(crate) fn run(&self, words: &str) -> Ran {
        Ran::of(self.command().args(words.split_whitespace()))
    }

    /// The same, with standard input.
    pub(crate) fn run_with(&self, words: &str, stdin: &str) -> Ran {
        Ran::of(self.command().args(words.split_whitespace()).write_stdin(stdin))
    }
}

impl Ran {
    fn of(command: &mut Command) -> Self {
        let output = command.output().unwrap();
        let ran = Self {
            code: output.status.code().unwrap(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        };
        assert!(!ran.stderr.contains("panicked"), "{}", ran.stderr);
        ran
    }

    /// Ends with `code` and says `words` on standard error.
    #[track_caller]
    pub(crate) fn fails(&self, code: i32, words: &str) {
        assert_eq!(self.code, code, "stderr: {}", self.stderr);
        assert!(self.stderr.contains(words), "expected {words:?} in: {}", self.stderr);
    }

    /// Ends with 0 and says nothing on standard error.
    #[track_caller]
    pub(crate) fn succeeds(&self) -> &str {
        assert_eq!((self.code, self.stderr.as_str()), (0, ""));
        &self.stdout
    }
}
