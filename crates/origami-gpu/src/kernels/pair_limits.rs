//! Under contact before the nodes move: how much of its move each pair leaves to its nodes.

use origami_shaders as wgsl;

use super::parts::pairs;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `pair_limits.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "pair_limits",
    entry: "pair_limits",
    text: wgsl::PAIR_LIMITS,
    shared: SHARED,
    parts: |variant| [pairs(variant), vec![wgsl::WHOLE_NODES, wgsl::MOVES]].concat(),
    uses: &[
        Binding::Control,
        Binding::Nodes,
        Binding::Pairs,
        Binding::PairRows,
        Binding::Nears,
        Binding::Moves,
        Binding::Shares,
    ],
    springs: false,
    per: Per::Pair,
};

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use origami_core::contact::PlainContact;
    use origami_core::contact::{Contact, Crossings};

    use super::super::{contact_clock, contact_move, pair_forces};
    use super::*;
    use crate::Gpu;
    use crate::layout::{Move, SPENT, Touch, single};
    use crate::testing::cases::Random;
    use crate::testing::gpu;
    use crate::testing::layers::{Layers, crumpled, model};

    /// How far a share may be from the plain one.
    const SHARE: f64 = 5e-3;
    /// So small that next to moves nothing is never used up of a gap, which is more in f32 than in f64.
    const THIN: Contact = Contact { gap: 1e-6, thickness: 0.0, stiffness: 50.0 };

    fn moves(by: &[DVec3]) -> Vec<Move> {
        by.iter().map(|by| Move { by: single(*by), springs: 1.0 }).collect()
    }

    /// The largest difference between the shares of moves and the plain ones, and how many are below 1.
    fn shares_error(gpu: &Gpu, name: &str, askew: f64) -> (f64, usize) {
        let model = model(name);
        let positions = crumpled(&model, 0.4, 3);
        let layers = Layers::new(gpu, &model, &positions, THIN);
        let mut random = Random(5);
        let longest = 0.9 * layers.list.longest_move();
        let by: Vec<DVec3> = positions.iter().map(|_| random.vector(1.0).normalize() * longest).collect();
        layers.engine.write(Binding::Moves, &moves(&by));
        layers.run(&layers.passes(&[&pair_forces::KERNEL, &KERNEL]));
        let told: Vec<DVec3> = by.iter().map(|by| *by + DVec3::X * askew * longest).collect();
        let mut plain = PlainContact::new(&model.mesh, (&model.rest, &positions), THIN);
        let plain = plain.limit(&positions, &told);
        let own = layers.rows::<f32>(Binding::Shares);
        let own = own.iter().map(|row| row.iter().fold(1.0, |least, share| f64::min(least, f64::from(*share))));
        let (mut error, mut limited) = (0.0_f64, 0);
        for (own, plain) in own.zip(plain) {
            assert!((0.0..=1.0).contains(&own));
            error = error.max((own - plain).abs());
            limited += usize::from(own < 1.0);
        }
        (error, limited)
    }

    #[test]
    fn shares_of_random_moves_are_those_of_the_plain_limit() {
        let Some(gpu) = gpu() else { return };
        let mut limited = 0;
        for name in ["square-twist", "waterbomb", "miura"] {
            let (error, own) = shares_error(&gpu, name, 0.0);
            println!("pair_limits, {name}: {error:.1e}, {own} limited");
            assert!(error < SHARE, "{name}: {error}");
            limited += own;
        }
        assert!(limited > 10, "{limited} moves are shortened");
        assert!(shares_error(&gpu, "miura", 0.5).0 > SHARE, "other moves are seen");
    }

    /// A walk of random moves from a flat sheet, shortened or not: the steps after which it is crossed.
    fn walk(gpu: &Gpu, name: &str, seed: u64, shortened: bool) -> usize {
        let model = model(name);
        let mut random = Random(seed);
        let mut layers = Layers::new(gpu, &model, &model.rest, Contact::default());
        let mut crossed = 0;
        let last = [&contact_move::KERNEL, &contact_clock::KERNEL];
        let all = [&[&pair_forces::KERNEL, &KERNEL][..], &last[..]].concat();
        let kernels = if shortened { &all[..] } else { &last[..] };
        let mut passes = layers.passes(kernels);
        for step in 0..150 {
            if step % 40 == 0 {
                let drift: Vec<DVec3> =
                    model.rest.iter().map(|_| random.vector(layers.list.longest_move() / 1.8)).collect();
                layers.engine.write(Binding::Moves, &moves(&drift));
            }
            if !shortened {
                layers.engine.write(Binding::Shares, &vec![1.0_f32; 4 * layers.pairs().len()]);
            }
            layers.run(&passes);
            let positions = layers.positions();
            crossed += usize::from(!Crossings::of(&model.mesh, &positions).is_empty());
            if layers.control().stop == SPENT {
                layers.list(&positions);
                layers.engine.go_on().expect("written");
                passes = layers.passes(kernels);
            }
        }
        let touch: Vec<Touch> = layers.read(Binding::Touch, 1);
        assert_eq!(touch[0].limited > 0, shortened, "{touch:?}");
        crossed
    }

    #[test]
    fn shortened_moves_never_cross_and_whole_ones_do() {
        let Some(gpu) = gpu() else { return };
        for (name, seed) in [("bird-base", 1), ("square-twist", 2)] {
            assert_eq!(walk(&gpu, name, seed, true), 0, "{name}, seed {seed}");
        }
        assert!(walk(&gpu, "bird-base", 1, false) > 50, "whole moves cross");
    }
}
