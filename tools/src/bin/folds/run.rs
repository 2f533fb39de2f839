//! Folds, and writes a line for each.

use std::error::Error;
use std::io;
use std::time::Instant;

use origami::measure::{Strain, align};
use origami::scene::Scene;
use origami::solve::{Reflect, unwatched};
use origami::{Material, Model, Relax, Solver, State};
use serde::{Deserialize, Serialize};

use crate::patterns;

/// By how much a file may miss itself at the flat-folded state, in radii.
const CLOSED: f64 = 1e-3;

/// One fold.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Fold {
    pub(crate) pattern: String,
    pub(crate) vertices: usize,
    pub(crate) percent: f64,
    pub(crate) ea: f64,
    pub(crate) k_fold: f64,
    pub(crate) k_facet: f64,
    pub(crate) k_face: f64,
    pub(crate) collapse: f64,
    /// How the solver stopped, or what went wrong.
    pub(crate) stop: String,
    pub(crate) attempts: u32,
    pub(crate) saddles: u32,
    pub(crate) evaluations: u64,
    pub(crate) factorisations: u32,
    pub(crate) energy: Option<f64>,
    /// The largest of a beam.
    pub(crate) strain: Option<f64>,
    pub(crate) lost_creases: Option<usize>,
    /// From the flat-folded state in radii, beside the file's own misfit; at 100 and -100 %, where there is one.
    pub(crate) from_exact: Option<f64>,
    pub(crate) milliseconds: f64,
}

/// What is asked for.
struct Asked {
    relax: Relax,
    percents: Vec<f64>,
    materials: Vec<Material>,
    most: usize,
}

/// Folds what the words say, and prints it.
pub(crate) fn print(words: &[String]) -> Result<(), Box<dyn Error>> {
    let (settings, files): (Vec<String>, Vec<String>) = words.iter().cloned().partition(|word| word.contains('='));
    let asked = Asked::read(&settings)?;
    let all = if files.is_empty() { patterns::generated()? } else { patterns::read(&files)? };
    let mut rows = csv::Writer::from_writer(io::stdout());
    for (name, _, pattern) in all {
        for model in Model::of_each(&pattern, &asked.materials)? {
            for percent in asked.percents.iter().filter(|_| model.node_count() <= asked.most) {
                rows.serialize(fold(&name, &model, &asked.relax, *percent))?;
                rows.flush()?;
            }
        }
    }
    Ok(())
}

impl Asked {
    fn read(settings: &[String]) -> Result<Self, Box<dyn Error>> {
        let usual = vec![Material::default()];
        let mut asked =
            Self { relax: Relax::default(), percents: vec![60.0, 100.0], materials: usual, most: usize::MAX };
        for (key, value) in settings.iter().filter_map(|setting| setting.split_once('=')) {
            match key {
                "relax" => asked.relax = serde_json::from_str(value)?,
                "most" => asked.most = value.parse()?,
                "percent" => asked.percents = numbers(value)?,
                _ => {
                    let set = setter(key).ok_or_else(|| format!("there is no {key}"))?;
                    let (before, numbers) = (std::mem::take(&mut asked.materials), numbers(value)?);
                    let with = |number: &f64, mut material: Material| {
                        *set(&mut material) = *number;
                        material
                    };
                    let each = before.iter().flat_map(|material| numbers.iter().map(|number| with(number, *material)));
                    asked.materials = each.collect();
                }
            }
        }
        Ok(asked)
    }
}

fn setter(key: &str) -> Option<fn(&mut Material) -> &mut f64> {
    Some(match key {
        "ea" => |material| &mut material.ea,
        "k_fold" => |material| &mut material.k_fold,
        "k_facet" => |material| &mut material.k_facet,
        "k_face" => |material| &mut material.k_face,
        "collapse" => |material| &mut material.collapse,
        _ => return None,
    })
}

fn numbers(text: &str) -> Result<Vec<f64>, std::num::ParseFloatError> {
    text.split(',').map(str::parse).collect()
}

fn fold(pattern: &str, model: &Model, relax: &Relax, percent: f64) -> Fold {
    let began = Instant::now();
    let folded = relax.fold(model, &State::at_rest(model), &Scene::percent(percent), &mut unwatched);
    let milliseconds = 1e3 * began.elapsed().as_secs_f64();
    let Material { ea, k_fold, k_facet, k_face, collapse, .. } = model.material;
    let mut row = Fold {
        pattern: pattern.to_owned(),
        vertices: model.node_count(),
        percent,
        ea,
        k_fold,
        k_facet,
        k_face,
        collapse,
        stop: String::new(),
        attempts: 0,
        saddles: 0,
        evaluations: 0,
        factorisations: 0,
        energy: None,
        strain: None,
        lost_creases: None,
        from_exact: None,
        milliseconds,
    };
    match folded {
        Err(failed) => row.stop = failed.to_string(),
        Ok(folded) => {
            row.stop = format!("{:?}", folded.stop);
            (row.attempts, row.saddles) = (folded.attempts, folded.saddles);
            (row.evaluations, row.factorisations) = (folded.steps, folded.factorisations);
            row.energy = Some(folded.state.energy(model).total());
            row.strain = Some(Strain::of(model, &folded.state.positions).beams.max);
            row.lost_creases = Some(folded.state.lost_creases());
            row.from_exact = from_exact(model, &folded.state, percent);
        }
    }
    row
}

fn from_exact(model: &Model, state: &State, percent: f64) -> Option<f64> {
    let exact = Reflect { tolerance: CLOSED }.fold_from_rest(model, percent).ok()?;
    Some((align(&state.positions, &exact.state.positions).max - exact.distance).max(0.0))
}
