//! Folds flat-folded paper along a line, and keeps book on the sheet: how a model's crease pattern is derived.

use std::collections::{HashMap, VecDeque};

use glam::{DAffine2, DMat2, DVec2};

use super::builder::SheetBuilder;
use crate::pattern::CreasePattern;

/// Nearer to a line than this is on it; the sheet has size 1.
const ON_LINE: f64 = 1e-9;

/// A line in the folded plane, and which side of it moves.
#[derive(Clone, Copy)]
pub(super) struct FoldLine {
    through: DVec2,
    /// Unit normal towards the side that moves.
    normal: DVec2,
}

impl FoldLine {
    /// The line through a point along a direction; the side of `moving` moves.
    pub(super) fn new(through: DVec2, direction: DVec2, moving: DVec2) -> Self {
        let normal = direction.normalize().perp();
        Self { through, normal: if normal.dot(moving - through) < 0.0 { -normal } else { normal } }
    }

    fn distance(&self, point: DVec2) -> f64 {
        self.normal.dot(point - self.through)
    }

    /// A direction, as it is after the fold.
    pub(super) fn reflected(&self, direction: DVec2) -> DVec2 {
        direction - 2.0 * self.normal.dot(direction) * self.normal
    }

    fn reflection(&self) -> DAffine2 {
        let n = self.normal;
        let linear = DMat2::from_cols(DVec2::X - 2.0 * n.x * n, DVec2::Y - 2.0 * n.y * n);
        DAffine2::from_mat2_translation(linear, self.through - linear * self.through)
    }
}

/// A piece of paper without a crease inside.
#[derive(Clone)]
struct Facet {
    /// Counterclockwise on the sheet; convex.
    corners: Vec<usize>,
    /// From the sheet to the folded plane.
    placed: DAffine2,
}

/// A sheet, folded flat. Convex facets of paper, each with its position in the folded plane.
pub(super) struct FlatFold {
    /// On the sheet.
    points: Vec<DVec2>,
    facets: Vec<Facet>,
    /// Fold angles by the ends of the crease, the lower one first; valley positive.
    folds: HashMap<[usize; 2], f64>,
}

fn key(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

impl FlatFold {
    /// Folds `facets` flat along `folds`; the first one stays where it is.
    pub(super) fn new(points: Vec<DVec2>, facets: Vec<Vec<usize>>, folds: &[([usize; 2], f64)]) -> Self {
        let facets = facets.into_iter().map(|corners| Facet { corners, placed: DAffine2::IDENTITY }).collect();
        let folds = folds.iter().map(|&([a, b], angle)| (key(a, b), angle)).collect();
        let mut paper = Self { points, facets, folds };
        let across = paper.across();
        let mut reached = vec![false; paper.facets.len()];
        reached[0] = true;
        let mut queue = VecDeque::from([0]);
        while let Some(f) = queue.pop_front() {
            for (a, b) in paper.sides(f) {
                let Some(&g) = across.get(&[b, a]).filter(|&&g| !reached[g]) else { continue };
                let here = paper.facets[f].placed;
                let [from, to] = [a, b].map(|v| here.transform_point2(paper.points[v]));
                let crease = FoldLine::new(from, to - from, from);
                let folded = paper.folds.contains_key(&key(a, b));
                paper.facets[g].placed = if folded { crease.reflection() * here } else { here };
                reached[g] = true;
                queue.push_back(g);
            }
        }
        paper
    }

    /// Where a point of the sheet lies in the folded plane, on any facet that has it as a corner.
    pub(super) fn folded(&self, point: usize) -> DVec2 {
        let facet = self.facets.iter().find(|facet| facet.corners.contains(&point));
        facet.map_or(self.points[point], |facet| facet.placed.transform_point2(self.points[point]))
    }

    /// Folds over the flap that hangs on `tip`: what is connected with it on the line's moving side, through all its
    /// layers. `side` says for a point of the sheet whether its layer turns towards the viewer (1) or away (-1); a
    /// crease between layers that turn opposite ways is turned inside out, as in a reverse fold.
    pub(super) fn fold(&mut self, tip: usize, line: FoldLine, angle: f64, side: impl Fn(DVec2) -> f64) {
        let flap = self.flap(tip, line);
        let mut cuts: HashMap<[usize; 2], usize> = HashMap::new();
        let mut moved = Vec::new();
        for f in flap {
            let Facet { corners, placed } = self.facets[f].clone();
            let turn = side(corners.iter().map(|&v| self.points[v]).sum::<DVec2>() / corners.len() as f64);
            let (stays, moves) = self.cut(&corners, placed, line, &mut cuts);
            let crease: Vec<usize> = stays.iter().copied().filter(|v| moves.contains(v)).collect();
            if let (&[a, b], true) = (crease.as_slice(), stays.len() > 2) {
                let facing = placed.matrix2.determinant().signum();
                self.folds.insert(key(a, b), turn * facing * angle);
                self.facets[f].corners = stays;
                moved.push((self.facets.len(), turn));
                self.facets.push(Facet { corners: moves, placed: line.reflection() * placed });
            } else {
                self.facets[f].placed = line.reflection() * placed;
                moved.push((f, turn));
            }
        }
        self.turn_inside_out(&moved);
    }

    /// The facets that reach over the line and hang together there, beginning with those at `tip`.
    fn flap(&self, tip: usize, line: FoldLine) -> Vec<usize> {
        let across = self.across();
        let over = |f: usize, v: usize| line.distance(self.facets[f].placed.transform_point2(self.points[v])) > ON_LINE;
        let mut reached: Vec<bool> =
            (0..self.facets.len()).map(|f| self.facets[f].corners.contains(&tip) && over(f, tip)).collect();
        let mut flap: Vec<usize> = (0..reached.len()).filter(|&f| reached[f]).collect();
        let mut next = 0;
        while let Some(&f) = flap.get(next) {
            next += 1;
            for (a, b) in self.sides(f).filter(|&(a, b)| over(f, a) || over(f, b)) {
                if let Some(&g) = across.get(&[b, a]).filter(|&&g| !reached[g]) {
                    reached[g] = true;
                    flap.push(g);
                }
            }
        }
        flap
    }

    /// The part of a facet that stays, and the part that moves. New points are shared between neighbours through `cuts`.
    fn cut(
        &mut self,
        corners: &[usize],
        placed: DAffine2,
        line: FoldLine,
        cuts: &mut HashMap<[usize; 2], usize>,
    ) -> (Vec<usize>, Vec<usize>) {
        let (mut stays, mut moves) = (Vec::new(), Vec::new());
        for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let [from, to] = [a, b].map(|v| line.distance(placed.transform_point2(self.points[v])));
            if from < ON_LINE {
                stays.push(a);
            }
            if from > -ON_LINE {
                moves.push(a);
            }
            if from.abs() >= ON_LINE && to.abs() >= ON_LINE && (from < 0.0) != (to < 0.0) {
                let point = *cuts.entry(key(a, b)).or_insert_with(|| {
                    let new = self.points.len();
                    self.points.push(self.points[a].lerp(self.points[b], from / (from - to)));
                    if let Some(angle) = self.folds.remove(&key(a, b)) {
                        self.folds.extend([(key(a, new), angle), (key(new, b), angle)]);
                    }
                    new
                });
                stays.push(point);
                moves.push(point);
            }
        }
        (stays, moves)
    }

    /// Swaps mountain and valley between moved facets that turned opposite ways.
    fn turn_inside_out(&mut self, moved: &[(usize, f64)]) {
        let turned: HashMap<usize, f64> = moved.iter().copied().collect();
        let across = self.across();
        for &(f, turn) in moved {
            for (a, b) in self.sides(f).filter(|(a, b)| a < b) {
                let other = across.get(&[b, a]).and_then(|g| turned.get(g));
                if other.is_some_and(|&other| other != turn)
                    && let Some(angle) = self.folds.get_mut(&key(a, b))
                {
                    *angle = -*angle;
                }
            }
        }
    }

    /// The facet to the left of each directed side.
    fn across(&self) -> HashMap<[usize; 2], usize> {
        (0..self.facets.len()).flat_map(|f| self.sides(f).map(move |(a, b)| ([a, b], f))).collect()
    }

    fn sides(&self, facet: usize) -> impl Iterator<Item = (usize, usize)> + use<> {
        let corners = self.facets[facet].corners.clone();
        (0..corners.len()).map(move |i| (corners[i], corners[(i + 1) % corners.len()]))
    }

    /// The crease pattern, turned and scaled by `to_sheet`.
    pub(super) fn pattern(&self, to_sheet: DAffine2) -> CreasePattern {
        let mut sheet = SheetBuilder::default();
        let vertices: Vec<_> = self
            .points
            .iter()
            .map(|&point| {
                let place = to_sheet.transform_point2(point);
                sheet.at(place.x, place.y)
            })
            .collect();
        for facet in &self.facets {
            let corners: Vec<_> = facet.corners.iter().map(|&v| vertices[v]).collect();
            sheet.face(&corners);
            for (&a, &b) in facet.corners.iter().zip(facet.corners.iter().cycle().skip(1)) {
                if let Some(&angle) = self.folds.get(&key(a, b)) {
                    sheet.crease(vertices[a], vertices[b], angle);
                }
            }
        }
        sheet.finish()
    }
}
