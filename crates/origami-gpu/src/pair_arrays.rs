//! From the pairs that the processor has listed to what the shaders read of them.

use origami_core::contact::PairList;

use crate::kernels::Binding;
use crate::layout::{Move, Pair, Touch};

/// A list of pairs, with a slot for each of their nodes; slots are numbered by node, so that each node reads one after the
/// other, in the order of the list.
#[derive(Clone, Debug)]
pub(crate) struct PairArrays {
    pub(crate) pairs: Vec<Pair>,
    /// First slot of each node, and the end of the last.
    pub(crate) rows: Vec<u32>,
    /// How far a node may be from where it was listed, in radii.
    pub(crate) lasts: f32,
}

impl PairArrays {
    /// Those of a sheet of so many nodes.
    pub(crate) fn new(nodes: usize, list: &PairList) -> Self {
        let mut pairs: Vec<Pair> = list.pairs().map(|pair| Pair::from(&pair)).collect();
        let mut rows = vec![0_u32; nodes + 1];
        pairs.iter().flat_map(|pair| pair.nodes).for_each(|node| rows[node as usize + 1] += 1);
        for node in 0..nodes {
            rows[node + 1] += rows[node];
        }
        let mut next = rows.clone();
        for pair in &mut pairs {
            for (slot, node) in pair.slots.iter_mut().zip(pair.nodes) {
                *slot = next[node as usize];
                next[node as usize] += 1;
            }
        }
        Self { pairs, rows, lasts: narrow(list.spent()) }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
fn narrow(x: f64) -> f32 {
    x as f32
}

/// Bytes of the buffers that contact adds to a sheet of so many nodes, with room for so many pairs.
pub(crate) fn sizes(nodes: usize, pairs: usize) -> [(Binding, u64); 8] {
    let size = |count: usize, of: usize| (count * of) as u64;
    [
        (Binding::Pairs, size(pairs, size_of::<Pair>())),
        (Binding::PairRows, size(nodes + 1, 4)),
        (Binding::Nears, size(pairs, 16)),
        (Binding::Pushes, size(4 * pairs, 16)),
        (Binding::Moves, size(nodes, size_of::<Move>())),
        (Binding::Shares, size(4 * pairs, 4)),
        (Binding::Ways, size(nodes, 16)),
        (Binding::Touch, size(1, size_of::<Touch>())),
    ]
}

#[cfg(test)]
mod tests {
    use origami_core::contact::Contact;

    use super::*;
    use crate::testing::cases::miura;

    #[test]
    fn each_node_has_its_slots_in_the_order_of_the_list() {
        let model = miura();
        let mut list = PairList::new(&model.mesh, &model.rest, Contact { gap: 0.3, ..Contact::default() });
        list.list(&model.rest);
        let PairArrays { pairs, rows, lasts } = PairArrays::new(model.node_count(), &list);
        assert!(f64::from(lasts) <= list.spent() * (1.0 + 1e-7));
        assert!(pairs.len() > 100 && pairs.len() == list.pairs().len());
        assert_eq!(rows.last().copied(), u32::try_from(4 * pairs.len()).ok());
        let mut of_slot = vec![None; 4 * pairs.len()];
        for (number, pair) in pairs.iter().enumerate() {
            for (slot, node) in pair.slots.into_iter().zip(pair.nodes) {
                assert!((rows[node as usize]..rows[node as usize + 1]).contains(&slot), "in the node's row");
                assert_eq!(of_slot[slot as usize].replace(number), None, "one slot for each");
            }
        }
        for row in rows.windows(2) {
            assert!(of_slot[row[0] as usize..row[1] as usize].is_sorted(), "in their order");
        }
    }
}
