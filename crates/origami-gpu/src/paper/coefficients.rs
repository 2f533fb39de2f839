//! Third pass: the coefficients of the creases' forces (paper 2.3).

use super::layout::SHARED;
use crate::kernels::{Binding, Kernel, Per};

pub(super) const KERNEL: Kernel = Kernel {
    name: "coefficients",
    entry: "coefficients",
    text: origami_shaders::paper::COEFFICIENTS,
    shared: SHARED,
    parts: |_| Vec::new(),
    uses: &[Binding::Motions, Binding::FaceNormals, Binding::Creases, Binding::Springs],
    springs: false,
    per: Per::Crease,
};

/// One over the heights of the apexes, then the places of their feet, for each crease in f64; zeros where it has collapsed.
#[cfg(test)]
pub(super) fn on_cpu(case: &crate::testing::cases::Case) -> Vec<[f64; 4]> {
    let coefficients = |crease: &origami_core::model::Crease| {
        let points = crease.nodes.map(|n| case.state.positions[n.index()]);
        if origami_core::forces::creases::hinge(points).is_none() {
            return [0.0; 4];
        }
        let [p1, p2, p3, p4] = points;
        let e = p4 - p3;
        let [foot_one, foot_two] = [p1, p2].map(|p| (p - p3).dot(e) / e.length_squared());
        let height = |p: glam::DVec3| e.cross(p - p3).length() / e.length();
        [1.0 / height(p1), 1.0 / height(p2), foot_one, foot_two]
    };
    case.model.creases.iter().map(coefficients).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Gpu;
    use crate::paper::layout::Spring;
    use crate::paper::testing::{run, sheet};
    use crate::testing::cases::{Case, ROUNDING, cases, collapsed, reach, tampered, worst};
    use crate::testing::gpu;

    /// In roundings of the vectors that go in. The area comes rounded, and two or three operations follow, of which WGSL lets
    /// the quotient be off by 5.
    const TOLERANCE: f64 = 5.0;

    fn coefficients(gpu: &Gpu, case: &Case) -> Vec<[f64; 4]> {
        let sheet = sheet(gpu, case);
        run(&sheet, &KERNEL, 1);
        let springs: Vec<Spring> = sheet.engine.read(Binding::Springs, case.model.creases.len()).expect("read");
        let numbers = |s: &Spring| [s.per_height[0], s.per_height[1], s.foot[0], s.foot[1]].map(f64::from);
        springs.iter().map(numbers).collect()
    }

    fn error(case: &Case, got: &[[f64; 4]], expected: &Case) -> f64 {
        let errors = got.iter().zip(on_cpu(expected)).zip(&case.model.creases).flat_map(|((got, want), crease)| {
            let nodes @ [_, _, p3, p4] = crease.nodes.map(|n| n.index());
            let length = case.state.positions[p3].distance(case.state.positions[p4]);
            let along = ROUNDING * reach(case, [p3, p4]) / length;
            let foot = |i: usize| {
                let to = case.state.positions[nodes[i]].distance(case.state.positions[p3]);
                (ROUNDING * reach(case, [p3, nodes[i]]) + along * to) / length
            };
            let scales = [along * want[0], along * want[1], foot(0), foot(1)];
            // What must be exactly zero has no scale.
            [0, 1, 2, 3].map(|i| if got[i] == want[i] { (0.0, 1.0) } else { ((got[i] - want[i]).abs(), scales[i]) })
        });
        worst(errors)
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases() {
            let got = coefficients(&gpu, &case);
            let error = error(&case, &got, &case);
            println!("coefficients, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            assert!(self::error(&case, &got, &tampered(&case)) > TOLERANCE, "{}: a moved node is seen", case.name);
        }
    }

    #[test]
    fn collapsed_creases_have_none() {
        let Some(gpu) = gpu() else { return };
        let case = collapsed();
        let got = coefficients(&gpu, &case);
        assert_eq!(got[..2], [[0.0; 4]; 2]);
        assert!(error(&case, &got, &case) < TOLERANCE);
    }
}
