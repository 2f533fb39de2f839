//! Which group a pair is for.

use super::super::stars::{ARMS, Star};
use crate::ids::NodeId;

/// Where a pair is in its group.
pub(super) struct Place {
    /// As of [`super::Group`].
    pub(super) corners: [NodeId; 2],
    pub(super) along: Option<u8>,
    /// As of [`super::Places`].
    pub(super) row: usize,
    pub(super) bit: usize,
}

impl Place {
    /// Of a pair whose nearest points are where its weights are not 0, as bits of its nodes; of a point and a triangle, or of two
    /// edges. `None` where they are inside both, or a star has not all of the pair.
    pub(super) fn of([p, q, r, s]: [NodeId; 4], points: bool, weights: u8, stars: &[Star]) -> Option<Self> {
        let star = |node: NodeId| &stars[node.index()];
        // The nearest corner or edge of both things, by bits, and what else they have.
        if points {
            let (corner, others) = match weights >> 1 {
                0b001 => (q, [r, s]),
                0b010 => (r, [q, s]),
                0b100 => (s, [q, r]),
                sides => {
                    let (ends, other) = match sides {
                        0b011 => ([q, r], s),
                        0b101 => ([q, s], r),
                        0b110 => ([r, s], q),
                        _ => return None,
                    };
                    let (end, along) = side(ends, stars)?;
                    let far = star(end).ends[along];
                    let bit = star(end).triangle([far, other])?;
                    return Some(Self { corners: [p, end], along: Some(along as u8), row: ARMS, bit });
                }
            };
            let bit = star(corner).triangle(others)?;
            let (corners, row) = if p < corner { ([p, corner], ARMS) } else { ([corner, p], ARMS + 1) };
            return Some(Self { corners, along: None, row, bit });
        }
        let one = |bits: u8, [a, b]: [NodeId; 2]| match bits {
            0b01 => Some([a, b]),
            0b10 => Some([b, a]),
            _ => None,
        };
        match (one(weights & 3, [p, q]), one(weights >> 2, [r, s])) {
            (Some(first), Some(second)) => {
                let ([a, to], [b, other_to]) = if first[0] < second[0] { (first, second) } else { (second, first) };
                let (bit, row) = (star(a).arm(to)?, star(b).arm(other_to)?);
                Some(Self { corners: [a, b], along: None, row, bit })
            }
            (Some([corner, to]), None) => Self::beside([corner, to], [r, s], stars),
            (None, Some([corner, to])) => Self::beside([corner, to], [p, q], stars),
            (None, None) => None,
        }
    }

    /// Of an edge whose first end is near the inside of another.
    fn beside([corner, to]: [NodeId; 2], ends: [NodeId; 2], stars: &[Star]) -> Option<Self> {
        let (end, along) = side(ends, stars)?;
        let bit = stars[corner.index()].arm(to)?;
        Some(Self { corners: [corner, end], along: Some(along as u8), row: along, bit })
    }
}

/// An edge by an end and its place in the star there.
fn side([one, other]: [NodeId; 2], stars: &[Star]) -> Option<(NodeId, usize)> {
    let [one, other] = [one.min(other), one.max(other)];
    Some((one, stars[one.index()].arm(other)?))
}
