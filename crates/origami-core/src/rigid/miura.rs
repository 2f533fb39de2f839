//! The folded Miura sheet.

use glam::DVec3;

/// A folded Miura sheet of parallelograms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MiuraFold {
    /// Length of the straight creases' segments.
    pub a: f64,
    /// Length of the zigzag creases' segments.
    pub b: f64,
    /// Acute corner of a panel.
    pub gamma: f64,
    /// Inclination of the panels: 0 flat in the plane, pi/2 folded flat.
    pub theta: f64,
}

impl MiuraFold {
    /// `[H, S, L, V]`: height of the ridges, and per panel the extent along the zigzags, along the straight creases,
    /// and the swing of the zigzags (Schenk and Guest, PNAS 110, 2013).
    #[must_use]
    pub fn extents(&self) -> [f64; 4] {
        let (sin, cos) = self.theta.sin_cos();
        let slant = cos * self.gamma.tan();
        let zigzag = (1.0 + slant * slant).sqrt();
        let h = self.a * sin * self.gamma.sin();
        [h, self.b * slant / zigzag, (self.a * self.a - h * h).sqrt(), self.b / zigzag]
    }

    /// Vertex `i` along the zigzag `j`; zigzags of odd `j` are ridges.
    #[must_use]
    pub fn vertex(&self, i: usize, j: usize) -> DVec3 {
        let [h, s, l, v] = self.extents();
        let odd = |k: usize| (k % 2) as f64;
        DVec3::new(s * i as f64, l * j as f64 + v * odd(i), h * odd(j))
    }

    /// How far the zigzag creases fold, unsigned: `2 theta`.
    #[must_use]
    pub fn zigzag_fold(&self) -> f64 {
        2.0 * self.theta
    }

    /// How far the straight creases fold, unsigned: `tan(rho/2) = cos gamma tan theta`.
    #[must_use]
    pub fn straight_fold(&self) -> f64 {
        2.0 * (self.gamma.cos() * self.theta.tan()).atan()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    use crate::pattern::fold_angle;

    fn angle_between(u: DVec3, v: DVec3) -> f64 {
        u.cross(v).length().atan2(u.dot(v))
    }

    #[test]
    fn miura_panels_are_rigid_and_creases_fold_as_said() {
        for (gamma, theta) in [(1.0, 0.0), (1.0, 0.6), (1.3, 1.5), (0.4, 0.2)] {
            let fold = MiuraFold { a: 1.3, b: 0.8, gamma, theta };
            let at = |i, j| fold.vertex(i, j);
            for i in 0..3 {
                for j in 0..3 {
                    let zigzag = at(i + 1, j) - at(i, j);
                    let straight = at(i, j + 1) - at(i, j);
                    assert!((zigzag.length() - 0.8).abs() < 1e-14 && (straight.length() - 1.3).abs() < 1e-14);
                    let corner = if i % 2 == 0 { gamma } else { PI - gamma };
                    assert!((angle_between(zigzag, straight) - corner).abs() < 1e-12);
                    assert!((at(i, j) + at(i + 1, j + 1) - at(i + 1, j) - at(i, j + 1)).length() < 1e-14, "not flat");
                    let along = fold_angle(at(i, j + 2), at(i, j), at(i, j + 1), at(i + 1, j + 1));
                    assert!((along.abs() - fold.zigzag_fold()).abs() < 1e-9, "{along}");
                    let across = fold_angle(at(i, j), at(i + 2, j), at(i + 1, j), at(i + 1, j + 1));
                    assert!((across.abs() - fold.straight_fold()).abs() < 1e-9, "{across}");
                }
            }
        }
    }
}
