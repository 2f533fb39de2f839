//! Bars. With the stretch `s = l / l0` all three agree to first order in `s - 1`, and differ by 11 % in the limit load of a
//! truss that is half as high as it is wide: results name the law.

use super::Response;

/// How the tension of a bar depends on its length. All have the rigidity EA at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum BarLaw {
    /// `N = EA (s - 1)`: that of the paper and of every other solver here. The default.
    #[default]
    Linear,
    /// `N = EA e s` with Green's strain `e = (s^2 - 1) / 2`: softer under pressure, stiffer under tension. Sim-FAST, SWOMPS.
    Green,
    /// `N = EA (s^4 - 1) / 4`, Ogden's law with the exponents 5 and 1: that of MERLIN (Liu and Paulino 2017).
    Ogden,
}

impl BarLaw {
    /// Energy, tension and stiffness of a bar of rigidity `ea` (a force) and rest length `rest` at the length `length`.
    #[must_use]
    pub fn respond(self, ea: f64, rest: f64, length: f64) -> Response {
        let s = length / rest;
        // s - 1 without the rounding of s.
        let strain = (length - rest) / rest;
        let (energy, slope, curvature) = match self {
            Self::Linear => (0.5 * strain * strain, strain, 1.0),
            Self::Green => {
                let green = 0.5 * strain * (s + 1.0);
                (0.5 * green * green, green * s, green + s * s)
            }
            Self::Ogden => {
                let x = strain;
                // ((s^5 - 1) / 5 - (s - 1)) / 4 and (s^4 - 1) / 4 in powers of s - 1.
                let energy = x * x * (10.0 + x * (10.0 + x * (5.0 + x))) / 20.0;
                let slope = 0.25 * x * (s + 1.0) * (s * s + 1.0);
                (energy, slope, s * s * s)
            }
        };
        Response { energy: ea * rest * energy, slope: ea * slope, curvature: ea / rest * curvature }
    }

    /// Its name in job files and results.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Green => "green",
            Self::Ogden => "ogden",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAWS: [BarLaw; 3] = [BarLaw::Linear, BarLaw::Green, BarLaw::Ogden];

    #[test]
    fn tension_and_stiffness_are_derivatives_of_the_energy() {
        let (ea, rest, h) = (7.0, 0.6, 1e-5);
        for law in LAWS {
            for length in [0.2, 0.5, 0.6, 0.61, 0.9] {
                let at = |l: f64| law.respond(ea, rest, l);
                let slope = (at(length + h).energy - at(length - h).energy) / (2.0 * h);
                let curvature = (at(length + h).slope - at(length - h).slope) / (2.0 * h);
                assert!((slope - at(length).slope).abs() < 1e-8, "{law:?} at {length}: {slope}");
                assert!(
                    (curvature - at(length).curvature).abs() < 1e-8 * ea / rest,
                    "{law:?} at {length}: {curvature}"
                );
            }
        }
    }

    #[test]
    fn the_energies_are_those_that_are_named() {
        let (ea, rest) = (3.0, 2.0);
        for s in [0.7_f64, 1.0, 1.3] {
            let energy = |law: BarLaw| law.respond(ea, rest, s * rest).energy / (ea * rest);
            assert!((energy(BarLaw::Linear) - 0.5 * (s - 1.0).powi(2)).abs() < 1e-15);
            assert!((energy(BarLaw::Green) - 0.125 * (s * s - 1.0).powi(2)).abs() < 1e-15);
            assert!((energy(BarLaw::Ogden) - 0.25 * ((s.powi(5) - 1.0) / 5.0 - (s - 1.0))).abs() < 1e-15);
        }
    }
}
