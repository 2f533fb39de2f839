//! What is measured side by side, against the plain functions, in every region.

use glam::DVec3;

use super::{Given, Measured, Push, WIDTH, measure_edges, measure_ends, measure_points, push};
use crate::contact::distance::{Nearest, of_edges, of_point_and_triangle};
use crate::contact::noise::noise;
use crate::contact::pairs::{Near, Pair};
use crate::ids::NodeId;

/// Four points that are one by one of `from`, and so far apart.
fn points(from: &mut impl FnMut() -> f64) -> [DVec3; 4] {
    std::array::from_fn(|_| DVec3::new(from(), from(), from()))
}

/// Edges at an angle of that sine that pass each other near some ends.
fn nearly_parallel(from: &mut impl FnMut() -> f64, sine: f64) -> [DVec3; 4] {
    let (shift, height) = (1.2 * from(), 0.05 * from());
    [
        DVec3::ZERO,
        DVec3::X,
        DVec3::new(shift, -0.5 * sine, height),
        DVec3::new(shift + 1.0 + 0.3 * from(), 0.5 * sine, height),
    ]
}

/// All of these side by side.
fn given(all: &[[DVec3; 4]]) -> Given {
    let mut given = Given::new();
    for (i, points) in all.iter().enumerate() {
        given.place(i, &[0, 1, 2, 3].map(NodeId), points);
    }
    given
}

/// By how much the measures of pair `i` differ from those of the plain function.
fn difference(measured: &Measured, i: usize, plain: &Nearest) -> f64 {
    let distance = plain.apart.length();
    let own = DVec3::from_array(measured.normal.map(|row| row[i]));
    let weights = measured.weights.iter().zip(plain.weights).map(|(row, plain)| (row[i] - plain).abs());
    weights.fold((measured.gap[i] - distance).abs().max((own - plain.apart / distance).length()), f64::max)
}

/// Which of the weights are 0.
fn region(weights: &[f64; 4]) -> usize {
    weights.iter().enumerate().map(|(i, weight)| usize::from(*weight == 0.0) << i).sum()
}

#[test]
fn points_and_triangles_are_as_far_apart_as_plainly_in_every_region() {
    let (mut from, mut regions, mut measured) = (noise(5), [0; 16], Measured::new());
    for _ in 0..60 {
        let all: Vec<[DVec3; 4]> = (0..WIDTH).map(|_| points(&mut from)).collect();
        measure_points(&given(&all), &mut measured);
        for (i, points) in all.iter().enumerate() {
            let plain = of_point_and_triangle(points);
            assert!(difference(&measured, i, &plain) < 1e-11, "{points:?}: {plain:?}");
            assert_eq!(region(&measured.weights.map(|row| row[i])), region(&plain.weights));
            regions[region(&plain.weights)] += 1;
        }
    }
    assert_eq!(regions.iter().filter(|count| **count > 10).count(), 7, "{regions:?}");
}

#[test]
fn edges_are_as_far_apart_as_plainly_in_every_region() {
    let (mut from, mut regions, mut measured) = (noise(7), [0; 16], Measured::new());
    for round in 0..120 {
        // Half of them at smaller and smaller angles.
        let sine = 10.0_f64.powf(-f64::from(round) / 35.0);
        let mut make =
            |i: usize| if i.is_multiple_of(2) { points(&mut from) } else { nearly_parallel(&mut from, sine) };
        let all: Vec<[DVec3; 4]> = (0..WIDTH).map(&mut make).collect();
        measure_edges(&given(&all), &mut measured);
        for (i, points) in all.iter().enumerate() {
            let plain = of_edges(points);
            // Where edges of length 1 pass is known to some last places over the squared sine.
            let known = 1e-14 / measured.sine[i].min(1.0);
            let difference = difference(&measured, i, &plain);
            assert!(difference < 1e-11 + 10.0 * known, "{points:?}: {plain:?} differs by {difference}");
            let of_gap = (measured.gap[i] - plain.apart.length()).abs();
            assert!(of_gap < 1e-11 + 10.0 * known * known / plain.apart.length(), "{points:?}: {plain:?} by {of_gap}");
            regions[region(&plain.weights)] += 1;
        }
    }
    assert!(regions.iter().filter(|count| **count > 10).count() >= 9, "{regions:?}");
}

#[test]
fn edges_that_are_nearly_parallel_are_as_far_apart_as_plainly() {
    let (mut from, mut measured, mut ends, mut others) = (noise(13), Measured::new(), 0, 0);
    for round in 0..40 {
        let sine = if round == 39 { 0.0 } else { 10.0_f64.powf(-2.0 - f64::from(round) / 3.0) };
        let all: Vec<[DVec3; 4]> = (0..WIDTH).map(|_| nearly_parallel(&mut from, sine)).collect();
        measure_edges(&given(&all), &mut measured);
        let before = measured.clone();
        measure_ends(&given(&all), &mut measured);
        for (i, points) in all.iter().enumerate() {
            if !measured.is_parallel(i) {
                assert_eq!(measured.gap[i].to_bits(), before.gap[i].to_bits(), "others stay as they are");
                others += 1;
                continue;
            }
            let distance = of_edges(points).apart.length();
            assert!((measured.gap[i] - distance).abs() < 1e-13, "{points:?}: {}, not {distance}", measured.gap[i]);
            let weights = measured.weights.map(|row| row[i]);
            let apart: DVec3 = points.iter().zip(weights).map(|(p, w)| *p * w).sum();
            assert!((apart.length() - distance).abs() < 1e-13, "{points:?}: {weights:?}");
            ends += usize::from(weights.contains(&0.0));
        }
    }
    assert!(ends > 500 && others > 100, "{ends} {others}");
}

#[test]
fn edges_that_are_too_parallel_are_told() {
    let mut measured = Measured::new();
    let sines = [1e-3, 1.1e-4, 0.9e-4, 1e-6, 0.0];
    let parallel = |sine: f64| [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, sine)];
    let mut all = sines.map(parallel).to_vec();
    // And what is no edge.
    all.push([DVec3::ZERO; 4]);
    measure_edges(&given(&all), &mut measured);
    let told = std::array::from_fn(|i| measured.is_parallel(i));
    assert_eq!(told, [false, false, true, true, true, true]);
}

#[test]
fn they_push_as_plainly() {
    let (mut from, mut measured, mut pushes) = (noise(9), Measured::new(), Push::new());
    let (mut eased_out, mut stiffest) = (0, 0.0_f64);
    for edges in [false, true] {
        for round in 0..20 {
            let sine = 10.0_f64.powf(-f64::from(round) / 6.0);
            let mut make =
                |i: usize| if i.is_multiple_of(2) { points(&mut from) } else { nearly_parallel(&mut from, sine) };
            let all: Vec<[DVec3; 4]> = (0..WIDTH).map(&mut make).collect();
            let mut given = given(&all);
            (given.width, given.closed, given.eased) = ([2.5; WIDTH], [-1e-3; WIDTH], [1e-3; WIDTH]);
            if edges {
                measure_edges(&given, &mut measured);
            } else {
                measure_points(&given, &mut measured);
            }
            push(edges, 50.0, &given, &measured, &mut pushes);
            for (i, points) in all.iter().enumerate().filter(|(i, _)| !edges || measured.sine[*i] > 1e-6) {
                let nodes = [0, 1, 2, 3].map(NodeId);
                let split = if edges { 2 } else { 1 };
                let pair = Pair { nodes, split, closed: -1e-3, width: 2.5, eased: 1e-3 };
                let near: Near = pair.near(0, points);
                if near.gap >= pair.width {
                    continue;
                }
                let turning = pushes.turning.each_ref().map(|rows| DVec3::from_array(rows.map(|row| row[i])));
                let beside = match edges && pushes.factor[i] < 1.0 {
                    true => [-turning[0], turning[0], -turning[1], turning[1]],
                    false => [DVec3::ZERO; 4],
                };
                eased_out += usize::from(beside[1] != DVec3::ZERO);
                for (k, (force, sum)) in pair.push(&near, points, 50.0).into_iter().enumerate() {
                    let weight = measured.weights[k][i];
                    let own = weight * DVec3::from_array(pushes.force.map(|row| row[i])) + beside[k];
                    let own_sum = weight.abs() * pushes.stiffness[i];
                    assert!((own - force).length() < 1e-7 * force.length().max(1.0), "{points:?}: {own}, {force}");
                    assert!((own_sum - sum).abs() < 1e-7 * sum.max(1.0), "{points:?}: {own_sum}, {sum}");
                    stiffest = stiffest.max(sum);
                }
            }
        }
    }
    assert!(eased_out > 20 && stiffest > 1e3, "{eased_out} {stiffest}");
}

#[test]
fn a_difference_is_seen() {
    let mut measured = Measured::new();
    let all = [points(&mut noise(3))];
    measure_points(&given(&all), &mut measured);
    let plain = of_point_and_triangle(&all[0]);
    assert!(difference(&measured, 0, &plain) < 1e-12);
    measured.weights[2][0] += 1e-6;
    assert!(difference(&measured, 0, &plain) > 1e-7);
    measured.weights[2][0] -= 1e-6;
    measured.normal[1][0] += 1e-6;
    assert!(difference(&measured, 0, &plain) > 1e-7);
}
