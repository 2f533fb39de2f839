//! The distance between a point and a triangle, and between two edges, with the points that are nearest to each other.

use glam::DVec3;

/// Edges whose directions enclose an angle of less sine squared than this are nearly parallel: where their lines are nearest
/// is not known well then, and their ends are looked at too.
pub const PARALLEL: f64 = 1e-8;

/// The two nearest points of two things.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nearest {
    /// Weights of the four points: their sum with these is the vector from the nearest point of the second thing to that of the
    /// first. Those of the first thing add up to 1, those of the second to -1.
    pub(super) weights: [f64; 4],
    /// That vector.
    pub(super) apart: DVec3,
}

impl Nearest {
    fn new(points: &[DVec3; 4], weights: [f64; 4]) -> Self {
        let apart = points.iter().zip(weights).map(|(p, w)| *p * w).sum();
        Self { weights, apart }
    }
}

/// Of a point, the first of `points`, and the triangle of the other three (after Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.5).
pub(super) fn of_point_and_triangle(points: &[DVec3; 4]) -> Nearest {
    let [p, a, b, c] = *points;
    let (ab, ac) = (b - a, c - a);
    let corners = |u: f64, v: f64, w: f64| Nearest::new(points, [1.0, -u, -v, -w]);
    let ap = p - a;
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return corners(1.0, 0.0, 0.0);
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return corners(0.0, 1.0, 0.0);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = d1 / (d1 - d3);
        return corners(1.0 - v, v, 0.0);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return corners(0.0, 0.0, 1.0);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = d2 / (d2 - d6);
        return corners(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return corners(0.0, 1.0 - w, w);
    }
    let sum = va + vb + vc;
    let (v, w) = (vb / sum, vc / sum);
    corners(1.0 - v - w, v, w)
}

/// Of the edge between the first two of `points` and that between the last two.
pub(super) fn of_edges(points: &[DVec3; 4]) -> Nearest {
    let [p, q, r, s] = *points;
    let (u, v, w) = (q - p, s - r, p - r);
    let (a, b, c, d, e) = (u.length_squared(), u.dot(v), v.length_squared(), u.dot(w), v.dot(w));
    let at = |s: f64, t: f64| Nearest::new(points, [1.0 - s, s, t - 1.0, -t]);
    let det = a * c - b * b;
    let parallel = det <= PARALLEL * a * c;
    let along_first = if det > 0.0 { ((b * e - c * d) / det).clamp(0.0, 1.0) } else { 0.0 };
    let t = (b * along_first + e) / c;
    let (first, second) = if t < 0.0 {
        ((-d / a).clamp(0.0, 1.0), 0.0)
    } else if t > 1.0 {
        (((b - d) / a).clamp(0.0, 1.0), 1.0)
    } else {
        (along_first, t)
    };
    let nearest = at(first, second);
    if !parallel {
        return nearest;
    }
    // The nearest of the four ends, each against the other edge.
    let onto_first = |x: DVec3| ((x - p).dot(u) / a).clamp(0.0, 1.0);
    let onto_second = |x: DVec3| ((x - r).dot(v) / c).clamp(0.0, 1.0);
    let ends = [at(0.0, onto_second(p)), at(1.0, onto_second(q)), at(onto_first(r), 0.0), at(onto_first(s), 1.0)];
    let nearer = |best: Nearest, own: Nearest| {
        if own.apart.length_squared() < best.apart.length_squared() { own } else { best }
    };
    ends.into_iter().fold(nearest, nearer)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from -1 to 1, by a fixed sequence.
    fn points(seed: u64) -> [DVec3; 4] {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 32).expect("32 bits")) / f64::from(1_u32 << 31) - 1.0
        };
        std::array::from_fn(|_| DVec3::new(next(), next(), next()))
    }

    /// No point of a fine grid over both things is nearer than the nearest, and one is nearly as near.
    fn check(
        of: impl Fn(&[DVec3; 4]) -> Nearest,
        grid: impl Fn(&[DVec3; 4]) -> f64,
        region: impl Fn([f64; 4]) -> usize,
    ) {
        let mut regions = [0; 16];
        for seed in 1..400 {
            let points = points(seed);
            let Nearest { weights, apart } = of(&points);
            assert!((weights.iter().sum::<f64>()).abs() < 1e-14, "{weights:?}");
            let (distance, least) = (apart.length(), grid(&points));
            assert!(distance <= least + 1e-12 && distance > least - 0.05, "{seed}: {distance}, {least} on a grid");
            regions[region(weights)] += 1;
        }
        assert!(regions.iter().filter(|count| **count > 0).count() >= 7, "each region: {regions:?}");
    }

    #[test]
    fn no_point_of_a_triangle_is_nearer() {
        let grid = |[p, a, b, c]: &[DVec3; 4]| {
            let mut least = f64::INFINITY;
            for i in 0..=60 {
                for j in 0..=60 - i {
                    let (v, w) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
                    least = least.min((*p - (*a + v * (*b - *a) + w * (*c - *a))).length());
                }
            }
            least
        };
        let zeros = |w: [f64; 4]| w[1..].iter().enumerate().map(|(i, w)| usize::from(*w == 0.0) << i).sum();
        check(of_point_and_triangle, grid, zeros);
    }

    #[test]
    fn no_points_of_two_edges_are_nearer() {
        let grid = |[p, q, r, s]: &[DVec3; 4]| {
            let mut least = f64::INFINITY;
            for i in 0..=60 {
                for j in 0..=60 {
                    let (u, v) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
                    least = least.min((p.lerp(*q, u) - r.lerp(*s, v)).length());
                }
            }
            least
        };
        let zeros = |w: [f64; 4]| w.iter().enumerate().map(|(i, w)| usize::from(*w == 0.0) << i).sum();
        check(of_edges, grid, zeros);
    }

    #[test]
    fn nearly_parallel_edges_are_as_far_apart_as_their_ends_say() {
        for tilt in [0.0, 1e-12, 1e-9, 1e-6] {
            let [p, q] = [DVec3::ZERO, DVec3::X];
            for (r, s, expected) in [
                (DVec3::new(0.2, 0.3, tilt), DVec3::new(0.9, 0.3, -tilt), 0.3),
                (DVec3::new(1.4, 0.3, tilt), DVec3::new(2.0, 0.3, 0.0), 0.5),
                (DVec3::new(2.0, 0.3, tilt), DVec3::new(1.4, 0.3, 0.0), 0.5),
                (DVec3::new(-1.0, 0.0, tilt), DVec3::new(-0.1, 0.0, 0.0), 0.1),
            ] {
                let distance = of_edges(&[p, q, r, s]).apart.length();
                assert!((distance - expected).abs() < 2e-6, "{tilt}: {distance}, not {expected}");
            }
        }
    }
    #[test]
    fn nearly_parallel_edges_that_pass_over_each_other_are_near_there() {
        for tilt in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
            let height = 1e-7;
            let edges = [
                DVec3::new(0.1, 0.2, 0.3),
                DVec3::new(1.1, 0.2, 0.3),
                DVec3::new(0.0, 0.2 - 0.4 * tilt, 0.3 + height),
                DVec3::new(0.9, 0.2 + 0.5 * tilt, 0.3 + height),
            ];
            // At their ends they are so much farther apart sideways.
            let Nearest { apart, .. } = of_edges(&edges);
            assert!((apart.length() - height).abs() < 1e-2 * height, "{tilt}: {apart}");
        }
    }
}
