//! Compressed rows: many short lists in two arrays.

/// Lists of unequal length, one after the other in one array. Row `i` is `items[starts[i]..starts[i + 1]]`.
///
/// ```
/// use origami_core::csr::Csr;
///
/// let rows = Csr::from_entries(3, [(2, 'a'), (0, 'b'), (2, 'c')].into_iter());
/// assert_eq!(rows.row(0), ['b']);
/// assert!(rows.row(1).is_empty());
/// assert_eq!(rows.row(2), ['a', 'c']);
/// assert_eq!(rows.starts(), [0, 1, 1, 3]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Csr<T> {
    starts: Vec<u32>,
    items: Vec<T>,
}

impl<T: Copy> Csr<T> {
    /// Row `i` holds the items of the entries `(i, item)`, in the order of the entries. The entries are read twice: once
    /// to count them, once to fill the rows.
    ///
    /// # Panics
    /// If an entry names row `rows` or a later one, or if there are more than 2^32 - 1 entries.
    pub fn from_entries(rows: usize, entries: impl Iterator<Item = (usize, T)> + Clone) -> Self {
        // Counted two places further on, so that the ends of rows become the starts of the next ones as they fill.
        let mut starts = vec![0_u32; rows + 2];
        let mut any = None;
        for (row, item) in entries.clone() {
            starts[row + 2] += 1;
            any = Some(item);
        }
        for i in 2..starts.len() {
            starts[i] = starts[i].checked_add(starts[i - 1]).expect("more than 2^32 entries");
        }
        let mut items = any.map_or(Vec::new(), |item| vec![item; starts[rows + 1] as usize]);
        for (row, item) in entries {
            let end = &mut starts[row + 1];
            items[*end as usize] = item;
            *end += 1;
        }
        starts.truncate(rows + 1);
        Self { starts, items }
    }

    /// Inverts `elements`, each a list of nodes: row `i` holds, in ascending order, the elements whose list has node `i`.
    /// `index` gives the row of a node, `id` the name of the element at an index.
    ///
    /// # Panics
    /// As [`Csr::from_entries`], with `nodes` rows.
    pub fn inverted<'a, N: 'a>(
        nodes: usize,
        elements: impl Iterator<Item = &'a [N]> + Clone,
        index: impl Fn(&N) -> usize + Copy,
        id: impl Fn(usize) -> T + Copy,
    ) -> Self {
        let of_element = move |(e, list): (usize, &'a [N])| list.iter().map(move |n| (index(n), id(e)));
        Self::from_entries(nodes, elements.enumerate().flat_map(of_element))
    }
}

impl<T> Csr<T> {
    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.starts.len() - 1
    }

    /// The items of row `i`.
    #[must_use]
    pub fn row(&self, i: usize) -> &[T] {
        &self.items[self.starts[i] as usize..self.starts[i + 1] as usize]
    }

    /// The items of row `i`, to be changed or reordered in place.
    pub fn row_mut(&mut self, i: usize) -> &mut [T] {
        &mut self.items[self.starts[i] as usize..self.starts[i + 1] as usize]
    }

    /// All rows in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[T]> {
        (0..self.rows()).map(|i| self.row(i))
    }

    /// Where each row starts in [`items`](Self::items), and where the last one ends: one number more than rows.
    #[must_use]
    pub fn starts(&self) -> &[u32] {
        &self.starts
    }

    /// All rows, one after the other.
    #[must_use]
    pub fn items(&self) -> &[T] {
        &self.items
    }

    /// The two arrays: `starts`, `items`.
    #[must_use]
    pub fn into_parts(self) -> (Vec<u32>, Vec<T>) {
        (self.starts, self.items)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_keep_the_order_of_their_entries() {
        let entries = [(3, 10), (0, 11), (3, 12), (1, 13), (3, 14)];
        let mut csr = Csr::from_entries(5, entries.into_iter());
        let plain = |row| entries.iter().filter(|(r, _)| *r == row).map(|(_, item)| *item).collect::<Vec<_>>();
        let rows: Vec<&[i32]> = csr.iter().collect();
        assert_eq!(rows, (0..5).map(plain).collect::<Vec<_>>());
        csr.row_mut(3).reverse();
        assert_eq!(csr.clone().into_parts(), (vec![0, 1, 2, 2, 5, 5], vec![11, 13, 14, 12, 10]));
    }

    #[test]
    fn without_entries_every_row_is_empty() {
        let csr = Csr::<u8>::from_entries(2, [].into_iter());
        assert_eq!((csr.rows(), csr.starts(), csr.items()), (2, &[0, 0, 0][..], &[][..]));
        assert_eq!(Csr::<u8>::from_entries(0, [].into_iter()).rows(), 0);
    }

    #[test]
    fn an_inverse_names_each_element_at_each_of_its_nodes() {
        let triangles = [[0_u8, 1, 2], [2, 1, 4]];
        let csr = Csr::inverted(5, triangles.iter().map(|t| t.as_slice()), |n| usize::from(*n), |e| e);
        for node in 0..5 {
            let with = |t: &usize| triangles[*t].iter().any(|n| usize::from(*n) == node);
            assert_eq!(csr.row(node), (0..2).filter(with).collect::<Vec<_>>());
        }
    }
}
