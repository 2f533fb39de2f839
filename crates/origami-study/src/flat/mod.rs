//! Whether sheets that fold flat are folded flat by motion alone, and at what cost.
//!
//! The flat-folded state of a pattern whose creases all fold by half a turn is known without a solver: its faces are
//! reflected. That makes it the hardest honest test of one. At 60 % there is no such state; there the two ways to it, closing
//! the open sheet and opening the flat-folded one, are held against each other by energy.

mod cases;
mod report;
mod row;

use crate::options::Deadline;
use crate::{Options, Study, StudyError, Watch};

use row::Row;

/// Runs the study on [`Options::patterns`], or on generated ones. A pattern that has no flat-folded state is a row that
/// says why; those that there is no time for are named.
///
/// # Errors
/// Where a pattern makes no model.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let deadline = Deadline::after(options.time_limit);
    let cases = cases::cases(options)?;
    watch.begins(cases.len());
    let mut rows = Vec::with_capacity(cases.len());
    // One after the other: their time is measured.
    for case in cases {
        let name = case.name.clone();
        rows.push(if deadline.passed() { Row::left_out(&case) } else { row::run(&case, &options.gpu) });
        watch.ran(&name);
    }
    Ok(report::study(&rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cell, Part, Table};
    use origami_core::generate::{self, catalog};

    fn table<'a>(study: &'a Study, name: &str) -> &'a Table {
        let of = |part: &'a Part| match part {
            Part::Table { file, table, .. } if file == name => Some(table),
            _ => None,
        };
        study.parts.iter().find_map(of).expect(name)
    }

    fn column<'a>(table: &'a Table, key: &str) -> Vec<&'a Cell> {
        let place = table.columns.iter().position(|column| column.key == key).expect(key);
        table.rows.iter().map(|row| &row[place]).collect()
    }

    #[test]
    fn generated_patterns_arrive_and_others_say_why_not() {
        let named = |name: &str| (name.to_owned(), catalog::generate(name, &[]).expect(name));
        let patterns =
            vec![named("bird-base"), ("miura".into(), generate::miura(4, 4).expect("valid")), named("hypar")];
        let study = study(&Options { patterns, ..Options::default() }, &mut ()).expect("they make models");
        let rows = table(&study, "flat-patterns");
        let flags = [Cell::Flag(true), Cell::Flag(true), Cell::Missing];
        assert_eq!(column(rows, "arrived"), flags.iter().collect::<Vec<_>>());
        for cell in &column(rows, "distance")[..2] {
            assert!(matches!(cell, Cell::Number(x) if *x < 1e-4), "{cell:?}");
        }
        assert!(matches!(column(rows, "why_not")[2], Cell::Text(why) if why.contains("90.0")), "{rows:?}");
        let sizes = table(&study, "flat-sizes");
        assert_eq!(column(sizes, "patterns").last(), Some(&&Cell::Count(2)));
        assert_eq!(column(sizes, "arrived").last(), Some(&&Cell::Count(2)));
        let ways = table(&study, "flat-60");
        assert_eq!(ways.rows.len(), 2);
        for cell in column(ways, "energy_ratio") {
            assert!(matches!(cell, Cell::Number(x) if *x > 0.0), "{cell:?}");
        }
    }

    #[test]
    fn a_state_elsewhere_has_not_arrived() {
        let case = cases::Case::new("miura", &generate::miura(3, 3).expect("valid")).expect("a model");
        let exact = row::exact(&case.model).expect("it folds flat");
        let mut off = exact.clone();
        off.state.positions[4].z += 1e-3;
        assert!(row::distance(&exact, &exact.state) < 1e-12 && row::has_arrived(&exact, &exact.state));
        assert!(row::distance(&exact, &off.state) > 5e-4 && !row::has_arrived(&exact, &off.state));
    }

    #[test]
    fn without_time_patterns_are_named() {
        let options = Options { quick: true, time_limit: Some(std::time::Duration::ZERO), ..Options::default() };
        let study = study(&options, &mut ()).expect("generated");
        let texts =
            study.parts.iter().filter_map(|part| if let Part::Text(text) = part { Some(text.as_str()) } else { None });
        let text: String = texts.collect();
        assert!(text.contains("There was no time for") && text.contains("bird-base"), "{text}");
    }
}
