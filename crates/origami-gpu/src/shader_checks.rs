//! What tests ask of shaders without a GPU: that they are valid, laid out as in Rust, and touch the bindings that Rust
//! gives them.

use std::collections::{BTreeMap, BTreeSet};

use naga::valid::{Capabilities, GlobalUse, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, StorageAccess, TypeInner};

/// A shader that was found valid, without optional capabilities but those named.
#[derive(Debug)]
pub(crate) struct Checked {
    module: Module,
    info: ModuleInfo,
}

impl Checked {
    /// The names of the buffers by their bindings.
    pub(crate) fn buffers(&self) -> BTreeMap<u32, String> {
        let variables = self.module.global_variables.iter().map(|(_, variable)| variable);
        let named = variables.filter_map(|v| Some((v.binding.as_ref()?.binding, v.name.clone().unwrap_or_default())));
        named.collect()
    }
}

/// Parses and validates a shader.
///
/// # Panics
/// If it is not valid, or calls a function that is too coarse on some adapters.
pub(crate) fn checked(name: &str, text: &str) -> Checked {
    checked_with(name, text, Capabilities::empty())
}

/// The same where the adapter is known to have these capabilities.
///
/// # Panics
/// As [`checked`].
pub(crate) fn checked_with(name: &str, text: &str, capabilities: Capabilities) -> Checked {
    for coarse in ["acos(", "asin("] {
        assert!(!text.contains(coarse), "{name}: {coarse} is off by up to 4e-4 on some adapters");
    }
    let module =
        naga::front::wgsl::parse_str(text).unwrap_or_else(|e| panic!("{}", e.emit_to_string_with_path(text, name)));
    let info = Validator::new(ValidationFlags::all(), capabilities).validate(&module);
    let info = info.unwrap_or_else(|e| panic!("{}", e.emit_to_string_with_path(text, name)));
    Checked { module, info }
}

/// Whether struct `name` has these fields at these offsets, in this order, and is `size` bytes long (as in an array).
///
/// # Panics
/// If not, telling what the shader has.
pub(crate) fn check_struct(shader: &Checked, name: &str, fields: &[(&str, usize)], size: usize) {
    let mut types = shader.module.types.iter().map(|(_, ty)| ty);
    let ty = types.find(|ty| ty.name.as_deref() == Some(name)).unwrap_or_else(|| panic!("there is no struct {name}"));
    let TypeInner::Struct { members, span } = &ty.inner else { panic!("{name} is no struct") };
    let there: Vec<(&str, usize)> =
        members.iter().map(|m| (m.name.as_deref().unwrap_or_default(), m.offset as usize)).collect();
    assert_eq!(there, fields, "fields of {name}: in the shader, in Rust");
    assert_eq!(*span as usize, size, "size of {name}: in the shader, in Rust");
}

/// Calls [`check_struct`] with the offsets and the size of a struct of Rust.
macro_rules! same_layout {
    ($shader:expr, $name:ident { $($field:ident),* $(,)? }) => {
        $crate::shader_checks::check_struct(
            $shader,
            stringify!($name),
            &[$((stringify!($field), std::mem::offset_of!($name, $field))),*],
            size_of::<$name>(),
        )
    };
}
pub(crate) use same_layout;

/// The bindings of group 0 that an entry point touches, itself or through what it calls.
pub(crate) fn bindings(shader: &Checked, entry: &str) -> BTreeSet<u32> {
    let index = shader.module.entry_points.iter().position(|e| e.name == entry);
    let uses = shader.info.get_entry_point(index.unwrap_or_else(|| panic!("there is no entry point {entry}")));
    let touched = shader.module.global_variables.iter().filter(|(handle, _)| !uses[*handle].is_empty());
    touched.filter_map(|(_, variable)| variable.binding.as_ref()).map(|binding| binding.binding).collect()
}

/// Whether an entry point, itself or through what it calls, reads each binding of group 0 that it touches, and writes it.
pub(crate) fn accesses(shader: &Checked, entry: &str) -> BTreeMap<u32, (bool, bool)> {
    let index = shader.module.entry_points.iter().position(|e| e.name == entry);
    let uses = shader.info.get_entry_point(index.unwrap_or_else(|| panic!("there is no entry point {entry}")));
    let touched = shader.module.global_variables.iter().filter(|(handle, _)| !uses[*handle].is_empty());
    let access = |(handle, variable): (_, &naga::GlobalVariable)| {
        let how: GlobalUse = uses[handle];
        let binding = variable.binding.as_ref()?;
        Some((binding.binding, (how.contains(GlobalUse::READ), how.contains(GlobalUse::WRITE))))
    };
    touched.filter_map(access).collect()
}

/// The storage buffers of a shader that it declares as read-only, whether an entry point touches them or not.
pub(crate) fn read_only(shader: &Checked) -> BTreeSet<u32> {
    let only_read = |variable: &&naga::GlobalVariable| matches!(variable.space, naga::AddressSpace::Storage { access } if access == StorageAccess::LOAD);
    let variables = shader.module.global_variables.iter().map(|(_, variable)| variable);
    variables.filter(only_read).filter_map(|v| v.binding.as_ref()).map(|binding| binding.binding).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "
        struct Pair { first: u32, second: vec3<f32> }
        @group(0) @binding(0) var<storage, read> pairs: array<Pair>;
        @group(0) @binding(3) var<storage, read_write> sums: array<f32>;
        @group(0) @binding(4) var<storage, read_write> others: array<f32>;
        fn sum(i: u32) -> f32 { return pairs[i].second.x; }
        @compute @workgroup_size(64) fn one(@builtin(global_invocation_id) id: vec3<u32>) { sums[id.x] = sum(id.x); }
        @compute @workgroup_size(64) fn two(@builtin(global_invocation_id) id: vec3<u32>) { others[id.x] = 1.0; }";

    fn fails(f: impl FnOnce()) -> bool {
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(f)).is_err()
    }

    #[test]
    fn each_entry_point_has_its_own_bindings() {
        let shader = checked("test", TEXT);
        assert_eq!(bindings(&shader, "one"), BTreeSet::from([0, 3]), "the first through a function");
        assert_eq!(bindings(&shader, "two"), BTreeSet::from([4]));
        assert_eq!(accesses(&shader, "one"), BTreeMap::from([(0, (true, false)), (3, (false, true))]));
        assert_eq!(read_only(&shader), BTreeSet::from([0]));
        assert!(fails(|| drop(bindings(&shader, "three"))));
    }

    #[test]
    fn wrong_layouts_are_found() {
        let shader = checked("test", TEXT);
        check_struct(&shader, "Pair", &[("first", 0), ("second", 16)], 32);
        assert!(fails(|| check_struct(&shader, "Pair", &[("first", 0), ("second", 4)], 32)), "offset");
        assert!(fails(|| check_struct(&shader, "Pair", &[("first", 0), ("second", 16)], 28)), "size");
        assert!(fails(|| check_struct(&shader, "Pair", &[("second", 0), ("first", 16)], 32)), "names");
        assert!(fails(|| check_struct(&shader, "Pair", &[("first", 0)], 32)), "a field is missing");
        assert!(fails(|| check_struct(&shader, "Triple", &[], 0)), "no such struct");
    }

    #[test]
    fn wrong_shaders_are_found() {
        assert!(fails(|| drop(checked("test", "fn f() -> f32 { return 1u; }"))));
        assert!(fails(|| drop(checked("test", "fn f() -> f32 { return acos(1.0); }"))));
        assert!(fails(|| drop(checked("test", "fn f() -> f64 { return 1.0lf; }"))), "f64 is a capability");
    }
}
