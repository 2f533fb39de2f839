//! What contact does: how often sheets go through themselves without it and with it, what it costs, and where it holds them up.
//!
//! Every pattern is folded to some percentages from some perturbations, freely and under contact. The exact test looks at the end
//! of both, and under contact at every tenth evaluation too. Then sheets of which it is known what must come of them are folded:
//! flaps and maps in order, thick accordions, what nothing touches.

mod accordions;
mod agreement;
mod asked;
mod found;
mod maps;
mod narrowed;
mod report;
mod row;
mod strips;
mod untouched;
mod watched;

use origami_core::generate::catalog;
use origami_core::{CreasePattern, Material, Model};

use crate::options::Deadline;
use crate::{Options, Study, StudyError, Watch};
use found::Found;

/// The percentages that each pattern is folded to.
const PERCENTS: [f64; 4] = [60.0, 90.0, 99.0, 100.0];
/// How far each node is moved at the start, as a share of its shortest beam.
const PERTURBATIONS: [f64; 3] = [1e-2, 5e-3, 2e-3];
/// Those of the quick study, which leaves large patterns out too.
const QUICK_PERCENTS: [f64; 1] = [100.0];
const QUICK_PERTURBATIONS: [f64; 1] = [1e-2];
/// Vertices of the largest pattern of the quick study.
const QUICK_VERTICES: usize = 60;

/// What is known beforehand, by name: quick or not.
type Kind = (&'static str, fn(bool) -> Result<Found, StudyError>);
const KINDS: [Kind; 5] = [
    ("flaps", strips::told),
    ("maps", maps::maps),
    ("accordions", accordions::study),
    ("narrowed bird base", narrowed::study),
    ("what nothing touches", untouched::study),
];

/// Runs the study on [`Options::patterns`], or on all that the generators make; those that there is no time for are named.
///
/// # Errors
/// Where a pattern makes no model.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let deadline = Deadline::after(options.time_limit);
    let quick = options.quick;
    let mut patterns: Vec<(String, CreasePattern)> = options.patterns.clone();
    let own = !patterns.is_empty();
    if !own {
        for name in catalog::names() {
            let pattern = catalog::generate(name, &[])?;
            if !quick || pattern.vertices.len() <= QUICK_VERTICES {
                patterns.push(((*name).to_owned(), pattern));
            }
        }
    }
    let percents: &[f64] = if quick { &QUICK_PERCENTS } else { &PERCENTS };
    let perturbations: &[f64] = if quick { &QUICK_PERTURBATIONS } else { &PERTURBATIONS };
    let kinds: &[Kind] = if own { &[] } else { &KINDS };
    watch.begins(patterns.len() * percents.len() * perturbations.len() + kinds.len() + 1);
    let (mut rows, mut left_out, mut models) = (Vec::new(), Vec::new(), Vec::new());
    // One after the other: their time is measured.
    for (name, pattern) in &patterns {
        let model = Model::new(pattern, &Material::default())?;
        for &percent in percents {
            for &perturbation in perturbations {
                if deadline.passed() {
                    left_out.push(format!("{name} at {percent} %"));
                } else {
                    rows.push(row::run(name, &model, percent, perturbation));
                }
                watch.ran(name);
            }
        }
        models.push((name.as_str(), model));
    }
    left_out.dedup();
    let mut found = Vec::new();
    for (name, kind) in kinds {
        if deadline.passed() {
            left_out.push((*name).to_owned());
        } else {
            found.push(kind(quick)?);
        }
        watch.ran(name);
    }
    if deadline.passed() {
        left_out.push("the order of the layers".into());
    } else {
        found.push(agreement::study(models.into_iter()));
    }
    watch.ran("the order of the layers");
    Ok(report::study(&rows, found, &left_out))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cell, Part, Table};

    fn table<'s>(study: &'s Study, name: &str) -> &'s Table {
        let of = |part: &'s Part| match part {
            Part::Table { file, table, .. } if file == name => Some(table),
            _ => None,
        };
        study.parts.iter().find_map(of).expect(name)
    }

    fn cell<'s>(table: &'s Table, row: usize, key: &str) -> &'s Cell {
        &table.rows[row][table.columns.iter().position(|column| column.key == key).expect(key)]
    }

    #[test]
    fn sheets_cross_without_contact_and_not_with_it() {
        let named = |name: &str| (name.to_owned(), catalog::generate(name, &[]).expect(name));
        let patterns = vec![named("strip"), named("degree-4")];
        let study = study(&Options { patterns, quick: true, ..Options::default() }, &mut ()).expect("they make models");
        let rows = table(&study, "contact-patterns");
        assert!(matches!(cell(rows, 0, "crossings_free"), Cell::Count(n) if *n > 0), "a strip is stacked");
        let crossings = [0, 1].map(|row| cell(rows, row, "crossings"));
        assert_eq!(crossings, [&Cell::Count(0), &Cell::Count(0)]);
        assert!(matches!(cell(rows, 0, "off_deg"), Cell::Number(x) if *x > 0.0 && *x < 5.0), "{:?}", rows.rows[0]);
        let layers = table(&study, "contact-layers");
        assert_eq!(cell(layers, 0, "pairs"), cell(layers, 0, "told"), "all pairs of a stack are told");
        assert_eq!(cell(layers, 0, "differ"), &Cell::Count(0));
    }

    /// Flaps, maps and accordions; the others take longer.
    #[test]
    fn what_is_known_beforehand_comes_out() {
        for (name, kind) in &KINDS[..3] {
            let found = kind(true).expect(name);
            let asked = asked::table(&found.asked);
            assert!(asked.rows.iter().all(|row| row.last() == Some(&Cell::Flag(true))), "{:?}", asked.rows);
            assert!(found.parts.iter().any(|part| matches!(part, Part::Table { table, .. } if !table.rows.is_empty())));
        }
    }

    #[test]
    fn without_time_all_is_named() {
        let options = Options { quick: true, time_limit: Some(std::time::Duration::ZERO), ..Options::default() };
        let study = study(&options, &mut ()).expect("generated");
        let texts =
            study.parts.iter().filter_map(|part| if let Part::Text(text) = part { Some(text.as_str()) } else { None });
        let text: String = texts.collect();
        assert!(text.contains("There was no time for") && text.contains("maps"), "{text}");
    }
}
