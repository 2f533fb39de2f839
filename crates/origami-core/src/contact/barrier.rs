//! The energy of a gap: nothing from a width on, and without bound towards 0 (Li et al., Incremental Potential Contact, ACM
//! Trans. Graph. 39, 2020).

use glam::DVec3;

/// The curvature of a pair is bounded by that at this share of its gap.
pub const NEARER: f64 = 0.7;
/// Edges whose directions enclose an angle of less sine squared than this are eased out ([`mollifier`]).
pub(super) const EASED: f64 = 1e-3;

/// The energy of a gap, or one of its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Barrier {
    pub(super) energy: f64,
    /// By the gap; not above 0.
    pub(super) slope: f64,
    /// The second derivative; not below 0.
    pub(super) curvature: f64,
}

impl Barrier {
    /// `-stiffness (g - width)^2 ln(g / width)` of a gap g above 0; nothing from the width on.
    pub(super) fn of(gap: f64, width: f64, stiffness: f64) -> Self {
        if gap >= width {
            return Self::default();
        }
        let (less, log) = (gap - width, (gap / width).ln());
        let ratio = less / gap;
        Self {
            energy: -stiffness * less * less * log,
            slope: -stiffness * less * (2.0 * log + ratio),
            curvature: -stiffness * (2.0 * log + 4.0 * ratio - ratio * ratio),
        }
    }
}

/// A factor from 0 to 1 for edges that are nearly parallel, where their nearest points jump from one end to the other; with its
/// gradient by the four ends. `least` is the squared sine from which it is 1, times the squared lengths at rest.
pub(super) fn mollifier([p, q, r, s]: &[DVec3; 4], least: f64) -> (f64, [DVec3; 4]) {
    let (u, v) = (*q - *p, *s - *r);
    let (a, b, c) = (u.length_squared(), u.dot(v), v.length_squared());
    let x = u.cross(v).length_squared() / least;
    if x >= 1.0 {
        return (1.0, [DVec3::ZERO; 4]);
    }
    let slope = (2.0 - 2.0 * x) / least;
    let (by_u, by_v) = (2.0 * slope * (c * u - b * v), 2.0 * slope * (a * v - b * u));
    ((2.0 - x) * x, [-by_u, by_u, -by_v, by_v])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slope_and_curvature_are_those_of_the_energy() {
        let (width, stiffness) = (0.01, 50.0);
        for gap in [1e-5, 1e-4, 1e-3, 4e-3, 9e-3] {
            let h = 1e-4 * gap;
            let at = |gap| Barrier::of(gap, width, stiffness);
            let (less, here, more) = (at(gap - h), at(gap), at(gap + h));
            let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * b.abs();
            assert!(near((more.energy - less.energy) / (2.0 * h), here.slope), "{gap}");
            assert!(near((more.slope - less.slope) / (2.0 * h), here.curvature), "{gap}");
            assert!(here.energy > 0.0 && here.slope < 0.0 && here.curvature > 0.0);
        }
        assert_eq!(Barrier::of(0.01, 0.01, 50.0), Barrier::default());
        assert!(Barrier::of(0.01 * (1.0 - 1e-9), 0.01, 50.0).curvature < 1e-6, "it begins smoothly");
        assert!(Barrier::of(1e-300, 0.01, 50.0).energy > 3.0, "and has no end");
    }

    #[test]
    fn the_gradient_of_the_mollifier_is_that_of_its_value() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::new(0.1, 0.2, 0.0), DVec3::new(0.9, 0.21, 0.02)];
        let least = 1e-3;
        let (value, gradient) = mollifier(&points, least);
        assert!(value > 0.1 && value < 0.9, "{value}");
        for point in 0..4 {
            for axis in 0..3 {
                let at = |h: f64| {
                    let mut moved = points;
                    moved[point][axis] += h;
                    mollifier(&moved, least).0
                };
                let difference = (at(1e-6) - at(-1e-6)) / 2e-6;
                assert!((difference - gradient[point][axis]).abs() < 1e-6, "{difference} {}", gradient[point][axis]);
            }
        }
        let parallel = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE - DVec3::Z];
        assert_eq!(mollifier(&parallel, least).0, 0.0);
        assert_eq!(mollifier(&[DVec3::ZERO, DVec3::X, DVec3::Z, DVec3::ONE], least), (1.0, [DVec3::ZERO; 4]));
    }
}
