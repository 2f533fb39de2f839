//! The sky: directions all around, and from each a map of how near the sheet comes to it.

use std::f32::consts::PI;

use glam::Vec3;
use rayon::prelude::*;

use super::places::{Place, Sheet};

/// Steps of a map along its sides.
pub(super) const SIZE: usize = 256;
/// Directions for sheets of few triangles and of many.
const DIRECTIONS: [usize; 2] = [256, 64];
/// How many triangles are many.
const MANY: usize = 20_000;
/// Maps that are kept at once.
const BATCH: usize = 32;
/// Paper nearer than this, in radii, casts no shadow: layers that lie upon each other.
const NEAR: f32 = 8e-3;
/// How far over its place the sky is looked at, in steps of a map: what a slope rises within a step hides nothing.
const OVER: f32 = 1.2;

/// How open the front and the back of each place are.
pub(super) fn openness(sheet: &Sheet, places: &[Place]) -> Vec<[f32; 2]> {
    let directions = directions(DIRECTIONS[usize::from(sheet.triangles.len() > MANY)]);
    // By place: light that comes and light that there is, on both sides.
    let mut light = vec![[[0.0_f32; 2]; 2]; places.len()];
    for batch in directions.chunks(BATCH) {
        let maps: Vec<Map> = batch.par_iter().map(|towards| Map::new(sheet, *towards)).collect();
        light.par_iter_mut().zip(places).for_each(|(light, place)| {
            for map in &maps {
                let cosine = place.normal.dot(map.axes[2]);
                let (side, weight) = (usize::from(cosine < 0.0), cosine.abs());
                let over = place.normal * (OVER * sheet.texel() * if cosine < 0.0 { -1.0 } else { 1.0 });
                light[side][1] += weight;
                if map.sees(place.at + over - sheet.centre) {
                    light[side][0] += weight;
                }
            }
        });
    }
    light.iter().map(|sides| sides.map(|[comes, all]| if all > 0.0 { comes / all } else { 1.0 })).collect()
}

/// Unit vectors evenly all around: a spiral on the sphere, turned by the golden angle from one to the next.
fn directions(count: usize) -> Vec<Vec3> {
    let golden = PI * (3.0 - 5.0_f32.sqrt());
    let direction = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f32 / count as f32;
        let (sin, cos) = (i as f32 * golden).sin_cos();
        let flat = (1.0 - z * z).sqrt();
        Vec3::new(flat * cos, flat * sin, z)
    };
    (0..count).map(direction).collect()
}

/// How near the sheet comes to a far point in one direction.
struct Map {
    /// Across, up and towards that point.
    axes: [Vec3; 3],
    /// Steps of the map in a unit of length.
    scale: f32,
    near: f32,
    /// By step, row by row: the height of the nearest paper over the sheet's middle.
    heights: Vec<f32>,
}

impl Map {
    fn new(sheet: &Sheet, towards: Vec3) -> Self {
        let across = towards.any_orthonormal_vector();
        let axes = [across, towards.cross(across), towards];
        let heights = vec![f32::NEG_INFINITY; SIZE * SIZE];
        let mut map = Self { axes, scale: 1.0 / sheet.texel(), near: NEAR * sheet.radius, heights };
        for triangle in &sheet.triangles {
            map.draw(triangle.map(|p| map.seen(p - sheet.centre)));
        }
        map
    }

    /// Steps across and up, and the height.
    fn seen(&self, p: Vec3) -> [f32; 3] {
        let place = |axis: usize| p.dot(self.axes[axis]) * self.scale + 0.5 * SIZE as f32;
        [place(0), place(1), p.dot(self.axes[2])]
    }

    fn draw(&mut self, [a, b, c]: [[f32; 3]; 3]) {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area == 0.0 {
            return;
        }
        let steps = |axis: usize| {
            let (low, high) = (a[axis].min(b[axis]).min(c[axis]), a[axis].max(b[axis]).max(c[axis]));
            let step = |x: f32| x.clamp(0.0, SIZE as f32) as usize;
            step((low - 0.5).ceil())..step((high + 0.5).floor())
        };
        // Shares of the second and the third corner, and how they change along a row.
        let [second, third] = [[c, a], [a, b]].map(|[p, q]| [(p[1] - q[1]) / area, (q[0] - p[0]) / area, p[0], p[1]]);
        let share = |[dx, dy, x0, y0]: [f32; 4], x: f32, y: f32| dx * (x - x0) + dy * (y - y0);
        for row in steps(1) {
            let y = row as f32 + 0.5;
            for column in steps(0) {
                let x = column as f32 + 0.5;
                let (v, w) = (share(second, x, y), share(third, x, y));
                if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
                    let height = a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2]);
                    let place = &mut self.heights[row * SIZE + column];
                    *place = place.max(height);
                }
            }
        }
    }

    /// Whether nothing lies between a place, from the sheet's middle, and the far point.
    fn sees(&self, p: Vec3) -> bool {
        let [x, y, height] = self.seen(p);
        let step = |x: f32| (x as usize).min(SIZE - 1);
        self.heights[step(y) * SIZE + step(x)] <= height + self.near
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_even() {
        for count in DIRECTIONS {
            let all = directions(count);
            assert!(all.iter().all(|d| (d.length() - 1.0).abs() < 1e-5));
            let sum: Vec3 = all.iter().sum();
            assert!(sum.length() / (count as f32) < 0.02, "{sum}");
            // The mean of the square of each coordinate over a sphere is 1/3.
            let squares = all.iter().fold(Vec3::ZERO, |sum, d| sum + *d * *d) / count as f32;
            assert!((squares - 1.0 / 3.0).abs().max_element() < 0.01, "{squares}");
        }
    }
}
