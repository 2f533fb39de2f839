//! Triangles, ready to be drawn.

use origami_core::glam::DVec3;

use super::{Bounds, Corner, Plane};
use crate::camera::View;
use crate::figure::Figure;
use crate::layers::Layer;
use crate::map::Values;
use crate::openness::Openness;
use crate::picture::Picture;
use crate::shade::{brightness, lit};

/// A triangle in the picture.
#[derive(Clone, Debug)]
pub(super) struct Facet {
    pub(super) bounds: Bounds,
    /// Inside where all three are above 0, or 0 where the edge owns its points; gradient of each edge function.
    pub(super) edges: [Edge; 3],
    /// Clip depth, layers included.
    pub(super) depth: Plane,
    /// Clip depth without layers.
    pub(super) bare: Plane,
    /// Its corners' depths: rounding shall not lead beyond them.
    pub(super) range: [f64; 2],
    /// The paper's colour or its value's, in linear light, before any shading.
    pub(super) colour: [f32; 3],
    /// Where colours follow values at the corners.
    pub(super) shares: Option<Shares>,
    /// Light that reaches it with nothing before it.
    pub(super) lit: f32,
    /// Which side is seen: front (0) or back (1).
    pub(super) side: usize,
    /// Shares of the second and the third corner, where light differs from place to place.
    pub(super) along: Option<[Shares; 2]>,
}

/// Shares of the colour map over a triangle: over w, so that perspective does not bend them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shares {
    over_w: Plane,
    inverse_w: Plane,
}

impl Shares {
    /// The share at a point of the picture, 0 to 1.
    pub(super) fn of(&self, x: f64, y: f64) -> f64 {
        (self.over_w.of(x, y) / self.inverse_w.of(x, y)).clamp(0.0, 1.0)
    }
}

/// `plane` is positive inside; points exactly on the edge belong to it if `owns`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) plane: Plane,
    pub(super) owns: bool,
}

impl Edge {
    #[inline(always)]
    pub(super) fn holds(&self, x: f64, y: f64) -> bool {
        let value = self.plane.of(x, y);
        value > 0.0 || (value == 0.0 && self.owns)
    }

    fn new(a: Corner, b: Corner) -> Self {
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let plane = Plane { at: a.x * dy - a.y * dx, dx: -dy, dy: dx };
        // Of two triangles at an edge exactly one owns it: they run along it in opposite directions.
        Self { plane, owns: dy < 0.0 || (dy == 0.0 && dx > 0.0) }
    }
}

/// How much of the paper's shading is left under a map: enough to see the folds, too little to change what colours say.
const UNDER_MAP: f32 = 0.35;

/// How much of its shading a figure has.
#[must_use]
pub fn strength(picture: &Picture, figure: &Figure) -> f32 {
    picture.theme.shading * if figure.map.is_some() { UNDER_MAP } else { 1.0 }
}

/// What the colours of all triangles have in common.
pub(super) struct Paint<'a> {
    openness: &'a Openness,
    strength: f32,
    /// The colour map as linear light.
    table: Vec<[f32; 3]>,
}

impl<'a> Paint<'a> {
    pub(super) fn new(picture: &Picture, figure: &'a Figure) -> Self {
        let table = figure.map.as_ref().map_or_else(Vec::new, |map| map.scale.colours.table());
        Self { openness: &figure.openness, strength: strength(picture, figure), table }
    }

    /// The colour of a triangle at a point of the picture, in linear light.
    pub(super) fn at(&self, name: u32, facet: &Facet, x: f64, y: f64) -> [f32; 3] {
        let paper = match &facet.shares {
            Some(shares) => {
                let place = shares.of(x, y) * self.table.len().saturating_sub(1) as f64;
                self.table.get((place + 0.5) as usize).copied().unwrap_or_default()
            }
            None => facet.colour,
        };
        let along = facet.along.map(|shares| shares.map(|share| share.of(x, y) as f32));
        let open = along.map_or(1.0, |along| self.openness.at(name as usize, along, facet.side));
        let light = brightness(facet.lit, open, self.strength);
        paper.map(|c| c * light)
    }
}

/// All triangles; `None` for those that are seen edge-on or lie behind the viewer.
pub(super) fn facets(
    picture: &Picture,
    figure: &Figure,
    view: &View,
    corners: &[Option<Corner>],
) -> Vec<Option<Facet>> {
    let sides = [picture.theme.front, picture.theme.back].map(|c| c.linear());
    let facet = |(i, nodes): (usize, &[u32; 3])| {
        let [a, b, c] = nodes.map(|n| corners.get(n as usize).copied().flatten());
        let seen = [a?, b?, c?];
        let [p, q, r] = nodes.map(|n| DVec3::from_array(figure.positions[n as usize].map(f64::from)));
        let area =
            (seen[1].x - seen[0].x) * (seen[2].y - seen[0].y) - (seen[1].y - seen[0].y) * (seen[2].x - seen[0].x);
        // With y down, what is counterclockwise on the paper has a negative area.
        let front = area < 0.0;
        let normal = (q - p).cross(r - p).normalize_or_zero() * if front { 1.0 } else { -1.0 };
        let lift = figure.layers.get(i).map_or([0.0; 3], |layer| lift(layer, view));
        let bare = plane(&seen, area, seen.map(|p| p.z));
        let seen = [0, 1, 2].map(|k| Corner { z: seen[k].z - lift[k], ..seen[k] });
        let side = usize::from(!front);
        let mut facet = Facet::new(seen, area, bare, sides[side])?;
        (facet.side, facet.lit) = (side, lit(normal.to_array().map(|x| x as f32), view.light, view.up));
        let shares = |shares: [f64; 3]| Shares {
            over_w: plane(&seen, area, [0, 1, 2].map(|k| shares[k] * seen[k].inverse_w)),
            inverse_w: plane(&seen, area, seen.map(|p| p.inverse_w)),
        };
        facet.along = (!figure.openness.is_empty()).then(|| [shares([0.0, 1.0, 0.0]), shares([0.0, 0.0, 1.0])]);
        match figure.map.as_ref().map(|map| (&map.values, &map.scale)) {
            Some((Values::Triangles(values), scale)) => {
                facet.colour = scale.colours.colour(f64::from(scale.share(values[i]))).linear();
            }
            Some((Values::Nodes(values), scale)) => {
                facet.shares = Some(shares(nodes.map(|n| f64::from(scale.share(values[n as usize])))));
            }
            None => {}
        }
        Some(facet)
    };
    figure.triangles.iter().enumerate().map(facet).collect()
}

/// The plane that has these values at the corners of a triangle with this doubled area.
fn plane([a, b, c]: &[Corner; 3], area: f64, values: [f64; 3]) -> Plane {
    let (to_b, to_c) = (values[1] - values[0], values[2] - values[0]);
    let dx = (to_b * (c.y - a.y) - to_c * (b.y - a.y)) / area;
    let dy = (to_c * (b.x - a.x) - to_b * (c.x - a.x)) / area;
    Plane { at: values[0] - dx * a.x - dy * a.y, dx, dy }
}

/// Cosine between a layer's normal and the line of sight below which layers are drawn no farther apart.
const GRAZING: f32 = 0.1;

/// How much nearer each corner of a triangle is drawn, in clip depth.
#[must_use]
pub fn lift(layer: &Layer, view: &View) -> [f64; 3] {
    let dot: f32 = layer.up.iter().zip(view.towards).map(|(a, b)| a * b).sum();
    // Along the line of sight two parallel planes are farther apart than along their normal. Of layers seen from the side
    // nothing shows but edges.
    let turn = if dot.abs() < 1e-3 { 0.0 } else { dot.signum() / dot.abs().max(GRAZING) };
    layer.heights.map(|height| f64::from(height * turn) * view.depth_of_radius())
}

impl Facet {
    fn new(seen: [Corner; 3], area: f64, bare: Plane, colour: [f32; 3]) -> Option<Self> {
        if area == 0.0 {
            return None;
        }
        let [a, b, c] = if area > 0.0 { seen } else { [seen[0], seen[2], seen[1]] };
        let depth = plane(&seen, area, seen.map(|p| p.z));
        let all = [a, b, c];
        let least = |of: fn(&Corner) -> f64| all.iter().map(of).fold(f64::INFINITY, f64::min);
        let most = |of: fn(&Corner) -> f64| all.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        Some(Self {
            bounds: [least(|p| p.x), least(|p| p.y), most(|p| p.x), most(|p| p.y)],
            edges: [Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)],
            depth,
            bare,
            range: [least(|p| p.z), most(|p| p.z)],
            colour,
            shares: None,
            lit: 1.0,
            side: 0,
            along: None,
        })
    }
}
