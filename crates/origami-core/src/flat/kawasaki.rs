//! Kawasaki's rule: around a vertex that folds flat, every second sector adds up to half a turn. Walking around it, the
//! paper runs to and fro along a circle, and must come back to where it began.

use std::f64::consts::PI;

/// By how much the sum of every second sector misses half a turn, in radians; `None` for an odd number of sectors, which
/// cannot fold flat whatever their angles.
pub(super) fn residual(sectors: &[f64]) -> Option<f64> {
    sectors.len().is_multiple_of(2).then(|| (sectors.iter().step_by(2).sum::<f64>() - PI).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residuals_by_hand() {
        let degrees = |list: &[f64]| {
            let sectors: Vec<f64> = list.iter().map(|d| d.to_radians()).collect();
            residual(&sectors).map(|off| off.to_degrees())
        };
        assert!(degrees(&[60.0, 80.0, 120.0, 100.0]).unwrap() < 1e-12);
        assert!((degrees(&[60.0, 80.0, 123.0, 97.0]).unwrap() - 3.0).abs() < 1e-12);
        assert!((degrees(&[170.0, 190.0]).unwrap() - 10.0).abs() < 1e-12, "a bent line through a vertex");
        assert_eq!(degrees(&[120.0, 120.0, 120.0]), None);
    }
}
