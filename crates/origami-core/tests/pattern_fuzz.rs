//! Frames of all kinds, mostly broken: they are refused, or the pattern holds all its invariants.

mod pattern_support;

use std::borrow::Cow;

use glam::DVec3;
use origami_core::CreasePattern;
use origami_core::fold::{Coordinates, Frame};
use origami_core::mesh::Mesh;
use origami_core::mesh::triangulate::triangulate;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

/// A coordinate on a coarse lattice, so that lines meet and overlap, sometimes a little off it, sometimes anywhere.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => (0..5i32).prop_map(f64::from),
        1 => (0..5i32, -1e-5..1e-5f64).prop_map(|(at, off)| f64::from(at) + off),
        1 => 0.0..4.0f64,
    ]
}

fn letter() -> impl Strategy<Value = Cow<'static, str>> {
    prop_oneof![8 => "[BMVFUCJ]", 1 => "[bmvx]"].prop_map(Cow::Owned)
}

/// Lines without faces.
fn lines() -> impl Strategy<Value = Frame> {
    vec((coordinate(), coordinate()), 4..14).prop_flat_map(|places| {
        let count = places.len() as u32;
        let edges = vec((0..count, 1..count).prop_map(move |(a, step)| (a, (a + step) % count)), 3..24);
        let coords =
            places.iter().map(|&(x, y)| Coordinates { position: DVec3::new(x, y, 0.0), dimension: 2 }).collect();
        (Just(coords), edges).prop_flat_map(|(coords, edges): (Vec<Coordinates>, Vec<(u32, u32)>)| {
            let letters = option::of(vec(letter(), edges.len()));
            let angles = option::weighted(0.3, vec(option::of(-200.0..200.0f64), edges.len()));
            (letters, angles).prop_map(move |(letters, angles)| Frame {
                vertices_coords: Some(coords.clone()),
                edges_vertices: Some(edges.iter().map(|&(a, b)| [a, b]).collect()),
                edges_assignment: letters,
                edges_fold_angle: angles,
                ..Frame::default()
            })
        })
    })
}

/// Lines with faces that have little to do with them, now and then in space.
fn faces() -> impl Strategy<Value = Frame> {
    let loose = vec(vec(0..14u32, 3..8), 1..5);
    (lines(), loose, option::weighted(0.3, vec(coordinate(), 14))).prop_map(|(mut frame, faces, heights)| {
        let coords = frame.vertices_coords.as_mut().expect("lines have places");
        coords.iter_mut().zip(heights.unwrap_or_default()).for_each(|(place, z)| place.position.z = z);
        let count = coords.len() as u32;
        frame.faces_vertices =
            Some(faces.into_iter().map(|face| face.into_iter().map(|v| v % count).collect()).collect());
        frame
    })
}

fn holds(frame: &Frame) -> Result<(), TestCaseError> {
    let pattern = match CreasePattern::from_frame(frame) {
        Ok(pattern) => pattern,
        Err(error) => {
            prop_assert!(error.to_string().contains("; expected "), "{error}");
            return Ok(());
        }
    };
    pattern.sanity_check().map_err(TestCaseError::fail)?;
    let flat = frame.faces_vertices.is_none();
    match triangulate(&pattern) {
        Ok(parts) => {
            let mesh = Mesh::new(&pattern, &parts.triangles, parts.face_of);
            prop_assert!(mesh.is_ok() || !flat, "{:?}", mesh.err());
        }
        Err(error) => prop_assert!(!flat, "a face that was built cannot be triangulated: {error}"),
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn lines_without_faces(frame in lines()) {
        holds(&frame)?;
    }

    #[test]
    fn faces_of_any_kind(frame in faces()) {
        holds(&frame)?;
    }

    /// Taking a built pattern as a file with faces gives the same pattern.
    #[test]
    fn a_built_pattern_reads_back_the_same(frame in lines()) {
        let Ok(built) = CreasePattern::from_frame(&frame) else { return Ok(()) };
        let live: Vec<_> = built.edges.iter().filter(|edge| edge.alias_of.is_none()).collect();
        let again = Frame {
            vertices_coords: Some(
                built.vertices.iter().map(|&position| Coordinates { position, dimension: 2 }).collect(),
            ),
            edges_vertices: Some(live.iter().map(|edge| edge.vertices.map(|v| v.0)).collect()),
            edges_fold_angle: Some(live.iter().map(|edge| edge.fold_angle.map(f64::to_degrees)).collect()),
            edges_assignment: None,
            faces_vertices: Some(built.faces.iter().map(|face| face.iter().map(|v| v.0).collect()).collect()),
            ..Frame::default()
        };
        let again = CreasePattern::from_frame(&again).map_err(|error| TestCaseError::fail(error.to_string()))?;
        again.sanity_check().map_err(TestCaseError::fail)?;
        prop_assert_eq!(&again.faces, &built.faces);
        prop_assert_eq!(again.vertices.len(), built.vertices.len());
        prop_assert_eq!(again.edges.len(), live.len());
    }
}
