//! Leaving symmetry: a sheet folded from an exactly symmetric state stays on the saddle between its two ways to buckle,
//! where forces vanish and no test of convergence sees that the state is not stable.

use glam::{DMat3, DVec3};

use crate::model::Model;
use crate::scene::Held;

/// Moves every free node by up to `share` of its shortest beam in each direction. The direction comes from the bits of
/// its position at rest and from `seed`: the same for every run and every numbering.
pub(super) fn perturb(model: &Model, held: &Held, positions: &mut [DVec3], share: f64, seed: u64) {
    let seed = if seed == 0 { 0 } else { mixed(seed) };
    let mut shortest = vec![f64::INFINITY; positions.len()];
    for beam in &model.beams {
        for n in beam.nodes {
            shortest[n.index()] = shortest[n.index()].min(beam.rest_length);
        }
    }
    let mut axes = held.iter().peekable();
    for (n, ((p, rest), length)) in positions.iter_mut().zip(&model.rest).zip(shortest).enumerate() {
        // Adding 0 makes -0 and 0 the same number.
        let mut bits = rest.to_array().iter().fold(seed, |bits, x| mixed(bits ^ (x + 0.0).to_bits()));
        let mut random = || {
            bits = mixed(bits);
            // The upper 53 bits as a number from -1 to 1.
            (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        let moved = DVec3::new(random(), random(), random()) * (share * length);
        *p += match axes.next_if(|(node, _)| node.index() == n) {
            Some((_, axes)) => axes.without(moved),
            None => moved,
        };
    }
    if held.is_empty() {
        take_back_rigid_motion(&model.rest, positions);
    }
}

/// Moves and turns `positions`, a little off `rest`, so that as a whole they lie where they lay.
fn take_back_rigid_motion(rest: &[DVec3], positions: &mut [DVec3]) {
    let count = rest.len() as f64;
    let (from, to) = (rest.iter().sum::<DVec3>() / count, positions.iter().sum::<DVec3>() / count);
    // The turn of least squares: inertia times turn is the moment of the moves.
    let (mut inertia, mut moment) = (DMat3::ZERO, DVec3::ZERO);
    for (p, rest) in positions.iter().zip(rest) {
        let arm = *rest - from;
        inertia += DMat3::from_diagonal(DVec3::splat(arm.length_squared()))
            - DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z);
        moment += arm.cross(*p - to);
    }
    // Only points on one line have no inertia about it; a sheet has an area.
    let turn = inertia.inverse_or_zero() * moment;
    for (p, rest) in positions.iter_mut().zip(rest) {
        *p += from - to - turn.cross(*rest - from);
    }
}

/// `SplitMix64` (Steele, Lea and Flood, OOPSLA 2014): every bit of the result depends on every bit of `bits`.
fn mixed(bits: u64) -> u64 {
    let bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::{SingleCrease, miura};
    use crate::model::Material;

    #[test]
    fn moves_are_small_different_and_without_a_preferred_direction() {
        let model = Model::new(&miura(20, 20).expect("valid"), &Material::default()).expect("valid");
        let shortest = model.beams.iter().map(|b| b.rest_length).fold(f64::INFINITY, f64::min);
        let longest = model.beams.iter().map(|b| b.rest_length).fold(0.0, f64::max);
        for seed in [0, 1, 2, u64::MAX] {
            let mut positions = model.rest.clone();
            perturb(&model, &Held::default(), &mut positions, 1e-4, seed);
            let moves: Vec<DVec3> = positions.iter().zip(&model.rest).map(|(p, rest)| *p - *rest).collect();
            assert!(moves.iter().all(|m| m.abs().max_element() <= 1.1e-4 * longest));
            let mean = moves.iter().sum::<DVec3>() / moves.len() as f64;
            let size = (moves.iter().map(|m| m.length_squared()).sum::<f64>() / moves.len() as f64).sqrt();
            // Uniform in a cube: the root mean square is its half side.
            assert!(size > 0.9e-4 * shortest && size < 1.1e-4 * longest, "{size}");
            assert!(mean.length() < 1e-6 * size, "{mean}");
            let turn =
                moves.iter().zip(&model.rest).map(|(m, rest)| rest.cross(*m)).sum::<DVec3>() / moves.len() as f64;
            assert!(turn.length() < 1e-6 * size, "{turn}");
            assert!(moves.windows(2).all(|pair| pair[0] != pair[1]));
        }
    }

    #[test]
    fn each_seed_has_directions_of_its_own() {
        let model = Model::new(&miura(4, 4).expect("valid"), &Material::default()).expect("valid");
        let moved = |seed| {
            let mut positions = model.rest.clone();
            perturb(&model, &Held::default(), &mut positions, 1e-4, seed);
            let moves: Vec<DVec3> = positions.iter().zip(&model.rest).map(|(p, rest)| *p - *rest).collect();
            moves
        };
        let size = |moves: &[DVec3]| moves.iter().map(|m| m.length_squared()).sum::<f64>().sqrt();
        let all: Vec<Vec<DVec3>> = (0..8).map(moved).collect();
        for (i, one) in all.iter().enumerate() {
            for other in &all[..i] {
                let cosine = one.iter().zip(other).map(|(a, b)| a.dot(*b)).sum::<f64>() / (size(one) * size(other));
                assert!(cosine.abs() < 0.6, "75 numbers drawn twice have little in common, not {cosine}");
            }
        }
        assert_eq!(moved(3), all[3]);
    }

    #[test]
    fn seed_0_is_what_it_has_always_been() {
        // Without sines, of which each platform has its own.
        let pattern = SingleCrease::default().pattern().expect("valid");
        let model = Model::new(&pattern, &Material::default()).expect("valid");
        let mut positions = model.rest.clone();
        perturb(&model, &Held::default(), &mut positions, 1e-3, 0);
        let before_there_were_seeds = [
            DVec3::new(-0.999877379970668, 0.00027111484849012444, -0.0007352162440220212),
            DVec3::new(0.9991759300965388, 6.408306624498659e-5, -0.0007352162440220212),
            DVec3::new(0.0005577567193096967, -0.5008130992025586, 0.0007352162440220212),
            DVec3::new(0.00014369315481942114, 0.5004779012878234, 0.0007352162440220212),
        ];
        assert_eq!(positions, before_there_were_seeds);
    }
}
