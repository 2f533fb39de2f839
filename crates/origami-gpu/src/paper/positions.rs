//! Fifth pass: positions.

use super::layout::SHARED;
use crate::kernels::{Binding, Kernel, Per};

pub(super) const KERNEL: Kernel = Kernel {
    name: "positions",
    entry: "positions",
    text: origami_shaders::paper::POSITIONS,
    shared: SHARED,
    parts: |_| Vec::new(),
    uses: &[Binding::Control, Binding::Settings, Binding::RestNodes, Binding::Motions, Binding::NextVelocities],
    springs: false,
    per: Per::Node,
};

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use origami_core::State;
    use origami_core::solve::time_step;

    use super::*;
    use crate::Gpu;
    use crate::layout::{Control, NONE};
    use crate::paper::testing::{run, sheet};
    use crate::testing::cases::{Case, ROUNDING, Random, cases, worst};
    use crate::testing::gpu;

    /// In roundings of the displacement and the move: the time step, the product and the sum are rounded once each.
    const TOLERANCE: f64 = 3.0;

    fn next_velocities(case: &Case) -> Vec<DVec3> {
        let mut random = Random(3);
        case.state.velocities.iter().map(|_| random.vector(1.0).as_vec3().as_dvec3()).collect()
    }

    fn moved(gpu: &Gpu, case: &Case, next: &[DVec3], stop: u32) -> (State, Control) {
        let sheet = sheet(gpu, case);
        let next: Vec<[f32; 4]> = next.iter().map(|v| v.as_vec3().extend(0.0).to_array()).collect();
        sheet.engine.write(Binding::NextVelocities, &next);
        sheet.engine.write(Binding::Control, &[Control { bad_node: NONE, step: 1, stop, ..Control::default() }]);
        run(&sheet, &KERNEL, 1);
        let control: Control = sheet.engine.read(Binding::Control, 1).expect("read")[0];
        (sheet.read(&case.model, &case.state.targets).expect("read"), control)
    }

    fn error(case: &Case, got: &State, next: &[DVec3]) -> f64 {
        let dt = time_step::paper(&case.model);
        let nodes = case.state.positions.iter().zip(&case.model.rest).zip(&got.positions).zip(next);
        let of_positions = nodes.map(|(((before, rest), after), velocity)| {
            let scale = ROUNDING * (before.distance(*rest) + 2.0 * dt * velocity.length());
            (after.distance(*before + *velocity * dt), scale)
        });
        let of_velocities = got.velocities.iter().zip(next).map(|(got, want)| (got.distance(*want), ROUNDING));
        worst(of_positions.chain(of_velocities))
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases() {
            let mut next = next_velocities(&case);
            let (got, control) = moved(&gpu, &case, &next, 0);
            let error = error(&case, &got, &next);
            println!("positions, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            assert_eq!(control.bad_node, NONE, "{}", case.name);
            next[1].z += 1e-4;
            assert!(self::error(&case, &got, &next) > TOLERANCE, "{}: a wrong velocity is seen", case.name);
        }
    }

    #[test]
    fn the_first_node_out_of_bounds_is_noted() {
        let Some(gpu) = gpu() else { return };
        let case = cases().swap_remove(3);
        let dt = time_step::paper(&case.model);
        // Within the bounds; a long move; two of them; no number.
        let steps = [([0.9, 0.0], NONE), ([0.0, 1.1], 9), ([1.1, 5.0], 4), ([f64::NAN, 0.0], 4), ([0.0, 1e30], 9)];
        for (ways, expected) in steps {
            let mut next = vec![DVec3::ZERO; case.model.node_count()];
            (next[4].y, next[9].x) = (ways[0] / dt, ways[1] / dt);
            assert_eq!(moved(&gpu, &case, &next, 0).1.bad_node, expected, "{ways:?}");
        }
        let mut far = case.clone();
        far.state.positions[6] = DVec3::new(0.0, 0.0, 101.0);
        assert_eq!(moved(&gpu, &far, &vec![DVec3::ZERO; case.model.node_count()], 0).1.bad_node, 6, "a far place");
    }

    #[test]
    fn a_sheet_that_was_stopped_does_not_move() {
        let Some(gpu) = gpu() else { return };
        let case = cases().swap_remove(3);
        let (got, _) = moved(&gpu, &case, &next_velocities(&case), 2);
        assert_eq!((got.positions, got.velocities), (case.state.positions, case.state.velocities));
    }
}
