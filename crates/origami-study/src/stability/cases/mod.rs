//! What the study runs: families of cases, each along one parameter.

mod families;
pub(super) mod patterns;

use origami_core::{CreasePattern, Error, Material};

pub(super) use families::all;

/// How much of a row is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Size {
    /// Small enough for all that is run.
    Small,
    /// Too large for many steps: a few of each solver, which then answer that they have not arrived.
    Large,
}

/// A sheet and what is asked of it: a row of the study before it is run.
#[derive(Debug)]
pub(super) struct Case {
    /// Rows of one family are counted together.
    pub(super) family: &'static str,
    /// The name of the pattern that is folded.
    pub(super) pattern_name: String,
    /// The parameter that the family varies.
    pub(super) parameter: &'static str,
    /// The value of the parameter.
    pub(super) value: f64,
    /// The sheet, or why there is none.
    pub(super) pattern: Result<CreasePattern, Error>,
    /// The material of the sheet.
    pub(super) material: Material,
    /// Percentages that it is sent to, one after the other; the target jumps.
    pub(super) path: Vec<f64>,
    /// Whether the sheet is too large for many steps.
    pub(super) size: Size,
    /// Whether the quick study has it.
    pub(super) quick: bool,
}

impl Case {
    /// Of the default material, sent to 60 %.
    fn new(family: &'static str, name: impl Into<String>, pattern: Result<CreasePattern, Error>) -> Self {
        Self {
            family,
            pattern_name: name.into(),
            parameter: "",
            value: f64::NAN,
            pattern,
            material: Material::default(),
            path: vec![60.0],
            size: Size::Small,
            quick: false,
        }
    }

    fn with(mut self, parameter: &'static str, value: f64) -> Self {
        (self.parameter, self.value) = (parameter, value);
        self
    }

    fn made_of(mut self, material: Material) -> Self {
        self.material = material;
        self
    }

    fn sent_to(mut self, path: &[f64]) -> Self {
        self.path = path.to_vec();
        self
    }

    fn large(mut self) -> Self {
        self.size = Size::Large;
        self
    }

    /// In the quick study too, where that is so.
    fn quick(mut self, quick: bool) -> Self {
        self.quick = quick;
        self
    }

    /// Pattern, parameter and value, as tables name the case.
    pub(super) fn name(&self) -> String {
        if self.parameter.is_empty() {
            self.pattern_name.clone()
        } else {
            format!("{}, {} {}", self.pattern_name, self.parameter, self.value)
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn rows_are_sheets_and_differ() {
        let cases = all();
        let mut seen = HashSet::new();
        for case in &cases {
            assert!(case.pattern.is_ok(), "{}", case.name());
            let path: Vec<u64> = case.path.iter().map(|p| p.to_bits()).collect();
            assert!(seen.insert((case.family, case.name(), path)), "{} twice", case.name());
        }
        let families: HashSet<_> = cases.iter().map(|s| s.family).collect();
        let quick: HashSet<_> = cases.iter().filter(|s| s.quick).map(|s| s.family).collect();
        assert_eq!(families, quick, "the quick study has a part of each family");
    }
}
