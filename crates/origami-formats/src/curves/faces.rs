//! The faces between runs, as polygons whose corners know the direction of the curve that they are on.

use std::collections::BTreeMap;

use glam::DVec2;
use origami_core::CreasePattern;

use super::key;
use super::runs::Run;

/// The cosine of the turn at a corner beyond which it is none of a curve: 40 degrees.
const TURN: f64 = 0.766;

/// A corner of a face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) at: DVec2,
    /// The direction of the curve there, of length 1; `None` at corners and on straight lines.
    pub(super) tangent: Option<DVec2>,
}

/// A face, counterclockwise.
pub(super) type Face = Vec<Corner>;

/// The faces of a pattern made of `runs` that have a curved side.
pub(super) fn of(pattern: &CreasePattern, runs: &[Run]) -> Vec<Face> {
    // Where curves go on.
    let mut on_curve: BTreeMap<[u64; 2], ()> = BTreeMap::new();
    for run in runs.iter().filter(|run| run.curved) {
        let closed = run.nodes.first().map(|n| n.at) == run.nodes.last().map(|n| n.at);
        let last = run.nodes.len() - 1;
        let inner = run.nodes.iter().enumerate().filter(|(index, _)| closed || (*index > 0 && *index < last));
        on_curve.extend(inner.map(|(_, node)| (key(node.at), ())));
    }
    let faces = pattern.faces.iter().map(|face| {
        let at = without_spurs(face.iter().map(|vertex| pattern.vertices[vertex.index()].truncate()));
        let corner = |index: usize| {
            let [before, here, after] = [index + at.len() - 1, index, index + 1].map(|i| at[i % at.len()]);
            let tangent = on_curve.contains_key(&key(here)).then(|| tangent(before, here, after)).flatten();
            Corner { at: here, tangent }
        };
        (0..at.len()).map(corner).collect::<Face>()
    });
    faces.filter(|face| face.iter().any(|corner| corner.tangent.is_some())).collect()
}

/// Corners without those where the outline goes to and fro along a line that ends inside.
fn without_spurs(corners: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut outline: Vec<DVec2> = Vec::new();
    for corner in corners {
        match outline[..] {
            [.., before, _] if before == corner => {
                outline.pop();
            }
            _ => outline.push(corner),
        }
    }
    // Around the place where the list begins.
    while let [first, second, .., before, last] = outline[..] {
        if before == first {
            outline.truncate(outline.len() - 2);
        } else if last == second {
            outline.drain(..2);
        } else {
            break;
        }
    }
    outline
}

/// The direction at the middle of three points on a curve, exact on circles.
fn tangent(before: DVec2, here: DVec2, after: DVec2) -> Option<DVec2> {
    let (to, from) = ((here - before).try_normalize()?, (after - here).try_normalize()?);
    (to.dot(from) > TURN).then(|| (to * here.distance(after) + from * here.distance(before)).normalize_or_zero())
}
