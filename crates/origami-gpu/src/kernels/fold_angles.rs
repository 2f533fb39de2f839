//! First pass: the fold angle and the moment of every crease.

use origami_shaders as wgsl;

use super::parts::creases;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `fold_angles.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "fold_angles",
    entry: "fold_angles",
    text: wgsl::FOLD_ANGLES,
    shared: SHARED,
    parts: creases,
    uses: &[Binding::Control, Binding::Nodes, Binding::CreaseStates, Binding::Hinges],
    springs: false,
    per: Per::Crease,
};

#[cfg(test)]
mod tests {
    use origami_core::forces::creases;

    use super::*;
    use crate::Gpu;
    use crate::layout::CreaseState;
    use crate::testing::bench::{Bench, EULER, held};
    use crate::testing::cases::{Case, ROUNDING, cases, collapsed, tampered, worst};
    use crate::testing::{gpu, magnitudes};
    use crate::variant::Scheme;

    /// In roundings of pi, in triangles that are not thin: 2e-7 radians come from [`wgsl::ANGLE`] and the rest from its
    /// arguments, some ten operations.
    const TOLERANCE: f64 = 5.0;

    fn states(gpu: &Gpu, case: &Case) -> Vec<CreaseState> {
        let bench = Bench::new(gpu, case, EULER);
        bench.run(&[&KERNEL], false);
        bench.read(Binding::CreaseStates, case.model.creases.len())
    }

    /// The largest errors of angles and of moments, in roundings.
    fn errors(case: &Case, got: &[CreaseState]) -> [f64; 2] {
        let state = &case.state;
        let angles = creases::fold_angles(&case.model, &state.positions, &state.fold_angles);
        let bounds: Vec<f64> =
            magnitudes::of_creases(case).iter().map(|b| b.as_ref().map_or(1.0, |b| b.thinness)).collect();
        let angle = got.iter().zip(&angles).zip(&bounds);
        let angle = angle
            .map(|((got, want), thin)| ((f64::from(got.angle) - want).abs(), ROUNDING * std::f64::consts::PI * thin));
        let springs = case.model.creases.iter().zip(got).zip(&angles).zip(&state.targets).zip(&bounds);
        let moment =
            springs.filter(|((((c, _), _), _), _)| is_open(case, c)).map(|((((c, got), angle), target), thin)| {
                let want = c.stiffness * (target - angle);
                let size = c.stiffness * (std::f64::consts::PI * thin + target.abs());
                ((f64::from(got.moment) - want).abs(), ROUNDING * size)
            });
        [worst(angle), worst(moment)]
    }

    fn is_open(case: &Case, crease: &origami_core::model::Crease) -> bool {
        creases::hinge(crease.nodes.map(|n| case.state.positions[n.index()])).is_some()
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases() {
            let case = held(&case);
            let got = states(&gpu, &case);
            let errors = errors(&case, &got);
            println!("fold_angles, {}: {errors:.2?}", case.name);
            assert!(errors.iter().all(|e| *e < TOLERANCE), "{}: {errors:?} roundings", case.name);
            assert!(self::errors(&tampered(&case), &got).iter().all(|e| *e > TOLERANCE), "a moved node is seen");
            let mut stiffer = case.clone();
            stiffer.model.creases[0].stiffness *= 1.0 + 1e-5;
            assert!(self::errors(&stiffer, &got)[1] > TOLERANCE || case.name != "random hinges", "stiffness is seen");
        }
    }

    #[test]
    fn angles_are_good_to_2e_7_where_triangles_are_not_thin() {
        let Some(gpu) = gpu() else { return };
        for case in cases().iter().map(held).filter(|case| case.name != "nearly degenerate hinges") {
            let (got, state) = (states(&gpu, &case), &case.state);
            let angles = creases::fold_angles(&case.model, &state.positions, &state.fold_angles);
            // Beyond half a turn an angle itself is only given to 2.4e-7.
            let off = worst(
                got.iter()
                    .zip(angles)
                    .map(|(got, want)| ((f64::from(got.angle) - want).abs(), 2e-7 + ROUNDING * want.abs())),
            );
            println!("fold_angles, {}: {off:.2} of 2e-7 radians", case.name);
            assert!(off < 1.5, "{}: {off}", case.name);
        }
    }

    #[test]
    fn collapsed_creases_keep_their_angles_and_pull_at_nothing() {
        let Some(gpu) = gpu() else { return };
        let case = held(&collapsed());
        let got = states(&gpu, &case);
        let mut closed = 0;
        for ((crease, got), before) in case.model.creases.iter().zip(&got).zip(&case.state.fold_angles) {
            if !is_open(&case, crease) {
                assert_eq!((f64::from(got.angle), got.moment), (*before, 0.0));
                closed += 1;
            }
        }
        assert_eq!(closed, 2);
        assert!(errors(&case, &got).iter().all(|e| *e < TOLERANCE));
    }

    #[test]
    fn a_crease_that_turns_fast_holds_the_ramp_of_a_relaxation() {
        let Some(gpu) = gpu() else { return };
        let case = held(&cases()[0]);
        let waits_after = |scheme, turned: f64| {
            let mut case = case.clone();
            let angles = creases::fold_angles(&case.model, &case.state.positions, &case.state.fold_angles);
            case.state.fold_angles = angles.iter().map(|a| f64::from(*a as f32)).collect();
            case.state.fold_angles[5] += turned;
            let bench = Bench::new(&gpu, &case, scheme);
            bench.run(&[&KERNEL], false);
            bench.control().too_fast
        };
        let hold = origami_core::twins::fire_update::HOLD;
        assert_eq!(waits_after(Scheme::Relax, 1.01 * hold), 1);
        assert_eq!(waits_after(Scheme::Relax, -1.01 * hold), 1);
        assert_eq!(waits_after(Scheme::Relax, 0.99 * hold), 0);
        assert_eq!(waits_after(EULER, 1.01 * hold), 0, "the ramp of dynamics does not wait");
    }

    #[test]
    fn targets_lie_on_the_ramp() {
        let Some(gpu) = gpu() else { return };
        let case = held(&cases()[3]);
        let bench = Bench::new(&gpu, &case, EULER);
        let mut states: Vec<CreaseState> = bench.read(Binding::CreaseStates, case.model.creases.len());
        states.iter_mut().for_each(|s| s.start_target = 0.5 * s.end_target - 0.25);
        bench.write(Binding::CreaseStates, &states);
        bench.change_control(|c| (c.ramp_step, c.ramp_length) = (3, 8));
        bench.run(&[&KERNEL], false);
        let got: Vec<CreaseState> = bench.read(Binding::CreaseStates, case.model.creases.len());
        let mut on_the_way = case.clone();
        on_the_way.state.targets.iter_mut().for_each(|t| *t = (0.5 * *t - 0.25) * 5.0 / 8.0 + *t * 3.0 / 8.0);
        assert!(errors(&on_the_way, &got)[1] < TOLERANCE);
        assert!(errors(&case, &got)[1] > TOLERANCE, "not those at its end");
    }
}
