//! What can be said of the shaders without a GPU.

use std::collections::BTreeSet;

use naga::valid::Capabilities;
use origami_shaders::render::{EXTREMES, FACES, LINES, RESOLVE};

use super::super::layout::{Frame, Line, Resolve, Search, Style, Tile, Triangle};
use super::super::node_positions;
use super::super::pipelines::{BINDINGS, Sampling, source};
use crate::shader_checks::{Checked, bindings, checked, checked_with, read_only, same_layout};

fn scene_shaders(sampling: Sampling) -> [Checked; 2] {
    let allowed = match sampling {
        Sampling::Single => Capabilities::empty(),
        Sampling::Four => Capabilities::MULTISAMPLED_SHADING,
    };
    [("faces", FACES), ("lines", LINES)].map(|(name, own)| checked_with(name, &source(own, sampling), allowed))
}

#[test]
fn structs_lie_as_in_rust() {
    for shader in scene_shaders(Sampling::Single) {
        same_layout!(&shader, Style { colour, half_width, on, off, dot_length, bias });
        same_layout!(&shader, Tile { origin, size });
        same_layout!(&shader, Line { nodes, triangles, along, kind, unused });
    }
    let [shader, _] = scene_shaders(Sampling::Four);
    same_layout!(
        &shader,
        Frame {
            matrix,
            front,
            shading,
            back,
            mapped,
            light,
            depth_of_radius,
            up,
            depth_of_pixel,
            size,
            grid,
            edge_on,
            steep,
            unused,
            styles,
        }
    );
    same_layout!(&shader, Triangle { nodes, start, lifts, parts });
    same_layout!(&checked("resolve", RESOLVE), Resolve { ground, factor, size, bare, unused });
    same_layout!(&checked("extremes", EXTREMES), Search { count });
}

#[test]
fn bindings_are_those_that_rust_gives() {
    let [faces, lines] = scene_shaders(Sampling::Four);
    let all = [(&faces, "face_corner"), (&faces, "face_colour"), (&lines, "line_corner"), (&lines, "line_colour")];
    let stages = [wgpu::ShaderStages::VERTEX, wgpu::ShaderStages::FRAGMENT];
    let mut touched = BTreeSet::new();
    for ((shader, entry), stage) in all.into_iter().zip(stages.into_iter().cycle()) {
        for binding in bindings(shader, entry) {
            let (_, visible) = BINDINGS[binding as usize];
            assert!(visible.contains(stage), "{entry} touches {binding}");
            touched.insert(binding);
        }
        let storage: BTreeSet<u32> = (0..).zip(BINDINGS).filter(|(_, (uniform, _))| !uniform).map(|(i, _)| i).collect();
        assert_eq!(read_only(shader), storage);
    }
    assert_eq!(touched, (0..BINDINGS.len() as u32).collect());
    assert_eq!(
        bindings(&checked("node_positions", &node_positions::source()), "node_positions"),
        BTreeSet::from([1, 14])
    );
    assert_eq!(bindings(&checked("resolve", RESOLVE), "resolve"), BTreeSet::from([0, 1, 2]));
    assert_eq!(bindings(&checked("extremes", EXTREMES), "find"), BTreeSet::from([0, 1, 2, 3]));
}
