//! Sheets that come to rest strained.

use crate::error::{Place, Warning, WarningCode};
use crate::measure::{Strain, angle_error};
use crate::model::Model;
use crate::solve::Folded;

/// Largest strain of a sheet that has come to rest where it was asked to. Of the generated patterns at 100 %, those that can
/// have all their angles end below 1e-6, those that cannot above 7e-3.
pub(super) const STRAINED: f64 = 1e-3;

/// A warning if the sheet came to rest at 100 % of its angles (or -100 %), and is strained there: not all creases can have
/// their angles together, whether the letters cannot fold or the sheet is caught in another state.
///
/// At any other percentage strain is no sign: a uniform share of all angles is on no rigid path.
#[must_use]
pub fn strained_at_rest(model: &Model, folded: &Folded) -> Option<Warning> {
    let percent = folded.percent().filter(|percent| percent.abs() == 100.0)?;
    if !folded.converged() {
        return None;
    }
    let strain = Strain::of(model, &folded.state.positions).beams;
    // Of the strain, what the way that is left to the equilibrium may have added.
    let shortest = model.beams.iter().map(|beam| beam.rest_length).fold(f64::INFINITY, f64::min);
    let on_the_way = 2.0 * folded.distance / shortest;
    (strain.max - on_the_way > STRAINED).then(|| {
        let angles = angle_error(&folded.state);
        let message = format!(
            "comes to rest strained, {:.2} % at the most and {:.2} % in the mean, with creases up to {:.0} degrees from their \
             angles: it cannot have all of them together, or is caught in another state",
            100.0 * strain.max,
            100.0 * strain.mean,
            angles.max
        );
        Warning::new(WarningCode::StrainedAtRest, Place::Sheet { percent: Some(percent) }, message)
    })
}
