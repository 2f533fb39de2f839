//! Rest lengths and rest angles of single edges in the file itself: what a design writes, and what is read again.

use serde_json::Value;

use super::edges::{Kind, on_edges};
use super::keys::{entries, read};
use crate::analysis::Structure;
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;
use crate::model::Model;
use crate::pattern::CreasePattern;

/// For each edge the length at which it has no tension, in the job's lengths, or null: as drawn.
const LENGTH: &str = "edges_origami:rest_length";
/// For each edge the fold angle at which it has no moment, in degrees, or null: as the job says.
const ANGLE: &str = "edges_origami:rest_angle";

/// Gives bars and hinges what the frame says of their edges.
pub(super) fn set(
    frame: &Frame,
    pattern: &CreasePattern,
    model: &Model,
    structure: &mut Structure,
) -> Result<(), Error> {
    for (key, kind, expected) in
        [(LENGTH, Kind::Bars, "a length above 0, or null"), (ANGLE, Kind::Hinges, "an angle in degrees, or null")]
    {
        let mut members = None;
        for (index, value) in entries(frame, key)? {
            let Some(x) = read::<f64>(key, index, value, expected)? else { continue };
            let members = members.get_or_insert_with(|| on_edges(kind, pattern, model));
            let fine = x.is_finite() && (kind == Kind::Hinges || x > 0.0);
            let Some(member) = members.get(index).copied().flatten().filter(|_| fine) else {
                let place = Place::entry(key, index);
                let expected = format!("{expected}; of an edge that has one");
                return Err(Error::new(ErrorCode::WrongValue, place, format!("is {x}"), expected));
            };
            match kind {
                Kind::Bars => structure.bars[member].rest_length = x,
                Kind::Hinges => structure.hinges[member].rest_angle = x.to_radians(),
            }
        }
    }
    Ok(())
}

/// The keys with which a file has the rest lengths and rest angles, and the stiffnesses, in which `designed` differs from
/// `original`, for each of the file's edges.
#[must_use]
pub fn keys_of(
    original: &Structure,
    designed: &Structure,
    pattern: &CreasePattern,
    model: &Model,
) -> Vec<(&'static str, Value)> {
    let per_length = |structure: &Structure, i: usize| {
        let [a, b] = [2, 3].map(|end| structure.nodes[structure.hinges[i].nodes[end].index()]);
        structure.hinges[i].stiffness / a.distance(b)
    };
    let drawn = original.redrawn(designed.nodes.clone());
    let differ = |a: f64, b: f64| ((a - b).abs() > 1e-12 * a.abs().max(b.abs())).then_some(b);
    let all = |kind: Kind, own: &dyn Fn(usize) -> Option<f64>| -> Value {
        on_edges(kind, pattern, model).into_iter().map(|member| member.and_then(own)).collect()
    };
    let (bars, hinges) = (&designed.bars, &designed.hinges);
    let keys = [
        (LENGTH, all(Kind::Bars, &|i| differ(drawn.bars[i].rest_length, bars[i].rest_length))),
        (ANGLE, all(Kind::Hinges, &|i| differ(drawn.hinges[i].rest_angle, hinges[i].rest_angle).map(f64::to_degrees))),
        (
            crate::pattern::keys::K_CREASE,
            all(Kind::Hinges, &|i| differ(per_length(&drawn, i), per_length(designed, i))),
        ),
        (crate::pattern::keys::EA, all(Kind::Bars, &|i| differ(drawn.bars[i].rigidity, bars[i].rigidity))),
    ];
    let says = |value: &Value| value.as_array().is_some_and(|all| all.iter().any(|own| !own.is_null()));
    keys.into_iter().filter(|(_, value)| says(value)).collect()
}
