//! Layers that lie on each other, where most pairs are in groups.

use super::*;
use crate::generate::miura;
use crate::solve::{ContactRelax, Solver};

/// How many pairs are in groups.
fn grouped(layers: &Layers) -> usize {
    layers.groups.all.iter().map(|group| group.count() as usize).sum()
}

/// How many different ones.
fn grouped_once(layers: &Layers) -> usize {
    let both = layers.groups.all.iter().zip(&layers.groups.places);
    let mut all: Vec<u32> = both.flat_map(|(group, places)| group.pairs(places)).collect();
    all.sort_unstable();
    all.dedup();
    all.len()
}

#[test]
fn groups_push_as_the_plain_functions_while_layers_move() {
    let model = Model::new(&miura(6, 6).expect("a pattern"), &Material::default()).expect("a model");
    let start = ContactRelax::default().fold_from_rest(&model, 100.0).expect("it folds").state.positions;
    // Of the layers as they lie, and of some that have slid and turned against each other.
    for (seed, first) in [(1, 0.0), (2, 3e-4)] {
        let mut next = noise(seed);
        let mut shake =
            |by: f64| -> Vec<DVec3> { start.iter().map(|_| by * DVec3::new(next(), next(), next())).collect() };
        let mut positions = start.clone();
        let (mut plain, mut layers) =
            [(); 2].map(|()| Layers::new(&model.mesh, &model.rest, Contact::default(), false)).into();
        let (mut most, mut least, mut lost, mut before) = (0, usize::MAX, 0, 0);
        for step in 0..60 {
            let felt = layers.felt(&positions).to_vec();
            let expected = plainly(&mut plain, &positions);
            assert_eq!(layers.count(), plain.count(), "step {step}");
            assert!(difference(&felt, &expected) < 1e-9, "step {step}: {}", difference(&felt, &expected));
            let now = grouped(&layers);
            assert_eq!(grouped_once(&layers), now, "no pair is in two groups");
            lost += before.max(now) - now;
            (most, before) = (most.max(now), now);
            if step > 5 {
                least = least.min(layers.count());
            }
            let scale = if step == 2 { first } else { [1e-9, 1e-6, 1e-5, 5e-5][step % 4] };
            let moves = shake(scale);
            let shares = layers.limit(&positions, &moves).to_vec();
            let others = plain.limit(&positions, &moves);
            assert!(shares.iter().zip(others).all(|(a, b)| (a - b).abs() < 1e-9), "step {step}: limited alike");
            let mut largest = 0.0_f64;
            for ((p, by), share) in positions.iter_mut().zip(&moves).zip(shares) {
                *p += *by * share;
                largest = largest.max((*by * share).length());
            }
            layers.moved(largest);
            plain.moved(largest);
        }
        assert!(2 * most > least && least > 100 && lost > 20, "{most} of {least} in groups, {lost} given back");
    }
}

#[test]
fn what_lies_exactly_on_each_other_pushes_as_plainly() {
    let model = model("waterbomb");
    let contact = Contact::default();
    // Folded in half, with all corners of one half above those of the other.
    let fold = |p: &DVec3| DVec3::new(p.x.abs(), p.y, if p.x > 1e-9 { 0.4 * contact.gap } else { 0.0 });
    let positions: Vec<DVec3> = model.rest.iter().map(fold).collect();
    let mut layers = Layers::new(&model.mesh, &model.rest, contact, false);
    let mut plain = layers.clone();
    let expected = plainly(&mut plain, &positions);
    assert!(plain.count() > positions.len(), "{} pairs", plain.count());
    for round in 0..4 {
        let felt = layers.felt(&positions).to_vec();
        assert!(difference(&felt, &expected) < 1e-9, "round {round}: {}", difference(&felt, &expected));
        assert_eq!(layers.count(), plain.count());
        layers.moved(1e-12);
    }
    assert!(2 * grouped(&layers) > layers.count(), "{} of {}", grouped(&layers), layers.count());
    // And after groups have been asked for what the plain functions know.
    layers.measure(&positions);
    assert_eq!((grouped(&layers), layers.count()), (0, plain.count()));
}

#[test]
fn groups_feel_the_same_bits_of_several_threads() {
    let model = model("waterbomb");
    let contact = Contact::default();
    let mut next = noise(11);
    let height = |p: &DVec3| if p.x > 1e-9 { 0.4 * contact.gap } else { 0.0 };
    let mut positions: Vec<DVec3> = model.rest.iter().map(|p| DVec3::new(p.x.abs(), p.y, height(p))).collect();
    let [mut one, mut shared] = [false, true].map(|shared| Layers::new(&model.mesh, &model.rest, contact, shared));
    for _ in 0..6 {
        assert_eq!(one.felt(&positions), shared.felt(&positions));
        positions.iter_mut().for_each(|p| *p += 1e-6 * DVec3::new(next(), next(), next()));
        one.moved(2e-6);
        shared.moved(2e-6);
    }
    assert!(grouped(&one) > 0 && one.tasks.len() > 1, "{} in groups, {} tasks", grouped(&one), one.tasks.len());
}
