use super::*;
use origami_core::fold::Document;
use origami_core::measure::Strain;
use origami_core::solve::{Relax, Solver};
use origami_core::{Material, Model};

fn without_rulings(document: &Document) -> Document {
    let mut bare = document.clone();
    let frame = &mut bare.key_frame;
    let sources = frame.extra.remove(origami_core::pattern::keys::SOURCE).unwrap();
    let keep: Vec<bool> = sources.as_array().unwrap().iter().map(|s| s != "a ruling").collect();
    fn only<T>(all: &mut Vec<T>, keep: &[bool]) {
        let mut keep = keep.iter();
        all.retain(|_| *keep.next().unwrap());
    }
    only(frame.edges_vertices.as_mut().unwrap(), &keep);
    only(frame.edges_assignment.as_mut().unwrap(), &keep);
    if let Some(angles) = &mut frame.edges_fold_angle {
        only(angles, &keep);
    }
    bare
}

fn folded(document: &Document, percent: f64) -> String {
    let pattern = CreasePattern::from_document(document, 0).unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    let folded = Relax { max_steps: 12_000, ..Relax::default() }.fold_from_rest(&model, percent).unwrap();
    let strain = Strain::of(&model, &folded.state.positions);
    let energy = folded.state.energy(&model);
    format!(
        "{} nodes, strain mean {:.4} % max {:.3} %, energy {:.4} of beams {:.4}, converged {} steps {}",
        model.node_count(),
        100.0 * strain.beams.mean,
        100.0 * strain.beams.max,
        energy.beams + energy.creases + energy.corner_angles,
        energy.beams,
        folded.converged(),
        folded.steps
    )
}

#[test]
fn debug_fold() {
    let files = std::env::var("FILES").unwrap_or("s12 s07".into());
    let percent: f64 = std::env::var("PERCENT").unwrap_or("40".into()).parse().unwrap();
    let tolerance: f64 = std::env::var("TOL").unwrap_or("1".into()).parse().unwrap();
    for f in files.split(' ') {
        let bytes = std::fs::read(format!("/work/shared/svg/{f}.svg")).unwrap();
        let first = crate::svg::read(&bytes, &crate::Options::default()).unwrap();
        let size = CreasePattern::from_document(&first, 0).unwrap().size();
        let options =
            crate::Options { curve_tolerance: Some(TOLERANCE * tolerance * size), ..crate::Options::default() };
        let document = crate::svg::read(&bytes, &options).unwrap();
        eprintln!("{f} rulings  {}", folded(&document, percent));
        eprintln!("{f} delaunay {}", folded(&without_rulings(&document), percent));
    }
}
