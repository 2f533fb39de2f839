//! Two tables of the same runs against each other.

use std::collections::BTreeMap;
use std::error::Error;

use crate::run::Fold;

/// Energies that differ by less than this share, or by less than the second number, are of one state.
const SAME: (f64, f64) = (1e-3, 1e-7);
/// Largest strain and energy of a flat state.
const FLAT: f64 = 1e-3;
/// Largest distance from the exact state, in radii.
const EXACT: f64 = 1e-4;

/// The percentage and the material without its springs against collapse, as text.
type Kind = String;

/// Prints a line for each percentage and material.
pub(crate) fn print(before: &str, after: &str) -> Result<(), Box<dyn Error>> {
    let (before, after) = (read(before)?, read(after)?);
    println!(
        "| runs | patterns | flat | exact | converged | evaluations | ratio: median | largest up to 600 vertices \
         | factorisations | lower | higher |\n|---|---|---|---|---|---|---|---|---|---|---|"
    );
    let mut kinds: BTreeMap<Kind, Vec<(&Fold, &Fold)>> = BTreeMap::new();
    for ((kind, pattern), fold) in &after {
        if let Some(earlier) = before.get(&(kind.clone(), pattern.clone())) {
            kinds.entry(kind.clone()).or_default().push((earlier, fold));
        }
    }
    kinds.iter().for_each(|(kind, pairs)| println!("{}", line(kind, pairs)));
    Ok(())
}

fn read(path: &str) -> Result<BTreeMap<(Kind, String), Fold>, Box<dyn Error>> {
    let folds: Vec<Fold> = csv::Reader::from_path(path)?.into_deserialize().collect::<Result<_, _>>()?;
    let kind = |f: &Fold| {
        let Fold { percent, ea, k_fold, k_facet, k_face, .. } = f;
        format!("{percent} %, EA {ea}, k {k_fold} {k_facet} {k_face}")
    };
    Ok(folds.into_iter().map(|fold| ((kind(&fold), fold.pattern.clone()), fold)).collect())
}

fn line(kind: &str, pairs: &[(&Fold, &Fold)]) -> String {
    let both = |count: &dyn Fn(&Fold) -> u64| {
        let sums = pairs.iter().fold((0, 0), |(a, b), (before, after)| (a + count(before), b + count(after)));
        format!("{} -> {}", sums.0, sums.1)
    };
    let flat = |f: &Fold| u64::from(f.strain.is_some_and(|s| s < FLAT) && f.energy.is_some_and(|e| e < FLAT));
    let exact = |f: &Fold| u64::from(f.from_exact.is_some_and(|distance| distance < EXACT));
    let mut ratios: Vec<(f64, usize)> = pairs
        .iter()
        .filter(|(before, _)| before.evaluations > 0)
        .map(|(before, after)| (after.evaluations as f64 / before.evaluations as f64, after.vertices))
        .collect();
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    let median = ratios.get(ratios.len() / 2).map_or(f64::NAN, |(ratio, _)| *ratio);
    let largest = ratios.iter().rfind(|(_, vertices)| *vertices <= 600).map_or(f64::NAN, |(ratio, _)| *ratio);
    let less = |a: &Fold, b: &Fold| match (a.energy, b.energy) {
        (Some(a), Some(b)) => a < b * (1.0 - SAME.0) - SAME.1,
        _ => false,
    };
    format!(
        "| {kind} | {} | {} | {} | {} | {} | {median:.2} | {largest:.2} | {} | {} | {} |",
        pairs.len(),
        both(&flat),
        both(&exact),
        both(&|f| u64::from(f.stop == "Converged")),
        both(&|f| f.evaluations),
        both(&|f| u64::from(f.factorisations)),
        pairs.iter().filter(|(before, after)| less(after, before)).count(),
        pairs.iter().filter(|(before, after)| less(before, after)).count(),
    )
}
