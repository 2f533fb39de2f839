//! Closed forms of rigid folding: what generators set and what a solver is checked against.
//!
//! Angles in radians, fold angles valley positive; lengths in any one unit.

use std::f64::consts::{PI, TAU};

pub use crate::pattern::fold_angle;
use glam::{DMat3, DVec3};

/// How far a vertex is from closing: the Frobenius norm of `prod Rx(rho_i) Rz(alpha_i) - I` over (fold angle `rho_i`,
/// sector `alpha_i`), counterclockwise, crease i before sector i (belcastro and Hull, 2002). 0 where it closes.
#[must_use]
pub fn loop_closure(folds_and_sectors: &[(f64, f64)]) -> f64 {
    let around = folds_and_sectors.iter().fold(DMat3::IDENTITY, |product, &(fold, sector)| {
        product * DMat3::from_rotation_x(fold) * DMat3::from_rotation_z(sector)
    });
    (around - DMat3::IDENTITY).to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Which of the two ways a flat-foldable vertex of degree 4 folds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Degree4Mode {
    /// Creases 1 and 3 fold alike: signs (+, -, +, +) where the first two sectors add up to less than pi.
    #[default]
    A,
    /// Creases 2 and 4 fold alike: signs (+, -, -, -) where the first sector is the smaller one.
    B,
}

/// Fold angles of a vertex with sectors (a, b, pi - a, pi - b) whose driven creases (1 and 3 in mode A, 2 and 4 in
/// mode B) fold by `driven`: half-angle tangents in a constant ratio (Lang, Twists, Tilings and Tessellations, 2018,
/// chapter 8).
#[must_use]
pub fn degree4(a: f64, b: f64, mode: Degree4Mode, driven: f64) -> [f64; 4] {
    let ratio = match mode {
        Degree4Mode::A => ((a + b) / 2.0).cos() / ((a - b) / 2.0).cos(),
        Degree4Mode::B => ((b - a) / 2.0).sin() / ((a + b) / 2.0).sin(),
    };
    let other = 2.0 * (ratio * (driven / 2.0).tan()).atan();
    match mode {
        Degree4Mode::A => [driven, -other, driven, other],
        Degree4Mode::B => [other, -driven, -other, -driven],
    }
}

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

/// The waterbomb vertex: 2n creases, pi/n apart on the sheet, alternately at the polar angles `first` and the returned
/// one from the axis of symmetry: `cos(pi/n) = cos p cos q + sin p sin q cos(pi/n)`. The two branches are the two roots;
/// they meet in the flat state, where both are pi/2.
#[must_use]
pub fn waterbomb_polar(n: usize, first: f64, upper: bool) -> f64 {
    let alpha = PI / n as f64;
    let (x, y) = (first.cos(), first.sin() * alpha.cos());
    let spread = (alpha.cos() / x.hypot(y)).min(1.0).acos();
    y.atan2(x) + if upper { spread } else { -spread }
}

/// Fold angles of the waterbomb vertex's creases at the polar angles `p` and at `q`: `pi - 2A`, where
/// `cos A = (cos q - cos p cos(pi/n)) / (sin p sin(pi/n))`, and the same with p and q swapped.
#[must_use]
pub fn waterbomb_folds(n: usize, p: f64, q: f64) -> [f64; 2] {
    let alpha = PI / n as f64;
    [(p, q), (q, p)].map(|(p, q)| {
        let half = (q.cos() - p.cos() * alpha.cos()) / (p.sin() * alpha.sin());
        PI - 2.0 * half.clamp(-1.0, 1.0).acos()
    })
}

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

    fn angle_between(u: DVec3, v: DVec3) -> f64 {
        u.cross(v).length().atan2(u.dot(v))
    }

    #[test]
    fn degree4_closes_in_both_modes() {
        for (a, b) in [(0.7, 1.2), (1.2, 0.7), (1.9, 1.8), (0.3, 2.9), (1.0, 1.0)] {
            for mode in [Degree4Mode::A, Degree4Mode::B] {
                for driven in [-2.0, 0.1, 1.0, 2.5, PI] {
                    let folds = degree4(a, b, mode, driven);
                    let sectors = [a, b, PI - a, PI - b];
                    let mut both: Vec<_> = folds.into_iter().zip(sectors).collect();
                    assert!(loop_closure(&both) < 1e-12, "{a} {b} {mode:?} {driven}");
                    both[0].0 += 1e-3;
                    assert!(loop_closure(&both) > 1e-4, "closure does not see a wrong angle");
                }
            }
        }
    }

    #[test]
    fn degree4_signs_are_those_of_the_modes() {
        assert_eq!(degree4(0.7, 1.2, Degree4Mode::A, 1.0).map(f64::signum), [1.0, -1.0, 1.0, 1.0]);
        assert_eq!(degree4(0.7, 1.2, Degree4Mode::B, 1.0).map(f64::signum), [1.0, -1.0, -1.0, -1.0]);
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

    #[test]
    fn waterbomb_closes_on_both_branches_and_is_flat_between() {
        for n in [3, 4, 6] {
            let alpha = PI / n as f64;
            for p in [1.2, 1.5, 1.9] {
                for upper in [false, true] {
                    let q = waterbomb_polar(n, p, upper);
                    let spherical = p.cos() * q.cos() + p.sin() * q.sin() * alpha.cos();
                    assert!((spherical - alpha.cos()).abs() < 1e-14);
                    let folds = waterbomb_folds(n, p, q);
                    let around: Vec<_> = (0..2 * n).map(|i| (folds[i % 2], alpha)).collect();
                    assert!(loop_closure(&around) < 1e-12, "{n} {p} {upper}");
                }
            }
            let flat = waterbomb_folds(n, PI / 2.0, waterbomb_polar(n, PI / 2.0, true));
            assert!(flat.iter().all(|fold| fold.abs() < 1e-7));
        }
    }

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

    #[test]
    fn yoshimura_ring_keeps_the_diamonds() {
        let fold = YoshimuraFold { n: 7, c: 0.4, alpha: 0.6 };
        assert!((fold.vertex(0, 0).distance(fold.vertex(1, 0)) - 0.8).abs() < 1e-14);
        for (i, j) in [(0, 1), (6, 1)] {
            assert!((fold.vertex(0, 0).distance(fold.vertex(i, j)) - 0.4 / 0.6f64.cos()).abs() < 1e-14);
        }
        assert!(YoshimuraFold { alpha: PI / 15.0, ..fold }.ring()[1].is_nan());
    }

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
