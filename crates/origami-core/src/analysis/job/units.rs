//! Units of a job. All numbers of a job are in them, and so are all results.

use serde::{Deserialize, Serialize};

use crate::error::{Error, ErrorCode, Place};

/// In what lengths and forces are counted. Stiffnesses and energies follow: a modulus is a force per length squared.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// `m`, `cm`, `mm`, `um`, `nm`, `in` or `pt`, as FOLD has them in `frame_unit`; or `unit`, that of the file whatever it is.
    pub length: String,
    /// `N`, `kN`, `mN`, `uN` or `lbf`; or `unit`.
    pub force: String,
    /// `kg`, `g`, `mg` or `t`; or `unit`. Only vibrations need it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<String>,
}

/// Lengths in metres. A point is 1/72 of an inch.
const LENGTHS: [(&str, f64); 7] =
    [("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9), ("in", 0.0254), ("pt", 0.0254 / 72.0)];
/// Forces in newtons.
const FORCES: [(&str, f64); 5] = [("N", 1.0), ("kN", 1e3), ("mN", 1e-3), ("uN", 1e-6), ("lbf", 4.448_221_615_260_5)];
/// Masses in kilograms.
const MASSES: [(&str, f64); 4] = [("kg", 1.0), ("g", 1e-3), ("mg", 1e-6), ("t", 1e3)];
/// No unit in particular.
const UNIT: &str = "unit";

impl Units {
    /// Whether all of them are known.
    pub(super) fn check(&self) -> Result<(), Error> {
        if self.length != UNIT && of(&LENGTHS, &self.length).is_none() {
            let expected = "`m`, `cm`, `mm`, `um`, `nm`, `in`, `pt` or `unit`";
            return Err(wrong("units.length", &self.length, expected));
        }
        if self.force != UNIT && of(&FORCES, &self.force).is_none() {
            return Err(wrong("units.force", &self.force, "`N`, `kN`, `mN`, `uN`, `lbf` or `unit`"));
        }
        match self.mass.as_deref() {
            Some(mass) if mass != UNIT && of(&MASSES, mass).is_none() => {
                Err(wrong("units.mass", mass, "`kg`, `g`, `mg`, `t` or `unit`"))
            }
            _ => Ok(()),
        }
    }

    /// What the root of an eigenvalue, of a force per length and mass, is to be multiplied by to be a frequency in hertz; none
    /// where a unit is not known.
    pub(super) fn hertz(&self) -> Option<f64> {
        let mass = of(&MASSES, self.mass.as_deref()?)?;
        let squared = of(&FORCES, &self.force)? / (of(&LENGTHS, &self.length)? * mass);
        Some(squared.sqrt() / std::f64::consts::TAU)
    }

    /// How many of these lengths the file's unit of length is, by its `frame_unit`. A file that names none is in these.
    pub(super) fn of_file(&self, frame_unit: Option<&str>) -> Result<f64, Error> {
        match (frame_unit.unwrap_or(UNIT), of(&LENGTHS, &self.length)) {
            (UNIT, _) => Ok(1.0),
            (file, Some(own)) => match of(&LENGTHS, file) {
                Some(of_file) => Ok(of_file / own),
                None => Err(wrong("frame_unit", file, "a unit of length that FOLD knows")),
            },
            (file, None) => Err(wrong("units.length", &self.length, &format!("a length: the file's is `{file}`"))),
        }
    }
}

/// A unit of a table in those of SI.
fn of(table: &[(&str, f64)], name: &str) -> Option<f64> {
    table.iter().find(|(own, _)| *own == name).map(|(_, of_si)| *of_si)
}

fn wrong(key: &'static str, name: &str, expected: &str) -> Error {
    Error::new(ErrorCode::WrongValue, Place::key(key), format!("is `{name}`"), expected)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_of_files_are_told_in_those_of_the_job() {
        let units = |length: &str| Units { length: length.into(), force: "N".into(), mass: Some("t".into()) };
        assert_eq!(units("mm").of_file(Some("cm")).expect("a length"), 10.0);
        assert_eq!(units("mm").of_file(Some("unit")).expect("that of the job"), 1.0);
        assert!((units("in").of_file(Some("pt")).expect("a length") - 1.0 / 72.0).abs() < 1e-15);
        let told = units("unit").of_file(Some("mm")).expect_err("no length").to_string();
        assert_eq!(told, "units.length: is `unit`; expected a length: the file's is `mm`");
        assert!(units("ell").check().expect_err("no unit").to_string().starts_with("units.length: is `ell`"));
        assert!(units("unit").check().is_ok());
        // A tonne on a spring of 1 N/mm turns as fast as a kilogram on one of 1 N/m: once in 2 pi seconds.
        assert!((units("mm").hertz().expect("known") * std::f64::consts::TAU - 1.0).abs() < 1e-12);
        assert_eq!(units("unit").hertz(), None);
    }
}
