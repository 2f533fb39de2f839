//! How open places of the sheet are: how much of the light from all around reaches them past the rest of the paper
//! (ambient occlusion). Valleys and what lies under a flap grow darker, which is how an eye tells how deep they are.
//!
//! It is a property of the sheet, not of the view: plain data of a [`Figure`](crate::Figure), from which all renderers
//! draw the same.

mod places;
mod sky;

use origami_core::Error;

/// Openness of both sides of each triangle, at the places of a lattice over it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Openness {
    /// By triangle: where its values begin, and into how many parts each of its sides is cut; none: all is open.
    pub lattices: Vec<[u32; 2]>,
    /// By place: the share of the light from all around that reaches the paper's front and its back, 0 to 1. Places of a
    /// triangle cut into n parts: first the n + 1 from its first corner to its third, then the n one step nearer to its
    /// second corner, and so on to that corner itself.
    pub values: Vec<[f32; 2]>,
}

impl Openness {
    /// How open these triangles are; positions in radii.
    ///
    /// Every corner of a triangle has to lead somewhere, and every position to be a finite number.
    #[must_use]
    pub fn of(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Self {
        let Some(sheet) = places::Sheet::new(positions, triangles) else { return Self::default() };
        let (lattices, places) = places::places(&sheet);
        Self { lattices, values: sky::openness(&sheet, &places) }
    }

    /// Whether it says nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lattices.is_empty()
    }

    /// How open a place of a triangle is, on its front (0) or back (1); `along` are its shares of the second and the third
    /// corner.
    #[must_use]
    pub fn at(&self, triangle: usize, along: [f32; 2], side: usize) -> f32 {
        let Some([start, parts]) = self.lattices.get(triangle).copied() else { return 1.0 };
        let value = |i: u32, j: u32| {
            let row = i * (parts + 1) - i * i.saturating_sub(1) / 2;
            self.values.get((start + row + j) as usize).and_then(|sides| sides.get(side)).copied().unwrap_or(1.0)
        };
        let along = along.map(|share| share.clamp(0.0, 1.0));
        // A pixel's middle may lie beside a triangle that covers a part of it.
        let beyond = (along[0] + along[1]).max(1.0);
        let [x, y] = along.map(|share| share / beyond * parts as f32);
        let i = (x as u32).min(parts - 1);
        let j = (y as u32).min(parts - 1 - i);
        let [x, y] = [x - i as f32, y - j as f32];
        if x + y > 1.0 && i + j + 2 <= parts {
            (1.0 - y) * value(i + 1, j) + (1.0 - x) * value(i, j + 1) + (x + y - 1.0) * value(i + 1, j + 1)
        } else {
            let [x, y] = [x, y].map(|share| share / (x + y).max(1.0));
            (1.0 - x - y) * value(i, j) + x * value(i + 1, j) + y * value(i, j + 1)
        }
    }

    /// Whether there is a value wherever a triangle of `count` has a place.
    ///
    /// # Errors
    /// [`Error::Invalid`] naming the first triangle where that is not so.
    pub(crate) fn check(&self, count: usize) -> Result<(), Error> {
        if self.lattices.is_empty() && self.values.is_empty() {
            return Ok(());
        }
        if self.lattices.len() != count {
            return Err(Error::invalid("openness", "has another length", "one lattice for each triangle, or none"));
        }
        let held = |[start, parts]: &[u32; 2]| {
            let places = (u64::from(*parts) + 1) * (u64::from(*parts) + 2) / 2;
            *parts > 0 && *parts < 1 << 15 && u64::from(*start) + places <= self.values.len() as u64
        };
        match self.lattices.iter().position(|lattice| !held(lattice)) {
            Some(i) => Err(Error::invalid(format!("openness of triangle {i}"), "lacks values", "one for each place")),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of 2 x `parts` x `parts` triangles from -1 to 1, at a height over each place.
    fn square(parts: u32, height: impl Fn(f32, f32) -> f32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let all = |count: u32| (0..count).flat_map(move |y| (0..count).map(move |x| (x, y)));
        let place = |(x, y): (u32, u32)| {
            let [x, y] = [x, y].map(|i| 2.0 * i as f32 / parts as f32 - 1.0);
            [x, y, height(x, y)]
        };
        let node = |x: u32, y: u32| y * (parts + 1) + x;
        let faces = |(x, y): (u32, u32)| {
            [[node(x, y), node(x + 1, y), node(x + 1, y + 1)], [node(x, y), node(x + 1, y + 1), node(x, y + 1)]]
        };
        (all(parts + 1).map(place).collect(), all(parts).flat_map(faces).collect())
    }

    #[test]
    fn a_flat_sheet_is_open_everywhere() {
        let (positions, triangles) = square(3, |_, _| 0.0);
        let open = Openness::of(&positions, &triangles);
        assert!(open.values.iter().flatten().all(|v| *v == 1.0));
        open.check(triangles.len()).unwrap();
        assert!(open.check(triangles.len() + 1).is_err());
    }

    /// Of what a place on one wall of a long valley sees, the other wall takes (1 - cos a) / 2, with `a` the angle from the
    /// place's own wall up to the other one's rim: the form factor of a strip (H. Hottel).
    #[test]
    fn a_valley_is_as_open_as_its_other_wall_leaves_it() {
        for degrees in [60.0_f32, 90.0, 120.0] {
            // Two walls of width 1, with this angle between them; the fold is 8 long.
            let half = (0.5 * degrees).to_radians();
            let (sin, cos) = half.sin_cos();
            let wall = |side: f32| [[0.0, -4.0, 0.0], [0.0, 4.0, 0.0], [side * sin, 4.0, cos], [side * sin, -4.0, cos]];
            let positions: Vec<[f32; 3]> =
                [wall(1.0), wall(-1.0)].concat().iter().map(|p| p.map(|x| x / 4.0)).collect();
            // Both fronts look into the valley.
            let triangles = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]];
            let open = Openness::of(&positions, &triangles);
            // The middle of the first wall, in the plane across the fold.
            let place = [0.5 * sin, 0.5 * cos];
            let rim = [-sin - place[0], cos - place[1]];
            let along = [-sin, -cos];
            let angle = ((rim[0] * along[0] + rim[1] * along[1]) / rim[0].hypot(rim[1])).acos();
            let expected = 1.0 - 0.5 * (1.0 - angle.cos());
            let is = open.at(0, [0.5, 0.0], 0);
            assert!((is - expected).abs() < 0.05, "{degrees}: {is}, expected {expected}");
            assert!(open.at(0, [0.5, 0.0], 1) > 0.97, "{degrees}: outside all is open");
        }
    }

    #[test]
    fn threads_do_not_change_it() {
        let (positions, triangles) = square(12, |x, y| 0.2 * (9.0 * x).sin() * (7.0 * y).cos());
        let made = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| Openness::of(&positions, &triangles))
        };
        let first = made(1);
        assert!(first.values.iter().flatten().any(|v| *v < 0.9));
        assert_eq!(made(3), first);
    }

    #[test]
    fn between_places_it_runs_straight() {
        let parts = 5;
        let mut values = Vec::new();
        for i in 0..=parts {
            values.extend((0..=parts - i).map(|j| [0.1 + 0.02 * i as f32 + 0.05 * j as f32, 1.0]));
        }
        let open = Openness { lattices: vec![[0, parts]], values };
        open.check(1).unwrap();
        for [v, w] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.33, 0.21], [0.5, 0.5], [0.19, 0.19], [0.71, 0.05]] {
            let expected = 0.1 + 0.02 * 5.0 * v + 0.05 * 5.0 * w;
            assert!((open.at(0, [v, w], 0) - expected).abs() < 1e-6, "{v} {w}");
        }
        assert_eq!(open.at(0, [2.0, 2.0], 0), open.at(0, [0.5, 0.5], 0), "what lies beside it counts as its rim");
        assert_eq!(open.at(7, [0.0, 0.0], 0), 1.0);
    }

    #[test]
    fn nothing_and_points_are_open() {
        assert!(Openness::of(&[], &[]).is_empty());
        let open = Openness::of(&[[0.0; 3]; 3], &[[0, 1, 2]]);
        open.check(1).unwrap();
        assert!(open.values.iter().flatten().all(|v| (0.0..=1.0).contains(v)));
    }
}
