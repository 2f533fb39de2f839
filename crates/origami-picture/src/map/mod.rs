//! Values over the sheet as colours.

mod colours;
mod quantities;
mod scale;

pub use colours::ColourMap;
pub use scale::{Scale, round_up};

use origami_core::{Model, State};

/// Values in the unit that is shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// By node; colours run between them.
    Nodes(Vec<f32>),
    /// One value for each triangle.
    Triangles(Vec<f32>),
}

impl Values {
    fn all(&self) -> &[f32] {
        match self {
            Self::Nodes(values) | Self::Triangles(values) => values,
        }
    }

    /// The largest that is a number; 0 where there is none.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.all().iter().copied().filter(|v| v.is_finite()).fold(0.0, |a, b| f64::max(a, f64::from(b)))
    }
}

/// Values and how they become colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// By node or by triangle.
    pub values: Values,
    /// From values to colours.
    pub scale: Scale,
}

/// What can be mapped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Mean strain of the beams at each node (paper 3.1), in percent.
    Strain,
    /// Mean strain of each triangle's sides, in percent.
    FaceStrain,
    /// Mean difference between the fold angles reached and asked for, over each triangle's creases, in degrees.
    AngleError,
    /// Energy over area at rest, by triangle; a spring between two triangles counts half for each. In units of force over
    /// radius of the sheet.
    EnergyDensity,
}

impl Quantity {
    /// All, in the order of their names.
    pub const ALL: [Self; 4] = [Self::Strain, Self::FaceStrain, Self::AngleError, Self::EnergyDensity];
    /// What to call them, in the order of [`Quantity::ALL`].
    pub const NAMES: [&str; 4] = ["strain", "face-strain", "angle-error", "energy"];

    /// The quantity of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let index = Self::NAMES.iter().position(|known| *known == name)?;
        Self::ALL.get(index).copied()
    }

    /// What stands over the colour bar: the quantity and its unit.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::Strain | Self::FaceStrain => "strain, %",
            Self::AngleError => "angle error, °",
            Self::EnergyDensity => "energy density",
        }
    }
}

impl Map {
    /// The map of a quantity over a state. `clip` is the value that the last colour stands for, in the unit shown; default
    /// is the largest value, rounded up.
    #[must_use]
    pub fn new(quantity: Quantity, model: &Model, state: &State, colours: ColourMap, clip: Option<f64>) -> Self {
        let values = quantities::values(quantity, model, state);
        let clip = clip.filter(|clip| *clip > 0.0 && clip.is_finite()).unwrap_or_else(|| round_up(values.largest()));
        let beyond = values.largest() > clip * (1.0 + 1e-6);
        Self { values, scale: Scale { colours, clip, label: quantity.label().into(), beyond } }
    }
}
