//! The structures in `examples/analysis` with their jobs: what MERLIN and MERLIN2 have, from files to figures.
#![cfg(feature = "analysis")]

use std::ops::ControlFlow;
use std::path::Path;

use origami::analysis::job::{Job, Setup};
use origami::analysis::{Ended, Event, Start, Trace};
use origami::fold::Document;
use origami::{CreasePattern, Material, Model};

fn example(name: &str, extension: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/analysis").join(name).with_extension(extension)
}

fn read(name: &str, job: &Job) -> (CreasePattern, Model, Setup) {
    let document = Document::read(example(name, "fold")).expect("FOLD");
    let frame = document.frame(0).expect("a frame");
    let pattern = CreasePattern::from_frame(&frame).expect("a pattern");
    assert!(pattern.warnings.is_empty(), "{name}: {:?}", pattern.warnings);
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let setup = job.setup(&frame, &pattern, &model).expect("a structure");
    (pattern, model, setup)
}

fn follow(name: &str) -> (Setup, Trace) {
    let job = Job::from_slice(&std::fs::read(example(name, "json")).expect("a file")).expect("a job");
    let (_, _, setup) = read(name, &job);
    let trace = setup.structure.trace(&Start::default(), &setup.path, &mut |_| ControlFlow::Continue(()));
    let trace = trace.expect("a path");
    (setup, trace)
}

#[test]
fn their_limit_points_are_those_published() {
    for (name, limits) in [
        ("kresling", &[0.432297769, -0.102125919][..]),
        ("miura-pop-through", &[2.311783656, -1.751595094]),
        ("waterbomb", &[0.611088758, -0.605846464]),
        ("yoshimura", &[151.584548115]),
    ] {
        let (_, trace) = follow(name);
        let found: Vec<f64> = trace
            .points
            .iter()
            .filter(|point| matches!(point.event, Event::LimitPoint { .. }))
            .map(|point| point.load_factor)
            .collect();
        for (got, wanted) in found.iter().zip(limits) {
            assert!((got - wanted).abs() < 1e-8 * wanted.abs().max(1.0), "{name}: {found:?}");
        }
        assert!(found.len() >= limits.len(), "{name}: {found:?}");
    }
}

#[test]
fn their_curves_end_where_other_programs_do() {
    // The load factor at the displacement at which each path ends, as MERLIN, MERLIN2 and Sim-FAST have it.
    for (name, load) in [
        ("miura-folding", 0.7388420514),
        ("miura-bending", 78.52815712),
        ("eggbox-folding", 2.118879559),
        ("single-crease", 1.990067696),
        ("crease-with-locking", 0.9256094566),
        ("hypar", 1.400954844),
        ("strip", 2.923873673),
        ("sim-fast-kresling", -0.07103822381),
    ] {
        let (_, trace) = follow(name);
        let end = trace.points.last().expect("some");
        assert_eq!((trace.ended, &end.event), (Ended::Reached, &Event::End), "{name}");
        let error = (end.load_factor / load - 1.0).abs();
        assert!(error < 1e-6, "{name}: {} is not {load}", end.load_factor);
    }
}

#[test]
fn every_example_makes_a_structure_and_a_design_where_it_asks_for_one() {
    let mut designs = 0;
    for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/analysis")).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let job = Job::from_slice(&std::fs::read(&path).expect("a file")).expect("a job");
        let name = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
        let sheet = match name {
            "kresling-height" => "kresling-tube",
            "miura-saddle" | "miura-cell" => "miura-sheet",
            own => own,
        };
        let (pattern, model, setup) = read(sheet, &job);
        assert!(setup.structure.check().is_ok(), "{name}");
        if job.design.is_some() {
            job.design_setup(&setup, &pattern, &model).expect("a design");
            designs += 1;
        }
    }
    assert_eq!(designs, 2);
}

#[test]
fn a_barrier_is_that_of_a_saddle_of_index_1() {
    let (_, pop_through) = follow("miura-pop-through");
    let states = pop_through.equilibria();
    assert_eq!(states.iter().map(|state| state.index).collect::<Vec<_>>(), [0, 1, 0]);
    assert!((states[0].barrier.expect("a saddle") - 2.185070).abs() < 1e-6);
    // Four negative directions: another way leads lower.
    let (_, kresling) = follow("kresling");
    let states = kresling.equilibria();
    assert_eq!((states[0].barrier, states[1].index), (None, 4));
}
