//! Fifth pass: positions.

use super::kernel::{Each, Kernel};
use super::layout::Slot;

pub(super) const KERNEL: Kernel = Kernel {
    name: "positions",
    own: origami_shaders::paper::POSITIONS,
    slots: &[Slot::Settings, Slot::Status, Slot::Nodes, Slot::Motions, Slot::NextVelocities],
    each: Each::Node,
};

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use origami_core::State;
    use origami_core::solve::time_step;

    use super::*;
    use crate::Gpu;
    use crate::paper::layout::{NONE, Status};
    use crate::paper::testing::{Case, ROUNDING, Random, cases, sheet, worst};
    use crate::testing::gpu;

    /// In roundings of the displacement and the way: the time step, the product and the sum are rounded once each.
    const TOLERANCE: f64 = 3.0;

    fn next_velocities(case: &Case) -> Vec<DVec3> {
        let mut random = Random(3);
        case.state.velocities.iter().map(|_| random.vector(1.0).as_vec3().as_dvec3()).collect()
    }

    fn run(gpu: &Gpu, case: &Case, next: &[DVec3], running: u32) -> (State, Status) {
        let sheet = sheet(gpu, case);
        let next: Vec<[f32; 4]> = next.iter().map(|v| v.as_vec3().extend(0.0).to_array()).collect();
        sheet.fill(Slot::NextVelocities, &next).expect("written");
        sheet.fill(Slot::Status, &[Status { bad_node: NONE, steps: 1, running }]).expect("written");
        sheet.run(&[&KERNEL], 1).expect("it runs");
        let status = sheet.contents(Slot::Status, 1).expect("read")[0];
        (sheet.read(&case.model, &case.state.targets).expect("read"), status)
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
            let (got, status) = run(&gpu, &case, &next, 1);
            let error = error(&case, &got, &next);
            println!("positions, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            assert_eq!(status.bad_node, NONE, "{}", case.name);
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
            assert_eq!(run(&gpu, &case, &next, 1).1.bad_node, expected, "{ways:?}");
        }
        let mut far = case.clone();
        far.state.positions[6] = DVec3::new(0.0, 0.0, 101.0);
        assert_eq!(run(&gpu, &far, &vec![DVec3::ZERO; case.model.node_count()], 1).1.bad_node, 6, "a far place");
    }

    #[test]
    fn a_sheet_that_was_stopped_does_not_move() {
        let Some(gpu) = gpu() else { return };
        let case = cases().swap_remove(3);
        let (got, _) = run(&gpu, &case, &next_velocities(&case), 0);
        assert_eq!((got.positions, got.velocities), (case.state.positions, case.state.velocities));
    }
}
