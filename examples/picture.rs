//! Folds a crease pattern and draws the sheet as SVG, seen from far away:
//!
//! `cargo run --release --example picture -- INPUT.fold PERCENT OUT.svg [AZIMUTH ELEVATION]`
//!
//! The two angles say where the viewer stands, in degrees: azimuth from x towards y, elevation above the plane z = 0.
//! Triangles are drawn from back to front; for each two that overlap in the picture, the depth where they do decides.
//! Where the sheet goes through itself no order is right.

use std::error::Error;
use std::fmt::Write;

use origami::export::write_whole;
use origami::glam::{DVec2, DVec3};
use origami::pattern::Assignment;
use origami::{CreasePattern, Material, Model, Relax};

const FRONT: DVec3 = DVec3::new(246.0, 196.0, 92.0);
const BACK: DVec3 = DVec3::new(243.0, 240.0, 232.0);
/// Width and height of the picture, and its margin.
const SIZE: f64 = 480.0;
const MARGIN: f64 = 12.0;

type Corners = [DVec3; 3];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, percent, output, angles @ ..] = arguments.as_slice() else {
        return Err("expected INPUT.fold PERCENT OUT.svg [AZIMUTH ELEVATION]".into());
    };
    let angle = |i: usize, default: f64| angles.get(i).map_or(Ok(default), |text| text.parse()).map(f64::to_radians);
    let (azimuth, elevation) = (angle(0, -60.0)?, angle(1, 35.0)?);

    let pattern = CreasePattern::read(input)?;
    let model = Model::new(&pattern, &Material::default())?;
    let folded = Relax::default().fold_from_rest(&model, percent.parse()?)?;
    let svg = draw(&pattern, &model, &seen(&folded.state.positions, azimuth, elevation))?;
    Ok(write_whole(output, |file| {
        file.write_all(svg.as_bytes()).map_err(|source| origami::Error::Io { path: "-".into(), source })
    })?)
}

/// Points as the viewer sees them, in the units of the picture: x to the right, y down, z towards the viewer.
fn seen(points: &[DVec3], azimuth: f64, elevation: f64) -> Vec<DVec3> {
    let towards = DVec3::new(azimuth.cos() * elevation.cos(), azimuth.sin() * elevation.cos(), elevation.sin());
    let right = DVec3::new(-azimuth.sin(), azimuth.cos(), 0.0);
    let down = right.cross(towards);
    let seen = || points.iter().map(|p| DVec3::new(p.dot(right), p.dot(down), p.dot(towards)));
    let (low, high) = (seen().fold(DVec3::INFINITY, DVec3::min), seen().fold(DVec3::NEG_INFINITY, DVec3::max));
    let scale = (SIZE - 2.0 * MARGIN) / (high - low).truncate().max_element();
    seen().map(|p| (p - 0.5 * (low + high)) * scale).collect()
}

fn draw(pattern: &CreasePattern, model: &Model, points: &[DVec3]) -> Result<String, std::fmt::Error> {
    let triangles: Vec<Corners> = model.mesh.triangles.iter().map(|t| t.map(|node| points[node.index()])).collect();
    // What each triangle draws over itself; one that is drawn later and lies before it covers that.
    let mut lines = vec![String::new(); triangles.len()];
    for side in &model.mesh.sides {
        let colour = match side.edge.map(|edge| pattern.edges[edge.index()].assignment) {
            Some(Assignment::Mountain) => "#c62828",
            Some(Assignment::Valley) => "#1556b0",
            Some(Assignment::Boundary) => "#222",
            _ => continue,
        };
        let [a, b] = side.nodes.map(|node| points[node.index()]);
        for triangle in side.triangles.into_iter().flatten() {
            let line = &mut lines[triangle.index()];
            writeln!(line, r#"<path d="M{:.1} {:.1}L{:.1} {:.1}" stroke="{colour}"/>"#, a.x, a.y, b.x, b.y)?;
        }
    }

    let (height, width) = { points.iter() }.fold((0.0_f64, 0.0_f64), |(h, w), p| (h.max(p.y.abs()), w.max(p.x.abs())));
    let (width, height) = ((2.0 * (width + MARGIN)).ceil(), (2.0 * (height + MARGIN)).ceil());
    let (left, top) = (-0.5 * width, -0.5 * height);
    let mut svg = String::new();
    writeln!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="{left} {top} {width} {height}">"#
    )?;
    writeln!(svg, r##"<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="#fff"/>"##)?;
    writeln!(svg, r#"<g stroke-width="1.1" stroke-linecap="round" stroke-linejoin="round">"#)?;
    for t in back_to_front(&triangles) {
        let ([a, b, c], colour) = (triangles[t], colour(&triangles[t]));
        let path = format!("M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}Z", a.x, a.y, b.x, b.y, c.x, c.y);
        // A thin line of its own colour closes the seam to its neighbours.
        writeln!(svg, r#"<path d="{path}" fill="{colour}" stroke="{colour}" stroke-width="0.6"/>"#)?;
        svg += &lines[t];
    }
    writeln!(svg, "</g>\n</svg>")?;
    Ok(svg)
}

/// Lambert's shading with a light over the viewer's left shoulder.
fn colour([a, b, c]: &Corners) -> String {
    let normal = (*b - *a).cross(*c - *a).normalize_or_zero();
    // With y down, what is counterclockwise on the sheet is clockwise in the picture.
    let (paper, normal) = if normal.z < 0.0 { (FRONT, -normal) } else { (BACK, normal) };
    let light = DVec3::new(-0.45, -0.55, 0.7).normalize();
    let [r, g, b] = (paper * (0.6 + 0.4 * normal.dot(light).max(0.0))).to_array();
    format!("#{:02x}{:02x}{:02x}", r as u8, g as u8, b as u8)
}

/// An order in which no triangle is drawn before one that it hides; cycles are broken at the farthest.
fn back_to_front(triangles: &[Corners]) -> Vec<usize> {
    let count = triangles.len();
    let depth = |t: usize| triangles[t].iter().map(|p| p.z).sum::<f64>();
    let mut hides: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut waits_for = vec![0_usize; count];
    for i in 0..count {
        for j in 0..i {
            let (back, front) = match nearer(&triangles[i], &triangles[j]) {
                Some(true) => (j, i),
                Some(false) => (i, j),
                None => continue,
            };
            hides[back].push(front);
            waits_for[front] += 1;
        }
    }
    let mut left: Vec<usize> = (0..count).collect();
    let mut order = Vec::with_capacity(count);
    while let Some(place) = (0..left.len())
        .min_by(|a, b| waits_for[left[*a]].cmp(&waits_for[left[*b]]).then(depth(left[*a]).total_cmp(&depth(left[*b]))))
    {
        let next = left.swap_remove(place);
        hides[next].iter().for_each(|front| waits_for[*front] = waits_for[*front].saturating_sub(1));
        order.push(next);
    }
    order
}

/// Whether `a` lies before `b` where the two overlap; `None` where they do not, or lie in one another.
fn nearer(a: &Corners, b: &Corners) -> Option<bool> {
    let overlap = overlap(&a.map(DVec3::truncate), &b.map(DVec3::truncate));
    let differences = overlap.iter().filter_map(|p| Some(depth_at(a, *p)? - depth_at(b, *p)?));
    let largest = differences.max_by(|x, y| x.abs().total_cmp(&y.abs()))?;
    (largest.abs() > 1e-3).then_some(largest > 0.0)
}

/// The depth of the plane of a triangle at a point of the picture; `None` if it is seen edge-on.
fn depth_at([a, b, c]: &Corners, point: DVec2) -> Option<f64> {
    let normal = (*b - *a).cross(*c - *a);
    let offset = point - a.truncate();
    (normal.z.abs() > 1e-6 * normal.length()).then(|| a.z - normal.truncate().dot(offset) / normal.z)
}

/// What two triangles have in common (Sutherland and Hodgman, Commun. ACM 17, 1974); empty if that has no area.
fn overlap(a: &[DVec2; 3], b: &[DVec2; 3]) -> Vec<DVec2> {
    let area =
        |p: &[DVec2]| (1..p.len().saturating_sub(1)).map(|i| (p[i] - p[0]).perp_dot(p[i + 1] - p[0])).sum::<f64>();
    let turn = area(b).signum();
    let mut clipped = a.to_vec();
    for i in 0..3 {
        let (start, along) = (b[i], b[(i + 1) % 3] - b[i]);
        let inside = |p: DVec2| turn * along.perp_dot(p - start);
        let before = std::mem::take(&mut clipped);
        for (k, p) in before.iter().enumerate() {
            let q = before[(k + 1) % before.len()];
            let (at_p, at_q) = (inside(*p), inside(q));
            if at_p >= 0.0 {
                clipped.push(*p);
            }
            if (at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0) {
                clipped.push(*p + (q - *p) * (at_p / (at_p - at_q)));
            }
        }
    }
    if area(&clipped).abs() > 0.5 { clipped } else { Vec::new() }
}
