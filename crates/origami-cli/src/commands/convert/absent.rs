//! A build without the feature `formats`: what is no FOLD is refused before any work.

use std::io::Write;

use origami::{CreasePattern, Error, Warning};

use super::Form;
use crate::args::ConvertArgs;

const ABSENT: &str = "this build writes patterns as FOLD only (feature `formats`)";
const EXPECTED: &str = "a build without --no-default-features or with --features formats";

/// Writes nothing.
pub(super) struct Writers(());

impl Writers {
    /// # Errors
    /// That there is something to be written.
    pub(super) fn new(_args: &ConvertArgs, mut forms: impl Iterator<Item = Form>) -> Result<Self, String> {
        if forms.any(|form| form != Form::Fold) {
            return Err(format!("{ABSENT}; expected {EXPECTED}"));
        }
        Ok(Self(()))
    }

    #[expect(clippy::unused_self, reason = "a build with the feature has options here")]
    pub(super) fn write(
        &self,
        _form: Form,
        _pattern: &CreasePattern,
        _writer: &mut dyn Write,
    ) -> Result<Vec<Warning>, Error> {
        Err(Error::invalid("formats", ABSENT, EXPECTED))
    }
}
