//! What contact is asked for, and what came of it.

use crate::table::markdown::rounded;
use crate::table::{Column, Table, column};

/// One figure that is asked for.
pub(super) struct Asked {
    what: String,
    asked: String,
    found: String,
    kept: bool,
}

impl Asked {
    /// That something is so.
    pub(super) fn that(
        what: impl Into<String>,
        asked: impl Into<String>,
        found: impl Into<String>,
        kept: bool,
    ) -> Self {
        Self { what: what.into(), asked: asked.into(), found: found.into(), kept }
    }

    /// At most so much; `found` NaN where nothing was.
    pub(super) fn at_most(what: impl Into<String>, most: f64, found: f64) -> Self {
        Self::that(what, format!("at most {}", rounded(most)), rounded(found), found <= most)
    }
}

const COLUMNS: &[Column] = &[
    column("what", "what", "what is asked for"),
    column("asked", "asked", "how much of it"),
    column("found", "found", "what came of it"),
    column("kept", "kept", "whether that is enough"),
];

pub(super) fn table(all: &[Asked]) -> Table {
    let mut table = Table::new(COLUMNS);
    for Asked { what, asked, found, kept } in all {
        table.push(vec![what.as_str().into(), asked.as_str().into(), found.as_str().into(), (*kept).into()]);
    }
    table
}

/// Those that are missed, in words.
pub(super) fn missed(all: &[Asked]) -> String {
    let missed: Vec<&str> = all.iter().filter(|asked| !asked.kept).map(|asked| asked.what.as_str()).collect();
    match missed.as_slice() {
        [] => format!("All {} figures that are asked for are kept.", all.len()),
        missed => {
            format!("Of {} figures that are asked for {} are missed: {}.", all.len(), missed.len(), missed.join("; "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missed_is_named() {
        let kept = || Asked::at_most("strain", 0.3, 0.2);
        assert_eq!(missed(&[kept()]), "All 1 figures that are asked for are kept.");
        let all = [kept(), Asked::at_most("angle", 1.5, f64::NAN), Asked::that("order", "as told", "another", false)];
        assert_eq!(missed(&all), "Of 3 figures that are asked for 2 are missed: angle; order.");
    }
}
