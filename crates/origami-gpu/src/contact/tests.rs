use std::error::Error;

use origami_core::ids::FaceId;
use origami_core::solve::{Relax, Stop, unwatched};

use super::*;
use crate::testing::gpu;
use crate::testing::layers::model;

/// How far a fold angle may be from the processor's, in degrees: where layers touch, sheets slide a little.
const ANGLE: f64 = 1.0;

/// Largest difference between two lists of angles, in degrees.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs().to_degrees()).fold(0.0, f64::max)
}

#[test]
fn sheets_come_to_the_states_of_the_processor_without_crossings() {
    let Some(gpu) = gpu() else { return };
    let solver = ContactRelax::default();
    let on_gpu = gpu.with_contact(solver.clone());
    for name in ["bird-base", "square-twist", "miura", "waterbomb"] {
        let model = model(name);
        let start = State::at_rest(&model);
        let mut session = on_gpu.on(&model);
        for percent in [60.0, 100.0] {
            let scene = Scene::percent(percent);
            // Each from rest, with the same buffers.
            session.method = solver.clone();
            let begun = std::time::Instant::now();
            let (own, touch) = session.fold_touching(&start, &scene, &mut unwatched).expect("it folds");
            let seconds = begun.elapsed().as_secs_f64();
            let (cpu, plain) = solver.fold_touching(&model, &start, &scene, &mut unwatched).expect("it folds");
            let far = apart(&own.state.fold_angles, &cpu.state.fold_angles);
            println!(
                "{name} at {percent} %: {} and {} evaluations, angles {far:.4} degrees apart, gaps {:.1e} and {:.1e}, pairs {} and {}, {seconds:.2} s",
                own.steps, cpu.steps, touch.least_gap, plain.least_gap, touch.most_pairs, plain.most_pairs,
            );
            assert_eq!((own.stop, cpu.stop), (Stop::Converged, Stop::Converged), "{name} at {percent} %");
            assert!(far < ANGLE, "{name} at {percent} %: {far} degrees");
            assert!(Crossings::of(&model.mesh, &own.state.positions).is_empty(), "{name} at {percent} %");
            assert_eq!(touch.least_gap.is_finite(), percent > 99.0, "{name} at {percent} %");
        }
    }
}

#[test]
fn a_crane_is_blocked_by_the_faces_that_press() {
    let Some(gpu) = gpu() else { return };
    let model = model("crane");
    let solver = gpu.with_contact(ContactRelax::default());
    let begun = std::time::Instant::now();
    let folded = solver.fold_touching(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched);
    let (folded, touch) = folded.expect("it folds");
    println!(
        "crane: {} evaluations, {} limited, {:?} {:.1} s",
        folded.steps,
        touch.limited,
        touch.pressing.first(),
        begun.elapsed().as_secs_f64()
    );
    assert_eq!(folded.stop, Stop::Blocked);
    assert!(touch.pressing.first().is_some_and(|hardest| hardest.force > 0.0 && hardest.gap > 0.0));
    assert!(touch.first_limited.is_some_and(|share| share > 0.3 && share < 1.0), "{:?}", touch.first_limited);
    assert!(touch.farthest.is_some_and(|(_, off)| off > 10_f64.to_radians()));
}

#[test]
fn equal_input_gives_equal_bits_whatever_is_submitted_at_once() {
    let Some(gpu) = gpu() else { return };
    let model = model("square-twist");
    let relax = Relax { steps: Some(700), ..Relax::default() };
    let solver = gpu.with_contact(ContactRelax { relax, ..ContactRelax::default() });
    let mut session = solver.on(&model);
    let fold = |session: &mut ContactOnModel<'_>| {
        session.method.relax.perturbation = 1e-2;
        let folded = session.fold_touching(&State::at_rest(&model), &Scene::percent(100.0), &mut unwatched);
        let (folded, touch) = folded.expect("it folds");
        assert_eq!((folded.stop, folded.steps), (Stop::StepsDone, 700));
        assert!(touch.limited > 0);
        (folded.state, touch)
    };
    assert_eq!(fold(&mut session), fold(&mut session));
}

#[test]
fn what_f32_does_not_bear_is_refused_by_name() {
    let Some(gpu) = gpu() else { return };
    let model = model("bird-base");
    let told = |contact: Contact, start: &State| {
        let relax = Relax { perturbation: 0.0, ..Relax::default() };
        let solver = gpu.with_contact(ContactRelax { relax, contact });
        let failed = solver.fold_touching(&model, start, &Scene::percent(50.0), &mut unwatched).expect_err("refused");
        assert!(matches!(failed, Failed::Refused { .. }), "{failed}");
        failed.to_string()
    };
    let flat = State::at_rest(&model);
    let gap = told(Contact { gap: 1e-5, ..Contact::default() }, &flat);
    assert!(gap.contains("contact gap in radii: 1e-5") && gap.contains("f32"), "{gap}");
    let gap = told(Contact::thick(5e-4), &flat);
    assert!(gap.contains("contact gap"), "a tenth of the thickness: {gap}");
    let stiff = told(Contact { stiffness: 1e40, ..Contact::default() }, &flat);
    assert!(stiff.contains("contact stiffness: 1e40"), "{stiff}");
    assert!(told(Contact { gap: f64::NAN, ..Contact::default() }, &flat).contains("gap NaN"));
    // Folded as far as it goes without contact.
    let crossed = Relax::default().fold_from_rest(&model, 100.0).expect("it folds").state;
    assert!(told(Contact::default(), &crossed).contains("cross where it begins"));
}

#[test]
fn a_state_that_is_crossed_is_an_error_that_is_told() {
    let model = model("square-twist");
    assert_eq!(check_crossings(&model.mesh, &model.rest, 7), Ok(()));
    // Folded as far as it goes without contact.
    let free = Relax::default().fold_from_rest(&model, 100.0).expect("it folds");
    let error = check_crossings(&model.mesh, &free.state.positions, 70).expect_err("it is crossed");
    let GpuError::Crossed { step: 70, faces: [one, other] } = error else { panic!("{error}") };
    assert!(FaceId(one) < FaceId(other));
    let failed = backend(error, &free.state, 40);
    assert!(failed.to_string().contains("after 70 evaluations under contact faces"), "{failed}");
    assert!(failed.source().is_some() || matches!(failed, Failed::Backend { last_read_step: 40, .. }));
}

#[test]
fn sheets_with_thickness_keep_it() {
    let Some(gpu) = gpu() else { return };
    let model = model("strip");
    let contact = Contact::thick(0.01);
    let solver = ContactRelax { contact, ..ContactRelax::default() };
    let fold = |solver: &dyn Touching| {
        let folded = solver.fold_touching(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched);
        folded.expect("it folds")
    };
    let ((own, touch), (cpu, _)) = (fold(&gpu.with_contact(solver.clone())), fold(&solver));
    assert_eq!(own.stop, cpu.stop);
    let far = apart(&own.state.fold_angles, &cpu.state.fold_angles);
    println!(
        "strip, thick: {} {} evaluations, {far:.4} degrees apart, gap {:.1e}",
        own.steps, cpu.steps, touch.least_gap
    );
    assert!(far < ANGLE && touch.least_gap > 0.0, "{far}");
}
