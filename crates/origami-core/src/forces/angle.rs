//! Angles from their cosine and sine, without paying for an arc tangent where the angle hardly moved.

use std::f64::consts::TAU;

/// The angle equal to `angle` up to whole turns that lies nearest to `previous` (both in radians).
#[must_use]
pub fn unwrapped(angle: f64, previous: f64) -> f64 {
    angle + TAU * ((previous - angle) / TAU).round()
}

/// Tangents up to this are taken from the series: its first term left out is then 6e-18 of the angle.
const SMALL: f64 = 0.1;

/// The angle with sine and cosine proportional to `y` and `x`, where it is small enough for the series.
#[inline(always)]
pub(super) fn small(y: f64, x: f64) -> Option<f64> {
    if !(x > 0.0 && y.abs() < SMALL * x) {
        return None;
    }
    let t = y / x;
    let q = t * t;
    // atan t = t - t^3/3 + t^5/5 - ...
    let series = -1.0 / 15.0;
    let series = 1.0 / 13.0 + q * series;
    let series = -1.0 / 11.0 + q * series;
    let series = 1.0 / 9.0 + q * series;
    let series = -1.0 / 7.0 + q * series;
    let series = 1.0 / 5.0 + q * series;
    let series = -1.0 / 3.0 + q * series;
    Some(t + t * q * series)
}

/// A direction near to which an angle stays for many evaluations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Anchor {
    angle: f64,
    cos: f64,
    sin: f64,
}

impl Default for Anchor {
    fn default() -> Self {
        Self { angle: 0.0, cos: 1.0, sin: 0.0 }
    }
}

impl Anchor {
    /// The angle with sine and cosine proportional to `y` and `x`, whole turns chosen by `previous`. Exact to rounding
    /// wherever the anchor lies; cheap where it lies near.
    #[inline(always)]
    pub(super) fn angle(&mut self, y: f64, x: f64, previous: f64) -> f64 {
        let (turned_y, turned_x) = (y * self.cos - x * self.sin, x * self.cos + y * self.sin);
        if (previous - self.angle).abs() < 1.0
            && let Some(turn) = small(turned_y, turned_x)
        {
            return self.angle + turn;
        }
        self.moved(y, x, previous)
    }

    /// Drops the anchor at the angle itself.
    #[cold]
    #[inline(never)]
    fn moved(&mut self, y: f64, x: f64, previous: f64) -> f64 {
        let angle = unwrapped(y.atan2(x), previous);
        let (sin, cos) = angle.sin_cos();
        *self = Self { angle, cos, sin };
        angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_is_exact_to_rounding_up_to_its_bound() {
        for i in -999..1000 {
            let t = SMALL * f64::from(i) / 1000.0;
            let got = small(3.0 * t, 3.0).expect("a small angle");
            assert!((got - t.atan()).abs() <= 3e-16 * t.abs(), "{t}: {got} is not {}", t.atan());
        }
        assert_eq!(small(0.2, 1.0), None);
        assert_eq!(small(0.0, -1.0), None);
        assert_eq!(small(f64::NAN, 1.0), None);
    }

    #[test]
    fn anchored_angle_follows_several_turns_and_jumps() {
        let mut anchor = Anchor::default();
        let mut previous = 0.0;
        for step in [0.01, 0.3, -0.07, 2.9] {
            for _ in 0..200 {
                let angle: f64 = previous + step;
                let got = anchor.angle(5.0 * angle.sin(), 5.0 * angle.cos(), previous);
                assert!((got - angle).abs() < 1e-12, "{got} is not {angle}");
                previous = got;
            }
        }
        assert!(previous > 500.0, "many turns were made: {previous}");
    }
}
