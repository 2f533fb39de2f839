//! What is blocked, and what is off its angles by itself.

use origami_core::contact::{Contact, Crossings, touching_lips};
use origami_core::scene::Scene;
use origami_core::solve::{ContactRelax, Stop};
use origami_core::{CreasePattern, fold::Document};

use crate::{model, model_of, off, watched};

#[test]
fn a_sheet_that_would_be_as_far_from_its_angles_without_contact_is_not_blocked() {
    // At 90 % its creases cannot have all of their angles together: without contact it is off by 13.5 degrees.
    for (name, percent, gap, expected) in [
        ("waterbomb", 90.0, 0.01, Stop::Converged),
        ("curved-pleat", 100.0, 0.1, Stop::Converged),
        ("waterbomb", 90.0, 0.03, Stop::Blocked),
    ] {
        let solver = ContactRelax { contact: Contact { gap, ..Contact::default() }, ..ContactRelax::default() };
        let (folded, touch, crossed) = watched(&model(name), &solver, &Scene::percent(percent));
        assert!(!touch.pressing.is_empty() && off(&folded) > 10.0, "{name}, {gap}: layers press, it is off its angles");
        assert_eq!((folded.stop, crossed), (expected, 0), "{name}, {gap}");
    }
}

/// A strip that is cut half way through along its middle, and folded by 90 degrees in what is left there.
const SLIT: &str = r#"{"vertices_coords": [[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1], [1, 0.5]],
    "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 6], [6, 4]],
    "edges_assignment": ["B", "B", "B", "B", "B", "B", "C", "V"], "edges_foldAngle": [0, 0, 0, 0, 0, 0, 0, 90]}"#;

#[test]
fn a_sheet_with_a_cut_that_has_no_width_folds() {
    let document = Document::from_slice(SLIT.as_bytes()).expect("a document");
    let model = model_of(&CreasePattern::from_document(&document, 0).expect("a pattern"));
    let (pairs, nodes) = touching_lips(&model.mesh, &model.rest);
    assert!(pairs >= 2 && nodes.len() == 2, "{pairs} pairs at {nodes:?}");
    // Its lips may go through each other on the way, where it is all but flat; in the end they are apart.
    let (folded, touch, _) = watched(&model, &ContactRelax::default(), &Scene::percent(100.0));
    assert_eq!((folded.stop, touch.pressing.len()), (Stop::Converged, 0));
    assert!(Crossings::of(&model.mesh, &folded.state.positions).is_empty());
    assert!(off(&folded) < 0.1, "{}", off(&folded));
}
