//! Random damage to a file ends in a result or an error, never in a panic.

use origami::fold::Document;
use origami::model::{Material, Model};
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::solve::{Relax, Solver, State};
use origami::{CreasePattern, Error};
use proptest::prelude::*;

use crate::place::{Place, SQUARE};

/// Small, with what makes files hard: crossings, a vertex on a line, a cut, a null angle, a frame that inherits.
const HARD: &str = r#"{"file_spec":1.2,"vertices_coords":[[0,0],[4,0],[4,4],[0,4],[2,0],[2,2],[2,4],[1,1,0]],
"edges_vertices":[[0,1],[1,2],[2,3],[3,0],[4,5],[5,6],[0,2],[1,3],[0,7]],
"edges_assignment":["B","B","B","B","C","V","M","F","U"],"edges_foldAngle":[0,0,0,0,0,90,-90,0,null],
"file_frames":[{"frame_parent":0,"frame_inherit":true,"edges_origami:ea":[1,1,1,1,1,1,1,1,null]}]}"#;

/// From text to a few steps of folding.
fn fold(text: &[u8]) -> Result<(), Error> {
    let document = Document::from_slice(text)?;
    for frame in 0..document.frame_count().min(3) {
        let pattern = CreasePattern::from_frame(&document.frame(frame)?)?;
        let model = Model::new(&pattern, &Material::default())?;
        let relax = Relax { steps: Some(20), ramp: Some(10), ..Relax::default() };
        if let Ok(folded) = relax.fold(&model, &State::at_rest(&model), &Scene::percent(100.0), &mut unwatched) {
            assert!(folded.state.positions.iter().all(|p| p.is_finite()), "a state that is not finite is no result");
        }
    }
    Ok(())
}

#[derive(Clone, Debug)]
enum Damage {
    Replace(usize, u8),
    Remove(usize, usize),
    Repeat(usize, usize),
    /// Another number in place of a digit.
    Number(usize, &'static str),
}

fn damage() -> impl Strategy<Value = Damage> {
    const NUMBERS: [&str; 12] =
        ["-1", "1e999", "1e308", "-1e-308", "4294967295", "4294967296", "0.5", "NaN", "null", "[]", "\"\"", "7"];
    prop_oneof![
        (any::<usize>(), prop::sample::select(b"0123456789-.eE[]{},:\"BMVFUCJxn \n\x00\xff".to_vec()))
            .prop_map(|(at, byte)| Damage::Replace(at, byte)),
        (any::<usize>(), 1..12usize).prop_map(|(at, length)| Damage::Remove(at, length)),
        (any::<usize>(), 1..12usize).prop_map(|(at, length)| Damage::Repeat(at, length)),
        (any::<usize>(), prop::sample::select(&NUMBERS[..])).prop_map(|(at, text)| Damage::Number(at, text)),
    ]
}

fn apply(text: &mut Vec<u8>, damage: &Damage) {
    if text.is_empty() {
        return;
    }
    match *damage {
        Damage::Replace(at, byte) => {
            let at = at % text.len();
            text[at] = byte;
        }
        Damage::Remove(at, length) => {
            let at = at % text.len();
            text.drain(at..(at + length).min(text.len()));
        }
        Damage::Repeat(at, length) => {
            let at = at % text.len();
            let again = text[at..(at + length).min(text.len())].to_vec();
            text.splice(at..at, again);
        }
        Damage::Number(at, number) => {
            let digits: Vec<usize> = (0..text.len()).filter(|i| text[*i].is_ascii_digit()).collect();
            if !digits.is_empty() {
                let at = digits[at % digits.len()];
                text.splice(at..=at, number.bytes());
            }
        }
    }
}

fn damaged() -> impl Strategy<Value = Vec<u8>> {
    let text = prop::sample::select(vec![SQUARE.as_bytes().to_vec(), HARD.as_bytes().to_vec()]);
    (text, prop::collection::vec(damage(), 1..4)).prop_map(|(mut text, damages)| {
        damages.iter().for_each(|damage| apply(&mut text, damage));
        text
    })
}

#[test]
fn the_undamaged_texts_fold() {
    for text in [SQUARE, HARD] {
        fold(text.as_bytes()).expect("both are patterns");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_library_survives(text in damaged()) {
        if let Err(error) = fold(&text) {
            let message = error.to_string();
            prop_assert!(message.contains(": "), "names a place: {}", message);
            prop_assert!(!message.chars().any(char::is_control), "fits on a line: {:?}", message);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_program_survives_and_keeps_older_output(text in damaged()) {
        let place = Place::new();
        place.put("a.fold", "as it was");
        std::fs::write(place.path("in.fold"), &text).unwrap();
        let ran = place.run("fold in.fold -o a.fold --max-steps 50 --quiet");
        prop_assert!([0, 1, 2, 3].contains(&ran.code));
        let kept = place.text("a.fold") == "as it was";
        prop_assert_eq!(kept, [1, 2].contains(&ran.code), "exit code {}: {}", ran.code, ran.stderr);
        prop_assert_eq!(ran.stderr.is_empty(), ran.code == 0);
    }
}
