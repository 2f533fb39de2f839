//! Scenes of any size as FOLD documents. `size` is about the number of vertices, edges or frames, whichever is at stake.

use std::borrow::Cow;
use std::f64::consts::TAU;

use origami::export::crease_pattern_document;
use origami::fold::{Coordinates, Document, Frame};
use origami::generate::miura;
use origami::glam::DVec3;

type Scene = fn(usize) -> Document;

/// By name.
pub(crate) const ALL: [(&str, Scene); 13] = [
    ("miura", ordered),
    ("miura_lines", |size| lines(ordered(size))),
    ("miura_shuffled", |size| shuffled(ordered(size))),
    ("miura_lines_shuffled", |size| lines(shuffled(ordered(size)))),
    ("one_face", one_face),
    ("hub", hub),
    ("hub_lines", |size| lines(hub(size))),
    ("islands", islands),
    ("islands_lines", |size| lines(islands(size))),
    ("islands_in_a_row_lines", |size| lines(islands_in_a_row(size))),
    ("cuts", cuts),
    ("duplicates_lines", duplicates),
    ("frames", frames),
];

fn ordered(size: usize) -> Document {
    let panels = (size as f64).sqrt() as usize - 1;
    crease_pattern_document(&miura(panels, panels).expect("valid"), "miura")
}

/// Without faces.
fn lines(mut document: Document) -> Document {
    document.key_frame.faces_vertices = None;
    document
}

/// Vertices, edges and faces in another order.
fn shuffled(mut document: Document) -> Document {
    let frame = &mut document.key_frame;
    let vertices = frame.vertices_coords.as_deref().unwrap_or_default().len();
    let place = |i: usize, of: usize| step(of) * i % of;
    permute(frame.vertices_coords.as_mut(), place);
    permute(frame.edges_vertices.as_mut(), place);
    permute(frame.edges_assignment.as_mut(), place);
    permute(frame.edges_fold_angle.as_mut(), place);
    permute(frame.faces_vertices.as_mut(), place);
    let renumber = |v: &mut u32| *v = number(place(*v as usize, vertices));
    frame.edges_vertices.iter_mut().flatten().flatten().for_each(renumber);
    frame.faces_vertices.iter_mut().flatten().flatten().for_each(renumber);
    document
}

/// A number near the golden section of `of` that has no divisor in common with it.
fn step(of: usize) -> usize {
    let common = |mut a: usize, mut b: usize| {
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    let near = (of as f64 * 0.618) as usize;
    (near.max(1)..).find(|step| common(*step, of) == 1).unwrap_or(1)
}

fn permute<T: Clone>(items: Option<&mut Vec<T>>, place: impl Fn(usize, usize) -> usize) {
    if let Some(items) = items {
        let old = items.clone();
        old.iter().enumerate().for_each(|(i, item)| items[place(i, old.len())] = item.clone());
    }
}

fn number(index: usize) -> u32 {
    u32::try_from(index).expect("a small scene")
}

/// A document of lettered edges; letters are cycled through.
fn document(points: &[[f64; 2]], edges: Vec<[usize; 2]>, letters: &str, faces: Vec<Vec<usize>>) -> Document {
    let letters = letters.chars().map(|letter| Cow::Owned(letter.to_string())).cycle();
    let key_frame = Frame {
        vertices_coords: Some(points.iter().map(|[x, y]| Coordinates::planar(DVec3::new(*x, *y, 0.0))).collect()),
        edges_assignment: Some(letters.take(edges.len()).collect()),
        edges_vertices: Some(edges.into_iter().map(|ends| ends.map(number)).collect()),
        faces_vertices: (!faces.is_empty())
            .then(|| faces.into_iter().map(|f| f.into_iter().map(number).collect()).collect()),
        ..Frame::default()
    };
    Document { key_frame, ..Document::default() }
}

fn circle(corners: usize) -> Vec<[f64; 2]> {
    (0..corners).map(|i| TAU * i as f64 / corners as f64).map(|angle| [angle.cos(), angle.sin()]).collect()
}

fn ring(corners: usize) -> Vec<[usize; 2]> {
    (0..corners).map(|i| [i, (i + 1) % corners]).collect()
}

/// A face of so many corners.
fn one_face(size: usize) -> Document {
    document(&circle(size), ring(size), "B", vec![(0..size).collect()])
}

/// A vertex of that valence.
fn hub(size: usize) -> Document {
    let mut points = circle(size);
    points.push([0.0, 0.0]);
    let spokes = (0..size).map(|i| [i, size]);
    let edges = spokes.zip(ring(size)).flat_map(|(spoke, rim)| [spoke, rim]).collect();
    document(&points, edges, "MBVB", (0..size).map(|i| vec![size, i, (i + 1) % size]).collect())
}

fn triangles(corners: impl Iterator<Item = [f64; 2]>) -> Document {
    let corners: Vec<[f64; 2]> = corners.collect();
    let points: Vec<[f64; 2]> = corners.iter().flat_map(|&[x, y]| [[x, y], [x + 1.0, y], [x, y + 1.0]]).collect();
    let each = || (0..corners.len()).map(|i| 3 * i);
    let edges = each().flat_map(|v| [[v, v + 1], [v + 1, v + 2], [v + 2, v]]).collect();
    document(&points, edges, "B", each().map(|v| vec![v, v + 1, v + 2]).collect())
}

/// Triangles apart from each other, in a square.
fn islands(size: usize) -> Document {
    let wide = (size as f64).sqrt() as usize;
    triangles((0..size).map(|i| [2.0 * (i % wide) as f64, 2.0 * (i / wide) as f64]))
}

/// Side by side: each looks left at all others.
fn islands_in_a_row(size: usize) -> Document {
    triangles((0..size).map(|i| [2.0 * i as f64, 0.0]))
}

/// Two rows of squares, cut from each other but at their ends.
fn cuts(size: usize) -> Document {
    let points: Vec<[f64; 2]> = (0..=size).flat_map(|i| [0.0, 1.0, 2.0].map(|y| [i as f64, y])).collect();
    let (mut edges, mut letters, mut faces) = (Vec::new(), String::new(), Vec::new());
    for v in (0..=size).map(|i| 3 * i) {
        edges.extend([[v, v + 1], [v + 1, v + 2]]);
        letters += if v == 0 || v == 3 * size { "BB" } else { "MV" };
    }
    for v in (0..size).map(|i| 3 * i) {
        edges.extend([0, 1, 2].map(|k| [v + k, v + k + 3]));
        letters += if v == 0 { "BFB" } else { "BCB" };
        faces.extend([0, 1].map(|k| vec![v + k, v + k + 3, v + k + 4, v + k + 1]));
    }
    document(&points, edges, &letters, faces)
}

/// A square with as many vertices on one of its corners, each with a diagonal of its own.
fn duplicates(size: usize) -> Document {
    let mut points = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    points.resize(size + 4, [0.0, 0.0]);
    let mut edges = ring(4);
    edges.extend((0..size).map(|i| [i + 4, 2]));
    document(&points, edges, &("BBBB".to_owned() + &"V".repeat(size)), Vec::new())
}

/// Each frame inherits from the one before it.
fn frames(size: usize) -> Document {
    let mut document = ordered(100);
    let frame = |parent| Frame { parent: Some(number(parent)), inherit: true, ..Frame::default() };
    document.frames = (0..size).map(frame).collect();
    document
}
