//! `--shard`: a part of a sweep, for one of many machines.

use std::num::NonZeroUsize;
use std::ops::Range;

use serde::Serialize;

use super::values::whole;

const EXPECTED: &str = "expected I/N, such as 2/8, or slurm, pbs/N or kubernetes/N, where I is told by the job array";

/// One of so many parts of a sweep, as equal as can be; each has rows that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Shard {
    /// From 1.
    pub(crate) number: usize,
    pub(crate) of: usize,
}

impl Shard {
    /// Of `count` rows those of this part: none where there are more parts than rows.
    pub(crate) fn rows(self, count: usize) -> Range<usize> {
        let begin = |part: usize| (count as u128 * part as u128 / self.of as u128) as usize;
        begin(self.number - 1)..begin(self.number)
    }
}

/// I/N, or the name of what starts an array of jobs. What it tells each of them is asked of the environment.
pub(super) fn shard(text: &str) -> Result<Shard, String> {
    read(text, |name| std::env::var(name).ok())
}

fn read(text: &str, variable: impl Fn(&str) -> Option<String>) -> Result<Shard, String> {
    let (place, of) = match text.split_once('/') {
        Some((place, of)) => (place.trim(), Some(counted(of).ok_or(EXPECTED)?)),
        None => (text.trim(), None),
    };
    let told = |name: &str| {
        let value = variable(name).ok_or_else(|| format!("{name} is not set; expected a job of an array"))?;
        whole::<usize>(0..=u64::MAX)(&value).map_err(|expected| format!("{name} is {value:?}; {expected}"))
    };
    let outside =
        |name: &str, place: usize| format!("{name} is {place}; expected a place among {} parts", of.unwrap_or(0));
    let (number, of) = match (place, of) {
        // An array begins and steps as it was asked to.
        ("slurm", of) => {
            let [id, least, count] = ["ID", "MIN", "COUNT"].map(|what| told(&format!("SLURM_ARRAY_TASK_{what}")));
            let (id, least, count) = (id?, least?, count?);
            let step = told("SLURM_ARRAY_TASK_STEP").unwrap_or(1).max(1);
            (id.saturating_sub(least) / step + 1, of.unwrap_or(count))
        }
        ("pbs", Some(of)) => (told("PBS_ARRAY_INDEX")?, of),
        // The one that counts from 0.
        ("kubernetes", Some(of)) => {
            let index = told("JOB_COMPLETION_INDEX")?;
            if index >= of {
                return Err(outside("JOB_COMPLETION_INDEX", index));
            }
            (index + 1, of)
        }
        (number, Some(of)) => (number.parse().map_err(|_| EXPECTED)?, of),
        _ => return Err(EXPECTED.to_owned()),
    };
    if of == 0 || !(1..=of).contains(&number) {
        return Err(format!("there is no part {number} of {of}; {EXPECTED}"));
    }
    Ok(Shard { number, of })
}

fn counted(text: &str) -> Option<usize> {
    text.trim().parse::<NonZeroUsize>().ok().map(NonZeroUsize::get)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_is_in_one_part_and_parts_are_equal_but_for_one_row() {
        for (count, of) in [(10, 3), (3, 10), (7, 7), (1_000_000, 999_999), (1, 1)] {
            let parts: Vec<_> = (1..=of).map(|number| Shard { number, of }.rows(count)).collect();
            assert!(parts.windows(2).all(|two| two[0].end == two[1].start));
            assert_eq!((parts[0].start, parts[of - 1].end), (0, count));
            let sizes = || parts.iter().map(ExactSizeIterator::len);
            assert!(sizes().max().unwrap_or(0) - sizes().min().unwrap_or(0) <= 1, "{count} in {of}");
        }
    }

    #[test]
    fn a_part_is_named_or_told_by_the_job_array() {
        let of = |text, variables: &'static [(&str, &str)]| {
            read(text, |name| Some(variables.iter().find(|(key, _)| *key == name)?.1.to_owned()))
        };
        assert_eq!(of("2/8", &[]), Ok(Shard { number: 2, of: 8 }));
        let slurm = &[
            ("SLURM_ARRAY_TASK_ID", "14"),
            ("SLURM_ARRAY_TASK_MIN", "10"),
            ("SLURM_ARRAY_TASK_COUNT", "5"),
            ("SLURM_ARRAY_TASK_STEP", "2"),
        ];
        assert_eq!(of("slurm", slurm), Ok(Shard { number: 3, of: 5 }));
        assert_eq!(of("pbs/4", &[("PBS_ARRAY_INDEX", "4")]), Ok(Shard { number: 4, of: 4 }));
        assert_eq!(of("kubernetes/4", &[("JOB_COMPLETION_INDEX", "0")]), Ok(Shard { number: 1, of: 4 }));
        let failed = |text, variables| of(text, variables).expect_err("refused");
        assert!(failed("slurm", &[]).starts_with("SLURM_ARRAY_TASK_ID is not set"));
        assert!(failed("pbs/4", &[("PBS_ARRAY_INDEX", "x")]).starts_with("PBS_ARRAY_INDEX is \"x\"; expected a whole"));
        assert!(failed("kubernetes/4", &[("JOB_COMPLETION_INDEX", "4")]).contains("among 4 parts"));
        for wrong in ["0/3", "4/3", "1/0", "1", "a/b", "/", "", "pbs"] {
            assert!(failed(wrong, &[]).contains("expected I/N"), "{wrong}");
        }
    }
}
