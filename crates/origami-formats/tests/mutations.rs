//! Damage to a file of any format ends in a document or in an error that names a place: never in a panic, without end, or in
//! more than the file can account for.

mod written;

use std::time::{Duration, Instant};

use origami_core::CreasePattern;
use origami_formats::{Options, open};
use proptest::prelude::*;

use written::{Segment, in_all_formats};

/// Small, with what makes files hard: a crossing, a line given twice, one that ends on another, one without length.
fn hard() -> Vec<Segment> {
    let line = |letter, a: [f64; 2], b: [f64; 2]| Segment { letter, ends: [a, b] };
    vec![
        line("B", [-2.0, -2.0], [2.0, -2.0]),
        line("B", [2.0, -2.0], [2.0, 2.0]),
        line("B", [2.0, 2.0], [-2.0, 2.0]),
        line("B", [-2.0, 2.0], [-2.0, -2.0]),
        line("M", [-2.0, -2.0], [2.0, 2.0]),
        line("V", [-2.0, 2.0], [2.0, -2.0]),
        line("F", [2.0, 2.0], [-2.0, -2.0]),
        line("V", [0.0, 0.5], [1.25, 1.25]),
        line("F", [1.0, 1.0], [1.0, 1.0]),
    ]
}

/// More of each format than lines.
const MORE: [&str; 3] = [
    "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\no a\nf 1/1 2/2 3/3\nf -4/1 3/3 -1/4\n#e 1 3 2 90\nl 1 2 3\n",
    "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nM\n90\n3\n70\n1\n10\n0\n20\n0\n42\n0.5\n10\n1\n20\n0\n10\n1\n20\n1\n0\nARC\n10\n0\n\
     20\n0\n40\n1\n50\n0\n51\n90\n0\nSPLINE\n71\n3\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n10\n1\n20\n0\n\
     10\n1\n20\n1\n10\n0\n20\n1\n0\nELLIPSE\n10\n0\n20\n0\n11\n2\n21\n0\n40\n0.5\n41\n0\n42\n3\n0\nENDSEC\n0\nEOF\n",
    "<svg viewBox='0 0 9 9'><style>.m{stroke:red}</style><g transform='rotate(10)'><path class='m' d='M0 0C1 2 3 4 5 6zA1 1 0 0 1 2 2'/>\
     <use href='#a'/><rect id='a' width='3' height='2' rx='1' stroke='#00f' opacity='.5'/></g></svg>",
];

#[derive(Clone, Debug)]
enum Damage {
    Replace(usize, u8),
    Remove(usize, usize),
    Repeat(usize, usize),
    Swap(usize, usize),
    CutOff(usize),
    Number(usize, &'static str),
}

fn damage() -> impl Strategy<Value = Damage> {
    const NUMBERS: [&str; 14] = [
        "-1",
        "1e999",
        "1e308",
        "-1e-308",
        "4294967296",
        "99999999999999999999",
        "0.5",
        "NaN",
        "inf",
        "",
        "7",
        "0",
        "-0",
        "1e100",
    ];
    const BYTES: &[u8] = b"0123456789-.,;eE[]{}<>/&\"'= \t\r\n\x00\xff\x1f\x8bMVvfl#";
    prop_oneof![
        (any::<usize>(), prop::sample::select(BYTES.to_vec())).prop_map(|(at, byte)| Damage::Replace(at, byte)),
        (any::<usize>(), 1..40usize).prop_map(|(at, length)| Damage::Remove(at, length)),
        (any::<usize>(), 1..200usize).prop_map(|(at, length)| Damage::Repeat(at, length)),
        (any::<usize>(), any::<usize>()).prop_map(|(a, b)| Damage::Swap(a, b)),
        any::<usize>().prop_map(Damage::CutOff),
        (any::<usize>(), prop::sample::select(&NUMBERS[..])).prop_map(|(at, text)| Damage::Number(at, text)),
    ]
}

fn apply(text: &mut Vec<u8>, damage: &Damage) {
    let Some(within) = (!text.is_empty()).then_some(text.len()) else { return };
    let range = |at: usize, length: usize| at % within..(at % within + length).min(within);
    match *damage {
        Damage::Replace(at, byte) => text[at % within] = byte,
        Damage::Remove(at, length) => drop(text.drain(range(at, length))),
        Damage::Repeat(at, length) => {
            let again = text[range(at, length)].to_vec();
            text.splice(at % within..at % within, again);
        }
        Damage::Swap(a, b) => text.swap(a % within, b % within),
        Damage::CutOff(at) => text.truncate(at % within),
        Damage::Number(at, number) => {
            let digits: Vec<usize> = (0..within).filter(|i| text[*i].is_ascii_digit()).collect();
            if !digits.is_empty() {
                let at = digits[at % digits.len()];
                text.splice(at..=at, number.bytes());
            }
        }
    }
}

fn texts() -> Vec<String> {
    in_all_formats(&hard()).into_iter().map(|(_, text)| text).chain(MORE.map(str::to_owned)).collect()
}

/// From bytes to a pattern.
fn read(bytes: &[u8]) -> Result<(), String> {
    let document = open(bytes, None, &Options::default()).map_err(|error| error.to_string())?.document;
    let vertices = document.key_frame.vertices_coords.as_ref().map_or(0, Vec::len);
    assert!(vertices <= 100_000, "{vertices} vertices from {} bytes", bytes.len());
    let finite = document.key_frame.vertices_coords.iter().flatten().all(|point| point.position.is_finite());
    assert!(finite, "no reader lets through what is no number");
    for warning in &document.warnings {
        assert!(!warning.to_string().chars().any(char::is_control), "fits on a line: {warning:?}");
    }
    if vertices < 2000 {
        CreasePattern::from_document(&document, 0).map_err(|error| error.to_string())?;
    }
    Ok(())
}

#[test]
fn the_undamaged_texts_are_read() {
    for text in texts() {
        read(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"));
    }
}

/// How many cases: `ORIGAMI_MUTATIONS` gives more, for a long run.
fn cases() -> u32 {
    std::env::var("ORIGAMI_MUTATIONS").ok().and_then(|number| number.parse().ok()).unwrap_or(1500)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn readers_survive(text in prop::sample::select(texts()), damages in prop::collection::vec(damage(), 1..5)) {
        let mut bytes = text.into_bytes();
        damages.iter().for_each(|damage| apply(&mut bytes, damage));
        let started = Instant::now();
        if let Err(message) = read(&bytes) {
            prop_assert!(message.contains(": "), "names a place: {}", message);
            prop_assert!(!message.chars().any(char::is_control), "fits on a line: {:?}", message);
            prop_assert!(message.chars().count() < 1000, "is read: {}", message);
        }
        prop_assert!(started.elapsed() < Duration::from_secs(20), "took {:?}", started.elapsed());
    }
}
