//! Linear buckling: at which multiple of its load a structure would lose its stability, were it to answer to all of the load as
//! it does to the first bit.
//!
//! `K(factor) = K0 + factor K1` with the tangent K0 of the state as drawn and its change K1 with the load; critical are factors
//! at which it is singular, found by counting its negative eigenvalues. Where a structure deforms much before it buckles, or
//! snaps, only a [path](super::Trace) tells.

use glam::DVec3;

use super::structure::Structure;
use super::tangent::Tangent;
use super::{Configuration, Refused};

/// How far the node that moves farthest is moved to see how the tangent changes, in sizes.
const FAR: f64 = 1e-5;
/// Displacements by linear analysis, in sizes, beyond which no critical load is sought: it would mean nothing.
const FARTHEST: f64 = 1.0;
/// How sharply a critical factor is found, as a share of itself.
const SHARP: f64 = 1e-12;

/// A critical load.
#[derive(Clone, Debug, PartialEq)]
pub struct Buckling {
    /// By how much the loads are multiplied.
    pub load_factor: f64,
    /// How the nodes begin to move, the farthest by 1.
    pub shape: Vec<DVec3>,
}

impl Structure {
    /// The `count` smallest positive load factors at which the structure as drawn buckles by linear analysis; fewer where
    /// there are none before a node would be displaced by the structure's own size.
    ///
    /// # Errors
    /// As [`Structure::first_order`]; [`Refused::Singular`] where it is not stable as drawn.
    pub fn buckling(&self, count: usize) -> Result<Vec<Buckling>, Refused> {
        let drawn = self.as_drawn();
        let first = self.first_order(&drawn, 0.0)?;
        let farthest = first.displacements.iter().map(|u| u.length()).fold(0.0, f64::max);
        if farthest == 0.0 {
            return Err(Refused::Unloaded);
        }
        let mut tangent = Tangent::new(self)?;
        let by = FAR * self.size() / farthest;
        let values_at = |tangent: &mut Tangent<'_>, factor: f64| {
            let positions: Vec<DVec3> =
                drawn.positions.iter().zip(&first.displacements).map(|(p, u)| *p + *u * factor).collect();
            let at = Configuration { fold_angles: self.fold_angles(&positions, &drawn.fold_angles), positions };
            tangent.set(&at, factor);
            (tangent.negative(), tangent.matrix.values().to_vec())
        };
        let (before, after) = (values_at(&mut tangent, -by).1, values_at(&mut tangent, by).1);
        let (negative, at_rest) = values_at(&mut tangent, 0.0);
        if negative > 0 {
            return Err(Refused::Singular { at: "the structure as drawn".to_owned() });
        }
        let change: Vec<f64> = after.iter().zip(&before).map(|(a, b)| (a - b) / (2.0 * by)).collect();
        let negative_at = |tangent: &mut Tangent<'_>, factor: f64| {
            let values = at_rest.iter().zip(&change).map(|(k, d)| k + factor * d);
            tangent.matrix.set_values(values);
            tangent.factor.factorise(tangent.matrix.as_ref())
        };
        let limit = FARTHEST * self.size() / farthest;
        let mut found: Vec<Buckling> = Vec::new();
        for wanted in 1..=count {
            let mut low = found.last().map_or(0.0, |last| last.load_factor);
            let mut high = by.max(2.0 * low);
            while negative_at(&mut tangent, high).is_none_or(|negative| negative < wanted) {
                (low, high) = (high, 2.0 * high);
                if high > limit {
                    return Ok(found);
                }
            }
            while high - low > SHARP * high {
                let middle = 0.5 * (low + high);
                match negative_at(&mut tangent, middle) {
                    Some(negative) if negative < wanted => low = middle,
                    _ => high = middle,
                }
            }
            // A little beside it there are factors.
            negative_at(&mut tangent, high * (1.0 + 1e3 * SHARP));
            let mut near = tangent.nearest_to_zero(wanted, &mut Vec::new()).into_iter();
            // Of several that vanish together each in its turn.
            let same = found.iter().filter(|own| (own.load_factor / high - 1.0).abs() < 1e-9).count();
            let Some((_, row)) = near.nth(same) else { return Ok(found) };
            let mut shape = tangent.equations.rows.scatter(&row);
            let farthest = shape.iter().map(|s| s.length()).fold(f64::MIN_POSITIVE, f64::max);
            shape.iter_mut().for_each(|s| *s /= farthest);
            found.push(Buckling { load_factor: high, shape });
        }
        Ok(found)
    }
}
