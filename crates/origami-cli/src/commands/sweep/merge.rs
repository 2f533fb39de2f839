//! `origami merge`: the tables of a whole sweep, from those of its parts.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

use origami::Error;
use origami::export::write_whole;
use serde::Deserialize;
use serde_json::{Map, Value};

use super::folder::{self, is_of_part};
use super::resume::difference;
use super::summary::Counts;
use crate::args::MergeArgs;
use crate::console;
use crate::exit::{Exit, Failure};
use crate::files;
use crate::numbers::grouped;
use crate::report::{Row, Seconds, Tail, csv_line, csv_names, json_begin, json_end, json_row};
use crate::text::plain;

const EXPECTED: &str = "expected a table that `origami sweep --shard` made";

/// Puts parts together.
pub(in crate::commands) fn run(args: &MergeArgs) -> Result<Exit, Failure> {
    let [csv, json] = folder::tables(&args.output);
    files::refuse_unwritable([csv.as_path(), json.as_path()])?;
    let mut tables = args.parts.iter().map(|part| paths(part)).collect::<Result<Vec<_>, _>>()?.concat();
    tables.sort();
    tables.dedup();
    let tables = tables.into_iter().map(Part::read).collect::<Result<Vec<_>, _>>()?;
    let whole = Whole::of(tables)?;
    fs::create_dir_all(&args.output).map_err(|source| Error::Io { path: args.output.display().to_string(), source })?;
    whole.write(&csv, &json)?;
    let counts = Counts::of(&whole.rows);
    if !args.quiet {
        let text = |key: &str| whole.head.get(key).and_then(Value::as_str).unwrap_or_default();
        let line = counts.line(text("input"), &whole.rows, None, whole.seconds);
        console::print_text(&format!("{}\n", plain(&line)))?;
    }
    Ok(counts.exit())
}

/// The tables that `part` names: itself, or those in it.
fn paths(part: &Path) -> Result<Vec<PathBuf>, String> {
    let shown = part.display();
    if !part.is_dir() {
        return Ok(vec![part.to_owned()]);
    }
    let entries = fs::read_dir(part).map_err(|error| format!("{shown}: {error}"))?;
    let is_part = |path: &PathBuf| path.file_name().is_some_and(|name| is_of_part(&name.to_string_lossy()));
    let tables: Vec<_> = entries.flatten().map(|entry| entry.path()).filter(is_part).collect();
    if tables.is_empty() {
        return Err(format!("{shown}: has no table of a part; expected one such as sweep.1-of-2.json"));
    }
    Ok(tables)
}

/// A table as it lies in a file.
#[derive(Deserialize)]
struct Written {
    instances: Vec<Row>,
    scenes: Vec<Value>,
    seconds: Seconds,
    /// How it was made.
    #[serde(flatten)]
    head: Map<String, Value>,
}

/// And where.
struct Part {
    shown: String,
    table: Written,
}

impl Part {
    fn read(path: PathBuf) -> Result<Self, String> {
        let shown = path.display().to_string();
        let file = File::open(&path).map_err(|error| format!("{shown}: {error}"))?;
        let table = serde_json::from_reader(BufReader::new(file));
        let mut table: Written = table.map_err(|error| format!("{shown}: {error}; {EXPECTED}"))?;
        table.head.remove("complete");
        let settings = table.head.get_mut("settings").and_then(Value::as_object_mut);
        if settings.and_then(|settings| settings.shift_remove("shard")).is_none() {
            return Err(format!("{shown}: settings.shard: is missing; {EXPECTED}"));
        }
        let scenes = table.scenes.len();
        match table.instances.iter().position(|row| row.scene >= scenes) {
            Some(row) => Err(format!("{shown}: instances[{row}].scene: is not among the {scenes} scenes; {EXPECTED}")),
            None => Ok(Self { shown, table }),
        }
    }

    /// Parts may have been folded from copies of a file.
    fn was_made_as(&self, other: &Self) -> Result<(), String> {
        match difference(&other.table.head, &self.table.head) {
            None => Ok(()),
            Some((key, others, own)) => Err(format!(
                "{}: was made with {key} {own}, {} with {others}; expected parts of one sweep",
                self.shown, other.shown
            )),
        }
    }
}

/// Where `scene` is in a list without repetition; its end, if it is new.
fn place_among(scenes: &mut Vec<Value>, scene: Value) -> usize {
    scenes.iter().position(|other| *other == scene).unwrap_or_else(|| {
        scenes.push(scene);
        scenes.len() - 1
    })
}

/// All parts in order.
struct Whole {
    head: Map<String, Value>,
    rows: Vec<Row>,
    scenes: Vec<Value>,
    seconds: Seconds,
}

impl Whole {
    fn of(mut parts: Vec<Part>) -> Result<Self, String> {
        // In the order of their rows, so that the order in which they are named does not count.
        parts.sort_by_key(|part| part.table.instances.first().map_or(usize::MAX, |row| row.index));
        let Some(first) = parts.first() else { return Err(format!("nothing to merge; {EXPECTED}")) };
        parts.iter().try_for_each(|part| part.was_made_as(first))?;
        let head = first.table.head.clone();
        let count = head.get("settings").and_then(|settings| settings.get("count")).and_then(Value::as_u64);
        let count = count.and_then(|count| usize::try_from(count).ok()).unwrap_or(0);

        let mut seconds = Seconds::default();
        let mut scenes = Vec::new();
        let mut rows: BTreeMap<usize, Row> = BTreeMap::new();
        for Part { shown, table } in parts {
            seconds = seconds + table.seconds;
            let places: Vec<usize> = table.scenes.into_iter().map(|scene| place_among(&mut scenes, scene)).collect();
            for mut row in table.instances {
                row.scene = places[row.scene];
                // A part that was folded twice came to the same.
                if rows.get(&row.index).is_some_and(|other| *other != row) {
                    return Err(format!("{shown}: row {} is another in another part; expected each once", row.index));
                }
                rows.insert(row.index, row);
            }
        }
        if let Some(missing) = (0..count).find(|index| !rows.contains_key(index)) {
            let (have, count) = (grouped(rows.len() as u64), grouped(count as u64));
            return Err(format!("row {missing} is missing, {have} of {count} are there; expected all parts, complete"));
        }
        Ok(Self { head, rows: rows.into_values().collect(), scenes, seconds })
    }

    fn write(&self, csv: &Path, json: &Path) -> Result<(), Error> {
        let failed = |path: &Path, source| Error::Io { path: path.display().to_string(), source };
        write_whole(csv, |writer| {
            let put = |source| failed(csv, source);
            writer.write_all(csv_names().as_bytes()).map_err(put)?;
            self.rows.iter().try_for_each(|row| {
                let line = csv_line(row).map_err(|error| put(error.into()))?;
                writer.write_all(line.as_bytes()).map_err(put)
            })
        })?;
        write_whole(json, |writer| {
            let put = |source| failed(json, source);
            let begin = json_begin(&self.head).map_err(|error| put(error.into()))?;
            writer.write_all(begin.as_bytes()).map_err(put)?;
            for (i, row) in self.rows.iter().enumerate() {
                let text = json_row(row, i == 0).map_err(|error| put(error.into()))?;
                writer.write_all(text.as_bytes()).map_err(put)?;
            }
            let tail = Tail { complete: true, scenes: &self.scenes, seconds: self.seconds };
            let end = json_end(tail, !self.rows.is_empty()).map_err(|error| put(error.into()))?;
            writer.write_all(end.as_bytes()).map_err(put)
        })
    }
}
