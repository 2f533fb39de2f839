//! The generators by name, with named numbers as parameters: lengths in any unit, angles in degrees, yes as 1 and no
//! as 0.

use super::{
    BirdBase, Crane, CurvedPleat, Degree4, Fan, Hypar, Kresling, Miura, SingleCrease, SquareTwist, Strip, Waterbomb,
    WaterbombVertex, Yoshimura,
};
use crate::error::Error;
use crate::pattern::CreasePattern;
use crate::rigid::Degree4Mode;

/// A number that a generator takes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// Its value where none is given.
    pub default: f64,
    /// Its meaning, unit and range.
    pub meaning: &'static str,
}

/// A generator.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Entry {
    /// Its name.
    pub name: &'static str,
    /// The pattern that it makes, in one line.
    pub summary: &'static str,
    /// Its parameters.
    pub parameters: &'static [Parameter],
    make: fn(&Values<'_>) -> Result<CreasePattern, Error>,
}

/// Names of all generators.
#[must_use]
pub fn names() -> &'static [&'static str] {
    const NAMES: [&str; ENTRIES.len()] = {
        let mut names = [""; ENTRIES.len()];
        let mut i = 0;
        while i < names.len() {
            names[i] = ENTRIES[i].name;
            i += 1;
        }
        names
    };
    &NAMES
}

/// All generators.
#[must_use]
pub fn entries() -> &'static [Entry] {
    ENTRIES
}

/// The pattern that the generator `name` makes with `parameters`; those not named have their defaults, and the last of
/// two of one name counts.
///
/// # Errors
/// If there is no generator or parameter of a name, or a value makes no sheet.
pub fn generate(name: &str, parameters: &[(String, f64)]) -> Result<CreasePattern, Error> {
    let entry = ENTRIES.iter().find(|entry| entry.name == name).ok_or_else(|| {
        Error::invalid(
            format!("pattern {name}"),
            "there is none of this name",
            format!("one of {}", names().join(", ")),
        )
    })?;
    for (given, _) in parameters {
        if !entry.parameters.iter().any(|known| known.name == given) {
            let known: Vec<&str> = entry.parameters.iter().map(|known| known.name).collect();
            return Err(Error::invalid(
                format!("parameter {given}"),
                format!("{name} has none of this name"),
                format!("one of {}", known.join(", ")),
            ));
        }
    }
    (entry.make)(&Values { entry, given: parameters })
}

/// The parameters given to a generator, completed by its defaults.
struct Values<'a> {
    entry: &'a Entry,
    given: &'a [(String, f64)],
}

impl Values<'_> {
    fn number(&self, name: &str) -> f64 {
        let given = self.given.iter().rev().find(|(given, _)| given == name).map(|(_, value)| *value);
        let default = || self.entry.parameters.iter().find(|known| known.name == name).map(|known| known.default);
        given.or_else(default).unwrap_or(f64::NAN)
    }

    /// In radians.
    fn angle(&self, name: &str) -> f64 {
        self.number(name).to_radians()
    }

    fn count(&self, name: &str) -> Result<usize, Error> {
        let value = self.number(name);
        if value >= 0.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0 {
            Ok(value as usize)
        } else {
            Err(Error::invalid(format!("parameter {name}"), format!("is {value}"), "a whole number from 0 to 2^32 - 1"))
        }
    }

    fn flag(&self, name: &str) -> Result<bool, Error> {
        match self.number(name) {
            0.0 => Ok(false),
            1.0 => Ok(true),
            value => Err(Error::invalid(format!("parameter {name}"), format!("is {value}"), "0 or 1")),
        }
    }
}

const fn parameter(name: &'static str, default: f64, meaning: &'static str) -> Parameter {
    Parameter { name, default, meaning }
}

const ANGLE: Parameter = parameter("angle", 180.0, "how far every crease folds, above 0 to 180 degrees");
const DRIVEN: Parameter =
    parameter("driven", 0.0, "1 to drive the edges to the angles that they have at rest, 0 not to");

const YOSHIMURA: [Parameter; 4] = [
    parameter("columns", 6.0, "diamonds around, at least 3"),
    parameter("rows", 6.0, "lines of triangles, half a diamond high each"),
    parameter("c", 0.5, "half the width of a diamond"),
    parameter("alpha", 30.0, "base angle of a diamond, above 90/columns and below 90 degrees"),
];
const KRESLING: [Parameter; 5] = [
    parameter("n", 6.0, "sides of the polygons, at least 3"),
    parameter("rows", 3.0, "storeys"),
    parameter("radius", 1.0, "circumradius of the polygons when folded"),
    parameter("height", 1.8, "height of a storey when folded"),
    parameter("twist", 20.0, "turn of a storey when folded, between -180 and 180 degrees"),
];
const YOSHIMURA_RING: [Parameter; 5] = [YOSHIMURA[0], YOSHIMURA[1], YOSHIMURA[2], YOSHIMURA[3], DRIVEN];
const KRESLING_RING: [Parameter; 6] = [KRESLING[0], KRESLING[1], KRESLING[2], KRESLING[3], KRESLING[4], DRIVEN];

fn yoshimura(v: &Values<'_>) -> Result<Yoshimura, Error> {
    Ok(Yoshimura { columns: v.count("columns")?, rows: v.count("rows")?, c: v.number("c"), alpha: v.angle("alpha") })
}

fn kresling(v: &Values<'_>) -> Result<Kresling, Error> {
    let [radius, height] = ["radius", "height"].map(|name| v.number(name));
    Ok(Kresling { n: v.count("n")?, rows: v.count("rows")?, radius, height, twist: v.angle("twist") })
}

const ENTRIES: &[Entry] = &[
    Entry {
        name: "single-crease",
        summary: "two triangles with one crease",
        parameters: &[
            parameter("length", 1.0, "length of the crease"),
            parameter("height", 1.0, "height of each triangle over the crease"),
            parameter("angle", 180.0, "fold angle, valley positive, -180 to 180 degrees"),
        ],
        make: |v| {
            SingleCrease { length: v.number("length"), height: v.number("height"), angle: v.angle("angle") }.pattern()
        },
    },
    Entry {
        name: "degree-4",
        summary: "a flat-foldable vertex of degree 4",
        parameters: &[
            parameter("a", 60.0, "first sector, between 0 and 180 degrees"),
            parameter("b", 80.0, "second sector, between 0 and 180 degrees; the others are 180 - a and 180 - b"),
            parameter("mode", 0.0, "0: creases 1 and 3 fold alike; 1: creases 2 and 4"),
            parameter("angle", 90.0, "how far those two fold, -180 to 180 degrees"),
            parameter("driven_only", 0.0, "1 to drive one of those two alone and leave the other creases free"),
            parameter("radius", 1.0, "length of the creases"),
        ],
        make: |v| {
            let mode = if v.flag("mode")? { Degree4Mode::B } else { Degree4Mode::A };
            let [a, b, angle] = ["a", "b", "angle"].map(|name| v.angle(name));
            let (driven_only, radius) = (v.flag("driven_only")?, v.number("radius"));
            Degree4 { a, b, mode, angle, driven_only, radius }.pattern()
        },
    },
    Entry {
        name: "miura",
        summary: "Miura-ori: parallelograms in zigzag columns",
        parameters: &[
            parameter("columns", 10.0, "panels along the zigzag creases"),
            parameter("rows", 10.0, "panels along the straight creases"),
            parameter("a", 1.0, "side of a panel along the straight creases"),
            parameter("b", 1.0, "side of a panel along the zigzag creases"),
            parameter("gamma", 60.0, "acute corner of a panel, between 0 and 90 degrees"),
            parameter("theta", 90.0, "inclination of the panels when folded, above 0 to 90 degrees (folded flat)"),
        ],
        make: |v| {
            let ([a, b], [gamma, theta]) =
                (["a", "b"].map(|name| v.number(name)), ["gamma", "theta"].map(|name| v.angle(name)));
            Miura { columns: v.count("columns")?, rows: v.count("rows")?, a, b, gamma, theta }.pattern()
        },
    },
    Entry {
        name: "waterbomb",
        summary: "rows of waterbomb bases, shifted by half against each other",
        parameters: &[
            parameter("columns", 6.0, "squares in a row"),
            parameter("rows", 6.0, "rows of squares"),
            parameter("size", 1.0, "side of a square"),
            ANGLE,
        ],
        make: |v| {
            let (columns, rows) = (v.count("columns")?, v.count("rows")?);
            Waterbomb { columns, rows, size: v.number("size"), angle: v.angle("angle") }.pattern()
        },
    },
    Entry {
        name: "waterbomb-vertex",
        summary: "one vertex of 2n equal sectors, alternately valley and mountain",
        parameters: &[
            parameter("n", 4.0, "half the number of creases, at least 3"),
            parameter(
                "polar",
                70.0,
                "angle of the valleys with the axis when folded, above 180/n and below 180 degrees",
            ),
            parameter("radius", 1.0, "length of the creases"),
        ],
        make: |v| WaterbombVertex { n: v.count("n")?, polar: v.angle("polar"), radius: v.number("radius") }.pattern(),
    },
    Entry {
        name: "yoshimura",
        summary: "a flat strip of diamonds that curls into a cylinder",
        parameters: &YOSHIMURA,
        make: |v| yoshimura(v)?.pattern(),
    },
    Entry {
        name: "yoshimura-ring",
        summary: "the closed cylinder of diamonds, at rest in space",
        parameters: &YOSHIMURA_RING,
        make: |v| yoshimura(v)?.ring(v.flag("driven")?),
    },
    Entry {
        name: "kresling",
        summary: "a flat strip of triangles that curls into a twisted cylinder",
        parameters: &KRESLING,
        make: |v| kresling(v)?.pattern(),
    },
    Entry {
        name: "kresling-ring",
        summary: "the closed twisted cylinder, at rest in space; it has two stable states",
        parameters: &KRESLING_RING,
        make: |v| kresling(v)?.ring(v.flag("driven")?),
    },
    Entry {
        name: "square-twist",
        summary: "squares that turn as their pleats close",
        parameters: &[
            parameter("columns", 1.0, "squares along x"),
            parameter("rows", 1.0, "squares along y"),
            parameter("side", 1.0, "side of a twisted square"),
            parameter("pleat", 45.0, "angle between sides and pleats, between 0 and 90 degrees"),
            parameter("cell", 4.0, "side of the paper that each twist takes"),
            ANGLE,
        ],
        make: |v| {
            let ([side, cell], [pleat, angle]) =
                (["side", "cell"].map(|name| v.number(name)), ["pleat", "angle"].map(|name| v.angle(name)));
            SquareTwist { columns: v.count("columns")?, rows: v.count("rows")?, side, pleat, cell, angle }.pattern()
        },
    },
    Entry {
        name: "hypar",
        summary: "concentric pleated squares, which fold into a saddle",
        parameters: &[
            parameter("rings", 8.0, "squares, the border among them"),
            parameter("size", 2.0, "side of the sheet"),
            parameter("angle", 90.0, "how far the creases fold, above 0 to 180 degrees"),
            parameter("free_facets", 0.0, "1 for facet diagonals without springs"),
            parameter(
                "alternating",
                1.0,
                "0 for facet diagonals that all turn the same way: its corners stay in a plane",
            ),
        ],
        make: |v| {
            let (rings, size, angle) = (v.count("rings")?, v.number("size"), v.angle("angle"));
            let (free_facets, alternating) = (v.flag("free_facets")?, v.flag("alternating")?);
            Hypar { rings, size, angle, free_facets, alternating }.pattern()
        },
    },
    Entry {
        name: "curved-pleat",
        summary: "a ring, or part of one, pleated along concentric arcs",
        parameters: &[
            parameter("creases", 3.0, "arcs that fold"),
            parameter("segments", 48.0, "straight pieces of each arc"),
            parameter("inner", 0.5, "radius of the inner border"),
            parameter("width", 0.25, "distance between arcs"),
            parameter("sweep", 360.0, "angle that the arcs span, above 0 to 360 degrees (closed)"),
            parameter("angle", 90.0, "how far the arcs fold, above 0 to 180 degrees"),
        ],
        make: |v| {
            let ([inner, width], [sweep, angle]) =
                (["inner", "width"].map(|name| v.number(name)), ["sweep", "angle"].map(|name| v.angle(name)));
            let (creases, segments) = (v.count("creases")?, v.count("segments")?);
            CurvedPleat { creases, segments, inner, width, sweep, angle }.pattern()
        },
    },
    Entry {
        name: "bird-base",
        summary: "the traditional bird base",
        parameters: &[
            parameter("size", 1.0, "side of the square"),
            ANGLE,
            parameter("narrowed", 0.0, "1 to fold the outer edges of the legs to their middle, 0 not to"),
        ],
        make: |v| {
            let (size, angle, narrowed) = (v.number("size"), v.angle("angle"), v.flag("narrowed")?);
            BirdBase { size, angle, narrowed }.pattern()
        },
    },
    Entry {
        name: "crane",
        summary: "the traditional crane",
        parameters: &[
            parameter("size", 1.0, "side of the square"),
            parameter("neck", 30.0, "angle of the neck with straight up, above 0 to 90 degrees"),
            parameter("tail", 40.0, "angle of the tail with straight up, above 0 to 90 degrees"),
            parameter("head_length", 0.3, "length of the head as a share of the neck's, 0.1 to 0.8"),
            parameter("head", 70.0, "angle between head and neck, above 0 to 120 degrees"),
            parameter("wing_length", 0.6, "part of a wing beyond its fold, as a share of the flap, 0.1 to 0.9"),
            parameter("wing", 90.0, "how far the wings fold down, above 0 to 180 degrees"),
        ],
        make: |v| {
            let [neck, tail, head, wing] = ["neck", "tail", "head", "wing"].map(|name| v.angle(name));
            let [size, head_length, wing_length] = ["size", "head_length", "wing_length"].map(|name| v.number(name));
            Crane { size, neck, tail, head_length, head, wing_length, wing }.pattern()
        },
    },
    Entry {
        name: "strip",
        summary: "an accordion of rectangles",
        parameters: &[
            parameter("panels", 10.0, "rectangles"),
            parameter("length", 1.0, "length of a rectangle along the strip"),
            parameter("width", 1.0, "width of the strip"),
            parameter("angle", 180.0, "fold angle of the first crease, the next ones alternate; -180 to 180 degrees"),
        ],
        make: |v| {
            let [length, width] = ["length", "width"].map(|name| v.number(name));
            Strip { panels: v.count("panels")?, length, width, angle: v.angle("angle") }.pattern()
        },
    },
    Entry {
        name: "fan",
        summary: "a polygon with a crease from the middle to each corner",
        parameters: &[
            parameter("valence", 16.0, "creases, an even number from 4"),
            parameter("radius", 1.0, "length of the creases"),
            parameter("angle", 90.0, "fold angle of the first crease, the next ones alternate; -180 to 180 degrees"),
        ],
        make: |v| Fan { valence: v.count("valence")?, radius: v.number("radius"), angle: v.angle("angle") }.pattern(),
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;

    #[test]
    fn defaults_are_those_of_the_types() {
        let made = [
            SingleCrease::default().pattern(),
            Degree4::default().pattern(),
            Miura::default().pattern(),
            Waterbomb::default().pattern(),
            WaterbombVertex::default().pattern(),
            Yoshimura::default().pattern(),
            Yoshimura::default().ring(false),
            Kresling::default().pattern(),
            Kresling::default().ring(false),
            SquareTwist::default().pattern(),
            Hypar::default().pattern(),
            CurvedPleat::default().pattern(),
            BirdBase::default().pattern(),
            Crane::default().pattern(),
            Strip::default().pattern(),
            Fan::default().pattern(),
        ];
        assert_eq!(made.len(), names().len());
        for (name, made) in names().iter().zip(made) {
            let pattern = generate(name, &[]).unwrap();
            assert_eq!(pattern, made.unwrap(), "{name}");
            check::sound(&pattern, if name.ends_with("-ring") || *name == "curved-pleat" { 0 } else { 1 });
        }
    }

    #[test]
    fn every_parameter_changes_the_pattern() {
        for entry in entries() {
            let plain = generate(entry.name, &[]).unwrap();
            for known in entry.parameters {
                let value = match known.default {
                    0.0 => 1.0,
                    _ if known.name == "valence" => 8.0,
                    _ if known.name == "alternating" => 0.0,
                    default if default.fract() != 0.0 => default * 0.9,
                    default if default > 10.0 => default - 1.0,
                    default => default + 1.0,
                };
                let other = generate(entry.name, &[(known.name.into(), 7.0), (known.name.into(), value)]).unwrap();
                assert_ne!(other, plain, "{} {}", entry.name, known.name);
            }
        }
    }

    #[test]
    fn no_value_panics() {
        let values = [
            f64::NAN,
            f64::INFINITY,
            -f64::INFINITY,
            -1.0,
            -0.0,
            0.0,
            0.5,
            1e-300,
            1e-60,
            1e60,
            1e300,
            4294967295.0,
            4e9,
        ];
        for entry in entries() {
            for known in entry.parameters {
                for value in values {
                    match generate(entry.name, &[(known.name.into(), value)]) {
                        Ok(made) => assert!(made.vertices.iter().all(|p| p.is_finite()), "{} {value}", known.name),
                        Err(error) => assert!(error.to_string().starts_with("parameter "), "{error}"),
                    }
                }
            }
        }
    }

    #[test]
    fn wrong_names_are_answered_with_the_right_ones() {
        let error = generate("kranich", &[]).unwrap_err().to_string();
        assert!(error.starts_with("pattern kranich: ") && error.contains("single-crease, degree-4, miura"), "{error}");
        let error = generate("hypar", &[("ring".into(), 3.0)]).unwrap_err().to_string();
        assert_eq!(
            error,
            "parameter ring: hypar has none of this name; expected one of rings, size, angle, free_facets, alternating"
        );
        let error = generate("hypar", &[("rings".into(), 2.5)]).unwrap_err().to_string();
        assert!(error.starts_with("parameter rings: is 2.5; expected a whole number"), "{error}");
        let error = generate("hypar", &[("free_facets".into(), 2.0)]).unwrap_err().to_string();
        assert_eq!(error, "parameter free_facets: is 2; expected 0 or 1");
    }
}
