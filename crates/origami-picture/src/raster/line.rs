//! Lines, ready to be drawn: round at their ends, so that joints are round too.
//!
//! A line lies on paper, and would be half swallowed by it where the paper slopes. So each of its points takes the depth
//! of its own faces there, [`BIAS`] nearer: just enough to win against them, and too little to win against a layer
//! in front.

use super::circles::Circles;
use super::{BIAS, Bounds, Corner, Facet, Plane};
use crate::camera::View;
use crate::figure::{Figure, LineKind};
use crate::picture::Picture;
use crate::theme::{Dash, LineStyle};

/// A steep face brings its line no nearer than this, in half widths of the line.
pub const STEEP: f64 = 6.0;
/// A face that falls away by more than this, in depth over distance, is seen edge-on and says nothing about its line.
pub const EDGE_ON: f64 = 100.0;

/// A line in the picture.
#[derive(Clone, Debug)]
pub(super) struct Stroke {
    pub(super) bounds: Bounds,
    pub(super) from: [f64; 2],
    pub(super) along: [f64; 2],
    /// One over the square of its length in pixels; 0 for a point.
    inverse_length: f64,
    /// Half its width in pixels.
    pub(super) half: f64,
    /// Depths at its ends.
    depths: [f64; 2],
    /// Depths at its ends without layers.
    bare: [f64; 2],
    /// Depths of the faces beside it.
    faces: [Option<Plane>; 2],
    /// The faces beside it, the one on top first.
    pub(super) triangles: [Option<u32>; 2],
    bias: f64,
    steep: f64,
    dashes: Option<Dashes>,
    /// Linear light.
    pub(super) colour: [f32; 3],
}

/// Lengths in radii on the flat sheet.
#[derive(Clone, Copy, Debug)]
struct Dashes {
    along: [f64; 2],
    on: f64,
    off: f64,
    dot: f64,
}

impl Dashes {
    fn new(dash: &Dash, along: [f32; 2], pixel: f64) -> Option<Self> {
        let [on, off, dot] = [dash.on, dash.off, dash.dot].map(|x| f64::from(x) * pixel);
        let sensible = on > 0.0 && off > 0.0 && dot >= 0.0 && (on + off).is_finite();
        sensible.then_some(Self { along: along.map(f64::from), on, off, dot: dot.min(off) })
    }

    fn drawn(&self, share: f64) -> bool {
        let place = self.along[0] + (self.along[1] - self.along[0]) * share;
        // A chain begins in the middle of a dash.
        let place = (place + 0.5 * self.on).rem_euclid(self.on + self.off);
        place <= self.on || (place - self.on - 0.5 * self.off).abs() < 0.5 * self.dot
    }
}

impl Stroke {
    /// The depth at a point of the picture, and that without layers, if the line covers it.
    #[inline(always)]
    pub(super) fn cover(&self, x: f64, y: f64) -> Option<[f64; 2]> {
        let (dx, dy) = (x - self.from[0], y - self.from[1]);
        let share = ((dx * self.along[0] + dy * self.along[1]) * self.inverse_length).clamp(0.0, 1.0);
        let (ox, oy) = (dx - share * self.along[0], dy - share * self.along[1]);
        if ox * ox + oy * oy > self.half * self.half || self.dashes.is_some_and(|dashes| !dashes.drawn(share)) {
            return None;
        }
        let own = self.depths[0] + (self.depths[1] - self.depths[0]) * share;
        let nearest = self.faces.iter().flatten().map(|plane| plane.of(x, y)).reduce(f64::min).unwrap_or(own);
        let bare = self.bare[0] + (self.bare[1] - self.bare[0]) * share;
        Some([nearest.max(own - self.steep) - self.bias, bare])
    }
}

/// Lines in this order are drawn one over the other.
pub const ORDER: [LineKind; LineKind::ALL.len()] =
    [LineKind::Facet, LineKind::Undriven, LineKind::Valley, LineKind::Mountain, LineKind::Boundary, LineKind::Cut];

/// By how much lines of a kind lie before the paper, in radii: those of two kinds do not fight.
#[must_use]
pub fn bias(kind: LineKind) -> f64 {
    let rank = ORDER.iter().position(|k| *k == kind).unwrap_or(0);
    BIAS * (1.0 + 0.05 * rank as f64)
}

/// The theme's style: with dashes if the picture has them, and over a map all creases alike.
#[must_use]
pub fn style(picture: &Picture, figure: &Figure, kind: LineKind) -> LineStyle {
    let style = *picture.theme.line(kind);
    let style = LineStyle { dash: style.dash.filter(|_| picture.dashed), ..style };
    if figure.map.is_none() || matches!(kind, LineKind::Boundary | LineKind::Cut) {
        return style;
    }
    LineStyle { colour: picture.theme.over_map, width: 0.6 * style.width, dash: None }
}

/// All lines that the picture shows, those first that others may cover.
pub(super) fn strokes(
    picture: &Picture,
    figure: &Figure,
    view: &View,
    corners: &[Option<Corner>],
    facets: &[Option<Facet>],
    circles: &Circles,
) -> Vec<Stroke> {
    let (scale, pixel, depth) = (picture.line_scale(), f64::from(view.pixel), f64::from(view.depth));
    let mut strokes = Vec::new();
    for kind in ORDER {
        let style = style(picture, figure, kind);
        let half = 0.5 * f64::from(style.width * scale);
        if !(picture.edges.has(kind) && half > 0.0 && half < 1e4) {
            continue;
        }
        for line in figure.lines.iter().filter(|line| line.kind == kind) {
            let [Some(a), Some(b)] = line.nodes.map(|n| corners.get(n as usize).copied().flatten()) else { continue };
            let faces = line.triangles.map(|t| facets.get(t? as usize)?.as_ref().map(|f| f.depth));
            let faces = faces.map(|face| face.filter(|plane| plane.dx.hypot(plane.dy) < EDGE_ON * depth));
            // The nearest of its faces at each end: layers are a part of their depths, not of the nodes'.
            let at_end = |p: Corner| faces.iter().flatten().map(|f| f.of(p.x, p.y)).fold(p.z, f64::min);
            let at_end = |p: Corner| at_end(p).max(p.z - view.depth_of_radius());
            let along = [b.x - a.x, b.y - a.y];
            let squared = along[0] * along[0] + along[1] * along[1];
            strokes.push(Stroke {
                bounds: [a.x.min(b.x) - half, a.y.min(b.y) - half, a.x.max(b.x) + half, a.y.max(b.y) + half],
                from: [a.x, a.y],
                along,
                inverse_length: if squared > 0.0 { 1.0 / squared } else { 0.0 },
                half,
                depths: [at_end(a), at_end(b)],
                bare: [a.z, b.z],
                faces,
                triangles: circles.top_first(line.triangles),
                bias: bias(kind) * view.depth_of_radius(),
                steep: STEEP * half * depth,
                dashes: style.dash.and_then(|dash| Dashes::new(&dash, line.along, pixel * f64::from(scale))),
                colour: style.colour.linear(),
            });
        }
    }
    strokes
}
