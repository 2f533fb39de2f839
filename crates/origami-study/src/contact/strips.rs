//! Strips of panels, folded crease after crease: what lies under what is what was folded first.

use std::collections::BTreeSet;

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
fn strip(widths: &[f64]) -> Result<Model, StudyError> {
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
fn fold(model: &Model, steps: &[&[(usize, f64)]]) -> Option<Watched> {
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
    watched(model, &solver(Relax::default().perturbation, Contact::default()), &stages).ok()
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
        let came = fold(model, steps)?;
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

const MAP_COLUMNS: &[Column] = &[
    column("squares", "squares", "of the strip"),
    column("orders", "orders", "in which it can lie, sequence A000136 of the OEIS"),
    column("reached", "reached", "those of them that came of some way"),
    column("ways", "ways", "to fold one crease after the other, each to either side"),
    column("as_told", "as told", "those that converge, with each crease to its side"),
    column("blocked", "blocked", "those that end so"),
    column("otherwise", "otherwise", "those that end in any other way"),
    column("crossings", "crossings", "of all of them, at every tenth evaluation and at the ends"),
];

/// Maps of one row.
pub(super) fn maps(quick: bool) -> Result<Found, StudyError> {
    let mut table = Table::new(MAP_COLUMNS);
    let (mut all, mut reached, mut otherwise, mut crossed) = (0, 0, 0, 0);
    for squares in 2..=if quick { 3 } else { 4 } {
        let map = Map::fold_in_all_ways(squares)?;
        let orders = permutations(&(0..squares).collect::<Vec<_>>()).iter().filter(|order| is_valid(order)).count();
        table.push(vec![
            squares.into(),
            orders.into(),
            map.orders.len().into(),
            map.ways.into(),
            map.as_told.into(),
            map.blocked.into(),
            (map.ways - map.as_told - map.blocked).into(),
            map.crossings.into(),
        ]);
        (all, reached) = (all + orders, reached + map.orders.len());
        (otherwise, crossed) = (otherwise + map.ways - map.as_told - map.blocked, crossed + map.crossings);
    }
    let asked = vec![
        Asked::that("maps: orders reached", format!("all {all}"), reached.to_string(), reached == all),
        Asked::that(
            "maps: no other order, no crossing",
            "none",
            format!("{otherwise}, {crossed}"),
            otherwise + crossed == 0,
        ),
    ];
    Ok(Found::one("Maps of one row", MAPS, ("contact-maps", table), asked))
}

const MAPS: &str = "Strips of squares, folded one crease after the other, in all orders of the creases and each to both sides. A panel \
    that is to be tucked into two pockets, one in the other, has no room, and such ways end blocked.";

/// What came of all ways to fold a strip of squares.
#[derive(Default)]
struct Map {
    orders: BTreeSet<Vec<usize>>,
    ways: usize,
    as_told: usize,
    blocked: usize,
    crossings: usize,
}

impl Map {
    fn fold_in_all_ways(squares: usize) -> Result<Self, StudyError> {
        let model = strip(&vec![1.0; squares])?;
        let mut map = Self::default();
        for creases in permutations(&(0..squares - 1).collect::<Vec<_>>()) {
            for sides in 0..1_usize << (squares - 1) {
                let is_valley = |crease: usize| sides >> crease & 1 == 1;
                let steps = creases.iter().map(|crease| [(*crease, if is_valley(*crease) { 180.0 } else { -180.0 })]);
                let steps: Vec<[(usize, f64); 1]> = steps.collect();
                let steps: Vec<&[(usize, f64)]> = steps.iter().map(<[_; 1]>::as_slice).collect();
                map.ways += 1;
                let Some(came) = fold(&model, &steps) else { continue };
                map.crossings += came.crossings;
                map.blocked += usize::from(came.stop() == "blocked");
                let Some(order) = layers(&model, &came.folded.state, squares, 0) else { continue };
                let place = |panel: usize| order.iter().position(|own| *own == panel);
                // A valley takes the next panel above one that faces up.
                let is_told = |crease: usize| {
                    (place(crease + 1) > place(crease)) == (is_valley(crease) == crease.is_multiple_of(2))
                };
                if came.stop() == "converged" && is_valid(&order) && (0..squares - 1).all(is_told) {
                    map.as_told += 1;
                    map.orders.insert(order);
                }
            }
        }
        Ok(map)
    }
}

/// Whether a strip of squares can lie in layers in this order, from the bottom to the top: no crease lies within another on its
/// side. (S. Legendre, Foldings and meanders, Australas. J. Combin. 58 (2014).)
fn is_valid(order: &[usize]) -> bool {
    let place = |panel: usize| order.iter().position(|own| *own == panel).unwrap_or_default();
    let crease = |i: usize| [place(i).min(place(i + 1)), place(i).max(place(i + 1))];
    let within = |[a, b]: [usize; 2], [c, d]: [usize; 2]| a < c && c < b && b < d;
    let meet = |i: usize, j: usize| within(crease(i), crease(j)) || within(crease(j), crease(i));
    (0..order.len() - 1).all(|i| (i + 2..order.len() - 1).step_by(2).all(|j| !meet(i, j)))
}

fn permutations(of: &[usize]) -> Vec<Vec<usize>> {
    if of.is_empty() {
        return vec![Vec::new()];
    }
    let with = |first: usize| {
        let rest: Vec<usize> = of.iter().copied().filter(|own| *own != first).collect();
        permutations(&rest).into_iter().map(move |tail| [vec![first], tail].concat())
    };
    of.iter().flat_map(|first| with(*first)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_orders_are_as_many_as_are_known() {
        let count = |n: usize| permutations(&(0..n).collect::<Vec<_>>()).iter().filter(|order| is_valid(order)).count();
        assert_eq!([2, 3, 4, 5, 6].map(count), [2, 6, 16, 50, 144], "sequence A000136 of the OEIS");
    }
}
