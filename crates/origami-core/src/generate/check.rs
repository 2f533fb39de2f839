//! What every generated pattern must satisfy, found from its arrays alone.

use std::collections::HashMap;
use std::f64::consts::PI;

use glam::{DAffine2, DMat2, DVec2, DVec3};

use crate::ids::VertexId;
use crate::pattern::fold_angle;
use crate::pattern::{Assignment, CreasePattern};
use crate::rigid::loop_closure;

/// Faces to the left of each directed edge.
fn half_edges(pattern: &CreasePattern) -> HashMap<[VertexId; 2], usize> {
    let mut left = HashMap::new();
    for (f, face) in pattern.faces.iter().enumerate() {
        for (i, &a) in face.iter().enumerate() {
            let b = face[(i + 1) % face.len()];
            assert_ne!(a, b, "face {f} repeats a corner");
            assert_eq!(left.insert([a, b], f), None, "two faces run along {a:?} {b:?} the same way");
        }
    }
    left
}

/// Topology and letters; `euler` is 1 for a disc and 0 for a ring.
pub(super) fn sound(pattern: &CreasePattern, euler: i64) {
    let counts = [pattern.vertices.len(), pattern.edges.len(), pattern.faces.len()].map(|n| n as i64);
    assert_eq!(counts[0] - counts[1] + counts[2], euler, "Euler characteristic of {counts:?}");
    assert_eq!((pattern.vertices_in_file, pattern.edges_in_file), (pattern.vertices.len(), pattern.edges.len()));
    assert_eq!(pattern.alias_of, vec![None; pattern.vertices.len()]);
    assert!(pattern.warnings.is_empty() && pattern.fixed.is_empty());

    let left = half_edges(pattern);
    assert_eq!(
        left.len(),
        pattern.edges.iter().map(|e| if e.assignment == Assignment::Boundary { 1 } else { 2 }).sum::<usize>()
    );
    for edge in &pattern.edges {
        let [a, b] = edge.vertices;
        let faces = [left.get(&[a, b]), left.get(&[b, a])].into_iter().flatten().count();
        assert_eq!(faces, if edge.assignment == Assignment::Boundary { 1 } else { 2 }, "faces of {edge:?}");
        assert!(edge.alias_of.is_none() && edge.ea.is_none() && edge.k_crease.is_none());
        match (edge.assignment, edge.fold_angle) {
            (Assignment::Boundary | Assignment::Unassigned, None) => {}
            (Assignment::Mountain, Some(angle)) => assert!((-PI..0.0).contains(&angle), "{edge:?}"),
            (Assignment::Valley, Some(angle)) => assert!(angle > 0.0 && angle <= PI, "{edge:?}"),
            (Assignment::Flat, Some(angle)) => assert_eq!(angle, 0.0),
            _ => panic!("{edge:?}: letter and angle do not agree"),
        }
        assert!(pattern.vertices[a.index()].distance(pattern.vertices[b.index()]) > 1e-9, "{edge:?} has no length");
    }
    assert!(pattern.vertices.iter().all(|p| p.is_finite()));
}

/// As [`sound`], and all faces lie in the plane, counterclockwise.
pub(super) fn sound_and_flat(pattern: &CreasePattern, euler: i64) {
    sound(pattern, euler);
    assert!(pattern.vertices.iter().all(|p| p.z == 0.0));
    for face in &pattern.faces {
        let corners: Vec<DVec2> = face.iter().map(|v| pattern.vertices[v.index()].truncate()).collect();
        let next = corners.iter().cycle().skip(1);
        let area: f64 = corners.iter().zip(next).map(|(p, q)| p.perp_dot(*q) / 2.0).sum();
        assert!(area > 1e-12, "face {face:?} has area {area}");
    }
}

/// Kawasaki, Maekawa and the letters around small sectors at every interior vertex where something folds; returns how many there were.
pub(super) fn flat_foldable_vertices(pattern: &CreasePattern) -> usize {
    let mut border = vec![false; pattern.vertices.len()];
    let mut creases: Vec<Vec<(f64, f64)>> = vec![Vec::new(); pattern.vertices.len()];
    for edge in &pattern.edges {
        let [a, b] = edge.vertices.map(VertexId::index);
        if edge.assignment == Assignment::Boundary {
            border[a] = true;
            border[b] = true;
        }
        for (v, w) in [(a, b), (b, a)] {
            let angle = edge.fold_angle.unwrap_or(0.0);
            if angle != 0.0 {
                let away = pattern.vertices[w] - pattern.vertices[v];
                creases[v].push((away.y.atan2(away.x), angle.signum()));
            }
        }
    }
    let mut count = 0;
    for (v, around) in creases.iter_mut().enumerate().filter(|(v, around)| !border[*v] && !around.is_empty()) {
        around.sort_by(|p, q| p.0.total_cmp(&q.0));
        let signs: f64 = around.iter().map(|(_, sign)| sign).sum();
        assert_eq!(signs.abs(), 2.0, "Maekawa at vertex {v}, {}: {around:?}", pattern.vertices[v]);
        // The even sectors add up to pi: (t1 - t0) + (t3 - t2) + ...
        let sum: f64 = around.iter().enumerate().map(|(i, (t, _))| if i % 2 == 0 { -t } else { *t }).sum();
        assert!((sum - PI).abs() < 1e-9, "Kawasaki at vertex {v}, {}: {around:?}", pattern.vertices[v]);
        letters_around_small_sectors(around);
        count += 1;
    }
    count
}

/// Hull's condition: around a run of k equal sectors, smaller than the next on either side, mountains and valleys are as
/// many if k is odd, and differ by one if it is even; else paper would cross. `around` holds azimuths and signs.
fn letters_around_small_sectors(around: &[(f64, f64)]) {
    let n = around.len();
    let sector = |i: usize| (around[(i + 1) % n].0 - around[i % n].0).rem_euclid(2.0 * PI);
    for first in (0..n).filter(|&i| sector(i) < sector(i + n - 1) - 1e-6) {
        let run = (first..first + n).take_while(|&i| (sector(i) - sector(first)).abs() < 1e-6).count();
        if sector(first + run) > sector(first) {
            let signs: f64 = (first..=first + run).map(|i| around[i % n].1).sum();
            let expected = if run % 2 == 1 { 0.0 } else { 1.0 };
            assert_eq!(signs.abs(), expected, "letters around sectors {first} to {} of {around:?}", first + run - 1);
        }
    }
}

/// Folds the sheet flat by reflecting faces across creases, face after face; every face must agree with all its
/// neighbours. Returns the position of each vertex.
pub(super) fn folds_flat(pattern: &CreasePattern) -> Vec<DVec2> {
    let left = half_edges(pattern);
    let folded: HashMap<[VertexId; 2], bool> = pattern
        .edges
        .iter()
        .flat_map(|e| [(e.vertices, e), ([e.vertices[1], e.vertices[0]], e)])
        .map(|(ends, e)| (ends, e.fold_angle.is_some_and(|angle| angle != 0.0)))
        .collect();
    let flat = |v: VertexId| pattern.vertices[v.index()].truncate();
    let mut placed = vec![None; pattern.faces.len()];
    placed[0] = Some(DAffine2::IDENTITY);
    let mut queue = vec![0];
    while let Some(f) = queue.pop() {
        let here: DAffine2 = placed[f].unwrap();
        for (i, &a) in pattern.faces[f].iter().enumerate() {
            let b = pattern.faces[f][(i + 1) % pattern.faces[f].len()];
            let Some(&g) = left.get(&[b, a]) else { continue };
            let there = if folded[&[a, b]] { here * reflection(flat(a), flat(b)) } else { here };
            match placed[g] {
                None => {
                    placed[g] = Some(there);
                    queue.push(g);
                }
                Some(before) => assert!(before.abs_diff_eq(there, 1e-9), "faces {f} and {g} tear along {a:?} {b:?}"),
            }
        }
    }
    let mut positions = vec![DVec2::ZERO; pattern.vertices.len()];
    for (face, place) in pattern.faces.iter().zip(&placed) {
        for &v in face {
            positions[v.index()] = place.unwrap().transform_point2(flat(v));
        }
    }
    positions
}

fn reflection(p: DVec2, q: DVec2) -> DAffine2 {
    let d = (q - p).normalize();
    let linear = DMat2::from_cols(2.0 * d.x * d - DVec2::X, 2.0 * d.y * d - DVec2::Y);
    DAffine2::from_mat2_translation(linear, p - linear * p)
}

/// (fold angle asked for, fold angle that `positions` have) for every crease that is driven.
pub(super) fn measured(pattern: &CreasePattern, positions: &[DVec3]) -> Vec<(f64, f64)> {
    let left = half_edges(pattern);
    // A corner of the face that is off the crease; all faces are flat, so any will do.
    let apex = |a: VertexId, b: VertexId| {
        let face = &pattern.faces[left[&[a, b]]];
        let place = face.iter().position(|&v| v == b).unwrap();
        positions[face[(place + 1) % face.len()].index()]
    };
    let driven = pattern.edges.iter().filter_map(|edge| Some((edge.vertices, edge.fold_angle?)));
    driven
        .map(|([a, b], asked)| (asked, fold_angle(apex(a, b), apex(b, a), positions[a.index()], positions[b.index()])))
        .collect()
}

/// Loop closure around every interior vertex from the sheet's sectors and the fold angles asked for; free edges must
/// not meet it. Returns the largest residual.
pub(super) fn closure(pattern: &CreasePattern) -> f64 {
    let mut around: Vec<Option<Vec<(f64, f64)>>> = vec![Some(Vec::new()); pattern.vertices.len()];
    for edge in &pattern.edges {
        let [a, b] = edge.vertices;
        for (v, w) in [(a, b), (b, a)] {
            let away = pattern.vertices[w.index()] - pattern.vertices[v.index()];
            match (edge.fold_angle, &mut around[v.index()]) {
                (Some(fold), Some(creases)) => creases.push((away.y.atan2(away.x), fold)),
                (None, creases) => *creases = None,
                _ => {}
            }
        }
    }
    around.into_iter().flatten().fold(0.0, |worst, mut creases| {
        creases.sort_by(|p, q| p.0.total_cmp(&q.0));
        let next = creases.iter().cycle().skip(1);
        let turns: Vec<_> =
            creases.iter().zip(next).map(|(&(t, fold), (u, _))| (fold, (u - t).rem_euclid(2.0 * PI))).collect();
        worst.max(loop_closure(&turns))
    })
}

/// Side lengths of all faces, sorted within each, in units of 1e-9.
pub(super) fn side_lengths(pattern: &CreasePattern) -> Vec<Vec<i64>> {
    let position = |v: &VertexId| pattern.vertices[v.index()];
    let sides = |face: &Vec<VertexId>| {
        let next = face.iter().cycle().skip(1);
        let mut lengths: Vec<i64> =
            face.iter().zip(next).map(|(a, b)| (position(a).distance(position(b)) * 1e9).round() as i64).collect();
        lengths.sort_unstable();
        lengths
    };
    pattern.faces.iter().map(sides).collect()
}
