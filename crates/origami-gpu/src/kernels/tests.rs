use std::collections::BTreeSet;

use naga::{AddressSpace, ArraySize, Module, ShaderStage, TypeInner};

use super::*;
use crate::paper::PASSES;
use crate::plan::Plan;
use crate::shader_checks::{bindings, checked};
use crate::testing::variants;

const ALL: [&Kernel; 32] = [
    &block_clock::KERNEL,
    &block_dynamics::KERNEL,
    &block_forces::KERNEL,
    &block_relax::KERNEL,
    &bring_home::KERNEL,
    &fire_update::KERNEL,
    &fold_angles::KERNEL,
    &triangle_forces::KERNEL,
    &settle_decide::KERNEL,
    &checkpoint::KERNEL,
    &contact_aim::KERNEL,
    &contact_clock::KERNEL,
    &contact_move::KERNEL,
    &contact_reduce::KERNEL,
    &pair_forces::KERNEL,
    &pair_limits::KERNEL,
    &loose_beams::KERNEL,
    &fire_move::KERNEL,
    &integrate::KERNEL,
    &safe_time_step::KERNEL,
    &row_sums::KERNEL,
    &settle_windows::KERNEL,
    &stiffness_max::KERNEL,
    &state_bounds::KERNEL,
    &reduce_forces::KERNEL,
    &workgroup_dynamics::KERNEL,
    &workgroup_relax::KERNEL,
    // With those of the paper, which are made of the same.
    PASSES[0],
    PASSES[1],
    PASSES[2],
    PASSES[3],
    PASSES[4],
];

/// What every WebGPU device has.
const STORAGE_BUFFERS: usize = 8;
const INVOCATIONS: u32 = 256;
const WORKGROUP_STORAGE: u32 = 16_384;

/// Whether the engine ever builds it so.
fn is_built(kernel: &Kernel, variant: &Variant) -> bool {
    if variant.blocks.is_some() {
        let plan = Plan::new(variant, true);
        let lists =
            [plan.forces.as_slice(), plan.settling, plan.row_sums, plan.integration, plan.checkpoint, plan.home];
        let whole = kernel.springs && kernel.per == Per::Instance;
        return whole || lists.concat().iter().any(|planned| planned.name == kernel.name);
    }
    let of_contact = kernel.per == Per::Pair || kernel.name.starts_with("contact");
    let without = [reduce_forces::KERNEL.name, fire_move::KERNEL.name];
    if if variant.contact.is_some() { without.contains(&kernel.name) } else { of_contact } {
        return false;
    }
    let of_blocks =
        kernel.per == Per::Block || [block_clock::KERNEL.name, bring_home::KERNEL.name].contains(&kernel.name);
    !of_blocks && (kernel.per != Per::Instance || !kernel.springs)
}

/// Every kernel in every variant that has a text of its own: constants alone do not change it.
fn texts() -> impl Iterator<Item = (&'static Kernel, Variant, String)> {
    let all = variants::of_texts().into_iter().flat_map(|variant| ALL.map(|kernel| (kernel, variant.clone())));
    all.filter(|(kernel, variant)| is_built(kernel, variant)).map(|(kernel, variant)| {
        let text = kernel.source(&variant);
        (kernel, variant, text)
    })
}

/// The constants of a module that get no value from `given`.
fn without_value(module: &Module, given: &[(&str, f64)]) -> Vec<String> {
    let names = module.overrides.iter().filter_map(|(_, constant)| constant.name.clone());
    names.filter(|name| given.iter().all(|(known, _)| known != name)).collect()
}

/// Bytes of a module's workgroup variables, with these values for the constants that arrays are as long as.
fn workgroup_storage(module: &Module, given: &[(&str, f64)]) -> u32 {
    let variables = module.global_variables.iter().map(|(_, variable)| variable);
    let shared = variables.filter(|variable| variable.space == AddressSpace::WorkGroup);
    let value = |constant: naga::Handle<naga::Override>| {
        let name = module.overrides[constant].name.as_deref();
        given.iter().find(|(known, _)| Some(*known) == name).expect("it has a value").1 as u32
    };
    let size = |variable: &naga::GlobalVariable| match module.types[variable.ty].inner {
        TypeInner::Array { size: ArraySize::Pending(length), stride, .. } => stride * value(length),
        ref inner => inner.size(module.to_ctx()),
    };
    shared.map(size).sum()
}

#[test]
fn each_kernel_is_valid_and_touches_what_it_is_given() {
    let mut count = 0;
    for (kernel, variant, text) in texts() {
        let shader = checked(kernel.name, &text);
        let given: BTreeSet<u32> = kernel.bindings(&variant).into_iter().map(|binding| binding as u32).collect();
        assert_eq!(bindings(&shader, kernel.entry), given, "{} of {variant:?}: in the shader, in Rust", kernel.name);
        let storage = given.iter().filter(|binding| **binding != Binding::Settings as u32).count();
        assert!(storage <= STORAGE_BUFFERS, "{} of {variant:?} fits the default limits", kernel.name);
        count += 1;
    }
    assert!(count > 100, "{count} texts");
}

#[test]
fn each_constant_gets_a_value_and_workgroups_are_small_enough() {
    for (kernel, variant, text) in texts() {
        let module = naga::front::wgsl::parse_str(&text).expect("valid");
        let constants = variant.constants(false);
        let missing = without_value(&module, &constants);
        assert!(missing.is_empty(), "{}: {missing:?} have no value", kernel.name);
        let storage = workgroup_storage(&module, &constants);
        assert!(storage <= WORKGROUP_STORAGE, "{}", kernel.name);
        let room = variant.blocks.filter(|_| kernel.springs).map(|blocks| match kernel.per {
            Per::Block => blocks.room.memory(),
            _ => blocks.room.memory_of_whole(variant.small.words, variant.workgroup as usize),
        });
        assert!(room.is_none_or(|room| storage as usize == room), "{}: {storage} bytes, {room:?} counted", kernel.name);
        let entry = module.entry_points.iter().find(|entry| entry.name == kernel.entry).expect("it is there");
        assert_eq!(entry.stage, ShaderStage::Compute);
        // Either one invocation or as many as the constant says, which is no more than 256.
        let by_constant = entry.workgroup_size_overrides.is_some_and(|sizes| sizes[0].is_some());
        assert!(by_constant || entry.workgroup_size == [1, 1, 1], "{}", kernel.name);
    }
}

#[test]
fn workgroups_have_what_every_device_has_and_a_power_of_two() {
    for variant in variants::of_texts() {
        assert!(variant.workgroup <= INVOCATIONS && variant.workgroup.is_power_of_two(), "{variant:?}");
    }
}

#[test]
fn each_kernel_has_the_shader_of_its_name() {
    for kernel in ALL {
        let file = format!("{}.wgsl", kernel.name);
        let folder = if kernel.shared == SHARED { wgsl::ALL } else { wgsl::paper::ALL };
        let of_this_name = |(name, _): &&(&str, &str)| name.rsplit('/').next() == Some(file.as_str());
        let (_, text) = folder.iter().find(of_this_name).expect("a file of this name");
        assert_eq!(*text, kernel.text, "{file}");
    }
}

#[test]
fn the_checks_can_fail() {
    let text = "override KNOWN: u32 = 1u; override NEW: f32 = 2.0; var<workgroup> some: array<vec4<f32>, KNOWN>;
        var<workgroup> one: u32;
        @compute @workgroup_size(KNOWN) fn f() { some[0] = vec4<f32>(NEW); one = 1u; }";
    let module = naga::front::wgsl::parse_str(text).expect("valid");
    assert_eq!(without_value(&module, &[("KNOWN", 1.0)]), ["NEW"]);
    assert_eq!(workgroup_storage(&module, &[("KNOWN", 1024.0)]), 16_388);
}
