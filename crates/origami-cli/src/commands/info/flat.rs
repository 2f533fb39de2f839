//! What can be said of a pattern's flat folding. docs/REPORT.md documents the keys.

use std::fmt::Write;

use origami::CreasePattern;
use origami::flat::{Fault, FlatFoldability, VertexFault};
use origami::ids::VertexId;
use serde::Serialize;

use crate::numbers::{count, short};

/// How many places of a kind a person is told.
const NAMED: usize = 5;
/// Degrees and radii below this are those of rounding, which are not the same on every machine.
const ROUNDING: f64 = 1e-9;
/// A sheet that misses itself by more than this, in radii, does not close.
const CLOSED: f64 = 1e-3;

/// All of it, of every place.
#[derive(Debug, Serialize)]
pub(super) struct FlatFacts {
    applies: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    why_not: Option<&'static str>,
    folded: usize,
    partial: usize,
    free: usize,
    checked: usize,
    unchecked: usize,
    faults: Vec<FaultFacts>,
    farthest_from_kawasaki: Option<Off>,
    open_ends: Vec<OpenEndFacts>,
    closure: Option<ClosureFacts>,
    /// The longest side of the sheet.
    #[serde(skip)]
    size: f64,
}

/// A rule that a vertex breaks.
#[derive(Debug, Serialize)]
struct FaultFacts {
    rule: &'static str,
    vertex: u32,
    at: [f64; 2],
    creases: Vec<u32>,
    #[serde(flatten)]
    what: What,
    #[serde(skip)]
    size: f64,
}

/// The numbers of a fault.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum What {
    Count { count: usize },
    Off { off_deg: f64 },
    Letters { mountains: usize, valleys: usize },
    Sectors { sectors: usize, mountains: usize, valleys: usize },
}

#[derive(Debug, Serialize)]
struct Off {
    vertex: u32,
    at: [f64; 2],
    off_deg: f64,
}

#[derive(Debug, Serialize)]
struct OpenEndFacts {
    vertex: u32,
    at: [f64; 2],
    crease: u32,
    face: u32,
    nearest: Option<Nearest>,
}

#[derive(Debug, Serialize)]
struct Nearest {
    edge: u32,
    distance: f64,
}

#[derive(Debug, Serialize)]
struct ClosureFacts {
    spread: f64,
    vertex: Option<u32>,
    at: Option<[f64; 2]>,
}

impl FlatFacts {
    pub(super) fn of(pattern: &CreasePattern) -> Self {
        let flat = FlatFoldability::of(pattern);
        let at = |vertex: VertexId| {
            let place = pattern.vertices[vertex.index()];
            [place.x, place.y]
        };
        let fault = |fault: &VertexFault| FaultFacts {
            rule: fault.fault.rule(),
            vertex: fault.vertex.0,
            at: at(fault.vertex),
            creases: fault.creases.iter().map(|crease| crease.0).collect(),
            what: What::of(fault.fault, fault.creases.len()),
            size: fault.fault.size(),
        };
        let why_not = match &flat {
            FlatFoldability { flat_sheet: false, .. } => Some("the sheet is not flat"),
            FlatFoldability { folded: 0, .. } => Some("no crease is asked to fold by 180 degrees"),
            _ => None,
        };
        Self {
            applies: flat.applies(),
            why_not,
            folded: flat.folded,
            partial: flat.partial,
            free: flat.free,
            checked: flat.checked,
            unchecked: flat.unchecked,
            faults: flat.faults.iter().map(fault).collect(),
            farthest_from_kawasaki: flat.farthest_from_kawasaki.map(|(vertex, off)| Off {
                vertex: vertex.0,
                at: at(vertex),
                off_deg: off.to_degrees(),
            }),
            open_ends: { flat.open_ends.iter() }
                .map(|end| OpenEndFacts {
                    vertex: end.vertex.0,
                    at: at(end.vertex),
                    crease: end.crease.0,
                    face: end.face.0,
                    nearest: end.nearest.map(|(edge, distance)| Nearest { edge: edge.0, distance }),
                })
                .collect(),
            closure: flat.closure.map(|closure| ClosureFacts {
                spread: closure.spread,
                vertex: closure.vertex.map(|vertex| vertex.0),
                at: closure.vertex.map(at),
            }),
            size: pattern.size(),
        }
    }

    /// Lines for a person: one about the whole, and the worst places of each kind.
    pub(super) fn tell(&self, text: &mut String) -> std::fmt::Result {
        match self.why_not {
            Some(why) => writeln!(text, "  flat        not asked for: {why}")?,
            None => {
                let vertices = count(self.checked, "inner vertex", "inner vertices");
                write!(text, "  flat        ")?;
                match (self.checked, self.faulty_vertices()) {
                    (0, _) => write!(text, "no inner vertex to check")?,
                    (_, 0) => write!(text, "{vertices} checked, all obey the rules of flat folding")?,
                    (_, faulty) => {
                        write!(
                            text,
                            "{vertices} checked, {} a rule of flat folding",
                            count(faulty, "breaks", "break")
                        )?;
                    }
                }
                if let Some(Off { off_deg, vertex, .. }) =
                    self.farthest_from_kawasaki.as_ref().filter(|off| self.faults.is_empty() && off.off_deg > ROUNDING)
                {
                    write!(text, " (at most {} degrees off, vertex {vertex})", short(*off_deg))?;
                }
                if self.unchecked > 0 {
                    write!(text, "; {} not checked, with creases of other angles", self.unchecked)?;
                }
                writeln!(text)?;
                self.tell_closure(text)?;
            }
        }
        let mut heading = "fault";
        for rule in ["parity", "kawasaki", "maekawa", "big-little-big"] {
            self.tell_rule(text, rule, &mut heading)?;
        }
        self.tell_open_ends(text)
    }

    /// A place with six digits; what is nothing beside the sheet is 0.
    fn place(&self, at: [f64; 2]) -> String {
        let [x, y] = at.map(|x| six(if x.abs() < 1e-12 * self.size { 0.0 } else { x }));
        format!("({x}, {y})")
    }

    fn faulty_vertices(&self) -> usize {
        // They come by vertex.
        let mut vertices: Vec<u32> = self.faults.iter().map(|fault| fault.vertex).collect();
        vertices.dedup();
        vertices.len()
    }

    fn tell_closure(&self, text: &mut String) -> std::fmt::Result {
        match &self.closure {
            None => writeln!(text, "  closure     not known: not all creases are asked to fold by 180 degrees"),
            Some(ClosureFacts { spread, vertex: Some(vertex), at: Some(at) }) if *spread > CLOSED => writeln!(
                text,
                "  closure     reflected face by face, the sheet misses itself by {} of its radius, most at vertex {vertex} {}",
                short(*spread),
                self.place(*at)
            ),
            Some(ClosureFacts { spread, .. }) if *spread < ROUNDING => {
                writeln!(text, "  closure     reflected face by face, the sheet closes")
            }
            Some(ClosureFacts { spread, .. }) => {
                writeln!(
                    text,
                    "  closure     reflected face by face, the sheet closes to {} of its radius",
                    short(*spread)
                )
            }
        }
    }

    /// The worst places first; only the very first line has a heading.
    fn tell_rule(&self, text: &mut String, rule: &str, heading: &mut &str) -> std::fmt::Result {
        let mut broken: Vec<&FaultFacts> = self.faults.iter().filter(|fault| fault.rule == rule).collect();
        broken.sort_by(|a, b| b.size.total_cmp(&a.size));
        for fault in broken.iter().take(NAMED) {
            let creases: Vec<String> = fault.creases.iter().map(u32::to_string).collect();
            let place = self.place(fault.at);
            write!(text, "  {:<11} {rule}: vertex {} {place}: {}", std::mem::take(heading), fault.vertex, fault.what)?;
            writeln!(text, ", edges {}", creases.join(" "))?;
        }
        more(text, broken.len())
    }

    fn tell_open_ends(&self, text: &mut String) -> std::fmt::Result {
        for (i, end) in self.open_ends.iter().take(NAMED).enumerate() {
            let heading = if i == 0 { "open end" } else { "" };
            write!(
                text,
                "  {heading:<11} edge {} ends inside face {} at vertex {} {}",
                end.crease,
                end.face,
                end.vertex,
                self.place(end.at)
            )?;
            if let Some(Nearest { edge, distance }) = end.nearest {
                write!(text, ", {} from edge {edge}", short(distance))?;
            }
            writeln!(text)?;
        }
        more(text, self.open_ends.len())
    }
}

impl What {
    fn of(fault: Fault, creases: usize) -> Self {
        match fault {
            Fault::Kawasaki { off } => Self::Off { off_deg: off.to_degrees() },
            Fault::Maekawa { mountains, valleys } => Self::Letters { mountains, valleys },
            Fault::BigLittleBig { sectors, mountains, valleys } => Self::Sectors { sectors, mountains, valleys },
            _ => Self::Count { count: creases },
        }
    }
}

impl std::fmt::Display for What {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Count { count } => write!(f, "{count} creases, an odd number"),
            Self::Off { off_deg } => write!(f, "every second angle adds up to {} degrees off 180", short(*off_deg)),
            Self::Letters { mountains, valleys } => write!(f, "M {mountains}, V {valleys}, expected a difference of 2"),
            Self::Sectors { sectors: 1, .. } => write!(f, "both sides of its smallest angle have one letter"),
            Self::Sectors { sectors, mountains, valleys } => {
                write!(f, "M {mountains}, V {valleys} around {sectors} equal small angles")
            }
        }
    }
}

/// How many places are left out.
fn more(text: &mut String, all: usize) -> std::fmt::Result {
    match all.saturating_sub(NAMED) {
        0 => Ok(()),
        more => writeln!(text, "  {:<11} and {more} more; --json has all", ""),
    }
}

fn six(x: f64) -> String {
    if x == 0.0 || !(1e-4..1e9).contains(&x.abs()) {
        return if x == 0.0 { "0".to_owned() } else { format!("{x:.5e}") };
    }
    #[expect(clippy::cast_possible_truncation, reason = "from -4 to 9")]
    let decimals = (5 - x.abs().log10().floor() as i32).max(0) as usize;
    let text = format!("{x:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_have_six_digits_and_no_zeros_after_them() {
        assert_eq!([0.1 + 0.2, -120.0, 1.0 / 3.0].map(six), ["0.3", "-120", "0.333333"]);
        assert_eq!([123_456.7, 1e-7, 0.0].map(six), ["123457", "1.00000e-7", "0"]);
    }
}
