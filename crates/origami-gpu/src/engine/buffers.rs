//! The buffers of a sheet: how large they are, and what fits.

use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::{Before, Control, CreaseState, Node};
use crate::pipeline::{Buffers, buffer};
use crate::purpose::Purpose;
use crate::route::Route;
use crate::sheet_arrays::SheetArrays;
use crate::variant::Variant;

/// Dispatches count workgroups in 16 bits.
pub(crate) fn check_counts(variant: &Variant) -> Result<(), GpuError> {
    // A block has several creases for each invocation.
    let creases = if variant.blocks.is_some() { 0 } else { variant.creases };
    let most = creases.max(variant.faces).max(variant.nodes);
    let allowed = 65_535;
    match variant.groups(most) {
        groups if groups > allowed => Err(GpuError::TooManyElements {
            count: most as u64,
            allowed: (allowed * variant.workgroup as usize) as u64,
        }),
        _ => Ok(()),
    }
}

/// Bytes that each buffer takes for one instance, and once for all: what a sheet needs.
pub(crate) fn sizes(arrays: &SheetArrays, variant: &Variant, route: &Route) -> Vec<(Binding, u64, u64)> {
    let size = |count: usize, of: usize| (count * of) as u64;
    let nodes = arrays.nodes;
    // By blocks dynamics keeps the nodes twice: where they are, and where they come to.
    let halves = if matches!(route, Route::Blocks(_)) && !variant.relaxing() { 2 } else { 1 };
    let mut sizes = vec![
        (Binding::Control, size(1, size_of::<Control>()), 0),
        (Binding::Nodes, size(halves * nodes, size_of::<Node>()), 0),
        (Binding::Windows, size(nodes, size_of::<Before>()), 0),
        (Binding::CheckpointNodes, size(nodes, size_of::<Node>()), 0),
        (Binding::CheckpointAngles, size(variant.creases, 4), 0),
    ];
    let partials = (Binding::Partials, size(variant.groups(nodes).max(variant.sums()), 16), 0);
    if let Some(blocks) = route.blocks() {
        sizes.extend([
            (Binding::Blocks, 0, size(blocks.words.len(), 4)),
            (Binding::Angles, size(variant.creases, 4), 0),
            (Binding::Targets, size(variant.creases, 8), 0),
        ]);
        if variant.loads {
            sizes.push((Binding::Loads, size(nodes, 16), 0));
        }
        if matches!(route, Route::Blocks(_)) {
            sizes.extend([partials, (Binding::Slots, size(nodes, 16), 0)]);
        }
        return sizes;
    }
    sizes.extend([
        partials,
        (Binding::CreaseStates, size(arrays.hinges.len(), size_of::<CreaseState>()), 0),
        (Binding::Hinges, 0, size_of_val(&arrays.hinges[..]) as u64),
        (Binding::Faces, 0, size_of_val(&arrays.faces[..]) as u64),
        (Binding::Slots, size(arrays.slot_count(), 16), 0),
        (Binding::Rows, 0, size(nodes + 1, 4)),
    ]);
    if variant.corners {
        sizes.push((Binding::Corners, 0, size(arrays.corners.len(), 16)));
    }
    if variant.rigidities {
        sizes.push((Binding::Rigidities, 0, size(arrays.rigidities.len(), 4)));
    }
    if variant.loose_beams > 0 {
        sizes.push((Binding::LooseBeams, 0, size_of_val(&arrays.loose_beams[..]) as u64));
    }
    sizes
}

/// Makes them, with what does not change in them, for so many instances.
pub(super) fn buffers(
    gpu: &Gpu,
    arrays: &SheetArrays,
    variant: &Variant,
    route: &Route,
    instances: usize,
) -> Result<Buffers, GpuError> {
    let mut buffers = Buffers::new();
    for (binding, each, once) in sizes(arrays, variant, route) {
        let contents: &[u8] = match (binding, route) {
            (Binding::Hinges, _) => bytemuck::cast_slice(&arrays.hinges),
            (Binding::Faces, _) => bytemuck::cast_slice(&arrays.faces),
            (Binding::Rows, _) => bytemuck::cast_slice(&arrays.rows),
            (Binding::Corners, _) => bytemuck::cast_slice(&arrays.corners),
            (Binding::Rigidities, _) => bytemuck::cast_slice(&arrays.rigidities),
            (Binding::LooseBeams, _) => bytemuck::cast_slice(&arrays.loose_beams),
            (Binding::Blocks, Route::Blocks(blocks) | Route::Workgroup(blocks)) => bytemuck::cast_slice(&blocks.words),
            _ => &[],
        };
        buffers.insert(binding, buffer(gpu, binding, each * instances as u64 + once, contents)?);
    }
    Ok(buffers)
}

/// How many instances of a sheet fit into the adapter's buffers.
pub(crate) fn most_instances(gpu: &Gpu, arrays: &SheetArrays, purpose: Purpose) -> usize {
    // Buffers are as large with one material as with many.
    let plain = purpose.variant(arrays, None);
    let route = Route::new(arrays, purpose, gpu.abilities());
    let variant = route.variant(&plain);
    let allowed = gpu.largest_buffer();
    let fits = sizes(arrays, &variant, &route).into_iter().filter(|(_, each, _)| *each > 0);
    let most = fits.map(|(_, each, once)| allowed.saturating_sub(once) / each).min().unwrap_or(1);
    usize::try_from(most.clamp(1, 65_535)).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use origami_core::Model;

    use super::*;
    use crate::purpose::Dispatch;
    use crate::testing::bench::EULER;
    use crate::testing::cases::miura;
    use crate::testing::{gpu, sheets};

    fn arrays_and_variant(model: &Model) -> (SheetArrays, Variant) {
        let arrays = SheetArrays::new(model);
        let variant = Variant::new(&arrays, EULER, Some(model.material));
        (arrays, variant)
    }

    #[test]
    fn more_elements_than_a_dispatch_counts_are_refused() {
        let (_, mut variant) = arrays_and_variant(&miura());
        variant.faces = 65_535 * variant.workgroup as usize;
        assert_eq!(check_counts(&variant), Ok(()));
        variant.faces += 1;
        let count = variant.faces as u64;
        assert_eq!(check_counts(&variant), Err(GpuError::TooManyElements { count, allowed: count - 1 }));
    }

    #[test]
    fn buffers_that_the_adapter_does_not_allow_are_refused() {
        let Some(gpu) = gpu() else { return };
        let model = miura();
        let (mut arrays, variant) = arrays_and_variant(&model);
        let allowed = gpu.largest_buffer();
        // As if it had so many nodes: only what is allowed is ever made.
        arrays.nodes = usize::try_from(allowed).expect("64 bits") / size_of::<Node>() + 1;
        let refused = buffers(&gpu, &arrays, &variant, &Route::Passes, 1).expect_err("too large");
        let needed = (arrays.nodes * size_of::<Node>()) as u64;
        assert_eq!(refused, GpuError::TooLarge { what: "the nodes", needed, allowed });
    }

    #[test]
    fn as_many_instances_as_fit_and_no_more() {
        let Some(gpu) = gpu() else { return };
        let allowed = gpu.largest_buffer();
        for model in [miura(), sheets::loose_beams()] {
            let (arrays, variant) = arrays_and_variant(&model);
            let purpose = Purpose { scheme: EULER, safe: false, softens: false, dispatch: Dispatch::Passes };
            let most = most_instances(&gpu, &arrays, purpose) as u64;
            let largest = |count: u64| sizes(&arrays, &variant, &Route::Passes).iter().map(|s| s.1 * count + s.2).max();
            assert!(largest(most) <= Some(allowed));
            assert!(most == 65_535 || largest(most + 1) > Some(allowed));
            assert!(most >= 1);
        }
    }
}
