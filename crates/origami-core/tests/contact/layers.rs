//! The order in which layers come to lie, against the one that the flat-folded sheet has.

use origami_core::Solver;
use origami_core::glam::{DVec2, DVec3};
use origami_core::ids::TriangleId;
use origami_core::layers::{Agreement, Stacking, face_orders};
use origami_core::scene::Scene;
use origami_core::solve::{ContactRelax, Reflect, State, Stop};
use origami_core::{Material, Model};

use crate::{off, watched};

/// Places where two triangles lie over each other as they are seen along `up`, and how far the second is above the first there.
fn heights(model: &Model, state: &State, pair: [TriangleId; 2], up: DVec3) -> Vec<f64> {
    let x = up.any_orthonormal_vector();
    let y = up.cross(x);
    let [first, second] = pair.map(|t| {
        model.mesh.triangles[t.index()].map(|n| {
            let p = state.positions[n.index()];
            (DVec2::new(p.dot(x), p.dot(y)), p.dot(up))
        })
    });
    let at = |[a, b, c]: [(DVec2, f64); 3], p: DVec2| {
        let all = (b.0 - a.0).perp_dot(c.0 - a.0);
        let (v, w) = ((p - a.0).perp_dot(c.0 - a.0) / all, (b.0 - a.0).perp_dot(p - a.0) / all);
        (v > 0.02 && w > 0.02 && v + w < 0.98).then_some(a.1 + v * (b.1 - a.1) + w * (c.1 - a.1))
    };
    let mut heights = Vec::new();
    for (i, j) in (1..20).flat_map(|i| (1..20 - i).map(move |j| (f64::from(i) / 20.0, f64::from(j) / 20.0))) {
        let [a, b, c] = first.map(|(p, _)| p);
        let p = a + i * (b - a) + j * (c - a);
        if let (Some(low), Some(high)) = (at(first, p), at(second, p)) {
            heights.push(high - low);
        }
    }
    heights
}

/// What the folds demand, what FOLD files say, and where the paper lies. In a square twist one pair of triangles may lie either
/// way.
#[test]
fn layers_lie_as_the_flat_folded_sheet_must_have_them() {
    for (name, parameters, open) in [
        ("bird-base", vec![], 0),
        ("strip", vec![], 0),
        ("square-twist", vec![], 1),
        ("miura", vec![("columns".to_owned(), 4.0), ("rows".to_owned(), 4.0)], 0),
        ("degree-4", vec![("angle".to_owned(), 180.0)], 0),
    ] {
        let pattern = origami_core::generate::catalog::generate(name, &parameters).expect(name);
        let model = Model::new(&pattern, &Material::default()).expect(name);
        let flat = Reflect::default().fold_from_rest(&model, 100.0).expect(name).state;
        let (folded, touch, crossed) = watched(&model, &ContactRelax::default(), &Scene::percent(100.0));
        assert_eq!((folded.stop, crossed), (Stop::Converged, 0), "{name}: {touch:?}");
        let state = &folded.state;
        let exact = (flat.positions.as_slice(), flat.fold_angles.as_slice());
        let agreement = Agreement::of(&model, exact, (&state.positions, &state.fold_angles)).expect(name);
        println!("{name}: {} degrees off, {agreement:?}", off(&folded));
        assert!(off(&folded) < 5.0 && agreement.pairs > 4, "{name}: {} degrees off", off(&folded));
        assert!(agreement.differ.is_empty() && agreement.told == agreement.forced, "{name}: {agreement:?}");
        assert_eq!(agreement.forced + open, agreement.pairs, "{name}");
        let stacking = Stacking::of(&model, &flat.positions, &flat.fold_angles).expect(name);
        if open == 0 {
            assert_eq!(face_orders(&model, &state.positions, &state.fold_angles), Some(stacking.faces), "{name}");
        }
        // As `up` is where z pointed: the first triangle looks as it does in the flat-folded sheet.
        let normal = |state: &State| {
            let [a, b, c] = model.mesh.triangles[0].map(|n| state.positions[n.index()]);
            (b - a).cross(c - a).normalize()
        };
        let up = normal(state) * normal(&flat).z.signum();
        let mut seen = 0;
        let mut turned = 0;
        for pair in stacking.triangles {
            let heights = heights(&model, state, pair, up);
            let [above, below] = [1.0, -1.0].map(|side| heights.iter().filter(|height| side * **height > 0.0).count());
            assert!(above == 0 || below == 0, "{name}: {pair:?} {heights:?}");
            turned += usize::from(below > 0);
            seen += usize::from(!heights.is_empty());
        }
        assert!(turned <= open, "{name}: {turned} pairs lie the other way round");
        assert!(2 * seen > agreement.pairs, "{name}: {seen} pairs have a place that was looked at");
    }
}
