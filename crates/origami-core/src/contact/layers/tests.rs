//! What layers do to each other, against what was asked of them.

mod stacked;

use super::*;
use crate::contact::Crossings;
use crate::contact::noise::noise;
use crate::generate::catalog;
use crate::model::{Material, Model};

fn model(name: &str) -> Model {
    Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

/// A sheet crumpled at random, whose layers are near each other in every way.
fn crumpled(name: &str, gap: f64) -> (Vec<DVec3>, Layers) {
    let model = model(name);
    let mut next = noise(3);
    let positions: Vec<DVec3> = model.rest.iter().map(|p| *p + 0.4 * DVec3::new(next(), next(), next())).collect();
    let mut layers = Layers::new(&model.mesh, &model.rest, Contact { gap, ..Contact::default() }, true);
    layers.measure(&positions);
    (positions, layers)
}

#[test]
fn forces_are_the_gradient_of_the_energy_in_every_region() {
    let (mut corners, mut insides) = (0, 0);
    for name in ["square-twist", "waterbomb", "miura"] {
        let (positions, mut layers) = crumpled(name, 0.1);
        let (mut forces, mut sums) = (vec![DVec3::ZERO; positions.len()], vec![0.0; positions.len()]);
        layers.add(&positions, &mut forces, &mut sums);
        for (_, near) in layers.pushing() {
            let zeros = near.weights.iter().filter(|weight| **weight == 0.0).count();
            corners += usize::from(zeros > 0);
            insides += usize::from(zeros == 0);
        }
        let size = forces.iter().map(|f| f.length()).fold(0.0, f64::max);
        assert!(size > 0.0);
        for node in 0..positions.len() {
            for axis in 0..3 {
                let mut at = |h: f64| {
                    let mut moved = positions.clone();
                    moved[node][axis] += h;
                    layers.measure(&moved);
                    layers.energy(&moved)
                };
                // Of fourth order: gaps are as small as a hundred steps.
                let h = 1e-7;
                let slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
                let error = (slope + forces[node][axis]).abs() / size;
                assert!(error < 1e-7, "{name}, node {node}: {slope}, force {}", forces[node][axis]);
            }
        }
    }
    assert!(corners > 20 && insides > 20, "{corners} {insides}");
}

#[test]
fn contact_has_no_momentum_and_no_moment() {
    let (positions, layers) = crumpled("waterbomb", 0.1);
    let (mut forces, mut sums) = (vec![DVec3::ZERO; positions.len()], vec![0.0; positions.len()]);
    layers.add(&positions, &mut forces, &mut sums);
    let size: f64 = forces.iter().map(|f| f.length()).sum();
    let sum: DVec3 = forces.iter().sum();
    let moment: DVec3 = positions.iter().zip(&forces).map(|(p, f)| p.cross(*f)).sum();
    assert!(sum.length() < 1e-13 * size && moment.length() < 1e-12 * size, "{sum} {moment} of {size}");
    assert!(sums.iter().any(|sum| *sum > 0.0) && sums.iter().all(|sum| *sum >= 0.0));
}

/// A walk of random moves from a flat sheet, shortened or not: the steps after which it is crossed.
fn walk(name: &str, seed: u64, shortened: bool) -> usize {
    let model = model(name);
    let mut layers = Layers::new(&model.mesh, &model.rest, Contact::default(), false);
    let (mut next, mut positions, mut crossed) = (noise(seed), model.rest.clone(), 0);
    let mut drift: Vec<DVec3> = positions.iter().map(|_| DVec3::new(next(), next(), next())).collect();
    for step in 0..150 {
        if step % 40 == 39 {
            drift.iter_mut().for_each(|by| *by = DVec3::new(next(), next(), next()));
        }
        let longest = layers.longest_move();
        let moves: Vec<DVec3> = drift.iter().map(|by| *by * (longest / 1.8)).collect();
        layers.measure(&positions);
        let shares = layers.limit(&positions, &moves).to_vec();
        let mut largest = 0.0_f64;
        for ((p, by), share) in positions.iter_mut().zip(&moves).zip(shares) {
            let by = *by * if shortened { share } else { 1.0 };
            *p += by;
            largest = largest.max(by.length());
        }
        layers.moved(largest);
        crossed += usize::from(!Crossings::of(&model.mesh, &positions).is_empty());
    }
    crossed
}

#[test]
fn shortened_moves_never_cross_and_whole_ones_do() {
    for name in ["bird-base", "square-twist", "miura"] {
        for seed in 1..4 {
            assert_eq!(walk(name, seed, true), 0, "{name}, seed {seed}");
        }
        assert!(walk(name, 1, false) > 50, "{name}: whole moves cross");
    }
}

/// By how much two lists of what nodes feel differ, as a share of the largest.
fn difference(one: &[Felt], other: &[Felt]) -> f64 {
    assert_eq!(one.len(), other.len());
    let both = || one.iter().flatten().zip(other.iter().flatten());
    let size = both().map(|(a, b)| a.abs().max(b.abs())).fold(0.0, f64::max);
    assert!(size.is_finite() && both().all(|(a, b)| (a - b).is_finite()), "{size}");
    both().map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
}

/// What nodes feel by the plain functions.
fn plainly(layers: &mut Layers, positions: &[DVec3]) -> Vec<Felt> {
    let (mut forces, mut sums) = (vec![DVec3::ZERO; positions.len()], vec![0.0; positions.len()]);
    layers.measure(positions);
    layers.add(positions, &mut forces, &mut sums);
    forces.iter().zip(sums).map(|(force, sum)| [force.x, force.y, force.z, sum]).collect()
}

/// The same as it is felt, with what stiff pairs add to the sums.
fn felt(layers: &mut Layers, positions: &[DVec3]) -> (Vec<Felt>, usize) {
    let mut felt = layers.felt(positions).to_vec();
    let mut count = 0;
    for pair in layers.stiff() {
        count += 1;
        for (node, weight) in pair.nodes.iter().zip(pair.weights) {
            felt[node.index()][3] += 2.0 * pair.stiffness * weight.abs();
        }
    }
    (felt, count)
}

#[test]
fn nodes_feel_what_the_plain_functions_add() {
    let mut all_stiff = 0;
    for (name, thickness) in [("square-twist", 0.0), ("waterbomb", 0.0), ("miura", 1e-5)] {
        let (positions, mut layers) = crumpled(name, 0.1);
        if thickness > 0.0 {
            let model = model(name);
            let contact = Contact { gap: 0.1, thickness, ..Contact::default() };
            layers = Layers::new(&model.mesh, &model.rest, contact, false);
        }
        let plain = plainly(&mut layers, &positions);
        let count = layers.count();
        let (felt, stiff) = felt(&mut layers, &positions);
        all_stiff += stiff;
        assert!(difference(&felt, &plain) < 1e-11, "{name}: {}", difference(&felt, &plain));
        assert!(layers.count() == count && count > 5, "{name}: {count} pairs");
        let mut other = felt.clone();
        other[3][1] += 1e-9 * plain.iter().flatten().map(|x| x.abs()).fold(0.0, f64::max);
        assert!(difference(&other, &plain) > 1e-10, "{name}: it can be told");
    }
    assert!(all_stiff > 5, "{all_stiff} are stiff");
}

#[test]
fn nodes_feel_the_same_bits_of_several_threads() {
    let model = model("waterbomb");
    let (positions, mut layers) = crumpled("waterbomb", 0.1);
    let mut one = Layers::new(&model.mesh, &model.rest, layers.contact, false);
    let alone = one.felt(&positions).to_vec();
    assert_eq!(one.pairs, layers.pairs);
    let shared = layers.felt(&positions).to_vec();
    assert!(layers.tasks.len() > 2, "{} tasks", layers.tasks.len());
    assert_eq!(alone, shared);
}

#[test]
fn a_list_that_lasts_is_as_good_as_a_new_one() {
    let model = model("miura");
    for gap in [0.01, 0.05] {
        let contact = Contact { gap, ..Contact::default() };
        // Gaps stay so wide that the rounding of positions is none of what is compared.
        let begin = || Layers { floor: 1e-3, ..Layers::new(&model.mesh, &model.rest, contact, false) };
        let mut layers = begin();
        let (mut next, mut positions) = (noise(5), model.rest.clone());
        let drift: Vec<DVec3> = positions.iter().map(|_| DVec3::new(next(), next(), next())).collect();
        let (mut lists, mut pushing) = (0, 0);
        for step in 0..120 {
            // At first fast, then slowly, and fast again.
            let speed = if step % 60 < 30 { 0.5 } else { 0.02 };
            let moves: Vec<DVec3> = drift.iter().map(|by| *by * speed * layers.longest_move()).collect();
            let known = layers.listed_at.first().copied();
            let (felt, _) = felt(&mut layers, &positions);
            lists += usize::from(layers.listed_at.first().copied() != known);
            let mut new = begin();
            let plain = plainly(&mut new, &positions);
            assert_eq!(layers.count(), new.count(), "step {step}");
            pushing += new.count();
            if !felt.is_empty() {
                assert!(difference(&felt, &plain) < 1e-9, "step {step}: {}", difference(&felt, &plain));
            }
            let shares = layers.limit(&positions, &moves).to_vec();
            assert_eq!(new.limit(&positions, &moves).len(), shares.len());
            let close = shares.iter().zip(&new.shares).all(|(a, b)| (a - b).abs() < 1e-6);
            assert!(close, "step {step}: moves are limited alike");
            let mut largest = 0.0_f64;
            for ((p, by), share) in positions.iter_mut().zip(&moves).zip(shares) {
                *p += *by * share;
                largest = largest.max((*by * share).length());
            }
            layers.moved(largest);
        }
        assert!(lists > 2 && lists < 60 && pushing > 200, "{lists} lists, {pushing} pairs");
    }
}
