//! What is folded: jumps from flat, on which solvers are compared in full, and all generated patterns as a user folds them.

use origami_core::generate::{self, catalog};
use origami_core::solve::default_ramp;
use origami_core::{CreasePattern, Material, Model};

use crate::{Options, StudyError};

/// Sheets above this many nodes are asked for their folded state only once: no scheme but `relax` would end.
pub(super) const LARGE: usize = 3000;

/// A sheet, what is asked of it, and how it starts.
#[derive(Clone, Debug)]
pub(super) struct Case {
    pub(super) name: String,
    pub(super) model: Model,
    pub(super) percent: f64,
    /// Evaluations over which the target angles rise; 0 is a jump.
    pub(super) ramp: u32,
    /// Whether every variant of every solver is run, not only each solver as it comes.
    pub(super) in_full: bool,
}

impl Case {
    /// Name and percentage: what a plot is called.
    pub(super) fn title(&self) -> String {
        let start = if self.ramp == 0 { "a jump from flat" } else { "the default ramp" };
        format!("{} at {} %, {start}", self.name, self.percent)
    }

    fn jump(name: &str, model: Model) -> Self {
        Self { name: name.into(), model, percent: 60.0, ramp: 0, in_full: true }
    }

    fn risen(name: &str, model: &Model, percent: f64) -> Self {
        Self { name: name.into(), model: model.clone(), percent, ramp: default_ramp(model), in_full: false }
    }
}

/// The cases of a study: the shipped ones, or the user's patterns.
pub(super) fn cases(options: &Options) -> Result<Vec<Case>, StudyError> {
    let soft = Material::default();
    let mut cases = Vec::new();
    if options.patterns.is_empty() {
        let small = generate::miura(10, 10)?;
        cases.push(Case::jump("miura 10x10", Model::new(&small, &soft)?));
        if !options.quick {
            cases.push(Case::jump("miura 30x30", Model::new(&generate::miura(30, 30)?, &soft)?));
            let stiff_facets = Material { k_facet: 70.0, ..soft };
            cases.push(Case::jump("miura 10x10, k_facet 70", Model::new(&small, &stiff_facets)?));
            let stiff_beams = Material { ea: 2000.0, ..soft };
            cases.push(Case::jump("miura 10x10, EA 2000", Model::new(&small, &stiff_beams)?));
        }
    }
    for (name, pattern) in risen(options)? {
        let model = Model::new(&pattern, &soft)?;
        let percents: &[f64] = if options.quick { &[60.0] } else { &[60.0, 100.0] };
        cases.extend(percents.iter().map(|percent| Case::risen(&name, &model, *percent)));
    }
    Ok(cases)
}

/// The patterns that are folded with the default ramp. Rings that are made folded have nothing to fold unless driven.
fn risen(options: &Options) -> Result<Vec<(String, CreasePattern)>, StudyError> {
    if !options.patterns.is_empty() {
        return Ok(options.patterns.clone());
    }
    let names: &[&str] = if options.quick { &["degree-4", "bird-base", "kresling"] } else { catalog::names() };
    let made = names.iter().filter(|name| !name.ends_with("-ring")).map(|name| {
        let pattern = catalog::generate(name, &[])?;
        Ok((String::from(*name), pattern))
    });
    made.collect()
}
