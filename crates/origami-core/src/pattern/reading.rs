//! How files are read where they leave a choice.

use crate::error::{Error, ErrorCode, Place};

/// How a frame is made into a crease pattern where it leaves a choice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Reading {
    /// The distance within which lines are joined, in the file's unit of length: ends to ends, and ends to lines.
    /// `None`: found from the file. What is off by rounding is always joined then, and near misses where what is separate
    /// on purpose is clearly farther apart.
    pub join: Option<f64>,
}

impl Reading {
    /// Lines are joined within `join`, in the file's unit of length; `None`: within what is found from the file.
    #[must_use]
    pub const fn joining(join: Option<f64>) -> Self {
        Self { join }
    }

    /// The distance, which must be one.
    pub(super) fn join(&self) -> Result<Option<f64>, Error> {
        match self.join {
            Some(join) if !(join >= 0.0 && join.is_finite()) => {
                let problem = format!("is {join}");
                Err(Error::new(ErrorCode::Setting, Place::from("join"), problem, "a distance, 0 or more"))
            }
            join => Ok(join),
        }
    }
}
