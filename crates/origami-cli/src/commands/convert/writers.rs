//! The writers of patterns.

use std::io::Write;

use origami::formats::write::{Options, cp, dxf, svg};
use origami::{CreasePattern, Error, Warning};

use super::Form;
use crate::args::{ConvertArgs, LinesName};

/// How patterns are written.
pub(super) struct Writers(Options);

impl Writers {
    /// As the arguments say.
    ///
    /// # Errors
    /// What is wrong with them.
    pub(super) fn new(args: &ConvertArgs, _forms: impl Iterator<Item = Form>) -> Result<Self, String> {
        let mut options = Options::default();
        options.joined = args.lines.map(|lines| lines == LinesName::Joined);
        options.straight = args.straight;
        let width = args.width.as_deref().map(str::parse).transpose();
        options.width = width.map_err(|error: Error| format!("--{error}"))?;
        Ok(Self(options))
    }

    /// Writes one of them; tells what it cannot hold.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a pattern that is not flat, [`Error::Io`] where writing fails.
    pub(super) fn write(
        &self,
        form: Form,
        pattern: &CreasePattern,
        writer: &mut dyn Write,
    ) -> Result<Vec<Warning>, Error> {
        match form {
            Form::Cp => cp(pattern, &self.0, writer),
            Form::Dxf => dxf(pattern, &self.0, writer),
            _ => svg(pattern, &self.0, writer),
        }
    }
}
