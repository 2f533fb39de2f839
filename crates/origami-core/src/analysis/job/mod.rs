//! What is asked of a sheet as a file says it: a *job*, JSON beside the crease pattern or under `origami:analysis` in its
//! frame.

mod axes;
mod build;
mod design;
mod edges;
mod keys;
mod masses;
mod members;
mod pick;
mod rest;
mod sheet;
mod units;

pub use axes::HeldAxes;
pub use build::Setup;
pub use design::{DesignJob, DesignSetup, FoldAngleJob, GoalJob, HeightJob, VariableJob};
pub use edges::{Edges, EdgesName};
pub use pick::Pick;
pub use rest::keys_of;
pub use sheet::SheetMaterial;
pub use units::Units;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::{Axis, BarLaw, HingeLaw};
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;

/// Where a frame has its job.
pub const JOB: &str = "origami:analysis";

/// What a sheet is made of, how it is held and loaded, and which path is followed.
///
/// Without `units` all is in the model's own: lengths in radii of the sheet, forces as
/// [`Material::ea`](crate::Material::ea). With them, lengths and forces are in these.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Job {
    /// Units of the job and of its results. Default: the model's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub units: Option<Units>,
    /// A material from which stiffnesses follow that nothing else gives. It needs units.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<SheetMaterial>,
    /// Bars.
    pub bar: BarJob,
    /// Creases.
    pub crease: HingeJob,
    /// Facets.
    pub facet: HingeJob,
    /// Angles at which hinges are at rest. Default: as drawn.
    pub rest: Rest,
    /// Where the sheet is held, besides the vertices that the file fixes.
    pub supports: Vec<SupportJob>,
    /// What acts on it, besides what the file says.
    pub loads: Vec<LoadJob>,
    /// Masses of vertices, besides that of the sheet; only vibrations know them.
    pub masses: Vec<MassJob>,
    /// Two vectors in the plane of x and y by which the sheet repeats itself, in the file's unit of length: for its effective
    /// moduli. Default: it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cell: Option<[[f64; 3]; 2]>,
    /// The path that is followed.
    pub path: PathJob,
    /// What is to be designed. Default: nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub design: Option<DesignJob>,
}

/// Masses of vertices.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct MassJob {
    /// Which.
    pub on: Pick,
    /// The mass of each. Above 0.
    pub mass: f64,
}

/// How bars answer.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct BarJob {
    /// Their law. Default linear.
    pub law: BarLaw,
    /// Axial rigidity, a force; `edges_origami:ea` goes before. Larger: less strain. Default: from the sheet, or the model's.
    pub ea: Option<f64>,
}

/// How hinges answer.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct HingeJob {
    /// `linear`, `stiffened` or `power`. Default linear.
    pub law: HingeName,
    /// Of stiffened ones: the angle between the facets, in degrees as seen from the front, below which they stiffen, and that
    /// above which they do; one number stands for itself and for 360 less it. Closer to each other: stiffer earlier. Above 0,
    /// below 360 and in order. Default 45, which is `[45, 315]`.
    pub from: Option<Limits>,
    /// Of those with a power: the exponent. Larger: softer near rest. At least 1. Default 4/3.
    pub exponent: Option<f64>,
    /// Stiffness, a moment per radian and length of hinge; `edges_origami:k_crease` goes before. Larger: it turns less.
    /// Default: from the sheet, or the model's.
    pub k: Option<f64>,
    /// Of creases with a stiffness from the sheet: the length scale L*. Larger: softer creases. Above 0.
    pub length_scale: Option<f64>,
}

/// Angles between facets, in degrees as seen from the front, at which a hinge stiffens.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(untagged)]
pub enum Limits {
    /// This angle, and 360 less it.
    Both(f64),
    /// The least and the largest: 180 is flat, a valley is below.
    Each([f64; 2]),
}

impl Default for Limits {
    fn default() -> Self {
        Self::Both(45.0)
    }
}

impl Limits {
    /// The least and the largest.
    #[must_use]
    pub fn between(self) -> [f64; 2] {
        match self {
            Self::Both(least) => [least, 360.0 - least],
            Self::Each(limits) => limits,
        }
    }
}

/// A law of hinges, by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum HingeName {
    /// [`HingeLaw::Linear`].
    #[default]
    Linear,
    /// [`HingeLaw::Stiffened`].
    Stiffened,
    /// [`HingeLaw::Power`].
    Power,
}

impl HingeJob {
    /// The law with its number.
    #[must_use]
    pub fn law(&self) -> HingeLaw {
        match self.law {
            HingeName::Linear => HingeLaw::Linear,
            HingeName::Stiffened => {
                let [least, most] = self.from.unwrap_or_default().between();
                HingeLaw::Stiffened { between: [180.0 - most, 180.0 - least].map(f64::to_radians) }
            }
            HingeName::Power => HingeLaw::Power { exponent: self.exponent.unwrap_or(4.0 / 3.0) },
        }
    }
}

/// Angles at which hinges are at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub enum Rest {
    /// Those of the drawn sheet: it is without stress.
    #[default]
    #[serde(rename = "as drawn")]
    AsDrawn,
    /// 0: it wants to be flat.
    #[serde(rename = "flat")]
    Flat,
    /// The fold angles of the pattern: it wants to be folded.
    #[serde(rename = "target")]
    Target,
}

/// Vertices that are held or moved.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SupportJob {
    /// Which.
    pub on: Pick,
    /// The directions in which they are held where they are drawn. Default: none.
    pub fixed: HeldAxes,
    /// How far they are moved at load factor 1, by direction; null where they are not.
    pub displacement: [Option<f64>; 3],
}

/// What acts on vertices or faces.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct LoadJob {
    /// On each of these vertices acts `force`.
    pub on: Option<Pick>,
    /// A dead load at load factor 1.
    pub force: Option<[f64; 3]>,
    /// On each of these faces, by number, acts `pressure`.
    pub faces: Option<Vec<u32>>,
    /// A force per area at load factor 1 that follows the front normals.
    pub pressure: Option<f64>,
}

/// The path that is followed.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct PathJob {
    /// `arc`, `load`, or a vertex and a direction whose displacement is controlled. Default `arc`.
    pub control: ControlJob,
    /// Where it ends: a load factor, or the displacement that is controlled. Null: by `ends` or `steps` alone. Default 1.
    pub to: Option<f64>,
    /// It also ends where these vertices have moved so far in these directions.
    pub ends: Vec<(u32, Axis, f64)>,
    /// Displacements that tables and plots show. Default: the first loaded or moved degree of freedom.
    pub monitor: Vec<(u32, Axis)>,
    /// As [`Path::steps`](super::Path::steps).
    pub steps: usize,
    /// As [`Path::backwards`](super::Path::backwards).
    pub backwards: bool,
    /// As [`Path::step`](super::Path::step).
    pub step: f64,
    /// As [`Path::longest`](super::Path::longest).
    pub longest: f64,
}

impl Default for PathJob {
    fn default() -> Self {
        let path = super::Path::default();
        Self {
            control: ControlJob::default(),
            to: Some(1.0),
            ends: Vec::new(),
            monitor: Vec::new(),
            steps: path.steps,
            backwards: path.backwards,
            step: path.step,
            longest: path.longest,
        }
    }
}

/// What grows along a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(untagged)]
pub enum ControlJob {
    /// By name.
    Named(ControlName),
    /// The displacement of a vertex in a direction.
    Displacement(u32, Axis),
}

impl Default for ControlJob {
    fn default() -> Self {
        Self::Named(ControlName::Arc)
    }
}

/// What grows along a path, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ControlName {
    /// The length of the path.
    Arc,
    /// The load factor.
    Load,
}

impl Job {
    /// Reads a job.
    ///
    /// # Errors
    /// [`Error::Invalid`] that names the key whose value is missing, of the wrong type or unknown.
    pub fn from_slice(bytes: &[u8]) -> Result<Self, Error> {
        let mut deserializer = serde_json::Deserializer::from_slice(bytes);
        let told = |error: &serde_json::Error| error.to_string();
        let job = serde_path_to_error::deserialize(&mut deserializer)
            .map_err(|error| wrong(&error.path().to_string(), told(error.inner())))?;
        deserializer.end().map_err(|error| wrong(".", told(&error)))?;
        Ok(job)
    }

    /// The job in a frame of a file; the default where it has none.
    ///
    /// # Errors
    /// As [`Job::from_slice`], with `origami:analysis` before the key.
    pub fn in_frame(frame: &Frame) -> Result<Self, Error> {
        let Some(value) = frame.extra.get(JOB).filter(|value| !value.is_null()) else { return Ok(Self::default()) };
        let read = serde_path_to_error::deserialize::<&Value, Self>(value);
        read.map_err(|error| wrong(&format!("{JOB}.{}", error.path()), error.inner().to_string()))
    }
}

fn wrong(path: &str, problem: String) -> Error {
    let place = if path == "." { "the job".to_owned() } else { path.to_owned() };
    let expected = "a job as docs/ANALYSIS.md has it";
    Error::new(ErrorCode::WrongValue, Place::key(place), problem, expected)
}
