//! What `relax` makes of crease patterns: a line of CSV for each pattern, percentage and material.
//!
//! `cargo run --release -p origami-tools --bin folds -- [KEY=VALUE ...] FILE.fold ...`, where KEY is `percent` or a number of
//! the material (several values: `percent=60,100`), or `relax`, the settings as JSON, such as `relax={"ramp":400}`.
//!
//! `exact` is the distance from the flat-folded state in radii, at 100 and -100 %.
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use origami::measure::{Strain, align};
use origami::solve::{Reflect, unwatched};
use origami::{CreasePattern, Material, Model, Relax, Scene, Solver, State};

fn main() -> Result<(), Box<dyn Error>> {
    let (settings, files): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|word| word.contains('='));
    let mut relax = Relax::default();
    let mut numbers = vec![("percent", vec![100.0]), ("ea", vec![20.0]), ("k_fold", vec![0.7]), ("k_facet", vec![0.7]), ("k_face", vec![0.2]), ("collapse", vec![0.03])];
    for setting in &settings {
        let (key, value) = setting.split_once('=').ok_or("KEY=VALUE")?;
        if key == "relax" {
            relax = serde_json::from_str(value)?;
            continue;
        }
        let known = numbers.iter_mut().find(|(name, _)| *name == key).ok_or_else(|| format!("no {key}"))?;
        known.1 = value.split(',').map(str::parse).collect::<Result<_, _>>()?;
    }
    println!("name,n,percent,ea,kfold,kface,stop,attempts,evals,E,smax,tangled,off,exact,ms,saddles,fact");
    let [(_, percents), (_, eas), (_, folds), (_, facets), (_, faces), (_, collapses)] = &numbers[..] else { unreachable!() };
    for file in &files {
        let name = Path::new(file).file_stem().map_or(file.as_str().into(), |stem| stem.to_string_lossy());
        let pattern = CreasePattern::read(file)?;
        for ea in eas { for k_fold in folds { for k_facet in facets { for k_face in faces { for percent in percents {
            let (ea, k_fold, k_facet, k_face, percent) = (*ea, *k_fold, *k_facet, *k_face, *percent);
            let model = Model::new(&pattern, &Material { ea, k_fold, k_facet, k_face, collapse: collapses[0], ..Material::default() })?;
            let began = Instant::now();
            let folded = relax.fold(&model, &State::at_rest(&model), &Scene::percent(percent), &mut unwatched);
            let ms = 1e3 * began.elapsed().as_secs_f64();
            let n = model.node_count();
            match folded {
                Ok(f) => {
                    let exact = (percent.abs() == 100.0).then(|| Reflect { tolerance: 1e-3 }.fold_from_rest(&model, percent).ok()).flatten();
                    let exact = exact.map(|e| format!("{:.2e}", align(&f.state.positions, &e.state.positions).max)).unwrap_or_default();
                    let tangled = f.state.fold_angles.iter().filter(|a| a.abs() > 200f64.to_radians()).count();
                    let off = f.state.fold_angles.iter().zip(&f.state.targets).filter(|(a, t)| (*a - *t).abs() > std::f64::consts::PI).count();
                    println!("{name},{n},{percent},{ea},{k_fold},{k_face},{:?},{},{},{:.6e},{:.3e},{tangled},{off},{exact},{ms:.1},{},{}", f.stop, f.attempts, f.steps,
                        f.state.energy(&model).total(), Strain::of(&model, &f.state.positions).beams.max, f.saddles, f.factorisations);
                }
                Err(e) => { eprintln!("{name}: {e}"); println!("{name},{n},{percent},{ea},{k_fold},{k_face},Failed,0,0,,,,,,{ms:.1},0,0"); }
            }
        }}}}}
    }
    Ok(())
}
