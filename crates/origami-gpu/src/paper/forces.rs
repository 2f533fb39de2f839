//! Fourth pass: forces and velocities (paper 2.2 to 2.5).

use super::layout::SHARED;
use crate::kernels::{Binding, Kernel, Per};

pub(super) const KERNEL: Kernel = Kernel {
    name: "forces",
    entry: "forces",
    text: origami_shaders::paper::FORCES,
    shared: SHARED,
    parts: |_| Vec::new(),
    uses: &[
        Binding::Settings,
        Binding::RestNodes,
        Binding::Motions,
        Binding::NextVelocities,
        Binding::Triangles,
        Binding::FaceNormals,
        Binding::Springs,
        Binding::BeamEnds,
        Binding::Roles,
    ],
    springs: false,
    per: Per::Node,
};

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec4};
    use origami_core::forces::{Forces, damping};
    use origami_core::solve::time_step;

    use super::*;
    use crate::Gpu;
    use crate::paper::layout::Spring;
    use crate::paper::testing::{run, sheet};
    use crate::paper::{coefficients, sheet};
    use crate::testing::cases::{Case, ROUNDING, cases, collapsed, reach, tampered, worst};
    use crate::testing::gpu;

    /// In roundings of all that is summed at a node. Each spring's force is some ten operations on numbers that come rounded;
    /// roots and quotients may be off by 5.
    const TOLERANCE: f64 = 8.0;

    /// The case with the fold angles that its positions have.
    fn settled(case: &Case) -> Case {
        let mut case = case.clone();
        let angles = &mut case.state.fold_angles;
        let _ = Forces::new(&case.model).evaluate(&case.state.positions, &case.state.targets, angles);
        case
    }

    fn velocities(gpu: &Gpu, case: &Case) -> Vec<DVec3> {
        let case = settled(case);
        let mut springs = sheet::springs(&case.model, &case.state);
        for (spring, of_cpu) in springs.iter_mut().zip(coefficients::on_cpu(&case)) {
            let [h1, h2, s1, s2] = of_cpu.map(|x| x as f32);
            *spring = Spring { per_height: [h1, h2], foot: [s1, s2], ..*spring };
        }
        let sheet = sheet(gpu, &case);
        sheet.engine.write(Binding::Springs, &springs);
        run(&sheet, &KERNEL, 1);
        let next: Vec<[f32; 4]> = sheet.engine.read(Binding::NextVelocities, case.model.node_count()).expect("read");
        next.into_iter().map(|v| Vec4::from_array(v).truncate().as_dvec3()).collect()
    }

    fn expected(case: &Case) -> Vec<DVec3> {
        let dt = time_step::paper(&case.model);
        let mut angles = case.state.fold_angles.clone();
        let mut forces = Forces::new(&case.model);
        let springs = forces.evaluate(&case.state.positions, &case.state.targets, &mut angles);
        let damping = damping::forces(&case.model, &case.state.velocities);
        let sums = springs.iter().zip(damping).zip(&case.state.velocities);
        sums.map(|((spring, damping), velocity)| *velocity + (*spring + damping) * dt).collect()
    }

    /// What is summed at each node, by magnitude: all that rounding takes its share of.
    fn magnitudes(case: &Case) -> Vec<f64> {
        let (model, state) = (&case.model, &settled(case).state);
        let distance = |i: usize, j: usize| state.positions[i].distance(state.positions[j]);
        let mut sums = vec![0.0; model.node_count()];
        for (beam, c) in model.beams.iter().zip(damping::coefficients(model)) {
            let [i, j] = beam.nodes.map(|n| n.index());
            let apart = state.velocities[i].distance(state.velocities[j]);
            // A short beam's direction is off by more than its length, which counts where it is much too short.
            let direction = 1.0 + (distance(i, j) - beam.rest_length).abs() / distance(i, j);
            for n in [i, j] {
                sums[n] += beam.stiffness * reach(case, [i, j]) * direction + c * apart;
            }
        }
        let springs = model.creases.iter().zip(coefficients::on_cpu(case)).zip(&state.fold_angles).zip(&state.targets);
        for (((crease, [h1, h2, s1, s2]), angle), target) in springs {
            let gradient = h1 * (1.0 + s1.abs()) + h2 * (1.0 + s2.abs());
            for n in crease.nodes {
                sums[n.index()] += crease.stiffness * (angle.abs() + target.abs()) * gradient;
            }
        }
        for corners in &model.corner_angles {
            let [a, b, c] = corners.nodes.map(|n| n.index());
            // Half a turn, and the directions of the sides, on which the forces stand.
            let pull = |i: usize, j: usize| reach(case, [i, j]) / distance(i, j).powi(2);
            let all = model.material.k_face * (pull(a, b) + pull(b, c) + pull(c, a));
            for n in [a, b, c] {
                sums[n] += std::f64::consts::PI * all;
            }
        }
        sums
    }

    fn error(case: &Case, got: &[DVec3], wanted: &Case) -> f64 {
        let dt = time_step::paper(&case.model);
        let scales = magnitudes(case).into_iter().zip(&case.state.velocities);
        let scales = scales.map(|(sum, velocity)| ROUNDING * (velocity.length() + dt * sum));
        worst(got.iter().zip(expected(wanted)).zip(scales).map(|((got, want), scale)| (got.distance(want), scale)))
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases() {
            let got = velocities(&gpu, &case);
            let error = error(&case, &got, &case);
            println!("forces, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            for (what, wrong) in wrongs(&case) {
                assert!(self::error(&case, &got, &wrong) > TOLERANCE, "{}: {what} is seen", case.name);
            }
        }
        let case = collapsed();
        let error = error(&case, &velocities(&gpu, &case), &case);
        assert!(error < TOLERANCE, "collapsed creases: {error} roundings");
    }

    /// One of everything that the forces depend on, a little wrong.
    fn wrongs(case: &Case) -> [(&'static str, Case); 7] {
        let wrong = |change: &dyn Fn(&mut Case)| {
            let mut wrong = case.clone();
            change(&mut wrong);
            wrong
        };
        [
            ("a moved node", tampered(case)),
            ("the stiffness of beams", wrong(&|c| c.model.beams.iter_mut().for_each(|b| b.stiffness *= 1.01))),
            ("damping", wrong(&|c| c.model.material.zeta *= 1.01)),
            ("a velocity", wrong(&|c| c.state.velocities[1].y += 1e-3)),
            ("targets", wrong(&|c| c.state.targets.iter_mut().for_each(|t| *t += 1e-3))),
            ("the stiffness of creases", wrong(&|c| c.model.creases.iter_mut().for_each(|s| s.stiffness *= 1.001))),
            ("corner angles", wrong(&|c| c.model.material.k_face *= 1.01)),
        ]
    }
}
