//! Patterns that fold flat.

use origami_core::generate::catalog;
use origami_core::{CreasePattern, Material, Model};

use crate::{Options, StudyError};

/// A pattern and its sheet.
pub(super) struct Case {
    pub(super) name: String,
    pub(super) model: Model,
}

impl Case {
    pub(super) fn new(name: &str, pattern: &CreasePattern) -> Result<Self, StudyError> {
        Ok(Self { name: name.into(), model: Model::new(pattern, &Material::default())? })
    }
}

/// A generator, its parameters, and the numbers of columns and rows that it is asked for; those that are quick first.
type Family = (&'static str, &'static [(&'static str, f64)], &'static [u32]);

const FAMILIES: [Family; 8] = [
    ("bird-base", &[], &[]),
    ("degree-4", &[("angle", 180.0)], &[]),
    ("miura", &[], &[4, 8, 16, 32, 70]),
    ("miura", &[("gamma", 40.0)], &[8, 16, 32]),
    ("waterbomb", &[], &[2, 4, 8, 16, 40]),
    ("square-twist", &[], &[1, 2, 4, 8, 16, 33]),
    ("square-twist", &[("pleat", 30.0)], &[1, 4, 8, 16]),
    ("square-twist", &[("pleat", 60.0)], &[1, 4, 8, 16]),
];

/// Of each family the quick study takes so many sizes.
const QUICK: usize = 2;

/// The user's patterns, or generated ones.
pub(super) fn cases(options: &Options) -> Result<Vec<Case>, StudyError> {
    if !options.patterns.is_empty() {
        return options.patterns.iter().map(|(name, pattern)| Case::new(name, pattern)).collect();
    }
    let mut cases = Vec::new();
    for (generator, parameters, sizes) in FAMILIES {
        let given: Vec<String> = parameters.iter().map(|(key, value)| format!(", {key} {value}")).collect();
        let given = given.concat();
        let parameters: Vec<(String, f64)> = parameters.iter().map(|(key, value)| ((*key).into(), *value)).collect();
        if sizes.is_empty() {
            cases.push(Case::new(&format!("{generator}{given}"), &catalog::generate(generator, &parameters)?)?);
        }
        for size in sizes.iter().take(if options.quick { QUICK } else { sizes.len() }) {
            let sides = ["columns", "rows"].map(|key| (key.to_owned(), f64::from(*size)));
            let pattern = catalog::generate(generator, &[&parameters[..], &sides].concat())?;
            cases.push(Case::new(&format!("{generator} {size}x{size}{given}"), &pattern)?);
        }
    }
    Ok(cases)
}
