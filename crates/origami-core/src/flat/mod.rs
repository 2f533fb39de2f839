//! Whether a crease pattern can lie flat: what its vertices must obey, creases that end inside a face, and the flat-folded
//! sheet itself, by reflecting its faces.
//!
//! The rules at a vertex are necessary, and sufficient for that vertex alone only up to four creases; that the whole sheet
//! closes says nothing of layers, which may still be in each other's way. T. C. Hull, Origametry (Cambridge, 2020),
//! chapters 5 and 6, has the proofs.

mod big_little_big;
#[cfg(test)]
mod brute_force;
mod corners;
mod kawasaki;
mod lay;
mod maekawa;
mod open_ends;
mod reflect;
mod rings;
mod rules;

pub(crate) use lay::{Hinge, lay};
pub use open_ends::{OpenEnd, open_ends};
pub use reflect::{Closure, Reflected};
pub use rules::{Fault, VertexFault};

use std::f64::consts::PI;

use crate::ids::VertexId;
use crate::pattern::{Assignment, CreasePattern, PatternEdge};

/// Angles that differ by less than this, in radians, are equal: a tenth of a degree. The least exact of 103 designers' files,
/// written with few digits, is off by 0.007 at its worst vertex.
pub const ANGLE_TOLERANCE: f64 = 0.1 * PI / 180.0;

/// What an edge does in a sheet that is folded flat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// It folds by half a turn.
    Folded { valley: bool },
    /// It stays flat.
    Flat,
    /// It is asked for another angle.
    Partial,
    /// Nobody says what it does.
    Free,
    /// The rim of the paper.
    Rim,
}

impl Role {
    fn of(edge: &PatternEdge) -> Self {
        match (edge.assignment, edge.fold_angle) {
            (Assignment::Boundary, _) => Self::Rim,
            (Assignment::Flat | Assignment::Join, None) => Self::Flat,
            (_, None) => Self::Free,
            (_, Some(angle)) if angle.abs() < ANGLE_TOLERANCE => Self::Flat,
            (_, Some(angle)) if (angle.abs() - PI).abs() < ANGLE_TOLERANCE => Self::Folded { valley: angle > 0.0 },
            (_, Some(_)) => Self::Partial,
        }
    }
}

/// What can be said of the flat folding of a pattern without folding it.
///
/// ```
/// use origami_core::flat::FlatFoldability;
/// use origami_core::generate::BirdBase;
///
/// let bird = BirdBase::default().pattern()?;
/// let flat = FlatFoldability::of(&bird);
/// assert!(flat.applies() && flat.faults.is_empty() && flat.open_ends.is_empty());
/// assert!(flat.closure.expect("all creases fold flat").spread < 1e-9, "of the radius");
/// # Ok::<(), origami_core::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FlatFoldability {
    /// Whether the sheet lies in a plane of constant height.
    pub flat_sheet: bool,
    /// Creases that are asked to fold by half a turn.
    pub folded: usize,
    /// Creases that are asked for another angle.
    pub partial: usize,
    /// Creases of which no angle is asked.
    pub free: usize,
    /// Inner vertices that were checked: all their creases fold by half a turn or stay flat, and two fold at least.
    pub checked: usize,
    /// Inner vertices with a crease that is asked for another angle or for none, of which nothing is said.
    pub unchecked: usize,
    /// Rules that vertices break, by vertex.
    pub faults: Vec<VertexFault>,
    /// The vertex that is farthest from Kawasaki's rule, and by how much, in radians; however little that is.
    pub farthest_from_kawasaki: Option<(VertexId, f64)>,
    /// Creases that end inside a face.
    pub open_ends: Vec<OpenEnd>,
    /// How well the sheet closes when its faces are reflected; `None` where a crease is asked for another angle or for none.
    pub closure: Option<Closure>,
}

impl FlatFoldability {
    /// Looks at all vertices, and reflects the sheet: in linear time but for the sorting of each vertex's neighbours.
    #[must_use]
    pub fn of(pattern: &CreasePattern) -> Self {
        let mut found = Self { flat_sheet: pattern.is_flat(), open_ends: open_ends(pattern), ..Self::default() };
        for edge in pattern.edges.iter().filter(|edge| edge.alias_of.is_none()) {
            match Role::of(edge) {
                Role::Folded { .. } => found.folded += 1,
                Role::Partial => found.partial += 1,
                Role::Free => found.free += 1,
                Role::Flat | Role::Rim => {}
            }
        }
        if !found.flat_sheet {
            return found;
        }
        for ring in rings::rings(pattern) {
            match rules::Vertex::of(pattern, &ring) {
                // The end of a lone crease is an open end.
                Some(vertex) if vertex.creases() < 2 => {}
                Some(vertex) => {
                    found.checked += 1;
                    let off = vertex.kawasaki();
                    if let Some(off) =
                        off.filter(|off| found.farthest_from_kawasaki.is_none_or(|(_, most)| *off > most))
                    {
                        found.farthest_from_kawasaki = Some((vertex.id, off));
                    }
                    vertex.judge(&mut found.faults);
                }
                None => found.unchecked += 1,
            }
        }
        found.closure = pattern.reflected().map(|reflected| reflected.closure);
        found
    }

    /// Whether the pattern asks to be folded flat: it is flat, and a crease of it folds by half a turn.
    #[must_use]
    pub fn applies(&self) -> bool {
        self.flat_sheet && self.folded > 0
    }
}
