//! Patterns as sheets of several materials.

use std::error::Error;

use origami::{Material, Model};

use crate::patterns::{generated, read};

/// A sheet to be folded.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) model: Model,
    /// Whether its material is the default.
    pub(crate) plain: bool,
}

/// All sheets: generated ones, those of `files`, and the smaller of either with soft facets and with stiff creases.
pub(crate) fn all(files: &[String]) -> Result<Vec<Case>, Box<dyn Error>> {
    let patterns = [generated()?, read(files)?].concat();
    let mut scenes = Vec::new();
    for (name, with_materials, pattern) in patterns {
        let default = Material::default();
        let plain = Model::new(&pattern, &default)?;
        if with_materials && plain.node_count() <= 200 {
            for (kind, material) in [
                ("soft facets", Material { k_facet: 0.1 * default.k_facet, ..default }),
                ("stiff creases", Material { k_fold: 10.0 * default.k_fold, ..default }),
            ] {
                scenes.push(Case {
                    name: format!("{name}, {kind}"),
                    model: Model::new(&pattern, &material)?,
                    plain: false,
                });
            }
        }
        scenes.push(Case { name, model: plain, plain: true });
    }
    Ok(scenes)
}
