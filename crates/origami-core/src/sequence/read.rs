//! A sequence as JSON.

use serde::Deserialize;
use serde_json::{Map, Value};

use super::{GROUP, SEQUENCE, Sequence, wrong};
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;

/// The version that this reads.
const VERSION: u32 = 1;

/// What a file has under [`SEQUENCE`].
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    version: u32,
    steps: Vec<Step>,
}

/// One step: some creases get new targets, or become free or held.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Step {
    /// What people call it; the title of its frame. Default: none, and its number stands for it.
    #[serde(default)]
    pub name: String,
    /// Which creases.
    pub creases: Selector,
    /// What becomes of them. Default: [`Mode::Drive`].
    #[serde(default)]
    pub mode: Mode,
    /// The angle they are driven to, from whatever they were asked for before; only with [`Mode::Drive`], which needs it.
    #[serde(default)]
    pub to: Option<To>,
    /// `"previous"`: it runs beside the step before it. Default: after it.
    #[serde(default)]
    pub(super) with: Option<With>,
    /// When its creases begin to fold, as a share of the step. Later: others go first. Default 0.
    #[serde(default)]
    pub start: f64,
    /// When they have arrived, as a share of the step, above `start`. Default 1.
    #[serde(default = "one")]
    pub end: f64,
    /// How the target goes from one to the other. Default: [`Ease::Linear`].
    #[serde(default)]
    pub ease: Ease,
    /// How long the targets rise, as a multiple of the solver's own ramp for the way, above 0. Larger: slower, and less likely
    /// to end tangled. Default 1.
    #[serde(default = "one")]
    pub duration: f64,
    /// Whether the sheet comes to rest before the next step. Without it the step ends as soon as its targets have arrived.
    /// Default true.
    #[serde(default = "yes")]
    pub settle: bool,
    /// Whether it may name no crease at all: no file says so.
    #[serde(skip)]
    pub(super) may_be_empty: bool,
}

impl Step {
    /// A step that drives all of `creases` to an angle.
    pub(super) fn drive(name: String, creases: Selector, to: To) -> Self {
        Self {
            name,
            creases,
            mode: Mode::Drive,
            to: Some(to),
            with: None,
            start: 0.0,
            end: 1.0,
            ease: Ease::Linear,
            duration: 1.0,
            settle: true,
            may_be_empty: false,
        }
    }

    /// Whether it runs beside the step before it.
    #[must_use]
    pub fn beside(&self) -> bool {
        self.with.is_some()
    }

    /// The same beside the step before it.
    pub(super) fn put_beside(self) -> Self {
        Self { with: Some(With::Previous), ..self }
    }
}

fn one() -> f64 {
    1.0
}

fn yes() -> bool {
    true
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum With {
    Previous,
}

/// What becomes of the creases of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Mode {
    /// They are asked for another angle.
    #[default]
    Drive,
    /// They lose their springs, until they are driven again from the angle that they have then.
    Free,
    /// They keep the angle that they have, ten times as stiff, until they are driven or freed.
    Hold,
}

/// How a target goes from one angle to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum Ease {
    /// Evenly.
    #[default]
    Linear,
    /// Slowly at both ends: 3 s^2 - 2 s^3 of the way at a share s of the time.
    Smooth,
}

/// The angle that creases are driven to.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(try_from = "Value")]
#[non_exhaustive]
pub enum To {
    /// The same for all, in degrees, valleys positive.
    Degrees(f64),
    /// That of the pattern at 100 %.
    Pattern,
    /// A percentage of that.
    Percent(f64),
    /// For each edge of the pattern its own, in degrees; none: it keeps its target. No file says this but by its frames.
    Each(Vec<Option<f64>>),
}

impl TryFrom<Value> for To {
    type Error = String;

    fn try_from(value: Value) -> Result<Self, String> {
        let percent = |map: &Map<String, Value>| match (map.len(), map.get("percent").and_then(Value::as_f64)) {
            (1, percent) => percent,
            _ => None,
        };
        let to = match &value {
            Value::String(text) if text == "pattern" => Some(Self::Pattern),
            Value::Number(number) => number.as_f64().map(Self::Degrees),
            Value::Object(map) => percent(map).map(Self::Percent),
            _ => None,
        };
        to.ok_or_else(|| format!("{value}, expected degrees, \"pattern\" or {{\"percent\": P}}"))
    }
}

/// Which creases: all that one of its parts names, without those of `except`.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[non_exhaustive]
pub struct Selector {
    /// Edges by their ends.
    pub vertices: Vec<[u32; 2]>,
    /// Edges by their numbers in the file.
    pub edges: Vec<u32>,
    /// All edges of groups (`edges_origami:group`).
    pub groups: Vec<String>,
    /// All edges with one of these letters, such as `"MV"`.
    pub assignment: Option<String>,
    /// All edges that have a spring.
    pub all: bool,
    /// Without these.
    pub except: Option<Box<Selector>>,
}

impl Sequence {
    /// Reads a file that stands beside a pattern: an object with the keys `origami:sequence` and, where the pattern's own are
    /// not meant, `edges_origami:group`; or what stands under `origami:sequence` alone.
    ///
    /// # Errors
    /// [`Error::Invalid`] that names the key or the step whose value is missing, of the wrong type, unknown or out of range.
    pub fn from_slice(bytes: &[u8]) -> Result<Self, Error> {
        let value: Value = serde_json::from_slice(bytes).map_err(|error| {
            let place = Place::Line { line: error.line(), column: Some(error.column()) };
            Error::new(ErrorCode::NotJson, place, error.to_string(), "a sequence as JSON")
        })?;
        let Value::Object(keys) = &value else {
            let place = Place::key(SEQUENCE);
            return Err(Error::new(ErrorCode::WrongType, place, "the file holds no object", "an object with this key"));
        };
        if keys.contains_key(SEQUENCE) { Self::of_keys(keys) } else { Self::written(&value, Vec::new()) }
    }

    /// The sequence in a frame of a FOLD file; `None` where it has none.
    ///
    /// # Errors
    /// As [`Sequence::from_slice`].
    pub fn in_frame(frame: &Frame) -> Result<Option<Self>, Error> {
        let has = frame.extra.get(SEQUENCE).is_some_and(|value| !value.is_null());
        has.then(|| Self::of_keys(&frame.extra)).transpose()
    }

    /// The same with the groups of a frame, unless it has its own.
    ///
    /// # Errors
    /// [`Error::Invalid`] where they are no list of names.
    pub fn with_groups_of(mut self, frame: &Frame) -> Result<Self, Error> {
        if self.groups.is_empty() {
            self.groups = groups(frame.extra.get(GROUP))?;
        }
        Ok(self)
    }

    fn of_keys(keys: &Map<String, Value>) -> Result<Self, Error> {
        Self::written(keys.get(SEQUENCE).unwrap_or(&Value::Null), groups(keys.get(GROUP))?)
    }

    fn written(value: &Value, groups: Vec<Vec<String>>) -> Result<Self, Error> {
        let Written { version, steps } = serde_path_to_error::deserialize(value).map_err(|error| {
            let path = match error.path().to_string() {
                path if path == "." => String::new(),
                path => format!(".{path}"),
            };
            let expected = "a sequence as docs/SEQUENCES.md has it";
            Error::new(ErrorCode::WrongValue, Place::key(SEQUENCE).within(&path), error.inner().to_string(), expected)
        })?;
        let refused = |within: &str, problem: String, expected: &str| {
            Error::new(ErrorCode::WrongValue, Place::key(SEQUENCE).within(within), problem, expected)
        };
        if version != VERSION {
            return Err(refused(".version", format!("is {version}"), "1"));
        }
        if steps.is_empty() {
            return Err(refused(".steps", "there are none".to_owned(), "at least one step"));
        }
        steps.iter().enumerate().try_for_each(|(index, step)| check(index, step))?;
        Ok(Self { steps, groups })
    }
}

/// Whether the numbers of a step make sense.
fn check(index: usize, step: &Step) -> Result<(), Error> {
    let refused = |problem: String, expected: &str| Err(wrong(index, step, problem, expected));
    let Step { start, end, duration, .. } = *step;
    if !(0.0 <= start && start < end && end <= 1.0) {
        return refused(format!("from {start} to {end} of the step"), "0 <= start < end <= 1");
    }
    if !(duration.is_finite() && duration > 0.0) {
        return refused(format!("duration {duration}"), "a number above 0");
    }
    if index == 0 && step.beside() {
        return refused("with previous, and there is none".to_owned(), "a step before it");
    }
    match (step.mode, &step.to) {
        (Mode::Drive, None) => refused("no `to`".to_owned(), "the angle that its creases are driven to"),
        (Mode::Free | Mode::Hold, Some(_)) => {
            refused("`to` beside this `mode`".to_owned(), "`to` with the mode drive alone")
        }
        (_, Some(To::Degrees(x) | To::Percent(x))) if !x.is_finite() => refused(format!("to {x}"), "a finite number"),
        _ => Ok(()),
    }
}

/// The groups of each edge: none, one name or several.
fn groups(value: Option<&Value>) -> Result<Vec<Vec<String>>, Error> {
    let refused =
        |place: Place, what: &str| Error::new(ErrorCode::WrongType, place, format!("is {what}"), "names of groups");
    let entries = match value {
        None | Some(Value::Null) => return Ok(Vec::new()),
        Some(Value::Array(entries)) => entries,
        Some(_) => return Err(refused(Place::key(GROUP), "no array")),
    };
    let one = |(index, entry): (usize, &Value)| {
        let names: Option<Vec<String>> = match entry {
            Value::Null => Some(Vec::new()),
            Value::String(name) => Some(vec![name.clone()]),
            Value::Array(names) => names.iter().map(|name| name.as_str().map(str::to_owned)).collect(),
            _ => None,
        };
        names.ok_or_else(|| refused(Place::entry(GROUP, index), "no name, no list of names and not null"))
    };
    entries.iter().enumerate().map(one).collect()
}
