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
    /// Linear between two fold angles, and from each rising without bound towards a half turn, where the facets would
    /// touch: the law of Liu and Paulino (2017, eq. 4.10), with their limits of 45 and 315 degrees at -135 and 135. Closer to
    /// each other: stiffer earlier. In radians, above -pi and below pi.
    Stiffened {
        /// The least and the largest fold angle at which it is linear, in radians.
        between: [f64; 2],
    },
    /// `kappa sign(d) |d|^exponent` with `d = theta - theta0`: MERLIN2 bends facets with 4/3. So near to rest that its
    /// stiffness would be below a thousandth of kappa (4e-10 radians with 4/3) it is linear with that: without any, nothing
    /// would hold a flat facet. At least 1; larger: softer near rest.
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
            Self::Stiffened { between: [_, most] } if angle > most => stiffened(most, rest, angle),
            // The mirror image of a hinge folded the other way.
            Self::Stiffened { between: [least, _] } if angle < least => {
                let (energy, slope, curvature) = stiffened(-least, -rest, -angle);
                (energy, -slope, curvature)
            }
            Self::Stiffened { .. } => (0.5 * turned * turned, turned, 1.0),
            Self::Power { exponent } => power(exponent, turned),
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
    pub(crate) fn problem(self) -> Option<(String, &'static str)> {
        match self {
            Self::Stiffened { between: [least, most] } if !(-PI < least && least < most && most < PI) => Some((
                format!("between {least} and {most}"),
                "two fold angles in order, above minus and below half a turn",
            )),
            Self::Power { exponent } if !(exponent.is_finite() && exponent >= 1.0) => {
                Some((exponent.to_string(), "an exponent of at least 1"))
            }
            _ => None,
        }
    }
}

/// Above its limit b, with `p = pi / (pi - b)`: the moment `b - theta0 + (2 / p) tan(p (theta - b) / 2)` per stiffness.
fn stiffened(limit: f64, rest: f64, angle: f64) -> (f64, f64, f64) {
    if angle >= PI {
        return (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    }
    let (at_limit, past) = (limit - rest, angle - limit);
    let p = PI / (PI - limit);
    let half = 0.5 * p * past;
    let energy = 0.5 * at_limit * at_limit + at_limit * past - 4.0 / (p * p) * half.cos().ln();
    (energy, at_limit + 2.0 / p * half.tan(), half.cos().powi(-2))
}

/// The least stiffness of a power law, as MERLIN2 has it.
const LEAST: f64 = 1e-3;

/// A power from where its slope is [`LEAST`], a line and a constant that join smoothly before.
fn power(exponent: f64, turned: f64) -> (f64, f64, f64) {
    let size = turned.abs();
    let joint = if exponent > 1.0 { (LEAST / exponent).powf((exponent - 1.0).recip()) } else { 0.0 };
    if size < joint {
        return (0.5 * LEAST * turned * turned, LEAST * turned, LEAST);
    }
    let whole = |x: f64| (x.powf(exponent + 1.0) / (exponent + 1.0), x.powf(exponent));
    let ((energy, moment), (energy_before, moment_before)) = (whole(size), whole(joint));
    let lifted = LEAST * joint - moment_before;
    let energy = energy - energy_before + 0.5 * LEAST * joint * joint + lifted * (size - joint);
    (energy, (moment + lifted).copysign(turned), exponent * size.powf(exponent - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [HingeLaw; 5] = [
        HingeLaw::Linear,
        HingeLaw::Stiffened { between: [-2.0, 2.0] },
        HingeLaw::Stiffened { between: [-0.4, 0.4] },
        HingeLaw::Stiffened { between: [-2.5, -0.5] },
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
    fn a_power_is_one_but_next_to_rest() {
        let exponent = 4.0 / 3.0;
        let law = HingeLaw::Power { exponent };
        for turned in [1e-5, 1e-3, 0.5] {
            let own = law.respond(2.0, 0.3, 0.3 - turned);
            assert!((own.slope / (-2.0 * turned.powf(exponent)) - 1.0).abs() < 1e-5, "{turned}: {own:?}");
        }
        assert_eq!(law.respond(2.0, 0.0, 0.0).curvature, 2e-3);
        // Smooth where the two join.
        let joint = (1e-3 / exponent).powi(3);
        let [before, after] = [0.999_999, 1.000_001].map(|share| law.respond(1.0, 0.0, share * joint));
        assert!((before.slope / after.slope - 1.0).abs() < 1e-5 && (before.energy / after.energy - 1.0).abs() < 1e-5);
        assert!((before.curvature / after.curvature - 1.0).abs() < 1e-5, "{before:?} {after:?}");
    }

    #[test]
    fn a_stiffened_hinge_is_smooth_at_its_limit_and_never_passes_half_a_turn() {
        let law = HingeLaw::Stiffened { between: [-100_f64.to_radians(), 135_f64.to_radians()] };
        for (side, limit) in [(1.0, 135_f64.to_radians()), (-1.0, -100_f64.to_radians())] {
            let (before, after) = (law.respond(1.0, 0.3, limit), law.respond(1.0, 0.3, limit * (1.0 + 1e-12)));
            assert!((before.energy - after.energy).abs() < 1e-10 && (before.slope - after.slope).abs() < 1e-10);
            assert!((before.curvature - after.curvature).abs() < 1e-10);
            let near = law.respond(1.0, 0.3, side * (PI - 1e-6));
            assert!(near.slope * side > 1e5, "{near:?}");
            assert!(law.respond(1.0, 0.3, side * 3.2).energy.is_infinite());
        }
    }
}
