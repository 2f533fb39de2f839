//! The Yoshimura cylinder.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

/// A Yoshimura cylinder: n diamonds around, each of width `2c` and base angle `alpha`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct YoshimuraFold {
    /// Diamonds around.
    pub n: usize,
    /// Half the width of a diamond.
    pub c: f64,
    /// Angle between a diamond's width and its sides; at least `pi/(2n)`.
    pub alpha: f64,
}

impl YoshimuraFold {
    /// `[R, h]`: circumradius `c / sin(pi/n)` and storey height `c sqrt(1/cos^2 alpha - 1/cos^2(pi/2n))`. The height is
    /// not a number below the least alpha.
    #[must_use]
    pub fn ring(&self) -> [f64; 2] {
        let n = self.n as f64;
        let height = self.c * (self.alpha.cos().powi(-2) - (PI / (2.0 * n)).cos().powi(-2)).sqrt();
        [self.c / (PI / n).sin(), height]
    }

    /// Vertex `i` of polygon `j`, the axis along z; odd polygons are turned by half a side.
    #[must_use]
    pub fn vertex(&self, i: usize, j: usize) -> DVec3 {
        let [radius, height] = self.ring();
        let azimuth = TAU * (i as f64 + 0.5 * (j % 2) as f64) / self.n as f64;
        DVec3::new(radius * azimuth.cos(), radius * azimuth.sin(), height * j as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn yoshimura_ring_keeps_the_diamonds() {
        let fold = YoshimuraFold { n: 7, c: 0.4, alpha: 0.6 };
        assert!((fold.vertex(0, 0).distance(fold.vertex(1, 0)) - 0.8).abs() < 1e-14);
        for (i, j) in [(0, 1), (6, 1)] {
            assert!((fold.vertex(0, 0).distance(fold.vertex(i, j)) - 0.4 / 0.6f64.cos()).abs() < 1e-14);
        }
        assert!(YoshimuraFold { alpha: PI / 15.0, ..fold }.ring()[1].is_nan());
    }
}
