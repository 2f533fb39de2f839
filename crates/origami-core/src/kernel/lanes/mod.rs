//! What each instruction set does with numbers side by side.

pub(super) mod portable;
#[cfg(target_arch = "x86_64")]
pub(super) mod x86;
