//! Any bytes as a FOLD file: they are refused, or what is written reads back as the same document. Its frames are refused
//! or built.
#![no_main]

use libfuzzer_sys::fuzz_target;
use origami_core::fold::Document;
use origami_core::{CreasePattern, Material, Model};

/// More vertices or lines are slow, not strange.
const MOST: usize = 200;

fuzz_target!(|bytes: &[u8]| {
    let Ok(document) = Document::from_slice(bytes) else { return };
    let text = document.to_string().expect("what was read can be written");
    let again = Document::from_slice(text.as_bytes()).expect("what was written can be read");
    assert_eq!(again.to_string().expect("again"), text, "reading and writing changed it");
    for index in 0..document.frame_count().min(4) {
        let Ok(frame) = document.frame(index) else { continue };
        let small = |length: Option<usize>| length.is_none_or(|length| length <= MOST);
        if small(frame.vertices_coords.as_ref().map(Vec::len)) && small(frame.edges_vertices.as_ref().map(Vec::len)) {
            let _ = CreasePattern::from_frame(&frame).map(|pattern| Model::new(&pattern, &Material::default()));
        }
    }
});
