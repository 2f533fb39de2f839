//! What can be told of a picture before the sheet is folded: nothing is folded for a picture that cannot be.

use origami::model::Model;
use origami::picture::{Figure, Glb};
use origami::{CreasePattern, Error, State};

use super::{Style, Subject, contact, still};
use crate::files::Format;

/// Whether a file of this format can be made of so many states of the sheet, whatever comes of folding.
///
/// # Errors
/// [`Error::Invalid`] for a size without room, a pattern that is not flat, or states that no file holds.
pub(crate) fn check_drawable(
    format: Format,
    style: &Style,
    pattern: &CreasePattern,
    model: &Model,
    states: usize,
) -> Result<(), Error> {
    let size = match format {
        Format::Svg => return still::refuse_bent(pattern),
        Format::Glb => {
            let figure = Figure::new(pattern, model, &model.rest);
            let edges = style.picture(still::SIZE).edges;
            return Glb { edges, ..Glb::default() }.check(&figure, states);
        }
        Format::Png => still::SIZE,
        Format::Contact | Format::Film => contact::SIZE,
        Format::Fold | Format::Obj | Format::Stl | Format::Html => return Ok(()),
    };
    let rest = State::at_rest(model);
    let subject = Subject { pattern, model, states: &[(0.0, &rest)], steps: &[] };
    let mut figure = Figure::new(pattern, model, &rest.positions);
    style.mapped(&mut figure, subject, &rest, style.clip(subject));
    style.picture(size).view(&figure, figure.positions.iter().copied()).map(drop)
}
