//! What a person is told of a sweep.

use std::time::Duration;

use crate::exit::Exit;
use crate::numbers::{count, duration, grouped, plain, share, short};
use crate::report::{Ending, Row, Seconds, Table};

/// How many sheets ended in each way.
pub(super) struct Counts {
    converged: usize,
    steps_done: usize,
    step_limit: usize,
    crushed: usize,
    diverged: usize,
    failed: usize,
}

impl Counts {
    pub(super) fn of(rows: &[Row]) -> Self {
        let of = |ending| rows.iter().filter(|row| row.measured.stop == ending).count();
        Self {
            converged: of(Ending::Converged),
            steps_done: of(Ending::StepsDone),
            step_limit: of(Ending::StepLimit),
            crushed: of(Ending::Crushed),
            diverged: of(Ending::Diverged),
            failed: of(Ending::Failed),
        }
    }

    /// The most severe.
    pub(super) fn exit(&self) -> Exit {
        match self {
            Self { failed: 1.., .. } => Exit::BadInput,
            Self { diverged: 1.., .. } => Exit::Diverged,
            Self { step_limit: 1.., .. } | Self { crushed: 1.., .. } => Exit::NotConverged,
            _ => Exit::Done,
        }
    }

    /// Such as `bird.fold: 63 sheets, 62 converged, 1 diverged, strain mean 0.0012 % to 1.4 %, 120 ms`.
    ///
    /// `what` is what the sheets are of, `software` the adapter on which they were folded where it is none of hardware.
    pub(super) fn line(&self, what: &str, rows: &[Row], software: Option<&str>, seconds: Seconds) -> String {
        let mut line = format!("{what}: {}", count(rows.len(), "sheet", "sheets"));
        let endings = [
            (self.converged, "converged"),
            (self.steps_done, "with the asked number of steps"),
            (self.step_limit, "not converged"),
            (self.crushed, "with a triangle crushed"),
            (self.diverged, "diverged"),
            (self.failed, "failed"),
        ];
        for (number, ending) in endings.iter().filter(|(number, _)| *number > 0) {
            line += &format!(", {} {ending}", grouped(*number as u64));
        }
        let strains = || rows.iter().filter_map(|row| Some(row.measured.strain?.mean));
        if let (Some(least), Some(most)) = (strains().reduce(f64::min), strains().reduce(f64::max)) {
            line += &format!(", strain mean {} to {}", share(least), share(most));
        }
        if let Some(adapter) = software {
            line += &format!(", on {adapter} (software)");
        }
        let total = seconds.read + seconds.build + seconds.solve + seconds.write;
        line + &format!(", {}", duration(Duration::from_secs_f64(total)))
    }

    /// A message for each way to end badly, with the first sheet that did. `divergence` is the message of the first that
    /// diverged.
    pub(super) fn complaints(&self, table: &Table, divergence: Option<(usize, &str)>, advice: &str) -> Vec<String> {
        let all = grouped(table.instances.len() as u64);
        let mut complaints = Vec::new();
        let mut complain = |number: usize, ending: Ending, how: &str, what: &dyn Fn(&Row) -> String| {
            if let Some(row) = table.instances.iter().find(|row| row.measured.stop == ending) {
                complaints.push(format!(
                    "{}: {} of {all} {how}; the first is {} at {} %: {}",
                    table.head.input,
                    grouped(number as u64),
                    row.index,
                    plain(row.measured.percent),
                    what(row)
                ));
            }
        };
        complain(self.failed, Ending::Failed, "failed", &|row| row.error.clone().unwrap_or_default());
        complain(self.diverged, Ending::Diverged, "diverged", &|row| match (divergence, &row.diverged) {
            (Some((index, why)), _) if index == row.index => format!("{why}; {advice}"),
            // Of a row from before, whose message nobody has.
            (_, Some(diverged)) => format!("at step {}; {advice}", diverged.step),
            _ => advice.to_owned(),
        });
        complain(self.crushed, Ending::Crushed, "with a triangle crushed to a line", &|row| {
            format!("forces have no rest there, given up after {} steps", grouped(row.measured.steps))
        });
        complain(self.step_limit, Ending::StepLimit, "not converged", &|row| {
            if table.head.solver == "newton" {
                let force = row.measured.residual.map_or_else(|| "not known".to_owned(), short);
                return format!("the largest force is {force}; a larger --residual or more --max-steps may help");
            }
            let distance = match row.measured.distance {
                Some(d) if d.is_finite() => format!("about {} of the radius from the equilibrium", short(d)),
                _ => "an unknown distance from the equilibrium".to_owned(),
            };
            let steps = grouped(row.measured.steps);
            let tolerance = short(table.head.tolerance);
            format!(
                "{distance} after {steps} steps, expected {tolerance}; more --max-steps or a larger --tolerance may help"
            )
        });
        complaints
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::commands::sweep::testing;

    /// A table of sheets that ended so.
    fn table(endings: &[Ending]) -> Table {
        let instances = endings.iter().enumerate().map(|(index, stop)| testing::row(index, *stop)).collect();
        Table { head: testing::head(), instances, seconds: Seconds::default() }
    }

    #[test]
    fn the_most_severe_ending_counts_and_each_is_told() {
        let all = [
            Ending::Converged,
            Ending::StepsDone,
            Ending::StepLimit,
            Ending::Crushed,
            Ending::Diverged,
            Ending::Failed,
        ];
        let exits = (1..=all.len()).map(|n| Counts::of(&table(&all[..n]).instances).exit());
        let expected = [Exit::Done, Exit::Done, Exit::NotConverged, Exit::NotConverged, Exit::Diverged, Exit::BadInput];
        assert_eq!(exits.collect::<Vec<_>>(), expected);

        let table = table(&all);
        let counts = Counts::of(&table.instances);
        let line = "a.fold: 6 sheets, 1 converged, 1 with the asked number of steps, 1 not converged, 1 with a triangle crushed, \
                    1 diverged, 1 failed, 0 ms";
        assert_eq!(counts.line("a.fold", &table.instances, None, table.seconds), line);
        let complaints = counts.complaints(&table, Some((4, "diverged at step 3")), "try less");
        let expected = [
            "a.fold: 1 of 6 failed; the first is 5 at 50 %: the adapter was lost",
            "a.fold: 1 of 6 diverged; the first is 4 at 50 %: diverged at step 3; try less",
            "a.fold: 1 of 6 with a triangle crushed to a line; the first is 3 at 50 %: forces have no rest there",
            "a.fold: 1 of 6 not converged; the first is 2 at 50 %: an unknown distance from the equilibrium after 0 steps",
        ];
        assert_eq!(complaints.len(), 4);
        assert!(complaints.iter().zip(expected).all(|(told, expected)| told.starts_with(expected)), "{complaints:?}");
    }
}
