//! Maps of one row: strips of squares, folded crease after crease in all ways, against all orders in which they can lie.

use std::collections::BTreeSet;

use origami_core::contact::Contact;
use origami_core::glam::DVec3;
use origami_core::ids::VertexId;
use origami_core::{Model, State};

use super::asked::Asked;
use super::found::Found;
use super::strips::{fold, strip};
use crate::StudyError;
use crate::table::{Column, Table, column};

/// What ends blocked is folded again so. A roll of five squares, of which the last is tucked into three pockets, one in the
/// other, closes in it; little more or less of either, and it does not.
const HARD: Contact = Contact { gap: 1.8e-4, thickness: 0.0, stiffness: 1.8e4 };

const COLUMNS: &[Column] = &[
    column("squares", "squares", "of the strip"),
    column("orders", "orders", "in which it can lie, sequence A000136 of the OEIS"),
    column("reached", "reached", "those of them that came of some way, with the default gap and stiffness"),
    column("ways", "ways", "to fold one crease after the other, each to either side"),
    column("as_told", "as told", "those that converge, with each crease to its side"),
    column("blocked", "blocked", "those that end so"),
    column("otherwise", "otherwise", "those that end in any other way"),
    column(
        "reached_hard",
        "reached, hard",
        "orders that came of some way, those that were blocked folded again with a gap of 1.8e-4 and a stiffness of 18000",
    ),
    column("blocked_hard", "blocked, hard", "ways that are blocked then too"),
    column("crossings", "crossings", "of all folds, at every tenth evaluation and at the ends"),
];

pub(super) fn maps(quick: bool) -> Result<Found, StudyError> {
    let mut table = Table::new(COLUMNS);
    let (mut all, mut reached, mut reached_hard, mut otherwise, mut crossed) = (0, 0, 0, 0, 0);
    for squares in 2..=if quick { 3 } else { 5 } {
        let map = Map::fold_in_all_ways(squares)?;
        let orders = permutations(&(0..squares).collect::<Vec<_>>()).iter().filter(|order| is_valid(order)).count();
        let [soft, hard] = &map.folds;
        let together = soft.orders.union(&hard.orders).count();
        let other = soft.otherwise() + hard.otherwise();
        table.push(vec![
            squares.into(),
            orders.into(),
            soft.orders.len().into(),
            soft.ways.into(),
            soft.as_told.into(),
            soft.blocked.into(),
            other.into(),
            together.into(),
            hard.blocked.into(),
            map.crossings.into(),
        ]);
        (all, reached, reached_hard) = (all + orders, reached + soft.orders.len(), reached_hard + together);
        (otherwise, crossed) = (otherwise + other, crossed + map.crossings);
    }
    let asked = vec![
        Asked::that(
            "maps: orders reached",
            format!("all {all}"),
            format!("{reached_hard}, {reached} of them with the defaults"),
            reached_hard == all,
        ),
        Asked::that(
            "maps: no other order, no crossing",
            "none",
            format!("{otherwise}, {crossed}"),
            otherwise + crossed == 0,
        ),
    ];
    Ok(Found::one("Maps of one row", MAPS, ("contact-maps", table), asked))
}

const MAPS: &str = "Strips of squares, folded one crease after the other, in all orders of the creases and each to both sides. Ways \
    that end blocked are folded again in a narrower gap that pushes back harder. A roll of five squares has its last one in three \
    pockets, one in the other: it is blocked with the defaults, and whether it closes at all hangs on little.";

/// What came of ways to fold a strip of squares.
#[derive(Default)]
struct Folds {
    orders: BTreeSet<Vec<usize>>,
    ways: usize,
    as_told: usize,
    blocked: usize,
}

impl Folds {
    fn otherwise(&self) -> usize {
        self.ways - self.as_told - self.blocked
    }
}

/// What came of all ways, and of those that ended blocked, folded again.
#[derive(Default)]
struct Map {
    folds: [Folds; 2],
    crossings: usize,
}

impl Map {
    fn fold_in_all_ways(squares: usize) -> Result<Self, StudyError> {
        let model = strip(&vec![1.0; squares])?;
        let mut map = Self::default();
        for creases in permutations(&(0..squares - 1).collect::<Vec<_>>()) {
            for sides in 0..1_usize << (squares - 1) {
                if map.fold(&model, (&creases, sides), false) {
                    map.fold(&model, (&creases, sides), true);
                }
            }
        }
        Ok(map)
    }

    /// Folds the creases one after the other, each to the side that its bit tells; true if that ends blocked.
    fn fold(&mut self, model: &Model, (creases, sides): (&[usize], usize), hard: bool) -> bool {
        let squares = creases.len() + 1;
        let is_valley = |crease: usize| sides >> crease & 1 == 1;
        let steps = creases.iter().map(|crease| [(*crease, if is_valley(*crease) { 180.0 } else { -180.0 })]);
        let steps: Vec<[(usize, f64); 1]> = steps.collect();
        let steps: Vec<&[(usize, f64)]> = steps.iter().map(<[_; 1]>::as_slice).collect();
        let folds = &mut self.folds[usize::from(hard)];
        folds.ways += 1;
        let Some(came) = fold(model, &steps, if hard { HARD } else { Contact::default() }) else { return false };
        self.crossings += came.crossings;
        let is_blocked = came.stop() == "blocked";
        folds.blocked += usize::from(is_blocked);
        let Some(order) = stack(model, &came.folded.state, squares) else { return is_blocked };
        let place = |panel: usize| order.iter().position(|own| *own == panel);
        // A valley takes the next panel above one that faces up.
        let is_told =
            |crease: usize| (place(crease + 1) > place(crease)) == (is_valley(crease) == crease.is_multiple_of(2));
        if came.stop() == "converged" && is_valid(&order) && (0..squares - 1).all(is_told) {
            folds.as_told += 1;
            folds.orders.insert(order);
        }
        is_blocked
    }
}

/// The squares of a strip that lies closed from the bottom to the top, where up is where the first faced when it was flat. Of
/// two squares the one is higher whose surface is, where the middle of a triangle of the one is above the other. `None` where
/// some two do not tell.
fn stack(model: &Model, state: &State, squares: usize) -> Option<Vec<usize>> {
    let at = |vertex: u32| Some(state.positions[model.node(VertexId(vertex))?.index()]);
    let x = (at(2)? - at(0)?).normalize();
    let up = x.cross(at(1)? - at(0)?).normalize();
    let y = up.cross(x);
    let seen = |p: DVec3| DVec3::new(p.dot(x), p.dot(y), p.dot(up));
    let triangles_of = |square: usize| -> Vec<[DVec3; 3]> {
        let corners = 2 * square..2 * square + 4;
        let own = model.mesh.triangles.iter();
        let own =
            own.filter(|nodes| nodes.iter().all(|n| corners.contains(&model.mesh.vertex_of_node[n.index()].index())));
        own.map(|nodes| nodes.map(|n| seen(state.positions[n.index()]))).collect()
    };
    let all: Vec<Vec<[DVec3; 3]>> = (0..squares).map(triangles_of).collect();
    // How high a triangle is at a place within it.
    let height = |[a, b, c]: [DVec3; 3], p: DVec3| {
        let cross = |u: DVec3, v: DVec3| u.x * v.y - u.y * v.x;
        let (v, w) = (cross(p - a, c - a) / cross(b - a, c - a), cross(b - a, p - a) / cross(b - a, c - a));
        (v >= 0.0 && w >= 0.0 && v + w <= 1.0).then_some(a.z + v * (b.z - a.z) + w * (c.z - a.z))
    };
    let mut below = vec![0; squares];
    for one in 0..squares {
        for other in 0..one {
            let [a, b, c] = *all[one].first()?;
            let middle = (a + b + c) / 3.0;
            let z = all[other].iter().find_map(|triangle| height(*triangle, middle))?;
            below[if middle.z > z { one } else { other }] += 1;
        }
    }
    let mut order: Vec<usize> = (0..squares).collect();
    order.sort_by_key(|square| below[*square]);
    let is_stack = order.iter().enumerate().all(|(place, square)| below[*square] == place);
    is_stack.then_some(order)
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
