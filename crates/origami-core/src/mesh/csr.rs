//! Compressed rows: for each node, the elements that touch it.

/// Lists of unequal length in two arrays. Row `i` is `items[starts[i]..starts[i + 1]]`, in ascending order.
#[derive(Clone, Debug)]
pub struct Csr<T> {
    starts: Vec<u32>,
    items: Vec<T>,
}

impl<T: Copy> Csr<T> {
    /// Inverts `elements` (each a list of nodes): row `i` holds the elements whose list has node `i`.
    pub(super) fn new<'a, N: 'a>(
        nodes: usize,
        elements: impl Iterator<Item = &'a [N]> + Clone,
        node: impl Fn(&N) -> usize,
        id: impl Fn(usize) -> T,
    ) -> Self {
        let mut starts = vec![0_u32; nodes + 1];
        for n in elements.clone().flatten() {
            starts[node(n) + 1] += 1;
        }
        for i in 0..nodes {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut items = vec![id(0); starts[nodes] as usize];
        for (e, list) in elements.enumerate() {
            for n in list {
                let place = &mut next[node(n)];
                items[*place as usize] = id(e);
                *place += 1;
            }
        }
        Self { starts, items }
    }

    /// The elements at node `i`.
    #[must_use]
    pub fn of(&self, i: usize) -> &[T] {
        &self.items[self.starts[i] as usize..self.starts[i + 1] as usize]
    }

    /// The array of row starts, one longer than there are nodes.
    #[must_use]
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// All rows one after the other.
    #[must_use]
    pub fn items(&self) -> &[T] {
        &self.items
    }
}
