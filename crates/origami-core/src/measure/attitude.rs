//! How a folded sheet lies in space. Folding does not say: without supports every rigid motion of a result is as good a
//! result, and which one a solver ends at depends on its rounding. So whoever shows, writes or compares results turns them
//! first, by a rule that knows nothing but the shape.
//!
//! The rule: the sheet is laid upon itself as it was before it was folded, by the rotation and translation that make the
//! mean square distance over its surface least (Horn's, as in [`super::align`]; the integral is exact, so how faces are
//! cut into triangles does not matter). Where a shape leaves that rotation nearly open, as a sheet folded in half does,
//! which may turn about its fold, one face decides: the largest, of several the one nearest to the middle. It takes over
//! step by step, so that neighbouring shapes lie in neighbouring attitudes. A sheet folded flat thereby lies flat.

use glam::{DMat3, DVec3};

use super::alignment::{best_rotation, outer};
use crate::error::{Error, ErrorCode};
use crate::ids::FaceId;
use crate::model::Model;
use crate::solve::State;

/// Below this the face begins to decide: how well the fit tells the rotation, as a share of how well it does for the sheet
/// before it is folded. A square folded in half by t has cos(t/2), so this is at 133 degrees.
const OPEN: f64 = 0.4;
/// A motion that moves nothing farther than this, in radii, is rounding and left out: a sheet that was not folded keeps its
/// every bit.
const NOTHING: f64 = 1e-12;
/// Areas and distances of faces that differ by less than this share are equal: the same sheet read from another file has
/// the same face for its reference.
const EQUAL: f64 = 1e-6;

/// What keeps its place when a folded sheet is turned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// The sheet as a whole: it lies as near as can be to where it lay before it was folded. A model with fixed vertices
    /// is not turned, as they hold it. The default.
    #[default]
    Sheet,
    /// A face of the pattern: it lies where it lay before the sheet was folded.
    Face(FaceId),
    /// Nothing: the sheet stays where the solver left it.
    Nothing,
}

/// A rigid motion, never a reflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Turned by this first.
    pub rotation: DMat3,
    /// Then moved by this, in the unit of the points.
    pub translation: DVec3,
}

impl Motion {
    /// That which moves nothing.
    pub const NONE: Self = Self { rotation: DMat3::IDENTITY, translation: DVec3::ZERO };

    /// Where a point goes.
    #[must_use]
    pub fn apply(&self, point: DVec3) -> DVec3 {
        self.rotation * point + self.translation
    }

    /// The motion by `rotation` that takes `from` to `to`.
    fn about(rotation: DMat3, from: DVec3, to: DVec3) -> Self {
        Self { rotation, translation: to - rotation * from }
    }

    /// Whether it moves no point of a sheet of radius 1 by anything but rounding.
    fn is_nothing(&self) -> bool {
        let turned = (self.rotation - DMat3::IDENTITY).to_cols_array().into_iter().map(f64::abs).fold(0.0, f64::max);
        turned.max(self.translation.length()) < NOTHING
    }
}

/// The motion that turns a folded sheet as `hold` says; `positions` are those of the nodes, in radii. The same shape in
/// another attitude ends in the same place. [`Motion::NONE`] where nothing is to be turned: a position is not finite, or the
/// sheet has no area.
///
/// Who runs a sheet with supports or loads of a scene, which hold it, passes [`Hold::Nothing`] or does not call this.
///
/// # Errors
/// [`Error::Invalid`] for a face that the pattern does not have.
///
/// # Panics
/// If there are not as many positions as nodes.
pub fn motion(model: &Model, positions: &[DVec3], hold: Hold) -> Result<Motion, Error> {
    assert_eq!(positions.len(), model.node_count(), "one position for each node");
    let held_by_itself = hold == Hold::Sheet && !model.fixed.is_empty();
    if let Hold::Face(face) = hold {
        check(model, face)?;
    }
    if hold == Hold::Nothing || held_by_itself || positions.iter().any(|p| !p.is_finite()) {
        return Ok(Motion::NONE);
    }
    let motion = match hold {
        Hold::Face(face) => of_face(model, positions, face),
        _ => of_sheet(model, positions),
    };
    Ok(motion.filter(|motion| !motion.is_nothing()).unwrap_or(Motion::NONE))
}

/// The state as [`motion`] turns it: positions and velocities; angles are what they were.
///
/// # Errors
/// As for [`motion`].
///
/// # Panics
/// As for [`motion`].
pub fn turned(model: &Model, state: &State, hold: Hold) -> Result<State, Error> {
    let motion = motion(model, &state.positions, hold)?;
    if motion == Motion::NONE {
        return Ok(state.clone());
    }
    Ok(State {
        positions: state.positions.iter().map(|p| motion.apply(*p)).collect(),
        velocities: state.velocities.iter().map(|v| motion.rotation * *v).collect(),
        ..state.clone()
    })
}

fn check(model: &Model, face: FaceId) -> Result<(), Error> {
    let faces = &model.mesh.face_of_triangle;
    if faces.contains(&face) {
        return Ok(());
    }
    let last = faces.iter().max().map_or_else(|| "a sheet with faces".to_owned(), |last| format!("0 to {}", last.0));
    Err(Error::new(ErrorCode::Setting, "the face to hold", format!("there is no face {}", face.0), last))
}

fn of_sheet(model: &Model, positions: &[DVec3]) -> Option<Motion> {
    let all = 0..model.mesh.triangles.len();
    let moments = Moments::of(model, positions, all.clone())?;
    let at_rest = Moments::of(model, &model.rest, all)?;
    let (rotation, told) = best_rotation(moments.products);
    let (_, told_at_rest) = best_rotation(at_rest.products);
    let open = OPEN - told / told_at_rest;
    let about = |rotation| Some(Motion::about(rotation, moments.folded, moments.rest));
    // NaN, of a sheet on a line, leaves the fit as it is.
    if open <= 0.0 || open.is_nan() {
        return about(rotation);
    }
    let face = of_face(model, positions, reference(model)?)?;
    about(best_rotation(moments.products + face.rotation * (0.25 * told_at_rest * open)).0)
}

fn of_face(model: &Model, positions: &[DVec3], face: FaceId) -> Option<Motion> {
    let faces = model.mesh.face_of_triangle.iter().enumerate();
    let own: Vec<usize> = faces.filter(|(_, of)| **of == face).map(|(triangle, _)| triangle).collect();
    let moments = Moments::of(model, positions, own.into_iter())?;
    Some(Motion::about(best_rotation(moments.products).0, moments.folded, moments.rest))
}

/// Integrals over triangles, each weighed by its area before folding.
struct Moments {
    /// The middle of the folded surface.
    folded: DVec3,
    /// The middle of the flat one.
    rest: DVec3,
    /// The products of coordinates about the two: folded by column, flat by row.
    products: DMat3,
}

impl Moments {
    /// `None` where they have no area.
    fn of(model: &Model, positions: &[DVec3], triangles: impl Iterator<Item = usize>) -> Option<Self> {
        let (mut area, mut folded, mut rest, mut products) = (0.0, DVec3::ZERO, DVec3::ZERO, DMat3::ZERO);
        for triangle in triangles {
            let nodes = model.mesh.triangles[triangle].map(|n| n.index());
            let (now, before) = (nodes.map(|n| positions[n]), nodes.map(|n| model.rest[n]));
            let own = 0.5 * (before[1] - before[0]).cross(before[2] - before[0]).length();
            let (sum, sum_before) = (now[0] + now[1] + now[2], before[0] + before[1] + before[2]);
            area += own;
            folded += sum * (own / 3.0);
            rest += sum_before * (own / 3.0);
            // Of two functions that are linear on the triangle.
            let corners = (0..3).fold(outer(sum, sum_before), |all, k| all + outer(now[k], before[k]));
            products += corners * (own / 12.0);
        }
        if area <= 0.0 || area.is_nan() {
            return None;
        }
        let (folded, rest) = (folded / area, rest / area);
        Some(Self { folded, rest, products: products - outer(folded, rest) * area })
    }
}

/// The face that decides where the fit leaves the rotation open.
fn reference(model: &Model) -> Option<FaceId> {
    let mut faces: Vec<(FaceId, f64, DVec3)> = Vec::new();
    let mut triangles: Vec<(FaceId, [DVec3; 3])> = { model.mesh.triangles.iter().zip(&model.mesh.face_of_triangle) }
        .map(|(nodes, face)| (*face, nodes.map(|n| model.rest[n.index()])))
        .collect();
    triangles.sort_by_key(|(face, _)| *face);
    for (face, [a, b, c]) in triangles {
        let area = 0.5 * (b - a).cross(c - a).length();
        let moment = (a + b + c) * (area / 3.0);
        match faces.last_mut() {
            Some((last, sum, moments)) if *last == face => (*sum, *moments) = (*sum + area, *moments + moment),
            _ => faces.push((face, area, moment)),
        }
    }
    let largest = faces.iter().map(|(_, area, _)| *area).fold(0.0, f64::max);
    faces.retain(|(_, area, _)| *area > 0.0 && *area >= (1.0 - EQUAL) * largest);
    let middle = |(_, area, moment): &(FaceId, f64, DVec3)| *moment / *area;
    // The nearest to the middle, which is the origin of the model's coordinates; then the leftmost, the lowest.
    for least in [|p: DVec3| p.length(), |p: DVec3| p.x, |p: DVec3| p.y, |p: DVec3| p.z] {
        let bound = faces.iter().map(|face| least(middle(face))).fold(f64::INFINITY, f64::min) + EQUAL;
        faces.retain(|face| least(middle(face)) <= bound);
    }
    faces.first().map(|(face, ..)| *face)
}
