//! Lengths on paper.

use std::fmt;
use std::str::FromStr;

use glam::DVec2;
use origami_core::error::{Error, ErrorCode};

/// A unit of length on paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unit {
    /// Millimetres.
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Inches of 25.4 mm.
    Inch,
}

impl Unit {
    const ALL: [Self; 3] = [Self::Millimetre, Self::Centimetre, Self::Inch];

    /// As SVG has it: `mm`, `cm` or `in`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Inch => "in",
        }
    }
}

/// A length on paper, greater than 0. Parsed from a number with its unit, such as `150mm`, `15cm` or `6in`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length {
    /// How many of its unit.
    pub number: f64,
    /// Its unit.
    pub unit: Unit,
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.number, self.unit.name())
    }
}

impl FromStr for Length {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let wrong = || {
            let expected = "a number above 0 with mm, cm or in behind it, such as 150mm";
            Error::new(ErrorCode::Setting, "width", format!("{text:?} is no length on paper"), expected)
        };
        let text = text.trim();
        let unit = Unit::ALL.into_iter().find(|unit| text.ends_with(unit.name())).ok_or_else(wrong)?;
        let number: f64 = text[..text.len() - unit.name().len()].trim().parse().map_err(|_| wrong())?;
        if number > 0.0 && number.is_finite() { Ok(Self { number, unit }) } else { Err(wrong()) }
    }
}

/// The corners of the box around points, and how far it reaches; the origin where there are none.
pub(super) fn extent(points: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    let corners = points.map(|p| (p, p)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    corners.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_units() {
        for (text, number, unit) in
            [("150mm", 150.0, Unit::Millimetre), (" 15 cm ", 15.0, Unit::Centimetre), ("6.5in", 6.5, Unit::Inch)]
        {
            let length: Length = text.parse().expect(text);
            assert_eq!(length, Length { number, unit });
            assert_eq!(length.to_string().parse::<Length>().expect("again"), length);
        }
        for wrong in ["", "150", "mm", "-1mm", "0cm", "NaNin", "1e999mm", "5 km", "5px"] {
            let error = wrong.parse::<Length>().expect_err(wrong).to_string();
            assert!(error.contains("expected a number above 0 with mm, cm or in"), "{error}");
        }
    }
}
