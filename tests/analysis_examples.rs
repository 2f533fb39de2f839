//! The structures in `examples/analysis` with their jobs: what MERLIN and MERLIN2 have, from files to figures.
#![cfg(feature = "analysis")]

use std::ops::ControlFlow;
use std::path::Path;

use origami::analysis::job::{Job, Setup};
use origami::analysis::{Event, Start, Trace};
use origami::fold::Document;
use origami::{CreasePattern, Material, Model};

fn follow(name: &str) -> (Setup, Trace) {
    let path = |extension| {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/analysis").join(name).with_extension(extension)
    };
    let document = Document::read(path("fold")).expect("FOLD");
    let frame = document.frame(0).expect("a frame");
    let pattern = CreasePattern::from_frame(&frame).expect("a pattern");
    assert!(pattern.warnings.is_empty(), "{name}: {:?}", pattern.warnings);
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let job = Job::from_slice(&std::fs::read(path("json")).expect("a file")).expect("a job");
    let setup = job.setup(&frame, &pattern, &model).expect("a structure");
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
