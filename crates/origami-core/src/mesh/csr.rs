//! Compressed rows: for each node, the elements that touch it.

/// Lists of unequal length in two arrays. Row `i` is `items[starts[i]..starts[i + 1]]`, in the order of the entries.
#[derive(Clone, Debug)]
pub struct Csr<T> {
    starts: Vec<u32>,
    items: Vec<T>,
}

impl<T: Copy> Csr<T> {
    /// Row `i` holds, in their order, the items of the entries `(i, item)`.
    pub(super) fn new(rows: usize, entries: impl Iterator<Item = (usize, T)> + Clone) -> Self {
        // Counted two places further on, so that the ends of rows become the starts of the next ones as they fill.
        let mut starts = vec![0_u32; rows + 2];
        let mut any = None;
        for (row, item) in entries.clone() {
            starts[row + 2] += 1;
            any = Some(item);
        }
        for i in 2..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut items = any.map_or(Vec::new(), |item| vec![item; starts[rows + 1] as usize]);
        for (row, item) in entries {
            let place = &mut starts[row + 1];
            items[*place as usize] = item;
            *place += 1;
        }
        starts.truncate(rows + 1);
        Self { starts, items }
    }

    /// Inverts `elements` (each a list of nodes): row `i` holds, ascending, the elements whose list has node `i`.
    pub(super) fn inverted<'a, N: 'a>(
        nodes: usize,
        elements: impl Iterator<Item = &'a [N]> + Clone,
        node: impl Fn(&N) -> usize + Copy,
        id: impl Fn(usize) -> T + Copy,
    ) -> Self {
        let of_element = move |(e, list): (usize, &'a [N])| list.iter().map(move |n| (node(n), id(e)));
        Self::new(nodes, elements.enumerate().flat_map(of_element))
    }

    /// How many nodes there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.starts.len() - 1
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
