//! The order of nodes in memory. Forces visit the nodes side by side, triangle by triangle: where neighbours in the sheet
//! lie far apart in memory, each visit waits for it.
//!
//! [`reverse_cuthill_mckee`]: E. Cuthill and J. `McKee`, Proc. 24th Nat. Conf. ACM (1969) 157; the end to start from after
//! A. George and J. W. H. Liu, ACM Trans. Math. Software 5 (1979) 284.

use std::cmp::Reverse;

use crate::csr::Csr;
use crate::ids::NodeId;

/// Sheets of fewer nodes lie in the processor's cache as a whole: no order is faster than another.
const SMALL: usize = 1000;
/// Walks in search of an end of the sheet; the second one mostly finds it.
const WALKS: usize = 4;

/// Whether another order would be faster: where there are many nodes, and neighbours (given as pairs) are farther apart than
/// in a square sheet that is numbered row by row.
pub(super) fn is_scattered(nodes: usize, neighbours: impl Iterator<Item = (usize, NodeId)>) -> bool {
    if nodes < SMALL {
        return false;
    }
    let add = |(spans, count), (a, b): (usize, NodeId)| (spans + a.abs_diff(b.index()) as u64, count + 1_u64);
    let (spans, count) = neighbours.fold((0, 0), add);
    spans as f64 > (nodes as f64).sqrt() * count as f64
}

/// The nodes of each connected part level by level from one of its ends, backwards. Parts come in the order of their first
/// nodes.
pub(super) fn reverse_cuthill_mckee(neighbours: &Csr<NodeId>) -> Vec<NodeId> {
    let mut walker = Walker { neighbours, seen: vec![0; neighbours.rows()], walks: 0 };
    let mut order = Vec::with_capacity(neighbours.rows());
    for seed in 0..neighbours.rows() {
        if walker.seen[seed] != 0 {
            continue;
        }
        let part = order.len();
        let mut walk = walker.walk(NodeId::new(seed), &mut order);
        for _ in 1..WALKS {
            order.truncate(part);
            let next = walker.walk(walk.far, &mut order);
            let deeper = next.depth > walk.depth;
            walk = next;
            if !deeper {
                break;
            }
        }
        order[part..].reverse();
    }
    order
}

/// Walks over connected parts, breadth first.
struct Walker<'a> {
    neighbours: &'a Csr<NodeId>,
    /// The last walk that came to each node.
    seen: Vec<u32>,
    walks: u32,
}

/// The result of a walk.
struct Walk {
    depth: usize,
    /// A node of the last level, the one with the fewest neighbours.
    far: NodeId,
}

impl Walker<'_> {
    /// Appends all nodes that hang together with `start`; of the neighbours of a node those with few neighbours first.
    fn walk(&mut self, start: NodeId, order: &mut Vec<NodeId>) -> Walk {
        self.walks += 1;
        self.seen[start.index()] = self.walks;
        let degree = |n: NodeId| self.neighbours.row(n.index()).len();
        let (mut level, mut depth) = (order.len(), 0);
        order.push(start);
        loop {
            let end = order.len();
            for at in level..end {
                let first = order.len();
                for &next in self.neighbours.row(order[at].index()) {
                    if self.seen[next.index()] != self.walks {
                        self.seen[next.index()] = self.walks;
                        order.push(next);
                    }
                }
                order[first..].sort_unstable_by_key(|n| (degree(*n), *n));
            }
            if order.len() == end {
                let far = order[level..].iter().copied().min_by_key(|n| (degree(*n), Reverse(*n)));
                return Walk { depth, far: far.unwrap_or(start) };
            }
            (level, depth) = (end, depth + 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::miura;
    use crate::model::{Material, Model};

    fn both(sides: &[[usize; 2]]) -> impl Iterator<Item = (usize, NodeId)> + Clone {
        sides.iter().flat_map(|&[a, b]| [(a, NodeId::new(b)), (b, NodeId::new(a))])
    }

    fn order(nodes: usize, sides: &[[usize; 2]]) -> Vec<NodeId> {
        reverse_cuthill_mckee(&Csr::from_entries(nodes, both(sides)))
    }

    fn sides_of_miura(columns: usize, rows: usize) -> (usize, Vec<[usize; 2]>) {
        let model = Model::new(&miura(columns, rows).expect("valid"), &Material::default()).expect("valid");
        (model.node_count(), model.mesh.sides.iter().map(|s| s.nodes.map(NodeId::index)).collect())
    }

    /// Multiplication by a number that has no factor in common with `nodes`.
    fn shuffled(nodes: usize, sides: &[[usize; 2]]) -> Vec<[usize; 2]> {
        sides.iter().map(|side| side.map(|n| n * 7919 % nodes)).collect()
    }

    fn bandwidth(sides: &[[usize; 2]], order: &[NodeId]) -> usize {
        let mut number = vec![usize::MAX; order.len()];
        order.iter().enumerate().for_each(|(i, n)| number[n.index()] = i);
        assert!(!number.contains(&usize::MAX), "every node comes once");
        sides.iter().map(|[a, b]| number[*a].abs_diff(number[*b])).max().unwrap_or(0)
    }

    /// The levels of a walk are bent where the diagonals of the quadrilaterals change direction: hence not quite as narrow.
    #[test]
    fn a_shuffled_miura_gets_a_band_about_as_narrow_as_row_by_row() {
        for (columns, rows) in [(39, 39), (99, 12), (12, 99)] {
            let (nodes, sides) = sides_of_miura(columns, rows);
            let given: Vec<NodeId> = (0..nodes).map(NodeId::new).collect();
            let shuffled = shuffled(nodes, &sides);
            assert!(bandwidth(&shuffled, &given) > nodes / 2, "the shuffle shuffles");
            assert!(is_scattered(nodes, both(&shuffled)));
            let order = order(nodes, &shuffled);
            let natural = (columns.min(rows) + 2) as f64;
            let width = bandwidth(&shuffled, &order) as f64;
            assert!(width <= 1.5 * natural, "{columns} x {rows}: {width}, natural {natural}");
        }
    }

    #[test]
    fn small_and_well_ordered_sheets_stay_as_they_are() {
        let (nodes, sides) = sides_of_miura(39, 39);
        assert!(!is_scattered(nodes, both(&sides)));
        let (nodes, sides) = sides_of_miura(20, 20);
        assert!(!is_scattered(nodes, both(&shuffled(nodes, &sides))));
        assert!(!is_scattered(0, both(&[])) && order(0, &[]).is_empty());
    }

    #[test]
    fn parts_and_single_nodes_keep_their_places() {
        // Two strips of three and a node alone between them.
        let sides = [[4, 6], [6, 5], [0, 2], [2, 1]];
        let order = order(7, &sides);
        assert_eq!(bandwidth(&sides, &order), 1);
        assert_eq!(order[3], NodeId(3));
        assert!(order[..3].iter().all(|n| n.index() < 3));
    }
}
