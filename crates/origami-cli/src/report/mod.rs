//! `--report`: what was built, done and measured, as JSON. docs/REPORT.md documents every key; they stay as they are.

mod adapter;
mod attitude;
mod contact;
mod crossings;
mod measured;
mod motion;
mod note;
mod scene;
mod sweep;

pub(crate) use adapter::{Adapter, AdapterDetails, By};
pub(crate) use attitude::attitude;
pub(crate) use contact::ContactFacts;
pub(crate) use crossings::CrossingFacts;
pub(crate) use measured::{Ending, Measured};
pub(crate) use motion::MotionFacts;
pub(crate) use note::Note;
pub(crate) use scene::{PaperFacts, SceneFacts};
pub(crate) use sweep::{Asked, Head, Row, Table, Tail, Varied, csv_line, csv_names, json_begin, json_end, json_row};

use std::borrow::Cow;
use std::ops::Add;

use origami::solve::{Diverged, Quantity};
use serde::{Deserialize, Serialize};

/// What one input came to.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(crate) enum Report {
    /// It could not be read, built or written.
    Refused {
        /// As named on the command line.
        input: String,
        /// The message.
        error: String,
        /// What was written before.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        outputs: Vec<String>,
    },
    /// It was folded, well or not.
    Folded(Box<Run>),
}

/// One input that a solver has worked on.
#[derive(Debug, Serialize)]
pub(crate) struct Run {
    /// As named on the command line.
    pub(crate) input: String,
    /// `relax`, `dynamics`, `newton` or `reflect`.
    pub(crate) solver: &'static str,
    /// Where it began: `rest` or `flat`.
    pub(crate) from: &'static str,
    /// `cpu` or `gpu`.
    pub(crate) backend: &'static str,
    /// What decided that.
    pub(crate) backend_by: By,
    /// The GPU.
    pub(crate) adapter: Option<Adapter>,
    /// What was built.
    #[serde(flatten)]
    pub(crate) scene: SceneFacts,
    /// `f64` or `mixed` on the processor, `f32` on a GPU.
    pub(crate) precision: &'static str,
    /// Distance from the equilibrium at which to stop, in radii.
    pub(crate) tolerance: f64,
    /// What keeps its place in the outputs.
    pub(crate) attitude: String,
    /// Of the last state.
    #[serde(flatten)]
    pub(crate) measured: Measured,
    /// Of every state on the way, with `--frames`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) frames: Option<Vec<Measured>>,
    /// With `--backwards`, of the motion that was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) backwards: Option<MotionFacts>,
    /// Where the state left all bounds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) diverged: Option<Divergence>,
    /// What was written.
    pub(crate) outputs: Vec<String>,
    /// How long each part took.
    pub(crate) seconds: Seconds,
}

/// Where and how a state left all bounds.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Divergence {
    vertex: u32,
    pub(crate) step: u64,
    quantity: Cow<'static, str>,
    /// None is no number, or an infinite one.
    value: Option<f64>,
}

impl From<&Diverged> for Divergence {
    fn from(diverged: &Diverged) -> Self {
        let quantity = match diverged.quantity {
            Quantity::Position => "position",
            _ => "move",
        };
        let value = Some(diverged.value).filter(|value| value.is_finite());
        Self { vertex: diverged.vertex.0, step: diverged.step, quantity: quantity.into(), value }
    }
}

/// Wall-clock time of each part.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Seconds {
    /// Reading and parsing the file.
    pub(crate) read: f64,
    /// From the document to a model.
    pub(crate) build: f64,
    /// The solver.
    pub(crate) solve: f64,
    /// All outputs but pictures.
    pub(crate) write: f64,
    /// Pictures, films and glTF; in a sweep a part of writing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) draw: Option<f64>,
}

impl Add for Seconds {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let draw = [self.draw, other.draw].into_iter().flatten().reduce(f64::add);
        Self {
            read: self.read + other.read,
            build: self.build + other.build,
            solve: self.solve + other.solve,
            write: self.write + other.write,
            draw,
        }
    }
}

/// Reports as JSON: an object for one input, an array for several.
pub(crate) fn to_json(reports: &[Report]) -> Result<Vec<u8>, serde_json::Error> {
    let mut text = match reports {
        [one] => serde_json::to_vec_pretty(one)?,
        many => serde_json::to_vec_pretty(many)?,
    };
    text.push(b'\n');
    Ok(text)
}
