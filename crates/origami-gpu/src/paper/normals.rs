//! First pass: normals of the triangles.

use super::layout::SHARED;
use crate::kernels::{Binding, Kernel, Per};

pub(super) const KERNEL: Kernel = Kernel {
    name: "normals",
    entry: "normals",
    text: origami_shaders::paper::NORMALS,
    shared: SHARED,
    parts: |_| Vec::new(),
    uses: &[Binding::Control, Binding::Motions, Binding::Triangles, Binding::FaceNormals],
    springs: false,
    per: Per::Face,
};

/// Unit normal and twice the area of each triangle, in f64.
#[cfg(test)]
pub(super) fn on_cpu(case: &crate::testing::cases::Case) -> Vec<glam::DVec4> {
    let triangles = case.model.mesh.triangles.iter();
    let normal = |nodes: &[origami_core::ids::NodeId; 3]| {
        let [a, b, c] = nodes.map(|n| case.state.positions[n.index()]);
        let normal = (b - a).cross(c - a);
        normal.normalize_or_zero().extend(normal.length())
    };
    triangles.map(normal).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Gpu;
    use crate::layout::{Control, NONE};
    use crate::paper::sheet::Sheet;
    use crate::paper::testing::{run, sheet};
    use crate::testing::cases::{Case, ROUNDING, cases, miura, reach, tampered, worst};
    use crate::testing::gpu;

    /// In roundings of the sides, times side over height, by which a wrong side turns the normal. Two sides and the products
    /// of the cross product are rounded; WGSL lets a root and a quotient be off by 2.5 units in the last place.
    const TOLERANCE: f64 = 4.0;

    fn error(gpu: &Gpu, case: &Case, expected: &Case) -> f64 {
        let sheet = sheet(gpu, case);
        let expected_normals = on_cpu(expected);
        sheet.engine.write(Binding::FaceNormals, &vec![[f32::NAN; 4]; expected_normals.len()]);
        run(&sheet, &KERNEL, 1);
        let normals: Vec<[f32; 4]> = sheet.engine.read(Binding::FaceNormals, expected_normals.len()).expect("read");
        worst(normals.iter().zip(expected_normals).zip(&case.model.mesh.triangles).flat_map(|((got, want), nodes)| {
            let got = glam::Vec4::from_array(*got).as_dvec4();
            let [a, b, c] = nodes.map(|n| n.index());
            let sides = [[a, b], [b, c], [c, a]];
            let reach = sides.map(|side| reach(case, side)).into_iter().fold(0.0, f64::max);
            let length = |[i, j]: [usize; 2]| case.state.positions[i].distance(case.state.positions[j]);
            let longest = sides.map(length).into_iter().fold(0.0, f64::max);
            let scale = ROUNDING * reach * longest;
            [((got - want).truncate().length(), scale / want.w), ((got.w - want.w).abs(), scale)]
        }))
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases() {
            let error = error(&gpu, &case, &case);
            println!("normals, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            assert!(self::error(&gpu, &case, &tampered(&case)) > TOLERANCE, "{}: a moved node is seen", case.name);
        }
    }

    #[test]
    fn the_first_pass_counts_steps_until_a_node_is_out_of_bounds() {
        let Some(gpu) = gpu() else { return };
        let sheet = Sheet::new(&gpu, &miura(), 0.1).expect("it fits");
        for (bad_node, stop, step) in [(NONE, 0, 8), (3, 2, 5)] {
            sheet.engine.write(Binding::Control, &[Control { bad_node, step: 5, ..Control::default() }]);
            run(&sheet, &KERNEL, 3);
            let control: Vec<Control> = sheet.engine.read(Binding::Control, 1).expect("read");
            assert_eq!(control, [Control { bad_node, stop, step, ..Control::default() }]);
        }
    }
}
