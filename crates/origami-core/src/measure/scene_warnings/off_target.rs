//! Creases far from their angles in a sheet that is at rest, where nothing else tells that they have not folded: it is not strained,
//! or is not at 100 %, where strain says nothing.

use crate::error::{CreasePlace, Place, Short, Warning, WarningCode, rounded};
use crate::flat::{OpenEnd, open_ends};
use crate::ids::EdgeId;
use crate::measure::Strain;
use crate::model::{Crease, Model};
use crate::pattern::CreasePattern;
use crate::solve::Folded;

use super::strained_at_rest::STRAINED;

/// How far, in degrees, a crease is from its angle before it is told. Of the generated patterns at 100 %, those that come to
/// rest without strain have all their creases within 0.1.
const FAR: f64 = 5.0;
/// The same of sheets that are not at 100 %, where creases have to share what their angles ask for. Of the generated patterns and
/// of those by designers that do not go through themselves, creases at 60 % come to rest within 100.
const ELSEWHERE: f64 = 120.0;

/// A crease with the degrees that it is off its angle.
struct Off<'m> {
    crease: &'m Crease,
    edge: EdgeId,
    degrees: f64,
}

/// Warnings of driven creases that are far from their angles: of those that end inside a face at any percentage, of others
/// where the sheet came to rest at 100 % (or -100 %) without strain, or very far from them at any other percentage. A sheet that is
/// strained at 100 % is warned of as such.
pub(super) fn off_target(pattern: &CreasePattern, model: &Model, folded: &Folded) -> Vec<Warning> {
    if !folded.converged() {
        return Vec::new();
    }
    let ends = open_ends(pattern);
    let state = &folded.state;
    let mut off: Vec<Off<'_>> = { model.creases.iter().zip(&state.fold_angles).zip(&state.targets) }
        .filter(|((crease, _), _)| crease.stiffness > 0.0 && crease.full_target != crease.rest_angle)
        .filter_map(|((crease, angle), target)| {
            let edge = model.mesh.sides[crease.side.index()].edge?;
            Some(Off { crease, edge, degrees: (angle - target).abs().to_degrees() })
        })
        .filter(|off| off.degrees > FAR)
        .collect();
    off.sort_by(|a, b| b.degrees.total_cmp(&a.degrees));
    let end_of = |off: &Off<'_>| ends.iter().find(|end| end.crease == off.edge);
    let (open, whole): (Vec<Off<'_>>, Vec<Off<'_>>) = off.into_iter().partition(|off| end_of(off).is_some());
    let mut warnings = Vec::new();
    if let Some((worst, end)) = open.first().and_then(|worst| Some((worst, end_of(worst)?))) {
        let message = format!(
            "{}{}; at rest it is {:.1} degrees off its angle{}",
            if open.len() > 1 { "the first " } else { "" },
            ends_inside(end),
            worst.degrees,
            others(&open)
        );
        warnings.push(Warning::new(WarningCode::OpenCrease, places(model, &open), message));
    }
    let is_full = folded.percent().is_some_and(|percent| percent.abs() == 100.0);
    let least = if is_full { FAR } else { ELSEWHERE };
    let told: Vec<Off<'_>> = whole.into_iter().filter(|off| off.degrees > least).collect();
    let worst = told.first().map(|worst| (worst, Strain::of(model, &state.positions).beams.max > STRAINED));
    if let Some((worst, is_strained)) = worst.filter(|(_, is_strained)| !(is_full && *is_strained)) {
        let (how, why) = match is_strained {
            true => ("at rest and strained,", "the sheet is caught in another state"),
            false => ("at rest and not strained, and yet", "something in its way keeps it from folding"),
        };
        let message = format!("{how} {:.1} degrees off its angle{}: {why}", worst.degrees, others(&told));
        warnings.push(Warning::new(WarningCode::CreaseOffTarget, places(model, &told), message));
    }
    warnings
}

/// Where a crease ends, and what it misses.
fn ends_inside(end: &OpenEnd) -> String {
    let nearest = match end.nearest {
        Some((line, distance)) => format!(", {} from the nearest line (edge {})", Short(rounded(distance)), line.0),
        None => String::new(),
    };
    format!(
        "ends inside face {} at vertex {}{nearest}, so that the paper around its end cannot fold",
        end.face.0, end.vertex.0
    )
}

fn others(off: &[Off<'_>]) -> String {
    match off.len() {
        1 => String::new(),
        more => format!(", the most of {more} such creases"),
    }
}

fn places(model: &Model, off: &[Off<'_>]) -> Place {
    let ends = |crease: &Crease| {
        let mut ends = [crease.nodes[2], crease.nodes[3]].map(|n| model.mesh.vertex_of_node[n.index()]);
        ends.sort_unstable();
        ends
    };
    Place::Creases(off.iter().map(|off| CreasePlace::new(ends(off.crease), Some(off.edge))).collect())
}
