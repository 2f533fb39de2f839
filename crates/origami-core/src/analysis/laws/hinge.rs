//! Hinges: moments by the fold angle, 0 flat, in radians. `kappa` is the stiffness of a whole hinge, a moment per radian.

use std::f64::consts::PI;

use super::Response;

/// How the moment of a hinge depends on its fold angle theta and its rest angle theta0.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum HingeLaw {
    /// `kappa (theta - theta0)`, whatever the angle: facets may go through each other. The default.
    #[default]
    Linear,
    /// Linear up to the fold angle `beyond` to either side, and from there rising without bound towards a half turn, where
    /// the facets would touch: the law of Liu and Paulino (2017, eq. 4.10), with their limits of 45 and 315 degrees at
    /// `beyond` = 135 degrees. Smaller: stiffer earlier. In radians, above 0 and below pi.
    Stiffened {
        /// Fold angle at which it becomes stiffer, in radians.
        beyond: f64,
    },
    /// `kappa sign(d) |d|^exponent` with `d = theta - theta0`: MERLIN2 bends facets with 4/3. Its stiffness at rest is 0
    /// for exponents above 1, and steps from there are many and small. At least 1; larger: softer near rest.
    Power {
        /// The exponent, without unit.
        exponent: f64,
    },
}

impl HingeLaw {
    /// Energy, moment and stiffness of a hinge at the fold angle `angle`, at rest at `rest` (radians). Infinite where
    /// facets that stiffen would have gone through each other.
    #[must_use]
    pub fn respond(self, kappa: f64, rest: f64, angle: f64) -> Response {
        let turned = angle - rest;
        let (energy, slope, curvature) = match self {
            Self::Linear => (0.5 * turned * turned, turned, 1.0),
            Self::Stiffened { beyond } if angle.abs() > beyond => stiffened(beyond, rest, angle),
            Self::Stiffened { .. } => (0.5 * turned * turned, turned, 1.0),
            Self::Power { exponent } => {
                let size = turned.abs();
                let slope = size.powf(exponent);
                (slope * size / (exponent + 1.0), slope.copysign(turned), exponent * size.powf(exponent - 1.0))
            }
        };
        Response { energy: kappa * energy, slope: kappa * slope, curvature: kappa * curvature }
    }

    /// Its name in job files and results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Stiffened { .. } => "stiffened",
            Self::Power { .. } => "power",
        }
    }

    /// What is wrong with its number, and what was expected.
    pub(crate) fn problem(self) -> Option<(f64, &'static str)> {
        match self {
            Self::Stiffened { beyond } if !(beyond > 0.0 && beyond < PI) => {
                Some((beyond, "a fold angle above 0 and below half a turn"))
            }
            Self::Power { exponent } if !(exponent.is_finite() && exponent >= 1.0) => {
                Some((exponent, "an exponent of at least 1"))
            }
            _ => None,
        }
    }
}

/// Beyond its limit b, with `p = pi / (pi - b)`: the moment `b - theta0 + (2 / p) tan(p (theta - b) / 2)` per stiffness.
fn stiffened(beyond: f64, rest: f64, angle: f64) -> (f64, f64, f64) {
    if angle.abs() >= PI {
        return (f64::INFINITY, f64::INFINITY.copysign(angle), f64::INFINITY);
    }
    // The mirror image of a hinge folded the other way.
    let side = angle.signum();
    let (at_limit, past) = (beyond - side * rest, side * angle - beyond);
    let p = PI / (PI - beyond);
    let half = 0.5 * p * past;
    let energy = 0.5 * at_limit * at_limit + at_limit * past - 4.0 / (p * p) * half.cos().ln();
    (energy, side * (at_limit + 2.0 / p * half.tan()), half.cos().powi(-2))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [HingeLaw; 4] = [
        HingeLaw::Linear,
        HingeLaw::Stiffened { beyond: 2.0 },
        HingeLaw::Stiffened { beyond: 0.4 },
        HingeLaw::Power { exponent: 4.0 / 3.0 },
    ];

    #[test]
    fn moment_and_stiffness_are_derivatives_of_the_energy() {
        let h = 1e-5;
        for law in LAWS {
            for rest in [-0.7, 0.0, 1.1] {
                for angle in [-2.9, -2.1, -1.0, -0.3, 0.2, 1.4, 2.3, 3.0] {
                    let at = |a: f64| law.respond(0.3, rest, a);
                    let slope = (at(angle + h).energy - at(angle - h).energy) / (2.0 * h);
                    let curvature = (at(angle + h).slope - at(angle - h).slope) / (2.0 * h);
                    let own = at(angle);
                    assert!((slope - own.slope).abs() < 1e-7 * own.slope.abs().max(1.0), "{law:?} at {angle}: {slope}");
                    let close = (curvature - own.curvature).abs() < 1e-6 * own.curvature.max(1.0);
                    assert!(close, "{law:?} at {angle}: {curvature}");
                }
            }
        }
    }

    #[test]
    fn a_stiffened_hinge_is_smooth_at_its_limit_and_never_passes_half_a_turn() {
        let law = HingeLaw::Stiffened { beyond: 135_f64.to_radians() };
        for side in [1.0, -1.0] {
            let limit = side * 135_f64.to_radians();
            let (before, after) = (law.respond(1.0, 0.3, limit), law.respond(1.0, 0.3, limit * (1.0 + 1e-12)));
            assert!((before.energy - after.energy).abs() < 1e-10 && (before.slope - after.slope).abs() < 1e-10);
            assert!((before.curvature - after.curvature).abs() < 1e-10);
            let near = law.respond(1.0, 0.3, side * (PI - 1e-6));
            assert!(near.slope * side > 1e5, "{near:?}");
            assert!(law.respond(1.0, 0.3, side * 3.2).energy.is_infinite());
        }
    }
}
