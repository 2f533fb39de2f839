//! One vertex before its judges.

use super::rings::Ring;
use super::{ANGLE_TOLERANCE, Role, big_little_big, kawasaki, maekawa};
use crate::ids::{EdgeId, VertexId};
use crate::pattern::CreasePattern;

/// A rule of flat folding that a vertex breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fault {
    /// An odd number of creases: they cannot fold flat, whatever their angles.
    Parity {
        /// How many there are.
        creases: usize,
    },
    /// Kawasaki's rule: every second sector does not add up to half a turn.
    Kawasaki {
        /// By how much it misses half a turn, in radians.
        off: f64,
    },
    /// Maekawa's rule: mountains and valleys do not differ by two.
    Maekawa {
        /// Mountains at the vertex.
        mountains: usize,
        /// Valleys at the vertex.
        valleys: usize,
    },
    /// The big-little-big rule, of one or more equal sectors between larger ones: the mountains and valleys on their sides
    /// are not as many (an odd number of sectors) or do not differ by one (an even number).
    BigLittleBig {
        /// Equal sectors in a row.
        sectors: usize,
        /// Mountains on their sides.
        mountains: usize,
        /// Valleys on their sides.
        valleys: usize,
    },
}

impl Fault {
    /// The rule's name.
    #[must_use]
    pub const fn rule(self) -> &'static str {
        match self {
            Self::Parity { .. } => "parity",
            Self::Kawasaki { .. } => "kawasaki",
            Self::Maekawa { .. } => "maekawa",
            Self::BigLittleBig { .. } => "big-little-big",
        }
    }

    /// How badly it is broken, to put the worst first: radians for [`Fault::Kawasaki`], creases that would have to change
    /// for the others. Comparable within one rule only.
    #[must_use]
    pub fn size(self) -> f64 {
        match self {
            Self::Kawasaki { off } => off,
            Self::Parity { .. } => 1.0,
            Self::Maekawa { mountains, valleys } => (mountains.abs_diff(valleys) as f64 - 2.0).abs(),
            Self::BigLittleBig { sectors, mountains, valleys } => {
                let wanted = f64::from(u8::from(sectors.is_multiple_of(2)));
                mountains.abs_diff(valleys) as f64 - wanted
            }
        }
    }
}

/// A rule that is broken, and where.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct VertexFault {
    /// The vertex.
    pub vertex: VertexId,
    /// The creases that break it, counterclockwise: of the big-little-big rule those around the small sectors, of the others
    /// all that fold.
    pub creases: Vec<EdgeId>,
    /// What is wrong.
    pub fault: Fault,
}

/// The creases of a vertex that fold, each with the sector that follows it; those that stay flat are left out.
pub(super) struct Vertex {
    pub(super) id: VertexId,
    creases: Vec<EdgeId>,
    valleys: Vec<bool>,
    sectors: Vec<f64>,
}

impl Vertex {
    /// `None` where a crease is asked for another angle than half a turn or none, or for nothing.
    pub(super) fn of(pattern: &CreasePattern, ring: &Ring) -> Option<Self> {
        let (mut creases, mut valleys, mut sectors) = (Vec::new(), Vec::new(), Vec::new());
        let mut before_the_first = 0.0;
        for (edge, sector) in &ring.spokes {
            match Role::of(&pattern.edges[edge.index()]) {
                Role::Folded { valley } => {
                    creases.push(*edge);
                    valleys.push(valley);
                    sectors.push(*sector);
                }
                Role::Flat => match sectors.last_mut() {
                    Some(last) => *last += sector,
                    None => before_the_first += sector,
                },
                Role::Partial | Role::Free | Role::Rim => return None,
            }
        }
        if let Some(last) = sectors.last_mut() {
            *last += before_the_first;
        }
        Some(Self { id: ring.vertex, creases, valleys, sectors })
    }

    /// How many creases fold here.
    pub(super) fn creases(&self) -> usize {
        self.creases.len()
    }

    /// By how much Kawasaki's rule is missed, in radians; `None` for an odd number of creases.
    pub(super) fn kawasaki(&self) -> Option<f64> {
        kawasaki::residual(&self.sectors)
    }

    /// Adds the rules that it breaks.
    pub(super) fn judge(&self, faults: &mut Vec<VertexFault>) {
        let mut add = |creases: Vec<EdgeId>, fault| faults.push(VertexFault { vertex: self.id, creases, fault });
        let count = self.creases.len();
        match self.kawasaki() {
            None => add(self.creases.clone(), Fault::Parity { creases: count }),
            Some(off) if off > ANGLE_TOLERANCE => add(self.creases.clone(), Fault::Kawasaki { off }),
            Some(_) => {}
        }
        let letters = maekawa::counts(self.valleys.iter().copied());
        // Of an odd number it would only repeat that.
        if count.is_multiple_of(2) && !maekawa::differ_by(letters, 2) {
            let [mountains, valleys] = letters;
            add(self.creases.clone(), Fault::Maekawa { mountains, valleys });
        }
        for (run, [mountains, valleys]) in big_little_big::broken(&self.sectors, &self.valleys) {
            let creases = run.creases(count).map(|crease| self.creases[crease]).collect();
            add(creases, Fault::BigLittleBig { sectors: run.sectors, mountains, valleys });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::brute_force::{equal_sectors, flat_foldings, kawasaki_sectors};
    use super::*;

    /// Whether a vertex of these sectors breaks no rule with these letters.
    fn obeys(sectors: &[f64], valleys: &[bool]) -> bool {
        let creases = (0..sectors.len()).map(EdgeId::new).collect();
        let vertex = Vertex { id: VertexId(0), creases, valleys: valleys.to_vec(), sectors: sectors.to_vec() };
        let mut faults = Vec::new();
        vertex.judge(&mut faults);
        faults.is_empty()
    }

    fn all_letters(creases: usize) -> impl Iterator<Item = Vec<bool>> {
        (0..1_u32 << creases).map(move |bits| (0..creases).map(|i| bits >> i & 1 == 1).collect())
    }

    #[test]
    fn four_creases_fold_flat_just_where_no_rule_is_broken() {
        for seed in 0..40 {
            let sectors = kawasaki_sectors(4, seed);
            let mut count = 0;
            for valleys in all_letters(4) {
                let folds = flat_foldings(&sectors, &valleys) > 0;
                assert_eq!(obeys(&sectors, &valleys), folds, "{sectors:?} {valleys:?}");
                count += u32::from(folds);
            }
            assert_eq!(count, 4, "a smallest sector: four ways (Hull 2003)");
        }
    }

    #[test]
    fn what_folds_flat_breaks_no_rule_with_more_creases_and_equal_sectors_too() {
        let two = [50.0, 50.0, 80.0, 60.0, 50.0, 70.0];
        let lists: Vec<Vec<f64>> = { (0..12).map(|seed| kawasaki_sectors(6, seed)) }
            .chain([
                two.map(f64::to_radians).to_vec(),
                [40.0, 40.0, 40.0, 80.0, 100.0, 60.0].map(f64::to_radians).to_vec(),
                [45.0, 45.0, 90.0, 90.0, 45.0, 45.0].map(f64::to_radians).to_vec(),
                [90.0, 45.0, 45.0, 45.0, 45.0, 90.0].map(f64::to_radians).to_vec(),
                [45.0, 90.0, 135.0, 90.0].map(f64::to_radians).to_vec(),
            ])
            .collect();
        for sectors in lists {
            let (mut folding, mut obeying) = (0, 0);
            for valleys in all_letters(sectors.len()) {
                let folds = flat_foldings(&sectors, &valleys) > 0;
                let obeys = obeys(&sectors, &valleys);
                assert!(obeys || !folds, "folds, and is said to break a rule: {sectors:?} {valleys:?}");
                folding += u32::from(folds);
                obeying += u32::from(obeys);
            }
            assert!(folding > 0 && obeying < 1 << (sectors.len() - 1), "{sectors:?}: {folding} of {obeying}");
        }
    }

    #[test]
    fn equal_sectors_fold_in_as_many_ways_as_hull_counts() {
        // 2 C(2n, n - 1) ways for 2n equal sectors, where Maekawa's rule alone decides.
        for (creases, ways) in [(2, 2), (4, 8), (6, 30)] {
            let sectors = equal_sectors(creases);
            let folding = all_letters(creases).filter(|valleys| flat_foldings(&sectors, valleys) > 0).count();
            let obeying = all_letters(creases).filter(|valleys| obeys(&sectors, valleys)).count();
            assert_eq!((folding, obeying), (ways, ways));
        }
    }

    #[test]
    fn wrong_sectors_fold_in_no_way() {
        let mut sectors = kawasaki_sectors(4, 3);
        (sectors[0], sectors[1]) = (sectors[0] + 0.01, sectors[1] - 0.01);
        for valleys in all_letters(4) {
            assert!(!obeys(&sectors, &valleys) && flat_foldings(&sectors, &valleys) == 0);
        }
    }
}
