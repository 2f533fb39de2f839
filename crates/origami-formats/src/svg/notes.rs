//! What was left out of a drawing, each kind said once with its first element and how many there are.

use std::collections::BTreeMap;

use origami_core::error::{Warning, WarningCode};

use super::places::Element;

/// Warnings on their way.
#[derive(Debug, Default)]
pub(super) struct Notes {
    warnings: Vec<Warning>,
    /// For each kind of what was left out, its warning and how many more there are.
    kinds: BTreeMap<String, (usize, usize)>,
}

impl Notes {
    /// A warning that stands for itself.
    pub(super) fn say(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }

    /// An element that is left out. `why` is its kind, such as `is hidden`.
    pub(super) fn left_out(&mut self, element: &Element, why: &str) {
        self.kind(WarningCode::LeftOut, element, why, "it is left out");
    }

    /// An element that is read but for something.
    pub(super) fn ignored(&mut self, element: &Element, why: &str) {
        self.kind(WarningCode::LeftOut, element, why, "that is not looked at");
    }

    fn kind(&mut self, code: WarningCode, element: &Element, why: &str, outcome: &str) {
        if let Some((_, more)) = self.kinds.get_mut(why) {
            *more += 1;
            return;
        }
        self.kinds.insert(why.to_owned(), (self.warnings.len(), 0));
        self.warnings.push(Warning::new(code, element.place.clone(), format!("{} {why}; {outcome}", element.name)));
    }

    /// What was left out, for a message that says that nothing remains.
    pub(super) fn summary(&self) -> String {
        let mut kinds: Vec<(usize, &str, usize)> =
            self.kinds.iter().map(|(why, (first, more))| (*first, why.as_str(), more + 1)).collect();
        kinds.sort_unstable();
        let parts: Vec<String> = kinds.iter().take(4).map(|(_, why, count)| format!("{count} × {why}")).collect();
        if parts.is_empty() { String::new() } else { format!(" (left out: {})", parts.join(", ")) }
    }

    /// All of them, in the order of the file.
    pub(super) fn into_warnings(mut self) -> Vec<Warning> {
        for (first, more) in self.kinds.into_values().filter(|(_, more)| *more > 0) {
            self.warnings[first].message.push_str(&format!("; so are {more} more"));
        }
        self.warnings
    }
}
