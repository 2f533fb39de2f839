//! Rigid facets on elastic hinges: a buckling load and a frequency.

use std::f64::consts::PI;

/// Load at which a strip of `n` stiff panels of length `l`, joined by hinges of stiffness `kappa` (moment per radian),
/// buckles between pinned ends: `2 kappa (1 - cos(pi/n)) / l`.
#[must_use]
pub fn strip_buckling_load(n: usize, l: f64, kappa: f64) -> f64 {
    2.0 * kappa * (1.0 - (PI / n as f64).cos()) / l
}

/// Angular frequency of a single crease of length `l` between two apexes at height `h` over its middle, unit masses:
/// `omega^2 = 4 k l / h^2`, `k` the stiffness per unit of length.
#[must_use]
pub fn single_crease_frequency(k: f64, l: f64, h: f64) -> f64 {
    (4.0 * k * l).sqrt() / h
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::fold_angle;
    use glam::DVec3;

    #[test]
    fn buckling_load_of_two_panels() {
        // One hinge, turned by 2 phi: energy kappa (2 phi)^2 / 2 against the work P l phi^2 of two panels.
        assert!((strip_buckling_load(2, 0.5, 3.0) - 2.0 * 3.0 / 0.5).abs() < 1e-14);
        // Many panels approach Euler's column: P = pi^2 kappa l / (n l)^2.
        let euler = PI * PI / 1e6;
        assert!((strip_buckling_load(1000, 1.0, 1.0) / euler - 1.0).abs() < 1e-6);
    }

    #[test]
    fn single_crease_frequency_is_that_of_its_gradient() {
        // Masses 1: omega^2 = k l |dtheta/dp|^2, by central differences.
        let (k, l, h) = (0.7, 1.4, 0.6);
        let half = DVec3::Y * l / 2.0;
        let mut p = [-DVec3::X * h, DVec3::X * h, -half, half];
        let theta = |p: &[DVec3; 4]| fold_angle(p[0], p[1], p[2], p[3]);
        let mut squared = 0.0;
        for i in 0..4 {
            for axis in 0..3 {
                p[i][axis] += 1e-5;
                let up = theta(&p);
                p[i][axis] -= 2e-5;
                let down = theta(&p);
                p[i][axis] += 1e-5;
                squared += ((up - down) / 2e-5).powi(2);
            }
        }
        assert!(((k * l * squared).sqrt() / single_crease_frequency(k, l, h) - 1.0).abs() < 1e-8);
    }
}
