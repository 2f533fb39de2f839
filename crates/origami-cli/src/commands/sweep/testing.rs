//! Rows that nothing has folded, for tests.

use origami::model::Material;
use origami::solve::Point;

use crate::report::{Asked, By, Ending, Head, Measured, Row, Varied};

/// Of a relaxation on the processor.
pub(super) fn head() -> Head {
    let settings = Asked {
        version: "0",
        pattern: "0".to_owned(),
        count: 3,
        percents: vec![50.0],
        perturbations: vec![0.0],
        seeds: 1,
        ea: vec![20.0],
        k_fold: vec![0.7],
        k_facet: vec![0.7],
        k_face: vec![0.2],
        zeta: vec![0.45],
        max_steps: 1000,
        steps: None,
        ramp: None,
        residual: None,
        time_step: "paper".to_owned(),
        integrator: "euler",
        folded: Vec::new(),
        shard: None,
    };
    Head {
        input: "a.fold".to_owned(),
        solver: "relax",
        backend: "cpu",
        backend_by: By::Asked,
        adapter: None,
        precision: "f64",
        tolerance: 1e-4,
        attitude: "sheet".to_owned(),
        settings,
    }
}

/// A sheet that ended so and was not measured.
pub(super) fn row(index: usize, stop: Ending) -> Row {
    let point = Point { material: 0, perturbation: 0.0, seed: 0, percent: 50.0 };
    Row {
        index,
        scene: 0,
        varied: Varied::new(&Material::default(), &point),
        measured: Measured { percent: 50.0, stop, ..Measured::default() },
        diverged: None,
        error: (stop == Ending::Failed).then(|| "the adapter was lost".to_owned()),
        outputs: Vec::new(),
    }
}
