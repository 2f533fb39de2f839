//! One vertex whose facets stay rigid: its fold angles and the condition that they close.

use std::f64::consts::PI;

use glam::DMat3;

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

#[cfg(test)]
mod tests {
    use super::*;

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
}
