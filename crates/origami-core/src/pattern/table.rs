//! Lists of lists in two arrays.

/// Row `r` holds `items[starts[r]..starts[r + 1]]`, in the order in which the entries came.
#[derive(Debug)]
pub(super) struct Table<T> {
    starts: Vec<u32>,
    items: Vec<T>,
}

impl<T: Copy> Table<T> {
    /// A table of `rows` rows from entries `(row, item)`.
    pub(super) fn new(rows: usize, entries: impl Iterator<Item = (u32, T)> + Clone) -> Self {
        let mut starts = vec![0u32; rows + 1];
        for (row, _) in entries.clone() {
            starts[row as usize + 1] += 1;
        }
        for row in 0..rows {
            starts[row + 1] += starts[row];
        }
        let Some((_, any)) = entries.clone().next() else { return Self { starts, items: Vec::new() } };
        let mut items = vec![any; starts[rows] as usize];
        let mut at = starts.clone();
        for (row, item) in entries {
            items[at[row as usize] as usize] = item;
            at[row as usize] += 1;
        }
        Self { starts, items }
    }

    pub(super) fn rows(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn row(&self, row: usize) -> &[T] {
        &self.items[self.starts[row] as usize..self.starts[row + 1] as usize]
    }

    pub(super) fn row_mut(&mut self, row: usize) -> &mut [T] {
        &mut self.items[self.starts[row] as usize..self.starts[row + 1] as usize]
    }
}
