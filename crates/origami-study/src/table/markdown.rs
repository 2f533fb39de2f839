//! Tables for people.

use super::{Cell, Table};

/// With the columns of the given keys and no more than so many rows.
pub(crate) fn table(table: &Table, keys: &[&str], rows: usize) -> String {
    let position = |key: &&str| table.columns.iter().position(|column| column.key == *key);
    let shown: Vec<usize> = keys.iter().filter_map(position).collect();
    if shown.is_empty() {
        return String::new();
    }
    let rows: Vec<&Vec<Cell>> = table.rows.iter().take(rows).collect();
    let columns: Vec<Shown> = shown.iter().map(|i| Shown::new(table.columns[*i].head, &rows, *i)).collect();
    let mut text = line(columns.iter().map(|column| column.padded(&column.head)));
    text += &line(columns.iter().map(Shown::rule));
    for row in 0..rows.len() {
        text += &line(columns.iter().map(|column| column.padded(&column.cells[row])));
    }
    text
}

fn line(cells: impl Iterator<Item = String>) -> String {
    let cells: Vec<String> = cells.collect();
    format!("| {} |\n", cells.join(" | "))
}

/// A column as text.
struct Shown {
    head: String,
    cells: Vec<String>,
    width: usize,
    /// Numbers stand right, so that their sizes can be compared.
    right: bool,
}

impl Shown {
    fn new(head: &str, rows: &[&Vec<Cell>], index: usize) -> Self {
        let head = escaped(head);
        let of_row = |row: &&Vec<Cell>| row.get(index).map_or_else(|| short(&Cell::Missing), short);
        let cells: Vec<String> = rows.iter().map(of_row).collect();
        let width = cells.iter().chain([&head]).map(|cell| cell.chars().count()).max().unwrap_or(0).max(3);
        let is_number = |cell: &&Cell| matches!(cell, Cell::Number(_) | Cell::Count(_));
        let mut present =
            rows.iter().filter_map(|row| row.get(index)).filter(|cell| **cell != Cell::Missing).peekable();
        let right = present.peek().is_some() && present.all(|cell| is_number(&cell));
        Self { head, cells, width, right }
    }

    fn padded(&self, cell: &str) -> String {
        let width = self.width;
        if self.right { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
    }

    fn rule(&self) -> String {
        let dashes = "-".repeat(self.width - 1);
        if self.right { format!("{dashes}:") } else { format!("{dashes}-") }
    }
}

fn short(cell: &Cell) -> String {
    match cell {
        Cell::Missing => "–".to_owned(),
        Cell::Flag(true) => "yes".to_owned(),
        Cell::Flag(false) => "no".to_owned(),
        Cell::Count(count) => grouped(*count),
        Cell::Number(number) => rounded(*number),
        Cell::Text(text) => escaped(text),
    }
}

/// With three significant digits; tiny and huge ones as `1.2e-7`.
pub(crate) fn rounded(x: f64) -> String {
    let size = x.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if !size.is_finite() {
        x.to_string()
    } else if (0.000_999_5..9_999.5).contains(&size) {
        // The power after rounding, so that 9.999 becomes 10.0 and not 10.00.
        let power = if size < 0.999_5e-2 { -3 } else { [-2, -1, 0, 1, 2, 3][decade(size)] };
        let decimals = usize::try_from(2 - power).unwrap_or(0);
        trimmed(&format!("{x:.decimals$}"))
    } else {
        let text = format!("{x:.2e}");
        text.split_once('e').map_or(text.clone(), |(digits, power)| format!("{}e{power}", trimmed(digits)))
    }
}

fn decade(size: f64) -> usize {
    [0.099_95, 0.999_5, 9.995, 99.95, 999.5].iter().filter(|end| size >= **end).count()
}

/// Without zeros behind the point that say nothing.
fn trimmed(digits: &str) -> String {
    match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits.to_owned(),
    }
}

/// In groups of three digits.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// What would end a cell or a row does so no more.
pub(crate) fn escaped(text: &str) -> String {
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    plain.replace('\\', "\\\\").replace('|', "\\|").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::super::Column;
    use super::*;

    const COLUMNS: &[Column] = &[
        Column { key: "scene", head: "scene", meaning: "" },
        Column { key: "steps", head: "steps", meaning: "" },
        Column { key: "error", head: "error (radii)", meaning: "" },
        Column { key: "holds", head: "holds", meaning: "" },
    ];

    #[test]
    fn columns_stand_in_line() {
        let mut table = Table::new(COLUMNS);
        table.push(vec!["a|b\nc".into(), 1_234_567_u64.into(), 1.234e-7.into(), true.into()]);
        table.push(vec!["π".into(), Cell::Missing, f64::INFINITY.into(), false.into()]);
        let expected = "\
| holds | scene  |     steps | error (radii) |
| ----- | ------ | --------: | ------------: |
| yes   | a\\|b c | 1 234 567 |       1.23e-7 |
| no    | π      |         – |           inf |
";
        assert_eq!(table.markdown(&["holds", "scene", "nobody", "steps", "error"]), expected);
        assert_eq!(super::table(&table, &["scene"], 1).lines().count(), 3);
        assert_eq!(table.markdown(&[]), "");
    }

    #[test]
    fn three_digits_are_left() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (0.5, "0.5"),
            (1.0 / 3.0, "0.333"),
            (-12.345, "-12.3"),
            (9.999, "10"),
            (99.96, "100"),
            (999.6, "1000"),
            (1234.5, "1234"),
            (12_345.0, "1.23e4"),
            (0.001, "0.001"),
            (0.009_994, "0.00999"),
            (0.009_999, "0.01"),
            (0.001_234, "0.00123"),
            (0.000_123_4, "1.23e-4"),
            (1.2e-7, "1.2e-7"),
            (2e300, "2e300"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ];
        for (x, text) in cases {
            assert_eq!(rounded(x), text);
        }
    }

    #[test]
    fn rounding_keeps_the_value_to_half_a_percent() {
        for i in 0..4000 {
            let x = 10_f64.powf(f64::from(i - 2000) / 97.3);
            let back: f64 = rounded(x).parse().unwrap();
            assert!((back / x - 1.0).abs() <= 5.001e-3, "{x} as {back}");
        }
    }
}
