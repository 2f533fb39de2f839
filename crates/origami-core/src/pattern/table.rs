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
        // Counted two places further on, so that the ends of rows become the starts of the next ones as they fill.
        let mut starts = vec![0u32; rows + 2];
        let mut any = None;
        for (row, item) in entries.clone() {
            starts[row as usize + 2] += 1;
            any = Some(item);
        }
        for row in 2..starts.len() {
            starts[row] += starts[row - 1];
        }
        let mut items = any.map_or(Vec::new(), |item| vec![item; starts[rows + 1] as usize]);
        for (row, item) in entries {
            let place = &mut starts[row as usize + 1];
            items[*place as usize] = item;
            *place += 1;
        }
        starts.truncate(rows + 1);
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

    /// Does something to each row.
    pub(super) fn each_row(&mut self, mut change: impl FnMut(&mut [T])) {
        for row in 0..self.rows() {
            change(self.row_mut(row));
        }
    }
}
