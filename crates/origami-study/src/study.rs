//! What comes of a study, and the files that it becomes.

use std::fs;
use std::path::{Path, PathBuf};

use origami_core::export::write_whole;

use crate::table::markdown;
use crate::{Column, Plot, PlotError, Table};

/// A piece of a study's document.
#[derive(Clone, Debug)]
pub enum Part {
    /// A heading of the second level.
    Heading(String),
    /// A paragraph of Markdown.
    Text(String),
    /// A table: whole as FILE.csv and FILE.json, and in the document with some of its columns and rows.
    Table {
        /// Name of its files, without an ending.
        file: String,
        /// The table, which becomes a file of its own too.
        table: Table,
        /// Keys of the columns that the document shows; none: only a line with the names of the files.
        shown: Vec<&'static str>,
    },
    /// A plot, as FILE.svg and in the document.
    Plot {
        /// Name of its file, without an ending.
        file: String,
        /// The plot, which becomes a file of its own.
        plot: Plot,
    },
}

/// What came of a study: the parts of its document.
#[derive(Clone, Debug)]
pub struct Study {
    /// Name of its document: NAME.md.
    pub name: &'static str,
    /// Title of its document.
    pub title: String,
    /// What it holds, in order.
    pub parts: Vec<Part>,
}

/// A study could not be run or written.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// A plot could not be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// A file could not be written, or a pattern makes no model.
    #[error(transparent)]
    Core(#[from] origami_core::Error),
}

/// Rows of a table in the document, at most; the files have all.
const ROWS: usize = 60;

impl Study {
    /// Writes the document, tables and plots into `folder`, which is made where it is missing: each file whole or not at
    /// all, and the document last. Returns their paths, in that order.
    ///
    /// Letters of file names other than a-z, 0-9, `-`, `_` and `.` become `-`; of equal names the later ones get a number.
    ///
    /// # Errors
    /// [`StudyError`]. A plot that cannot be drawn is found before anything is written.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, StudyError> {
        let files = self.files()?;
        fs::create_dir_all(folder).map_err(|source| unwritable(folder, source))?;
        let mut paths = Vec::new();
        for (name, text) in files {
            let path = folder.join(name);
            write_whole(&path, |file| file.write_all(text.as_bytes()).map_err(|source| unwritable(&path, source)))?;
            paths.push(path);
        }
        Ok(paths)
    }

    /// The names of the study's files and what each contains.
    fn files(&self) -> Result<Vec<(String, String)>, PlotError> {
        let mut names = Names::new(self.name);
        let mut files = Vec::new();
        let mut document = format!("# {}\n", self.title);
        let mut tables: Vec<(String, &'static [Column])> = Vec::new();
        for part in &self.parts {
            document.push('\n');
            match part {
                Part::Heading(text) => document += &format!("## {text}\n"),
                Part::Text(text) => document += &format!("{}\n", text.trim()),
                Part::Table { file, table, shown } => {
                    let name = names.next(file);
                    document += &shown_rows(&name, table, shown);
                    files.push((format!("{name}.csv"), table.csv()));
                    files.push((format!("{name}.json"), format!("{:#}\n", table.json())));
                    tables.push((name, table.columns));
                }
                Part::Plot { file, plot } => {
                    let name = names.next(file);
                    let alternative: String = plot.title.chars().filter(|c| !"[]\n".contains(*c)).collect();
                    document += &format!("![{alternative}]({name}.svg)\n");
                    files.push((format!("{name}.svg"), plot.svg()?));
                }
            }
        }
        document += &legend(&tables);
        files.push((format!("{}.md", self.name), document));
        Ok(files)
    }
}

/// A table in the document, and where all of it is.
fn shown_rows(name: &str, table: &Table, shown: &[&str]) -> String {
    let text = markdown::table(table, shown, ROWS);
    let all = table.rows.len();
    let links = format!("[{name}.csv]({name}.csv), [{name}.json]({name}.json)");
    match text.as_str() {
        "" => format!("{all} rows: {links}\n"),
        _ if all > ROWS => format!("{text}\nThe first {ROWS} of {all} rows. All rows and columns: {links}\n"),
        _ => format!("{text}\nAll columns: {links}\n"),
    }
}

/// What the columns of all files mean, those with the same columns together.
fn legend(tables: &[(String, &'static [Column])]) -> String {
    let mut text = String::new();
    for (i, (_, columns)) in tables.iter().enumerate() {
        if tables[..i].iter().any(|(_, earlier)| earlier == columns) {
            continue;
        }
        let same = tables.iter().filter(|(_, others)| others == columns);
        let names: Vec<String> = same.map(|(name, _)| format!("`{name}`")).collect();
        text += if text.is_empty() { "\n## Columns of the files\n" } else { "" };
        text += &format!("\n{}:\n\n", names.join(", "));
        for column in *columns {
            text += &format!("- `{}`: {}\n", column.key, column.meaning);
        }
    }
    text
}

/// Names of files that are good on any system, and each different.
struct Names(Vec<String>);

impl Names {
    fn new(document: &str) -> Self {
        Self(vec![document.to_owned()])
    }

    fn next(&mut self, wanted: &str) -> String {
        let plain = |c: char| match c.to_ascii_lowercase() {
            c @ ('a'..='z' | '0'..='9' | '_' | '.') => c,
            _ => '-',
        };
        let wanted: String = wanted.chars().map(plain).collect();
        let wanted = wanted.trim_matches(['.', '-']);
        let wanted = if wanted.is_empty() { "part" } else { wanted };
        let numbered = (2_usize..).map(|n| format!("{wanted}-{n}"));
        let name = std::iter::once(wanted.to_owned()).chain(numbered).find(|name| !self.0.contains(name));
        let name = name.unwrap_or_default();
        self.0.push(name.clone());
        name
    }
}

fn unwritable(path: &Path, source: std::io::Error) -> origami_core::Error {
    origami_core::Error::Io { path: path.display().to_string(), source }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Axis, Mark, Scale, Series};

    const COLUMNS: &[Column] = &[
        Column { key: "scene", head: "scene", meaning: "its name" },
        Column { key: "error", head: "error (radii)", meaning: "largest distance to the reference, in radii" },
    ];

    fn sample() -> Study {
        let mut table = Table::new(COLUMNS);
        table.push(vec!["miura".into(), 1e-5.into()]);
        let mut long = Table::new(COLUMNS);
        (0..100).for_each(|i| long.push(vec![format!("row {i}").into(), f64::from(i).into()]));
        let axis = |label: &str| Axis { label: label.into(), scale: Scale::Log };
        let series = Series { label: "relax".into(), mark: Mark::Line, points: vec![(1.0, 2.0), (3.0, 4.0)] };
        let plot = Plot {
            title: "Error [miura]".into(),
            note: "none".into(),
            x: axis("time (s)"),
            y: axis("error (radii)"),
            series: vec![series],
        };
        let parts = vec![
            Part::Heading("Errors".into()),
            Part::Text("Some *text*.\n".into()),
            Part::Table { file: "errors".into(), table: table.clone(), shown: vec!["scene", "error"] },
            Part::Plot { file: "../Errors".into(), plot },
            Part::Table { file: "long".into(), table: long, shown: vec!["error"] },
            Part::Table { file: "accuracy".into(), table, shown: Vec::new() },
        ];
        Study { name: "accuracy", title: "Accuracy".into(), parts }
    }

    #[test]
    fn all_parts_become_files() {
        let parent = tempfile::tempdir().unwrap();
        let folder = parent.path().join("made/on/the/way");
        let paths = sample().write(&folder).unwrap();
        let names: Vec<_> = paths.iter().map(|p| p.strip_prefix(&folder).unwrap().to_str().unwrap()).collect();
        let tables = ["errors.csv", "errors.json", "errors-2.svg", "long.csv", "long.json"];
        assert_eq!(names[..5], tables);
        assert_eq!(names[5..], ["accuracy-2.csv", "accuracy-2.json", "accuracy.md"]);
        assert_eq!(fs::read_dir(&folder).unwrap().count(), paths.len());
        let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
        assert!(read("errors-2.svg").ends_with("</svg>\n"));
        assert_eq!(read("errors.csv"), "scene,error\r\nmiura,1e-5\r\n");
        let json: serde_json::Value = serde_json::from_str(&read("long.json")).unwrap();
        assert_eq!(json.as_array().unwrap().len(), 100);
        let document = read("accuracy.md");
        let expected = "\
# Accuracy

## Errors

Some *text*.

| scene | error (radii) |
| ----- | ------------: |
| miura |          1e-5 |

All columns: [errors.csv](errors.csv), [errors.json](errors.json)

![Error miura](errors-2.svg)

| error (radii) |
";
        assert!(document.starts_with(expected), "{document}");
        assert!(document.contains("The first 60 of 100 rows. All rows and columns: [long.csv](long.csv)"));
        assert!(document.contains("\n1 rows: [accuracy-2.csv]"), "{document}");
        assert!(document.ends_with("`errors`, `long`, `accuracy-2`:\n\n- `scene`: its name\n- `error`: largest distance to the reference, in radii\n"), "{document}");
        for line in document.lines().filter(|line| line.contains("](")) {
            for name in line.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
                assert!(folder.join(name).is_file(), "{line}");
            }
        }
    }

    #[test]
    fn what_is_written_twice_is_the_same() {
        let parent = tempfile::tempdir().unwrap();
        let [first, second] = ["a", "b"].map(|name| sample().write(&parent.path().join(name)).unwrap());
        for (a, b) in first.iter().zip(&second) {
            assert!(fs::read(a).unwrap() == fs::read(b).unwrap(), "{}", a.display());
        }
    }

    #[test]
    fn what_cannot_be_written_is_named() {
        let parent = tempfile::tempdir().unwrap();
        let file = parent.path().join("file");
        fs::write(&file, "as it was").unwrap();
        let error = sample().write(&file).unwrap_err().to_string();
        assert!(error.starts_with(file.to_str().unwrap()), "{error}");
        fs::create_dir(parent.path().join("errors.json")).unwrap();
        let error = sample().write(parent.path()).unwrap_err().to_string();
        assert!(error.contains("errors.json"), "{error}");
        assert_eq!(fs::read_to_string(&file).unwrap(), "as it was");
    }
}
