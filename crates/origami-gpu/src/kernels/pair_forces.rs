//! Third pass under contact: gaps of pairs, and how they push.

use origami_shaders as wgsl;

use super::parts::pairs;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `pair_forces.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "pair_forces",
    entry: "pair_forces",
    text: wgsl::PAIR_FORCES,
    shared: SHARED,
    parts: |variant| [pairs(variant), vec![wgsl::WHOLE_NODES, wgsl::DISTANCE, wgsl::BARRIER]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::Pairs, Binding::PairRows, Binding::Nears, Binding::Pushes],
    springs: false,
    per: Per::Pair,
};

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use glam::DVec3;
    use origami_core::contact::Contact;
    use origami_core::contact::PlainContact;
    use origami_core::model::Model;
    use origami_core::solve::{ContactRelax, Solver};

    use super::*;
    use crate::Gpu;
    use crate::layout::vector;
    use crate::testing::cases::ROUNDING;
    use crate::testing::gpu;
    use crate::testing::layers::{Layers, as_held, crumpled, model};

    /// Gaps and, as far as they matter there, normals: in roundings of a radius, which is as long as edges are.
    const GAP: f64 = 4.0;
    /// Forces, in roundings of a radius times what their pairs add to the masses: a force changes by no more than that with a gap.
    const FORCE: f64 = 2.0;
    /// And in roundings of the largest force: what eases edges out does not show in the masses.
    const LARGEST: f64 = 8.0;

    /// Errors of gaps and of the normals' sideways parts, and of forces and masses, in these units.
    struct Errors {
        gap: f64,
        force: f64,
        mass: f64,
        /// Pairs that push, by how many of their weights are 0, and edges that are eased out.
        regions: [usize; 4],
        eased: usize,
    }

    fn errors(gpu: &Gpu, model: &Model, (positions, told): (&[DVec3], &[DVec3]), contact: Contact) -> Errors {
        let layers = Layers::new(gpu, model, positions, contact);
        layers.run(&layers.passes(&[&KERNEL]));
        let plain = PlainContact::new(&model.mesh, (&model.rest, told), contact);
        let nears: Vec<[f32; 4]> = layers.read(Binding::Nears, layers.pairs().len());
        let mut errors = Errors { gap: 0.0, force: 0.0, mass: 0.0, regions: [0; 4], eased: 0 };
        let pushing = plain.pushing();
        let listed = layers.pairs().iter().zip(&nears);
        let listed: BTreeMap<_, _> = listed.map(|(own, near)| ((own.split, own.nodes), (own, near))).collect();
        for (pair, weights, normal, gap) in &pushing {
            let (own, near) = listed[&(pair.split as u32, pair.nodes.map(|node| node.0))];
            let [x, y, z, own_gap] = *near;
            let is_eased = is_eased(own.eased, pair.nodes.map(|n| told[n.index()]));
            // Of parallel edges many points are equally near.
            let aside = if is_eased { 0.0 } else { vector([x, y, z]).distance(*normal) * (gap + pair.closed) };
            errors.gap = errors.gap.max((f64::from(own_gap) - gap).abs().max(aside) / ROUNDING);
            errors.regions[weights.iter().filter(|weight| **weight == 0.0).count()] += 1;
            errors.eased += usize::from(is_eased);
        }
        // What is nearer than any state on the way counts by its gap alone.
        let too_near = pushing.iter().filter(|(pair, _, _, gap)| *gap < 2e-2 * pair.width);
        let too_near: BTreeSet<usize> = too_near.flat_map(|(pair, ..)| pair.nodes.map(|n| n.index())).collect();
        assert!(too_near.len() < told.len() / 2);
        let (forces, sums) = plain.forces(told);
        let largest = forces.iter().map(|f| f.length()).fold(0.0, f64::max);
        let rows = layers.rows::<[f32; 4]>(Binding::Pushes);
        for (i, ((row, force), sum)) in rows.iter().zip(forces).zip(sums).enumerate() {
            if too_near.contains(&i) {
                continue;
            }
            let own: DVec3 = row.iter().map(|push| vector([push[0], push[1], push[2]])).sum();
            let mass: f64 = row.iter().map(|push| f64::from(push[3])).sum();
            let allowed = FORCE * ROUNDING * sum + LARGEST * ROUNDING * largest;
            errors.force = errors.force.max(own.distance(force) / allowed);
            errors.mass = errors.mass.max((mass - sum).abs() / (1e-30 + 1e-3 * sum));
        }
        errors
    }

    fn is_eased(eased: f32, [p, q, r, s]: [DVec3; 4]) -> bool {
        (q - p).cross(s - r).length_squared() < f64::from(eased)
    }

    /// Folded flat, with layers that lie on each other.
    fn stacked(model: &Model) -> Vec<DVec3> {
        let solver = ContactRelax { contact: Contact { gap: 0.01, ..Contact::default() }, ..ContactRelax::default() };
        let folded = solver.fold_from_rest(model, 100.0).expect("it folds");
        folded.state.positions.into_iter().map(as_held).collect()
    }

    #[test]
    fn gaps_and_forces_are_those_of_the_plain_formulas_in_every_region() {
        let Some(gpu) = gpu() else { return };
        let (mut regions, mut eased) = ([0; 4], 0);
        let thick = Contact { gap: 0.5, thickness: 0.02, ..Contact::default() };
        let wide = Contact { gap: 0.1, ..Contact::default() };
        for (name, size, contact) in [
            ("square-twist", 0.4, wide),
            ("waterbomb-vertex", 0.4, Contact { gap: 0.5, ..wide }),
            ("bird-base", 0.4, Contact { gap: 0.5, ..wide }),
            ("miura", 0.2, Contact { gap: 0.03, ..wide }),
            ("bird-base", 0.4, thick),
            ("waterbomb-vertex", 0.4, thick),
            // In a stack, with many edges that are nearly parallel.
            ("miura", 0.0, Contact { gap: 0.02, ..wide }),
        ] {
            let model = model(name);
            let positions = if size > 0.0 { crumpled(&model, size, 3) } else { stacked(&model) };
            let own = errors(&gpu, &model, (&positions, &positions), contact);
            println!(
                "pair_forces, {name} {size}: gaps {:.2}, forces {:.3}, masses {:.3}, {:?} {}",
                own.gap, own.force, own.mass, own.regions, own.eased
            );
            assert!(own.gap < GAP && own.force < 1.0 && own.mass < 1.0, "{name} {size}");
            own.regions.iter().zip(&mut regions).for_each(|(own, all)| *all += own);
            eased += own.eased;
        }
        assert!(regions[..3].iter().all(|pairs| *pairs > 20) && eased > 20, "{regions:?}, {eased} eased out");
        let model = model("miura");
        let positions = crumpled(&model, 0.2, 3);
        let uneven = |i: usize| DVec3::Z * (2e-5 * (i % 7) as f64);
        let askew: Vec<DVec3> = positions.iter().enumerate().map(|(i, p)| as_held(*p + uneven(i))).collect();
        let own = errors(&gpu, &model, (&positions, &askew), Contact { gap: 0.03, ..wide });
        assert!(own.gap > GAP && own.force > 1.0, "a sheet a little askew is seen: {} {}", own.gap, own.force);
    }

    #[test]
    fn a_pair_that_does_not_push_takes_back_what_it_did() {
        let Some(gpu) = gpu() else { return };
        let model = model("square-twist");
        let positions = crumpled(&model, 0.4, 3);
        let layers = Layers::new(&gpu, &model, &positions, Contact { gap: 0.1, ..Contact::default() });
        let passes = layers.passes(&[&KERNEL]);
        let pushing = || {
            layers.run(&passes);
            let pushes: Vec<[f32; 4]> = layers.read(Binding::Pushes, 4 * layers.pairs().len());
            pushes.iter().filter(|push| push[3] > 0.0).count()
        };
        assert!(pushing() > 0);
        let mut flat = layers.nodes();
        flat.iter_mut().zip(&model.rest).for_each(|(node, rest)| node.set_position(*rest));
        layers.engine.write(Binding::Nodes, &flat);
        assert_eq!(pushing(), 0, "the flat sheet is free of contact");
    }
}
