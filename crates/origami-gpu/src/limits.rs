//! What an adapter can do, and what is asked of it: `wgpu::Limits::default()`.

use std::fmt;

/// The limits that tell how large a sheet an adapter can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AdapterLimits {
    /// Storage buffers that one kernel can see.
    pub storage_buffers_per_stage: u32,
    /// Invocations in a workgroup.
    pub invocations_per_workgroup: u32,
    /// Memory that a workgroup shares, in bytes.
    pub workgroup_storage: u32,
    /// The part of a buffer that one kernel can see, in bytes.
    pub storage_binding: u64,
    /// A buffer, in bytes.
    pub buffer: u64,
}

impl AdapterLimits {
    pub(crate) fn of(limits: &wgpu::Limits) -> Self {
        Self {
            storage_buffers_per_stage: limits.max_storage_buffers_per_shader_stage,
            invocations_per_workgroup: limits.max_compute_invocations_per_workgroup,
            workgroup_storage: limits.max_compute_workgroup_storage_size,
            storage_binding: limits.max_storage_buffer_binding_size,
            buffer: limits.max_buffer_size,
        }
    }
}

/// A limit that is not met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lack {
    /// Its name, as wgpu has it.
    pub limit: &'static str,
    /// What the adapter allows.
    pub has: u64,
    /// What is needed: at least this; at most where the name begins with `min_`.
    pub needed: u64,
}

impl Lack {
    /// The first of the limits of `has` that stays behind the defaults.
    pub(crate) fn of(has: &wgpu::Limits) -> Option<Self> {
        let mut lack = None;
        wgpu::Limits::default().check_limits_with_fail_fn(has, true, |limit, needed, has| {
            lack.get_or_insert(Self { limit, has, needed });
        });
        lack
    }
}

impl fmt::Display for Lack {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = if self.limit.starts_with("min_") { "at most" } else { "at least" };
        write!(f, "its {} is {}; expected {at} {}", self.limit, self.has, self.needed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_compared_in_their_own_sense() {
        let default = wgpu::Limits::default();
        assert_eq!(Lack::of(&default), None);
        let better =
            wgpu::Limits { max_buffer_size: 1 << 40, min_storage_buffer_offset_alignment: 32, ..default.clone() };
        assert_eq!(Lack::of(&better), None);
        let worse = wgpu::Limits { min_storage_buffer_offset_alignment: 512, ..default };
        let lack = Lack::of(&worse).expect("an alignment that is too coarse");
        assert_eq!(lack.to_string(), "its min_storage_buffer_offset_alignment is 512; expected at most 256");
    }
}
