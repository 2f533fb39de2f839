//! What holds on stiff and extreme cases.
//!
//! Families of cases along one parameter each. Of every case is asked whether the paper's step and the safe step hold,
//! what the largest step that holds is against the bound, whether a relaxation converges and whether its claim is true,
//! and, where there is a GPU, the same in 32 bits. No time is measured, so rows run side by side.

mod cases;
mod drift;
mod found;
mod gpu_run;
mod limit;
mod motion;
mod report;
mod row;
mod run;

use self::found::Budget;
use self::report::Ran;
use self::row::{CaseResult, Row};
use crate::options::Deadline;
use crate::{Options, Study, StudyError, Watch};

/// Steps of the runs that ask for drift.
const MILLION: u64 = 1_000_000;
/// The same in the quick study.
const SOME: u64 = 20_000;

/// Runs the study; of [`Options::patterns`] it takes none.
///
/// A case that makes no model, or panics, is a row that says so. Rows that there is no time for are named.
///
/// # Errors
/// It has none: what fails is a row. The signature is that of the other study.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let deadline = Deadline::after(options.time_limit);
    let rows = rows(options, deadline, watch);
    let (drifts, drifts_left_out) = drift::all(if options.quick { SOME } else { MILLION }, deadline);
    watch.ran("drift");
    let (budget, gpu) = (Budget::new(options.quick), options.gpu.name());
    Ok(report::study(&Ran { rows: &rows, drifts: &drifts, drifts_left_out, budget, gpu }))
}

fn rows(options: &Options, deadline: Deadline, watch: &mut dyn Watch) -> Vec<Row> {
    let budget = Budget::new(options.quick);
    let mut cases = cases::all();
    cases.retain(|case| case.quick || !options.quick);
    let on_gpu = if options.gpu.is_there() { cases.len() } else { 0 };
    watch.begins(cases.len() + on_gpu + 1);
    let results = run::all(&cases, budget, deadline, watch);
    let mut row = |(case, result)| {
        let mut gpu = None;
        if on_gpu > 0 {
            if let CaseResult::Found(found) = &result
                && !deadline.passed()
            {
                gpu = gpu_run::run(&case, found, budget, &options.gpu);
            }
            watch.ran(&format!("{} in 32 bits", case.name()));
        }
        Row { case, result, gpu }
    };
    cases.into_iter().zip(results).map(&mut row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_of_the_quick_study_is_answered() {
        let rows = rows(&Options { quick: true, ..Options::default() }, Deadline::after(None), &mut ());
        for row in &rows {
            let name = row.case.name();
            let Some(found) = row.found() else { panic!("{name}: {:?}", row.result) };
            assert!(found.safe.holds() && found.safe_verlet.holds(), "{name}: {}, {}", found.safe, found.safe_verlet);
            for (what, ratio) in report::summary::ratios(found) {
                assert!(ratio <= 1.0, "{name}, {what}: the bound is {ratio} of what holds");
            }
            let folded = found.relaxed.folded().unwrap_or_else(|| panic!("{name}: {:?}", found.relaxed));
            assert!(motion::is_finite(&folded.state), "{name}");
        }
        let counts = report::summary::Counts::of(rows.iter());
        assert!(20 * (counts.claims - counts.claims_true) <= counts.claims, "true claims: {counts:?}");
    }

    #[test]
    fn no_number_of_the_tables_is_nan() {
        let study = study(&Options { quick: true, ..Options::default() }, &mut ()).expect("it has no errors");
        let mut cells = 0;
        for part in &study.parts {
            let crate::Part::Table { file, table, .. } = part else { continue };
            for (cell, column) in table.rows.iter().flat_map(|row| row.iter().zip(table.columns)) {
                cells += 1;
                let sound = !matches!(cell, crate::Cell::Number(x) if !x.is_finite());
                assert!(sound, "{file}, {}: {cell:?}", column.key);
            }
        }
        assert!(cells > 700);
    }

    #[test]
    fn without_time_rows_are_left_out_and_named() {
        let options = Options { quick: true, time_limit: Some(std::time::Duration::ZERO), ..Options::default() };
        let study = study(&options, &mut ()).expect("it has no errors");
        let crate::Part::Text(text) = &study.parts[0] else { panic!("it begins with a text") };
        assert!(text.contains("There was no time for") && text.contains("Miura 4x4, EA 1;"), "{text}");
    }
}
