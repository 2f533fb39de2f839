//! The barrier of gaps, and what eases out edges that are nearly parallel.

use super::{Given, Measured, Row, Rows, WIDTH, choose};
use crate::contact::barrier::NEARER;

/// How pairs push.
#[derive(Clone, Debug)]
pub(in crate::contact) struct Push {
    /// The force on the nearest point of the first thing; times its weight that on each node.
    pub(in crate::contact) force: Rows,
    /// Times the size of its weight the bound on the row sums of each node.
    pub(in crate::contact) stiffness: Row,
    /// Of edges that are eased out: the forces on the second ends of both beside that; on the first ends the opposite.
    pub(in crate::contact) turning: [Rows; 2],
    /// 1 where there is nothing of that.
    pub(in crate::contact) factor: Row,
}

impl Push {
    pub(in crate::contact) fn new() -> Self {
        let rows = [[0.0; WIDTH]; 3];
        Self { force: rows, stiffness: [0.0; WIDTH], turning: [rows; 2], factor: [1.0; WIDTH] }
    }
}

/// The barrier of [`super::super::barrier::Barrier`] of all pairs whose gap is below their width; of others nothing that says
/// anything. Edges are eased by [`super::super::barrier::mollifier`].
#[inline(always)]
pub(in crate::contact) fn push(edges: bool, stiffness: f64, given: &Given, measured: &Measured, push: &mut Push) {
    let mut ratio = [1.0; WIDTH];
    for ((ratio, gap), width) in ratio.iter_mut().zip(&measured.gap).zip(&given.width) {
        *ratio = gap / width;
    }
    let log = logarithm(&ratio);
    let mut energy = [0.0; WIDTH];
    for i in 0..WIDTH {
        let (gap, width) = (measured.gap[i], given.width[i]);
        let (less, inverse) = (gap - width, width / gap);
        // The same of the gap, and of the smaller one at which the curvature is bounded.
        let share = 1.0 - inverse;
        let nearer_share = 1.0 - inverse * (1.0 / NEARER);
        let nearer_log = log[i] + LOG_NEARER;
        let slope = -stiffness * less * (2.0 * log[i] + share);
        let curvature = -stiffness * (2.0 * nearer_log + 4.0 * nearer_share - nearer_share * nearer_share);
        energy[i] = -stiffness * less * less * log[i];
        push.stiffness[i] = 2.0 * curvature;
        for (force, normal) in push.force.iter_mut().zip(&measured.normal) {
            force[i] = -slope * normal[i];
        }
    }
    if edges {
        ease(given, &energy, push);
    }
}

/// `ln` of [`NEARER`].
const LOG_NEARER: f64 = -0.356_674_943_938_732_4;

#[inline(always)]
fn ease(given: &Given, energy: &Row, push: &mut Push) {
    for i in 0..WIDTH {
        let [p, q, r, s] = given.points(i);
        let (u, v) = (q - p, s - r);
        let (a, b, c) = (u.length_squared(), u.dot(v), v.length_squared());
        let least = given.eased[i];
        let x = u.cross(v).length_squared() / least;
        let x = choose(x < 1.0, x, 1.0);
        let factor = (2.0 - x) * x;
        let slope = -energy[i] * 2.0 * (2.0 - 2.0 * x) / least;
        let (by_u, by_v) = (slope * (c * u - b * v), slope * (a * v - b * u));
        for (turning, by) in push.turning.iter_mut().zip([by_u, by_v]) {
            turning[0][i] = by.x;
            turning[1][i] = by.y;
            turning[2][i] = by.z;
        }
        push.factor[i] = factor;
        push.stiffness[i] *= factor;
        for force in &mut push.force {
            force[i] *= factor;
        }
    }
}

/// The natural logarithms of normal numbers above 0, to a few units in the last place: `2^e m`, and the odd series of
/// `ln m = 2 artanh((m - 1) / (m + 1))` for m within the square root of 2 of 1.
#[inline(always)]
fn logarithm(x: &Row) -> Row {
    const MANTISSA: u64 = (1 << 52) - 1;
    /// An exponent in the last bits of this number counts whole ones.
    const COUNTING: f64 = 4_503_599_627_370_496.0;
    let mut log = [0.0; WIDTH];
    for (log, x) in log.iter_mut().zip(x) {
        let bits = x.to_bits();
        let exponent = f64::from_bits(bits >> 52 | COUNTING.to_bits()) - (COUNTING + 1023.0);
        let mantissa = f64::from_bits(bits & MANTISSA | 1.0_f64.to_bits());
        let large = mantissa > std::f64::consts::SQRT_2;
        let m = choose(large, 0.5 * mantissa, mantissa);
        let e = choose(large, exponent + 1.0, exponent);
        let z = (m - 1.0) / (m + 1.0);
        let y = z * z;
        let mut series = 2.0 / 21.0;
        for term in [19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0] {
            series = series * y + 2.0 / term;
        }
        *log = e * std::f64::consts::LN_2 + (2.0 * z + z * y * series);
    }
    log
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_are_those_of_the_library() {
        let mut x = 1e-12;
        while x < 2.0 {
            let row: Row = std::array::from_fn(|i| x * (1.0 + i as f64 / 17.0));
            for (x, own) in row.iter().zip(logarithm(&row)) {
                assert!((own - x.ln()).abs() <= 4e-16 * x.ln().abs().max(1e-1), "{x}: {own}, {}", x.ln());
            }
            x *= 1.37;
        }
        assert_eq!(logarithm(&[1.0; WIDTH]), [0.0; WIDTH]);
        assert!((LOG_NEARER - NEARER.ln()).abs() < 1e-16);
    }
}
