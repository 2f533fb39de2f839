//! In what numbers the processor computes.

/// The numbers in which the processor computes the steps of [`super::Relax`] and [`super::Dynamics`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Precision {
    /// f64 throughout.
    #[default]
    F64,
    /// Places in f64, their differences taken in f64, all else in f32: faster, with forces good to seven digits of the
    /// largest that act on a node. For tolerances of 1e-6 and more; below that, rounding keeps the sheet in motion.
    Mixed,
}

impl Precision {
    /// Its name, as on the command line and in reports: `f64` or `mixed`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::Mixed => "mixed",
        }
    }
}
