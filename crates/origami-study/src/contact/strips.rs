//! Strips of panels, folded crease after crease: what lies under what is what was folded first. Here letters and flaps; maps are in
//! [`super::maps`].

use origami_core::contact::Contact;
use origami_core::fold::Document;
use origami_core::ids::EdgeId;
use origami_core::layers::{FaceOrder, face_orders};
use origami_core::scene::Targets;
use origami_core::{CreasePattern, Material, Model, Relax, Scene, State};
use serde_json::json;

use super::asked::Asked;
use super::found::Found;
use super::watched::{Watched, solver, watched};
use crate::StudyError;
use crate::table::{Column, Table, column};

/// How far a fold may be off that is closed, in degrees.
const CLOSED: f64 = 5.0;

/// A strip of panels of these widths, which are its faces in turn. Edge k is the crease after panel k.
pub(super) fn strip(widths: &[f64]) -> Result<Model, StudyError> {
    let mut ends = vec![0.0];
    widths.iter().for_each(|width| ends.push(ends[ends.len() - 1] + width));
    let vertices: Vec<[f64; 2]> = ends.iter().flat_map(|x| [[*x, 0.0], [*x, 1.0]]).collect();
    let panels = widths.len();
    let line = |k: usize| [2 * k, 2 * k + 1];
    let mut edges: Vec<[usize; 2]> = (1..panels).map(line).collect();
    edges.extend([line(0), line(panels)]);
    edges.extend((0..panels).flat_map(|k| [[2 * k, 2 * k + 2], [2 * k + 1, 2 * k + 3]]));
    let letters: Vec<&str> = (0..edges.len()).map(|edge| if edge + 1 < panels { "V" } else { "B" }).collect();
    let faces: Vec<[usize; 4]> = (0..panels).map(|k| [2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1]).collect();
    let text = json!({
        "vertices_coords": vertices, "edges_vertices": edges, "edges_assignment": letters, "faces_vertices": faces,
    });
    let pattern = CreasePattern::from_document(&Document::from_slice(text.to_string().as_bytes())?, 0)?;
    Ok(Model::new(&pattern, &Material::default())?)
}

/// Folds a strip by steps: the creases of each, and how far each is folded, in degrees.
pub(super) fn fold(model: &Model, steps: &[&[(usize, f64)]], contact: Contact) -> Option<Watched> {
    let mut targets = vec![0.0; model.creases.len()];
    let stages = steps.iter().map(|step| {
        for (crease, degrees) in *step {
            if let Some(crease) = model.crease_of(EdgeId::new(*crease)) {
                targets[crease.index()] = degrees.to_radians();
            }
        }
        Scene::new(Targets::angles(targets.clone()))
    });
    let stages: Vec<Scene> = stages.collect();
    watched(model, &solver(Relax::default().perturbation, contact), &stages).ok()
}

/// The panels of a strip from the bottom to the top, where up is where panel `base` faced when it was flat: each lies on as many
/// others as are below it. `None` where they are not folded flat, or some two do not tell.
fn layers(model: &Model, state: &State, panels: usize, base: usize) -> Option<Vec<usize>> {
    let orders = face_orders(model, &state.positions, &state.fold_angles)?;
    let mut below = vec![0; panels];
    for FaceOrder { faces, side } in &orders {
        let [first, second] = faces.map(|face| face.index());
        let second_faces_up = second.abs_diff(base).is_multiple_of(2);
        match side {
            0 => return None,
            side => below[if (*side > 0) == second_faces_up { first } else { second }] += 1,
        }
    }
    let mut order: Vec<usize> = (0..panels).collect();
    order.sort_by_key(|panel| below[*panel]);
    let is_stack = order.iter().enumerate().all(|(place, panel)| below[*panel] == place);
    is_stack.then_some(order)
}

const COLUMNS: &[Column] = &[
    column("fold", "fold", "what is folded, and how"),
    column("end", "end", "of the last step"),
    column("crossings", "crossings", "at the end of each step and at every tenth evaluation, added up"),
    column("evaluations", "evaluations", "of all steps"),
    column("off_deg", "off (degrees)", "the largest difference of an angle from its target"),
    column("strain", "strain", "largest of a beam"),
    column(
        "layers",
        "layers",
        "panels from the bottom to the top, as the middle one faced when it was flat; where they are flat",
    ),
    column("pressing", "pressing", "the faces that press hardest"),
];

/// What came of a fold, and the order of its panels.
type Came = Option<(Watched, Option<Vec<usize>>)>;

/// A letter, and two flaps.
pub(super) fn told(_: bool) -> Result<Found, StudyError> {
    let (letter, flaps) = (strip(&[1.0; 3])?, strip(&[0.8, 1.0, 0.8])?);
    let (left, right) = ((0, 180.0), (1, 180.0));
    let mut table = Table::new(COLUMNS);
    let mut add = |what: &str, model: &Model, steps: &[&[(usize, f64)]]| {
        let came = fold(model, steps, Contact::default())?;
        let order = layers(model, &came.folded.state, 3, 1);
        let named = |order: &Vec<usize>| order.iter().map(ToString::to_string).collect::<Vec<String>>().join(" ");
        table.push(vec![
            what.into(),
            came.stop().into(),
            came.crossings.into(),
            came.evaluations.into(),
            came.off.into(),
            came.strain.into(),
            order.as_ref().map(named).into(),
            came.pressing(1).into(),
        ]);
        Some((came, order))
    };
    let in_order = add("letter, one third after the other", &letter, &[&[left], &[right]]);
    let at_once = add("letter, both at once", &letter, &[&[left, right]]);
    let left_first = add("two flaps, left first", &flaps, &[&[left], &[right]]);
    let right_first = add("two flaps, right first", &flaps, &[&[right], &[left]]);
    let closes = |came: &Came, order: &[usize]| {
        let lies_so = |own: &Option<Vec<usize>>| own.as_deref() == Some(order);
        came.as_ref().is_some_and(|(came, own)| came.crossings == 0 && came.off <= CLOSED && lies_so(own))
    };
    let ends = |came: &Came| came.as_ref().map_or("no end", |(came, _)| came.stop());
    let pair = at_once.as_ref().map_or(String::new(), |(came, _)| came.pressing(1));
    let closed = format!("closed within {CLOSED} degrees");
    let asked = vec![
        Asked::that("letter in order", closed, ends(&in_order), closes(&in_order, &[1, 0, 2])),
        Asked::that(
            "letter at once",
            "blocked, the outer panels press",
            format!("{}, {pair} press", ends(&at_once)),
            ends(&at_once) == "blocked" && pair == "0 and 2",
        ),
        Asked::that(
            "two flaps in both orders",
            "the last one on top",
            format!("{}, {}", ends(&left_first), ends(&right_first)),
            closes(&left_first, &[1, 0, 2]) && closes(&right_first, &[1, 2, 0]),
        ),
    ];
    Ok(Found::one("Flaps, in order and at once", TOLD, ("contact-told", table), asked))
}

const TOLD: &str = "Strips of three panels, both creases valleys, to 180 degrees: a letter of equal panels, and two flaps of 0.8 that \
    overlap in the middle.";
