//! Any bytes as a file of any format: they are refused, or become a document of finite coordinates, which makes a pattern or
//! is refused.
#![no_main]

use libfuzzer_sys::fuzz_target;
use origami_core::CreasePattern;
use origami_formats::{Options, open};

/// More vertices or lines are slow, not strange.
const MOST: usize = 200;

fuzz_target!(|bytes: &[u8]| {
    let Ok(opened) = open(bytes, None, &Options::default()) else { return };
    let frame = &opened.document.key_frame;
    assert!(frame.vertices_coords.iter().flatten().all(|point| point.position.is_finite()));
    let small = |length: Option<usize>| length.is_none_or(|length| length <= MOST);
    if small(frame.vertices_coords.as_ref().map(Vec::len)) && small(frame.edges_vertices.as_ref().map(Vec::len)) {
        let _ = CreasePattern::from_document(&opened.document, 0);
    }
});
