//! Pairs of triangles that lie upon each other.

use std::f64::consts::PI;

use crate::contact::Crossings;
use crate::model::Model;
use glam::{DVec2, DVec3};

use super::overlap::{overlap, width};

/// Nearer than this, in radii, depth does not tell which of two triangles is on top.
pub const NEAR: f64 = 4e-3;
/// Two triangles that go through each other by more than this, in radii, on both sides, are shown as they are.
const CROSSING: f64 = 2.0 * NEAR;
/// Up to here, in radii, layers are counted together: drawing them apart must not push one through the next.
pub const FAR: f64 = 0.08;
/// Cosine of the angle up to which two triangles count as parallel: 8 degrees.
pub const PARALLEL: f64 = 0.99;
/// An overlap that is narrower than this (in radii, area over perimeter) is rounding.
const NARROW: f64 = 2e-3;
/// Heights below this, in radii, are rounding: two layers meet at their crease.
pub const ROUNDING: f64 = 1e-9;
/// Comparisons of bounding boxes, and pairs, after which layers are left to their depths.
const MOST_COMPARISONS: usize = 20_000_000;
const MOST_PAIRS: usize = 20_000;

/// A point where two triangles lie upon each other.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Barycentric, in the first and the second.
    pub weights: [[f64; 3]; 2],
    /// How far the second lies above the first, in radii.
    pub height: f64,
}

/// Parallel triangles that lie upon each other.
pub struct Pairs {
    /// Unit normals of all triangles; zero for a triangle of no area.
    pub normals: Vec<DVec3>,
    /// The direction in which layers are counted: one for all triangles that lie upon each other, directly or not, and for
    /// those beside them.
    pub up: Vec<DVec3>,
    /// The least triangle of all that have this direction together.
    pub stacks: Vec<usize>,
    /// By pair, the smaller first; in order.
    pub triangles: Vec<[u32; 2]>,
    /// By pair: the corners of what they have in common.
    pub contacts: Vec<Vec<Contact>>,
    /// By pair: how far the second lies above the first on average, in radii.
    pub heights: Vec<f64>,
    /// Whether the state has layers of its own: nothing in it goes through anything and no crease is folded past half a turn, so
    /// that heights tell the order wherever they are more than rounding.
    own: bool,
    /// By triangle: the other one and the pair; in order.
    neighbours: Vec<(u32, u32)>,
    starts: Vec<usize>,
}

impl Pairs {
    /// Those up to so far above each other, in radii; `angles` are those of the creases, in radians, or none. `None` where depth
    /// tells everything, or there are too many.
    pub fn find(model: &Model, positions: &[DVec3], angles: &[f64], far: f64) -> Option<Self> {
        let corners = |t: usize| model.mesh.triangles[t].map(|n| positions[n.index()]);
        let count = model.mesh.triangles.len();
        let normal = |t: usize| {
            let [a, b, c] = corners(t);
            (b - a).cross(c - a).normalize_or_zero()
        };
        let normals: Vec<DVec3> = (0..count).map(normal).collect();
        let mut found: Vec<([u32; 2], Vec<Contact>)> = Vec::new();
        let mut any_near = false;
        for [i, j] in candidates(count, corners, far)? {
            if normals[i].dot(normals[j]).abs() < PARALLEL {
                continue;
            }
            let contacts = contacts(normals[i], corners(i), corners(j));
            let least = contacts.iter().map(|c| c.height).fold(f64::INFINITY, f64::min);
            let most = contacts.iter().map(|c| c.height).fold(f64::NEG_INFINITY, f64::max);
            // Paper that goes through paper is shown as it is.
            if contacts.is_empty() || least > far || most < -far || (least < -CROSSING && most > CROSSING) {
                continue;
            }
            any_near |= least < NEAR && most > -NEAR;
            found.push(([i as u32, j as u32], contacts));
            if found.len() > MOST_PAIRS {
                return None;
            }
        }
        if !any_near {
            return None;
        }
        found.sort_unstable_by_key(|(pair, _)| *pair);
        Some(Self::new(model, normals, found, has_layers(model, positions, angles)))
    }

    fn new(model: &Model, normals: Vec<DVec3>, found: Vec<([u32; 2], Vec<Contact>)>, own: bool) -> Self {
        let count = normals.len();
        let mut starts = vec![0; count + 1];
        found.iter().flat_map(|(pair, _)| pair).for_each(|t| starts[*t as usize + 1] += 1);
        for t in 0..count {
            starts[t + 1] += starts[t];
        }
        let mut neighbours: Vec<(u32, u32, u32)> = { found.iter().enumerate() }
            .flat_map(|(pair, ([i, j], _))| [(*i, *j, pair as u32), (*j, *i, pair as u32)])
            .collect();
        neighbours.sort_unstable();
        let neighbours = neighbours.into_iter().map(|(_, other, pair)| (other, pair)).collect();
        let (triangles, contacts) = found.into_iter().unzip();
        let up = vec![DVec3::ZERO; count];
        let stacks = (0..count).collect();
        let mut pairs = Self { up, stacks, normals, triangles, contacts, heights: Vec::new(), own, neighbours, starts };
        pairs.choose_directions(&goes_on(model, &pairs.normals));
        for ([i, _], contacts) in pairs.triangles.iter().zip(&mut pairs.contacts) {
            let turn = pairs.normals[*i as usize].dot(pairs.up[*i as usize]).signum();
            contacts.iter_mut().for_each(|contact| contact.height *= turn);
            let sum: f64 = contacts.iter().map(|contact| contact.height).sum();
            pairs.heights.push(sum / contacts.len() as f64);
        }
        pairs
    }

    /// Whether the second of a pair lies above the first where depth tells.
    pub fn clear(&self, pair: usize) -> Option<bool> {
        let all = |tells: fn(&Contact) -> bool| self.contacts[pair].iter().all(tells);
        if all(|contact| contact.height > NEAR) {
            Some(true)
        } else {
            all(|contact| contact.height < -NEAR).then_some(false)
        }
    }

    /// The same in a state that has layers of its own, where the least height tells.
    pub fn own(&self, pair: usize) -> Option<bool> {
        let above = self.heights[pair] > 0.0;
        let agrees = |contact: &Contact| if above { contact.height > -ROUNDING } else { contact.height < ROUNDING };
        (self.own && self.heights[pair].abs() > ROUNDING && self.contacts[pair].iter().all(agrees)).then_some(above)
    }

    /// Whether the state has layers of its own.
    pub fn has_own(&self) -> bool {
        self.own
    }

    /// Whether the state itself has a pair apart, by more than `least` radii on average.
    #[must_use]
    pub fn is_apart(&self, pair: usize, least: f64) -> bool {
        self.heights[pair].abs() > least && self.own(pair).is_some()
    }

    /// Whether depth says nowhere that a pair lies the other way round: its second above the first or not, as `above` says.
    pub fn agrees(&self, pair: usize, above: bool) -> bool {
        self.contacts[pair].iter().all(|contact| if above { contact.height > -NEAR } else { contact.height < NEAR })
    }

    /// The triangles that lie upon this one, each with their pair.
    pub fn of(&self, triangle: usize) -> &[(u32, u32)] {
        &self.neighbours[self.starts[triangle]..self.starts[triangle + 1]]
    }

    /// The pair of two triangles, and whether `b` is its second.
    pub fn between(&self, a: u32, b: u32) -> Option<(usize, bool)> {
        let others = self.of(a as usize);
        let place = others.binary_search_by_key(&b, |(other, _)| *other).ok()?;
        Some((others[place].1 as usize, a < b))
    }

    /// Spreads the normal of one triangle over all that hang together with it: that lie upon it, or go on beside it.
    fn choose_directions(&mut self, beside: &[[Option<u32>; 3]]) {
        for seed in 0..self.normals.len() {
            if self.up[seed] != DVec3::ZERO || self.of(seed).is_empty() {
                continue;
            }
            let up = self.normals[seed];
            self.up[seed] = up;
            let mut open = vec![seed];
            while let Some(triangle) = open.pop() {
                for k in self.starts[triangle]..self.starts[triangle + 1] {
                    let other = self.neighbours[k].0 as usize;
                    if self.up[other] == DVec3::ZERO {
                        self.up[other] = up;
                        self.stacks[other] = seed;
                        open.push(other);
                    }
                }
                for other in beside[triangle].iter().flatten().map(|t| *t as usize) {
                    let parallel = self.normals[other].dot(up).abs() > PARALLEL;
                    if self.up[other] == DVec3::ZERO && !self.of(other).is_empty() && parallel {
                        self.up[other] = up;
                        self.stacks[other] = seed;
                        open.push(other);
                    }
                }
            }
        }
    }
}

/// Whether paper has gone through nothing on the way to a state, and so has layers of its own: nothing crosses and no crease
/// is past half a turn (two faces with a common crease do not cross there).
fn has_layers(model: &Model, positions: &[DVec3], angles: &[f64]) -> bool {
    angles.len() == model.creases.len()
        && angles.iter().all(|angle| angle.abs() <= PI + ROUNDING)
        && Crossings::of(&model.mesh, positions).is_empty()
}

/// By triangle: those beside it over sides where the sheet goes on flat.
fn goes_on(model: &Model, normals: &[DVec3]) -> Vec<[Option<u32>; 3]> {
    let mut beside = vec![[None; 3]; normals.len()];
    for side in &model.mesh.sides {
        let [Some(one), Some(two)] = side.triangles else { continue };
        if normals[one.index()].dot(normals[two.index()]) > PARALLEL {
            for (here, there) in [(one, two), (two, one)] {
                if let Some(free) = beside[here.index()].iter_mut().find(|place| place.is_none()) {
                    *free = Some(there.0);
                }
            }
        }
    }
    beside
}

/// The corners of what two triangles have in common, with the heights of the second over the first along `normal`; none
/// if that is too narrow to tell.
fn contacts(normal: DVec3, first: [DVec3; 3], second: [DVec3; 3]) -> Vec<Contact> {
    let flat = Flat::new(normal);
    let [a, b] = [first, second].map(|corners| corners.map(|p| flat.of(p)));
    let common = overlap(&a, &b);
    if common.len() < 3 || width(&common) < NARROW.min(0.1 * width(&a).min(width(&b))) {
        return Vec::new();
    }
    let height =
        |corners: [DVec3; 3], weights: [f64; 3]| (0..3).map(|k| weights[k] * corners[k].dot(normal)).sum::<f64>();
    let contact = |p: &DVec2| {
        let weights = [barycentric(&a, *p), barycentric(&b, *p)];
        Contact { weights, height: height(second, weights[1]) - height(first, weights[0]) }
    };
    common.iter().map(contact).collect()
}

fn barycentric(triangle: &[DVec2; 3], p: DVec2) -> [f64; 3] {
    let area = |a: DVec2, b: DVec2| (a - p).perp_dot(b - p);
    let [a, b, c] = *triangle;
    let parts = [area(b, c), area(c, a), area(a, b)];
    let whole: f64 = parts.iter().sum();
    parts.map(|part| (part / whole).clamp(0.0, 1.0))
}

/// A plane through the origin, with coordinates.
pub struct Flat {
    axes: [DVec3; 2],
}

impl Flat {
    pub fn new(normal: DVec3) -> Self {
        let x = normal.any_orthonormal_vector();
        Self { axes: [x, normal.cross(x)] }
    }

    pub fn of(&self, p: DVec3) -> DVec2 {
        DVec2::new(p.dot(self.axes[0]), p.dot(self.axes[1]))
    }
}

/// Pairs whose bounding boxes come near each other; `None` if finding them takes too long.
fn candidates(count: usize, corners: impl Fn(usize) -> [DVec3; 3], far: f64) -> Option<Vec<[usize; 2]>> {
    let boxes: Vec<[DVec3; 2]> = (0..count)
        .map(|t| {
            let [a, b, c] = corners(t);
            [a.min(b).min(c) - far * 0.5, a.max(b).max(c) + far * 0.5]
        })
        .collect();
    // Sweep along the axis over which the sheet is longest.
    let low = boxes.iter().map(|b| b[0]).reduce(DVec3::min)?;
    let size = boxes.iter().map(|b| b[1]).reduce(DVec3::max)? - low;
    let axis = (0..3).max_by(|a, b| size[*a].total_cmp(&size[*b]))?;
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| boxes[*a][0][axis].total_cmp(&boxes[*b][0][axis]).then(a.cmp(b)));
    let (mut pairs, mut compared) = (Vec::new(), 0);
    for (place, i) in order.iter().enumerate() {
        for j in &order[place + 1..] {
            let ([low, high], [low2, high2]) = (boxes[*i], boxes[*j]);
            if low2[axis] > high[axis] {
                break;
            }
            compared += 1;
            if low.cmple(high2).all() && low2.cmple(high).all() {
                pairs.push([*i.min(j), *i.max(j)]);
            }
        }
        if compared > MOST_COMPARISONS {
            return None;
        }
    }
    Some(pairs)
}
