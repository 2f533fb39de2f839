//! Rows with named columns.

pub(crate) mod markdown;

use serde_json::{Map, Value};

/// A column of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its key in CSV and JSON.
    pub key: &'static str,
    /// Its head in documents; the unit in it.
    pub head: &'static str,
    /// What it holds: unit and meaning, in one line.
    pub meaning: &'static str,
}

/// A column with these: its key, head and meaning.
pub(crate) const fn column(key: &'static str, head: &'static str, meaning: &'static str) -> Column {
    Column { key, head, meaning }
}

/// A value in a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Nothing is known or nothing applies.
    Missing,
    /// A statement that is true or false.
    Flag(bool),
    /// A whole number.
    Count(u64),
    /// A number; one that is not finite is written as a word.
    Number(f64),
    /// Words, or numbers that are none of the above.
    Text(String),
}

/// Rows with named columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The columns.
    pub columns: &'static [Column],
    /// As many cells each as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// A table of these columns, without rows.
    #[must_use]
    pub fn new(columns: &'static [Column]) -> Self {
        Self { columns, rows: Vec::new() }
    }

    /// Adds a row below the others.
    ///
    /// # Panics
    /// If it has not one cell for each column.
    pub fn push(&mut self, row: Vec<Cell>) {
        assert_eq!(row.len(), self.columns.len(), "one cell for each column");
        self.rows.push(row);
    }

    /// As CSV (RFC 4180) with a line of keys. What is missing is empty; numbers read back as the same bits.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut writer =
            csv::WriterBuilder::new().terminator(csv::Terminator::CRLF).flexible(true).from_writer(Vec::new());
        let keys = self.columns.iter().map(|column| column.key.to_owned()).collect();
        let lines = std::iter::once(keys).chain(self.rows.iter().map(|row| row.iter().map(Cell::exact).collect()));
        for line in lines {
            let line: Vec<String> = line;
            writer.write_record(&line).expect("memory takes lines of any length");
        }
        let bytes = writer.into_inner().expect("memory needs no flushing");
        String::from_utf8(bytes).expect("CSV of text is text")
    }

    /// As a list of objects by key; what is missing or not finite is null.
    #[must_use]
    pub fn json(&self) -> Value {
        let object = |row: &Vec<Cell>| {
            let values = self.columns.iter().zip(row);
            Value::Object(values.map(|(column, cell)| (column.key.to_owned(), cell.json())).collect::<Map<_, _>>())
        };
        Value::Array(self.rows.iter().map(object).collect())
    }

    /// As a table of Markdown with the columns of the given keys, in their order; a key that no column has is left out.
    #[must_use]
    pub fn markdown(&self, keys: &[&str]) -> String {
        markdown::table(self, keys, usize::MAX)
    }
}

impl Cell {
    /// The value as CSV has it, with all digits of a number.
    fn exact(&self) -> String {
        match self {
            Self::Missing => String::new(),
            Self::Flag(flag) => flag.to_string(),
            Self::Count(count) => count.to_string(),
            // As short as it can be for the same bits: 0.1, 1e-7, NaN, inf.
            Self::Number(number) => format!("{number:?}"),
            Self::Text(text) => text.clone(),
        }
    }

    fn json(&self) -> Value {
        match self {
            Self::Missing => Value::Null,
            Self::Flag(flag) => (*flag).into(),
            Self::Count(count) => (*count).into(),
            Self::Number(number) => (*number).into(),
            Self::Text(text) => text.as_str().into(),
        }
    }
}

impl From<bool> for Cell {
    fn from(value: bool) -> Self {
        Self::Flag(value)
    }
}

impl From<u64> for Cell {
    fn from(value: u64) -> Self {
        Self::Count(value)
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        Self::Count(value as u64)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Cell {
    fn from(value: &str) -> Self {
        Self::Text(value.into())
    }
}

impl From<String> for Cell {
    fn from(value: String) -> Self {
        Self::Text(value)
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Missing, Into::into)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: &[Column] = &[
        Column { key: "scene", head: "scene", meaning: "its name" },
        Column { key: "steps", head: "steps", meaning: "force evaluations" },
        Column { key: "error", head: "error (radii)", meaning: "largest distance to the reference" },
        Column { key: "holds", head: "holds", meaning: "whether it stays finite" },
    ];

    fn sample() -> Table {
        let mut table = Table::new(COLUMNS);
        table.push(vec!["a, \"b\" | c\nd".into(), 1240_u64.into(), (0.1 + 0.2).into(), true.into()]);
        table.push(vec!["".into(), None::<u64>.into(), 1e-300.into(), false.into()]);
        table.push(vec!["π".into(), 0_usize.into(), f64::NAN.into(), Cell::Missing]);
        table.push(vec!["end".into(), u64::MAX.into(), f64::NEG_INFINITY.into(), Cell::Missing]);
        table
    }

    #[test]
    fn csv_comes_back() {
        let text = sample().csv();
        assert!(text.starts_with("scene,steps,error,holds\r\n") && text.ends_with("\r\n"), "{text}");
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let rows: Vec<Vec<String>> =
            reader.records().map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect();
        assert_eq!(rows.len(), 4);
        assert_eq!(rows[0][0], "a, \"b\" | c\nd");
        assert_eq!(rows[0][2].parse::<f64>().unwrap().to_bits(), (0.1_f64 + 0.2).to_bits());
        assert_eq!(rows[1], ["", "", "1e-300", "false"]);
        assert_eq!(rows[2], ["π", "0", "NaN", ""]);
        assert_eq!(rows[3], ["end", "18446744073709551615", "-inf", ""]);
    }

    #[test]
    fn json_comes_back() {
        let table = sample();
        let text = serde_json::to_string(&table.json()).unwrap();
        let back: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(back, table.json());
        assert_eq!(back[0]["error"].as_f64().unwrap().to_bits(), (0.1_f64 + 0.2).to_bits());
        assert_eq!(back[1], serde_json::json!({"scene": "", "steps": null, "error": 1e-300, "holds": false}));
        assert_eq!((&back[2]["error"], &back[3]["error"]), (&Value::Null, &Value::Null));
        assert_eq!(back[3]["steps"], u64::MAX);
        let keys: Vec<_> = back[0].as_object().unwrap().keys().collect();
        assert_eq!(keys, ["scene", "steps", "error", "holds"]);
    }

    #[test]
    fn a_table_without_rows_has_its_keys() {
        let table = Table::new(COLUMNS);
        assert_eq!((table.csv().as_str(), table.json()), ("scene,steps,error,holds\r\n", Value::Array(Vec::new())));
    }

    #[test]
    fn rows_of_another_length_are_written_nevertheless() {
        let table = Table { columns: COLUMNS, rows: vec![vec![true.into()], Vec::new()] };
        assert_eq!(table.csv(), "scene,steps,error,holds\r\ntrue\r\n\"\"\r\n");
        assert_eq!(table.json(), serde_json::json!([{"scene": true}, {}]));
        assert!(table.markdown(&["steps"]).contains('–'));
    }
}
