//! The Kresling cylinder.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

/// One storey of a Kresling cylinder: n-gons of the given circumradius, `height` apart, the upper one turned by `twist`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KreslingFold {
    /// Sides of the polygons.
    pub n: usize,
    /// Circumradius R of the polygons.
    pub radius: f64,
    /// Height H of a storey.
    pub height: f64,
    /// Turn phi of a storey.
    pub twist: f64,
}

impl KreslingFold {
    /// `[l, b, c]`: a polygon's side, and the bars that turn by the twist and by the twist and one side:
    /// `b^2 = H^2 + 4R^2 sin^2(phi/2)`, `c^2 = H^2 + 4R^2 sin^2(phi/2 + pi/n)`.
    #[must_use]
    pub fn bars(&self) -> [f64; 3] {
        let half_side = PI / self.n as f64;
        let chord = |half_turn: f64| 2.0 * self.radius * half_turn.sin();
        let half_twist = self.twist / 2.0;
        [chord(half_side), self.height.hypot(chord(half_twist)), self.height.hypot(chord(half_twist + half_side))]
    }

    /// The other state with the same bars: `phi' = pi - 2pi/n - phi`, `H'^2 = H^2 + 2R^2 (cos phi' - cos phi)`;
    /// `None` where that height is not real.
    #[must_use]
    pub fn second_state(&self) -> Option<Self> {
        let twist = PI - TAU / self.n as f64 - self.twist;
        let squared = self.height.powi(2) + 2.0 * self.radius.powi(2) * (twist.cos() - self.twist.cos());
        (squared > 0.0).then(|| Self { height: squared.sqrt(), twist, ..*self })
    }

    /// Vertex `i` of polygon `j`, the axis along z.
    #[must_use]
    pub fn vertex(&self, i: usize, j: usize) -> DVec3 {
        let azimuth = TAU * i as f64 / self.n as f64 + self.twist * j as f64;
        DVec3::new(self.radius * azimuth.cos(), self.radius * azimuth.sin(), self.height * j as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kresling_has_a_second_state_with_the_same_bars() {
        let tall = KreslingFold { n: 6, radius: 1.0, height: 1.8, twist: 0.35 };
        let short = tall.second_state().unwrap();
        assert!((short.height - 1.0078681887).abs() < 1e-10 && (short.twist - 1.7443951024).abs() < 1e-10);
        for (one, other) in tall.bars().into_iter().zip(short.bars()) {
            assert!((one - other).abs() < 1e-14);
        }
        for fold in [tall, short] {
            let [l, b, c] = fold.bars();
            for (bar, i, j) in [(l, 1, 0), (b, 0, 1), (c, 1, 1)] {
                assert!((fold.vertex(0, 0).distance(fold.vertex(i, j)) - bar).abs() < 1e-14);
            }
        }
        assert_eq!(KreslingFold { height: 0.1, ..tall }.second_state(), None);
    }
}
