//! A folding as a page for any browser, where this build has one.

use std::io::Write;

use origami::solve::Folded;
use origami::{CreasePattern, Error, Model};

/// Writes the page of the states of a sheet that is called `name`, with the steps of a sequence that they show.
///
/// # Errors
/// [`Error::Io`] where the system refuses.
#[cfg(feature = "view")]
pub(super) fn write(
    name: &str,
    pattern: &CreasePattern,
    model: &Model,
    (states, steps): (&[Folded], &[String]),
    writer: &mut dyn Write,
) -> Result<(), Error> {
    let film = origami::session::film((name, None), pattern, model, states, steps);
    let unwritable = |source| Error::Io { path: "-".to_owned(), source };
    let page = origami_page::film(&film.to_bytes(), name).map_err(unwritable)?;
    writer.write_all(page.as_bytes()).map_err(unwritable)
}

/// Without the feature `view`.
///
/// # Errors
/// Always; [`check`] has said so before.
#[cfg(not(feature = "view"))]
pub(super) fn write(
    _name: &str,
    _pattern: &CreasePattern,
    _model: &Model,
    _states: (&[Folded], &[String]),
    _writer: &mut dyn Write,
) -> Result<(), Error> {
    Err(Error::invalid("HTML", ABSENT, EXPECTED))
}

#[cfg(not(feature = "view"))]
const ABSENT: &str = "this build makes no pages (feature `view`)";
#[cfg(not(feature = "view"))]
const EXPECTED: &str = "a build without --no-default-features or with --features view";

/// Whether this build can make pages.
///
/// # Errors
/// That it cannot.
pub(super) fn check() -> Result<(), String> {
    #[cfg(not(feature = "view"))]
    return Err(format!("{ABSENT}; expected {EXPECTED}"));
    #[cfg(feature = "view")]
    Ok(())
}
