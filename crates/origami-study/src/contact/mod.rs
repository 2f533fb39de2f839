//! What contact does: how often sheets go through themselves without it and with it, what it costs, and where it holds them up.
//!
//! Every pattern is folded to some percentages twice, freely and under contact. The exact test looks at the end of both, and
//! under contact at every tenth evaluation too.

mod report;
mod row;

use origami_core::generate::catalog;
use origami_core::{CreasePattern, Material, Model};

use crate::options::Deadline;
use crate::{Options, Study, StudyError, Watch};

/// The percentages that each pattern is folded to.
const PERCENTS: [f64; 4] = [60.0, 90.0, 99.0, 100.0];
/// Those of the quick study, which leaves large patterns out too.
const QUICK_PERCENTS: [f64; 1] = [100.0];
/// Vertices of the largest pattern of the quick study.
const QUICK_VERTICES: usize = 60;

/// Runs the study on [`Options::patterns`], or on all that the generators make; those that there is no time for are named.
///
/// # Errors
/// Where a pattern makes no model.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let deadline = Deadline::after(options.time_limit);
    let mut patterns: Vec<(String, CreasePattern)> = options.patterns.clone();
    if patterns.is_empty() {
        for name in catalog::names() {
            let pattern = catalog::generate(name, &[])?;
            if !options.quick || pattern.vertices.len() <= QUICK_VERTICES {
                patterns.push(((*name).to_owned(), pattern));
            }
        }
    }
    let percents: &[f64] = if options.quick { &QUICK_PERCENTS } else { &PERCENTS };
    watch.begins(patterns.len() * percents.len());
    let (mut rows, mut left_out) = (Vec::new(), Vec::new());
    // One after the other: their time is measured.
    for (name, pattern) in &patterns {
        let model = Model::new(pattern, &Material::default())?;
        for &percent in percents {
            if deadline.passed() {
                left_out.push(format!("{name} at {percent} %"));
            } else {
                rows.push(row::run(name, &model, percent));
            }
            watch.ran(name);
        }
    }
    Ok(report::study(&rows, &left_out))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cell, Part};

    #[test]
    fn sheets_cross_without_contact_and_not_with_it() {
        let named = |name: &str| (name.to_owned(), catalog::generate(name, &[]).expect(name));
        let patterns = vec![named("strip"), named("degree-4")];
        let study = study(&Options { patterns, quick: true, ..Options::default() }, &mut ()).expect("they make models");
        let table =
            study.parts.iter().find_map(|part| if let Part::Table { table, .. } = part { Some(table) } else { None });
        let table = table.expect("a table");
        let column = |key: &str| table.columns.iter().position(|column| column.key == key).expect(key);
        let cell = |row: usize, key: &str| &table.rows[row][column(key)];
        assert!(matches!(cell(0, "crossings_free"), Cell::Count(n) if *n > 0), "a strip is stacked");
        assert_eq!((cell(0, "crossings"), cell(1, "crossings")), (&Cell::Count(0), &Cell::Count(0)));
        assert!(matches!(cell(0, "off_deg"), Cell::Number(x) if *x > 0.0 && *x < 5.0), "{:?}", cell(0, "off_deg"));
    }
}
