//! Folding step by step: what files say, what it asks of a sheet, and what the sheet does.
#![expect(clippy::expect_used, reason = "a test may")]

use std::ops::ControlFlow;

use origami_core::export::{Pose, animation};
use origami_core::fold::{Document, Frame};
use origami_core::ids::EdgeId;
use origami_core::sequence::{Sequence, Stage, Stiffness};
use origami_core::solve::{Reached, State, Stop, fold_sequence};
use origami_core::{CreasePattern, Material, Model, Relax};

/// A strip of three panels: creases 8 and 9 are valleys, edges 0 to 7 the border.
const LETTER: &str = r#"{"vertices_coords": [[0,0],[1,0],[2,0],[3,0],[3,2],[2,2],[1,2],[0,2]],
    "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],[1,6],[2,5]],
    "edges_assignment": ["B","B","B","B","B","B","B","B","V","V"],
    "edges_foldAngle": [0,0,0,0,0,0,0,0,120,90]}"#;

struct Sheet {
    document: Document,
    frame: Frame,
    pattern: CreasePattern,
    model: Model,
}

fn letter(extra: &str) -> Sheet {
    let text = LETTER.replace("\"vertices_coords\"", &format!("{extra}\"vertices_coords\""));
    let document = Document::from_slice(text.as_bytes()).expect("a document");
    let frame = document.frame(0).expect("a frame");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    Sheet { document, frame, pattern, model }
}

impl Sheet {
    fn read(&self, steps: &str) -> Result<Vec<Stage>, origami_core::Error> {
        let sequence = Sequence::from_slice(format!(r#"{{"version": 1, "steps": [{steps}]}}"#).as_bytes())?;
        sequence.with_groups_of(&self.frame)?.stages(&self.frame, &self.pattern, &self.model)
    }

    fn fold(&self, stages: &[Stage], frames: u32) -> Vec<Reached> {
        let mut go = |_, _| ControlFlow::Continue(());
        fold_sequence(&self.model, (&Relax::default(), None), &State::at_rest(&self.model), (stages, frames), &mut go)
            .expect("it folds")
    }

    /// Targets at shares of the first stage, in degrees.
    fn targets(&self, steps: &str, shares: &[f64]) -> Vec<Vec<f64>> {
        let stages = self.read(steps).expect("stages");
        let at = |share: &f64| {
            let targets = stages[0].targets(&self.flat(), *share);
            self.both(&targets).iter().map(|t| (t * 1e9).round() / 1e9).collect()
        };
        shares.iter().map(at).collect()
    }

    /// A list by crease, the diagonals of faces among them.
    fn flat(&self) -> Vec<f64> {
        vec![0.0; self.model.creases.len()]
    }

    /// Where edges 8 and 9 stand in such a list.
    fn places(&self) -> [usize; 2] {
        [8, 9].map(|edge| self.model.crease_of(EdgeId(edge)).expect("a crease").index())
    }

    /// Those of edges 8 and 9 in such a list, in degrees.
    fn both(&self, angles: &[f64]) -> [f64; 2] {
        self.places().map(|crease| angles[crease].to_degrees())
    }

    /// The angles that they have reached.
    fn degrees(&self, reached: &Reached) -> [f64; 2] {
        self.both(&reached.folded.state.fold_angles)
    }
}

fn near(angles: &[f64], expected: &[f64]) {
    assert_eq!(angles.len(), expected.len());
    assert!(angles.iter().zip(expected).all(|(a, e)| (a - e).abs() < 0.02), "{angles:?}, expected {expected:?}");
}

#[test]
fn every_mistake_names_step_and_crease() {
    let sheet = letter(r#""edges_origami:group": [null,null,null,null,null,null,null,null,"left",["left","right"]], "#);
    let cases = [
        (
            r#"{"name": "a", "creases": {"edges": [99]}, "to": 1}"#,
            "origami:sequence.steps[0]: `a`: there is no edge 99; expected an edge from 0 to 9",
        ),
        (r#"{"creases": {"edges": [3]}, "to": 1}"#, "steps[0]: edge 3 has no crease spring"),
        (r#"{"creases": {"vertices": [[0, 5]]}, "to": 1}"#, "steps[0]: there is no edge between vertices 0 and 5"),
        (r#"{"creases": {"groups": ["middle"]}, "to": 1}"#, "steps[0]: no edge is in group `middle`"),
        (r#"{"creases": {"assignment": "M"}, "to": 1}"#, "steps[0]: it names no crease"),
        (r#"{"creases": {"assignment": "X"}, "to": 1}"#, "steps[0]: assignment `X`"),
        (r#"{"creases": {"all": true, "except": {"edges": [8, 9]}}, "to": 1}"#, "steps[0]: it names no crease"),
        (r#"{"creases": {"all": true}}"#, "steps[0]: no `to`"),
        (r#"{"creases": {"all": true}, "mode": "hold", "to": 3}"#, "steps[0]: `to` beside this `mode`"),
        (r#"{"creases": {"all": true}, "to": 3, "start": 0.5, "end": 0.5}"#, "steps[0]: from 0.5 to 0.5 of the step"),
        (r#"{"creases": {"all": true}, "to": 3, "duration": 0}"#, "steps[0]: duration 0"),
        (r#"{"creases": {"all": true}, "to": 3, "with": "previous"}"#, "steps[0]: with previous, and there is none"),
        (r#"{"creases": {"all": true}, "to": "half"}"#, "origami:sequence.steps[0].to: \"half\", expected degrees"),
        (r#"{"creases": {"all": true}, "towards": 3}"#, "origami:sequence.steps[0].towards: unknown field `towards`"),
        (
            r#"{"creases": {"edges": [8]}, "to": 9}, {"name": "b", "creases": {"all": true}, "to": 3, "with": "previous", "start": 0.9}"#,
            "steps[1]: `b`: edge 8 is asked for by step 1 at the same time",
        ),
    ];
    for (steps, expected) in cases {
        let error = sheet.read(steps).expect_err(steps).to_string();
        assert!(error.contains(expected), "{steps}: {error}, expected {expected}");
    }
    for (text, expected) in [
        ("{", "line 1 column 1"),
        ("[]", "origami:sequence: the file holds no object"),
        (r#"{"version": 2, "steps": []}"#, "origami:sequence.version: is 2"),
        (r#"{"version": 1, "steps": []}"#, "origami:sequence.steps: there are none"),
        (
            r#"{"origami:sequence": {"version": 1, "steps": []}, "edges_origami:group": 3}"#,
            "edges_origami:group: is no array",
        ),
        (
            r#"{"origami:sequence": {"version": 1, "steps": []}, "edges_origami:group": [null, 3]}"#,
            "edges_origami:group[1]",
        ),
    ] {
        let error = Sequence::from_slice(text.as_bytes()).expect_err(text).to_string();
        assert!(error.contains(expected), "{text}: {error}");
    }
}

#[test]
fn an_edge_that_was_split_is_refused() {
    // Two diagonals that cross without a vertex there.
    let text = r#"{"vertices_coords": [[0,0],[1,0],[1,1],[0,1]], "edges_vertices": [[0,1],[1,2],[2,3],[3,0],[0,2],[1,3]],
        "edges_assignment": ["B","B","B","B","V","M"]}"#;
    let document = Document::from_slice(text.as_bytes()).expect("a document");
    let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let sequence =
        Sequence::from_slice(br#"{"version":1,"steps":[{"creases":{"edges":[4]},"to":90}]}"#).expect("a sequence");
    let error = sequence.stages(&document.frame(0).expect("a frame"), &pattern, &model).expect_err("it was split");
    assert!(error.to_string().contains("edge 4 was split"), "{error}");
}

#[test]
fn targets_follow_shares_eases_and_selectors() {
    let sheet = letter(r#""edges_origami:group": [null,null,null,null,null,null,null,null,"left",["left","right"]], "#);
    let targets = |steps: &str| sheet.targets(steps, &[0.5, 1.0]);
    assert_eq!(targets(r#"{"creases": {"all": true}, "to": "pattern"}"#), [[60.0, 45.0], [120.0, 90.0]]);
    assert_eq!(targets(r#"{"creases": {"groups": ["right"]}, "to": {"percent": -50}}"#), [[0.0, -22.5], [0.0, -45.0]]);
    assert_eq!(
        targets(r#"{"creases": {"vertices": [[6, 1]]}, "to": 80, "start": 0.25}"#)[0],
        [80.0 / 3.0, 0.0].map(|x: f64| (x * 1e9).round() / 1e9)
    );
    assert_eq!(
        targets(r#"{"creases": {"assignment": "V", "except": {"edges": [9]}}, "to": 80, "end": 0.5}"#),
        [[80.0, 0.0]; 2]
    );
    let smooth = r#"{"creases": {"edges": [8]}, "to": 100, "ease": "smooth"}"#;
    assert_eq!(sheet.targets(smooth, &[0.25, 0.75]), [[15.625, 0.0], [84.375, 0.0]]);
    // There and back in one stage.
    let back = r#"{"creases": {"edges": [8]}, "to": 100, "end": 0.5}, {"creases": {"edges": [8]}, "to": 0, "start": 0.5, "with": "previous"}"#;
    assert_eq!(sheet.targets(back, &[0.25, 0.5, 0.75, 1.0]), [[50.0, 0.0], [100.0, 0.0], [50.0, 0.0], [0.0, 0.0]]);
    assert_eq!(sheet.read(back).expect("stages")[0].shares(4), [0.25, 0.5, 0.75, 1.0]);
    assert_eq!(sheet.read(smooth).expect("stages")[0].shares(1).len(), 8);
}

#[test]
fn creases_fold_one_after_the_other() {
    let sheet = letter("");
    let stages = sheet
        .read(r#"{"name": "left", "creases": {"edges": [8]}, "to": "pattern"}, {"creases": {"edges": [9]}, "to": 60, "duration": 0.5}"#)
        .expect("stages");
    assert_eq!(stages.iter().map(|stage| stage.name.as_str()).collect::<Vec<_>>(), ["left", "step 2"]);
    let reached = sheet.fold(&stages, 1);
    assert_eq!(reached.len(), 2);
    assert!(reached.iter().all(|reached| reached.folded.converged() && reached.share == 1.0));
    near(&sheet.degrees(&reached[0]), &[120.0, 0.0]);
    near(&sheet.degrees(&reached[1]), &[120.0, 60.0]);
    assert!(reached[1].folded.steps < reached[0].folded.steps, "half the ramp");
    let parts = sheet.fold(&stages[..1], 3);
    assert_eq!(parts.iter().map(|reached| (reached.share * 3.0).round()).collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
    near(&sheet.degrees(&parts[1]), &[80.0, 0.0]);
}

#[test]
fn creases_are_freed_held_and_driven_again() {
    let sheet = letter("");
    let stages = sheet
        .read(
            r#"{"creases": {"assignment": "V"}, "to": 40}, {"creases": {"edges": [8]}, "mode": "free"},
               {"creases": {"edges": [9]}, "mode": "hold"}, {"creases": {"edges": [8]}, "to": -30}"#,
        )
        .expect("stages");
    let mut stiffness = Stiffness::of(&sheet.model);
    let [left, right] = sheet.places();
    let mut targets: Vec<f64> = sheet.flat().iter().map(|_| 0.7).collect();
    let mut reached = sheet.flat();
    (reached[left], reached[right]) = (0.2, 0.5);
    stages[1].begin(&mut stiffness, &mut targets, &reached);
    let freed = stiffness.model(&sheet.model).expect("another model");
    assert_eq!((freed.creases[left].stiffness, targets[left], targets[right]), (0.0, 0.7, 0.7));
    stages[2].begin(&mut stiffness, &mut targets, &reached);
    let held = stiffness.model(&sheet.model).expect("another model");
    let stiff = 10.0 * sheet.model.creases[right].stiffness;
    assert_eq!((held.creases[right].stiffness, targets[left], targets[right]), (stiff, 0.7, 0.5));
    stages[3].begin(&mut stiffness, &mut targets, &reached);
    assert_eq!((targets[left], targets[right]), (0.2, 0.5), "from the angle that it has");
    let reached = sheet.fold(&stages, 1);
    near(&sheet.degrees(&reached[3]), &[-30.0, 40.0]);
    // A free crease is not off its target.
    let of_free = &reached[1].folded.state;
    assert_eq!(of_free.targets[left], of_free.fold_angles[left]);
}

#[test]
fn a_stage_that_does_not_settle_ends_when_its_targets_have_arrived() {
    let sheet = letter("");
    let stages = sheet.read(r#"{"creases": {"assignment": "V"}, "to": 100, "settle": false}"#).expect("stages");
    let hurried = &sheet.fold(&stages, 1)[0].folded;
    let settled = sheet.read(r#"{"creases": {"assignment": "V"}, "to": 100}"#).expect("stages");
    let settled = &sheet.fold(&settled, 1)[0].folded;
    assert_eq!((hurried.stop, settled.stop), (Stop::StepsDone, Stop::Converged));
    assert!(hurried.steps < settled.steps, "{} {}", hurried.steps, settled.steps);
}

#[test]
fn the_short_form_folds_each_crease_in_its_time() {
    let sheet = letter(r#""edges_origami:timeline": [null,null,null,null,null,null,null,null,[0,0.4],[0.4,1]], "#);
    let sequence = Sequence::of_timeline(&sheet.frame, 50.0).expect("a timeline").expect("one");
    let stages = sequence.stages(&sheet.frame, &sheet.pattern, &sheet.model).expect("stages");
    assert_eq!(stages.len(), 1);
    let at = |share: f64| sheet.both(&stages[0].targets(&sheet.flat(), share));
    near(&at(0.4), &[60.0, 0.0]);
    near(&at(1.0), &[60.0, 45.0]);
    near(&sheet.degrees(&sheet.fold(&stages, 1)[0]), &[60.0, 45.0]);
    // Those without an entry fold all the time.
    let sheet = letter(r#""edges_origami:timeline": [null,null,null,null,null,null,null,null,[0,0.4],null], "#);
    let sequence = Sequence::of_timeline(&sheet.frame, 100.0).expect("a timeline").expect("one");
    let stages = sequence.stages(&sheet.frame, &sheet.pattern, &sheet.model).expect("stages");
    near(&sheet.both(&stages[0].targets(&sheet.flat(), 0.5)), &[120.0, 45.0]);
    for (entry, expected) in [("[0.4,0.4]", "edges_origami:timeline[9]: is [0.4,0.4]"), ("3", "timeline[9]: is 3")] {
        let sheet =
            letter(&format!(r#""edges_origami:timeline": [null,null,null,null,null,null,null,null,null,{entry}], "#));
        let error = Sequence::of_timeline(&sheet.frame, 100.0).expect_err("a bad entry").to_string();
        assert!(error.contains(expected), "{error}");
    }
    let few = letter(r#""edges_origami:timeline": [null], "#);
    assert!(Sequence::of_timeline(&few.frame, 100.0).is_err());
    assert_eq!(Sequence::of_timeline(&letter("").frame, 100.0).expect("none"), None);
}

#[test]
fn what_was_written_is_folded_again() {
    let sheet = letter("");
    let stages = sheet
        .read(r#"{"name": "left", "creases": {"edges": [8]}, "to": 70}, {"name": "right", "creases": {"edges": [9]}, "to": -20}"#)
        .expect("stages");
    let reached = sheet.fold(&stages, 1);
    let pose = |reached: &Reached| {
        let step = Some(stages[reached.stage].name.clone());
        Pose { step, ..Pose::of(&sheet.model, &sheet.pattern, &reached.folded) }
    };
    let poses: Vec<Pose> = reached.iter().map(pose).collect();
    let written = animation(&sheet.document, 0, &sheet.pattern, &poses).expect("a document");
    assert_eq!(written.frames[0].extra["frame_title"], "left");
    let mut text = Vec::new();
    written.write_to(&mut text).expect("memory");
    let read = Document::from_slice(&text).expect("what was written");
    let again = Sequence::of_frames(&read, 0).expect("two steps");
    assert_eq!(again.steps.iter().map(|step| step.name.as_str()).collect::<Vec<_>>(), ["left", "right"]);
    let stages = again.stages(&sheet.frame, &sheet.pattern, &sheet.model).expect("stages");
    let refolded = sheet.fold(&stages, 1);
    for (one, other) in reached.iter().zip(&refolded) {
        near(&sheet.degrees(other), &sheet.degrees(one));
    }
    near(&sheet.degrees(&refolded[1]), &[70.0, -20.0]);
    assert!(Sequence::of_frames(&sheet.document, 0).is_err(), "a pattern alone has no frames to fold to");
}

#[test]
fn the_examples_fold_to_their_end() {
    let files = [
        (include_str!("../../../examples/sequences/letter-fold.fold"), 2),
        (include_str!("../../../examples/sequences/petal-fold.fold"), 2),
        (include_str!("../../../examples/sequences/crane-base.fold"), 3),
    ];
    for (text, count) in files {
        let document = Document::from_slice(text.as_bytes()).expect("a document");
        let frame = document.frame(0).expect("a frame");
        let pattern = CreasePattern::from_document(&document, 0).expect("a pattern");
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let sequence = Sequence::in_frame(&frame).expect("a sequence").expect("one");
        let stages = sequence.stages(&frame, &pattern, &model).expect("stages");
        let mut go = |_, _| ControlFlow::Continue(());
        let start = State::at_rest(&model);
        let reached =
            fold_sequence(&model, (&Relax::default(), None), &start, (&stages, 1), &mut go).expect("it folds");
        assert_eq!(reached.len(), count);
        for Reached { folded, .. } in &reached {
            let State { fold_angles, targets, .. } = &folded.state;
            let off = fold_angles.iter().zip(targets).map(|(a, t)| (a - t).abs()).fold(0.0, f64::max);
            assert!(folded.converged() && off < 1e-3, "{}: {off}", stages[0].name);
        }
        // They end as the pattern says: all that is flat in it is flat again.
        let last = &reached[count - 1].folded.state;
        if count != 2 || text.contains("letter") {
            let asked = model.creases.iter().map(|crease| crease.full_target);
            assert!(last.targets.iter().zip(asked).all(|(target, asked)| (target - asked).abs() < 1e-9));
        }
    }
}
