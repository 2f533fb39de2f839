//! Where openness is looked for: lattices over triangles, close enough together for a shadow's rim.

use glam::Vec3;

/// Places shall lie no farther apart than this, in radii of the sheet's box.
const STEP: f32 = 0.035;
/// Into how many parts a side is cut at most.
const MOST_PARTS: f32 = 48.0;
/// Places in all above which they lie farther apart, but for the corners.
const MOST: f32 = 400_000.0;
/// How far inside its triangle's border a place is looked at, in steps of the sky's maps.
const INSIDE: f32 = 1.0;

/// Triangles and the ball around them.
pub(super) struct Sheet {
    pub(super) triangles: Vec<[Vec3; 3]>,
    pub(super) centre: Vec3,
    pub(super) radius: f32,
}

impl Sheet {
    /// `None` for no triangles.
    pub(super) fn new(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Option<Self> {
        let corner = |n: u32| positions.get(n as usize).map(|p| Vec3::from_array(*p));
        let triangles: Option<Vec<[Vec3; 3]>> =
            triangles.iter().map(|[a, b, c]| Some([corner(*a)?, corner(*b)?, corner(*c)?])).collect();
        let triangles = triangles?;
        let all = || triangles.iter().flatten().copied();
        let (low, high) = (all().reduce(Vec3::min)?, all().reduce(Vec3::max)?);
        let centre = 0.5 * (low + high);
        let radius = all().map(|p| p.distance(centre)).fold(1e-9, f32::max);
        Some(Self { triangles, centre, radius })
    }

    /// The length that a step of the sky's maps covers.
    pub(super) fn texel(&self) -> f32 {
        2.0 * self.radius / (super::sky::SIZE - 2) as f32
    }
}

/// A place on a triangle.
pub(super) struct Place {
    pub(super) at: Vec3,
    /// The unit normal of the front; zero for a triangle of no area.
    pub(super) normal: Vec3,
}

/// The lattices of all triangles, and all their places.
pub(super) fn places(sheet: &Sheet) -> (Vec<[u32; 2]>, Vec<Place>) {
    let longest = |[a, b, c]: &[Vec3; 3]| a.distance(*b).max(b.distance(*c)).max(c.distance(*a));
    let parts = |t: &[Vec3; 3], step: f32| (longest(t) / (step * sheet.radius)).ceil().clamp(1.0, MOST_PARTS);
    let total = |step: f32| -> f32 {
        sheet.triangles.iter().map(|t| parts(t, step)).map(|n| 0.5 * (n + 1.0) * (n + 2.0)).sum()
    };
    let mut step = STEP;
    while total(step) > MOST.max(3.0 * sheet.triangles.len() as f32) {
        step *= 1.5;
    }
    let (mut lattices, mut places) = (Vec::with_capacity(sheet.triangles.len()), Vec::new());
    for triangle in &sheet.triangles {
        let [a, b, c] = *triangle;
        let parts = parts(triangle, step) as u32;
        lattices.push([places.len() as u32, parts]);
        let across = (b - a).cross(c - a);
        let normal = across.normalize_or_zero();
        let perimeter = a.distance(b) + b.distance(c) + c.distance(a);
        // The radius of the circle in it is its doubled area over its perimeter.
        let inner = across.length() / perimeter.max(1e-12);
        let middle = (a + b + c) / 3.0;
        let inwards = (INSIDE * sheet.texel() / inner.max(1e-12)).min(0.6);
        for i in 0..=parts {
            for j in 0..=parts - i {
                let [v, w] = [i, j].map(|k| k as f32 / parts as f32);
                let at = a + (b - a) * v + (c - a) * w;
                places.push(Place { at: at.lerp(middle, inwards), normal });
            }
        }
    }
    (lattices, places)
}
