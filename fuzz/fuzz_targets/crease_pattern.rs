//! Lines on a coarse lattice, some a little off it, with letters, angles and now and then faces: they are refused, or become
//! a pattern whose indices are in range and which a model takes or refuses.
//!
//! Two bytes make a vertex, four a line, and a list of four a face, so that most inputs mean something.
#![no_main]

use std::borrow::Cow;

use libfuzzer_sys::fuzz_target;
use origami_core::fold::{Coordinates, Frame};
use origami_core::glam::DVec3;
use origami_core::{CreasePattern, Material, Model};

const LETTERS: &[u8; 8] = b"BMVFUCJx";

/// The lower four bits are a place on the lattice; the upper ones, if all are set, move it off by less than lines touch.
fn coordinate(byte: u8) -> f64 {
    f64::from(byte & 15) + if byte >= 240 { 1e-7 } else { 0.0 }
}

fn frame(bytes: &[u8]) -> Option<Frame> {
    let (&[vertices, lines, faces], bytes) = bytes.split_first_chunk()?;
    let (vertices, lines, faces) = (3 + usize::from(vertices % 30), usize::from(lines % 60), usize::from(faces % 8));
    let mut bytes = bytes.iter().copied().chain(std::iter::repeat(0));
    let mut next = || bytes.next().unwrap_or(0);
    let index = |byte: u8| u32::from(byte) % vertices as u32;
    let mut frame = Frame::default();
    let place = |x, y| Coordinates { position: DVec3::new(coordinate(x), coordinate(y), 0.0), dimension: 2 };
    frame.vertices_coords = Some((0..vertices).map(|_| place(next(), next())).collect());
    let (mut ends, mut letters, mut angles) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..lines {
        ends.push([index(next()), index(next())]);
        letters.push(Cow::Owned(char::from(LETTERS[usize::from(next() % 8)]).to_string()));
        let angle = next();
        angles.push((angle != 0).then(|| 3.0 * (f64::from(angle) - 128.0)));
    }
    (frame.edges_vertices, frame.edges_assignment) = (Some(ends), Some(letters));
    frame.edges_fold_angle = Some(angles);
    if faces > 0 {
        let corners = |next: &mut dyn FnMut() -> u8| (0..4).map(|_| index(next())).collect();
        frame.faces_vertices = Some((0..faces).map(|_| corners(&mut next)).collect());
    }
    Some(frame)
}

fuzz_target!(|bytes: &[u8]| {
    let Some(frame) = frame(bytes) else { return };
    let Ok(pattern) = CreasePattern::from_frame(&frame) else { return };
    let vertices = pattern.vertices.len();
    assert!(pattern.vertices.iter().all(|place| place.is_finite()), "a vertex that is nowhere");
    assert!(pattern.edges.iter().flat_map(|edge| edge.vertices).all(|v| v.index() < vertices), "an edge to nothing");
    assert!(pattern.faces.iter().flatten().all(|v| v.index() < vertices), "a face of nothing");
    if let Ok(model) = Model::new(&pattern, &Material::default()) {
        assert!(model.rest.iter().all(|place| place.is_finite()), "a node that is nowhere");
    }
});
