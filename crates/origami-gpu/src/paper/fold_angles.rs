//! Second pass: fold angles (paper 2.3).

use super::layout::SHARED;
use crate::kernels::{Binding, Kernel, Per};

pub(super) const KERNEL: Kernel = Kernel {
    name: "fold_angles",
    entry: "fold_angles",
    text: origami_shaders::paper::FOLD_ANGLES,
    shared: SHARED,
    parts: |_| Vec::new(),
    uses: &[Binding::Motions, Binding::FaceNormals, Binding::Creases, Binding::Springs],
    springs: false,
    per: Per::Crease,
};

#[cfg(test)]
mod tests {
    use origami_core::forces::creases;

    use super::*;
    use crate::Gpu;
    use crate::paper::layout::Spring;
    use crate::paper::testing::{run, sheet};
    use crate::testing::cases::{Case, ROUNDING, cases, collapsed, tampered, worst};
    use crate::testing::gpu;

    /// In roundings of the angle, or of 1 where it is less. The normals come rounded, their products are rounded, the arc
    /// tangent is good to 4 and so is its quotient; then whole turns are added.
    const TOLERANCE: f64 = 8.0;

    fn angles(gpu: &Gpu, case: &Case) -> Vec<f64> {
        let sheet = sheet(gpu, case);
        run(&sheet, &KERNEL, 1);
        let springs: Vec<Spring> = sheet.engine.read(Binding::Springs, case.model.creases.len()).expect("read");
        springs.iter().map(|spring| f64::from(spring.angle)).collect()
    }

    fn error(angles: &[f64], expected: &Case) -> f64 {
        let expected = creases::fold_angles(&expected.model, &expected.state.positions, &expected.state.fold_angles);
        worst(angles.iter().zip(expected).map(|(got, want)| ((got - want).abs(), ROUNDING * want.abs().max(1.0))))
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        let mut largest = 0.0_f64;
        for case in cases() {
            let angles = angles(&gpu, &case);
            let error = error(&angles, &case);
            println!("fold angles, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            assert!(self::error(&angles, &tampered(&case)) > TOLERANCE, "{}: a moved node is seen", case.name);
            largest = angles.iter().fold(largest, |most, angle| most.max(angle.abs()));
        }
        assert!(largest > 190_f64.to_radians(), "some were past half a turn: {largest}");
    }

    #[test]
    fn collapsed_creases_keep_their_angles() {
        let Some(gpu) = gpu() else { return };
        let case = collapsed();
        let angles = angles(&gpu, &case);
        assert_eq!(angles[..2], case.state.fold_angles[..2]);
        assert!(error(&angles, &case) < TOLERANCE);
    }
}
