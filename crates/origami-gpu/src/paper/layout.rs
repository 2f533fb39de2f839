//! The structs of `paper/sheet.wgsl`.

use bytemuck::{Pod, Zeroable};
use origami_shaders as wgsl;

/// What the five passes begin with.
pub(super) const SHARED: &[&str] = &[wgsl::CONTROL, wgsl::MATERIAL_UNIFORM, wgsl::ANGLE, wgsl::paper::SHEET];

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Settings {
    pub(super) time_step: f32,
}

/// Ranges are first and last, the last not included.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Node {
    pub(super) rest: [f32; 3],
    pub(super) fixed_in_place: u32,
    pub(super) beams: [u32; 2],
    pub(super) creases: [u32; 2],
    pub(super) corners: [u32; 2],
    pub(super) padding: [u32; 2],
}

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Motion {
    pub(super) displacement: [f32; 3],
    pub(super) padding: f32,
    pub(super) velocity: [f32; 3],
    pub(super) padding_too: f32,
}

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Triangle {
    pub(super) nodes: [u32; 3],
    pub(super) padding: u32,
    /// From each corner to the next; the fourth numbers are padding.
    pub(super) sides: [[f32; 4]; 3],
    /// Cosine and sine of the first two angles.
    pub(super) angles: [f32; 4],
}

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Crease {
    pub(super) nodes: [u32; 4],
    pub(super) along: [f32; 3],
    pub(super) triangle_one: u32,
    pub(super) to_one: [f32; 3],
    pub(super) triangle_two: u32,
    pub(super) to_two: [f32; 3],
    pub(super) padding: u32,
}

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Spring {
    pub(super) angle: f32,
    pub(super) target_angle: f32,
    pub(super) stiffness: f32,
    pub(super) padding: f32,
    pub(super) per_height: [f32; 2],
    pub(super) foot: [f32; 2],
}

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct BeamEnd {
    pub(super) rest: [f32; 3],
    pub(super) rest_length: f32,
    pub(super) other: u32,
    pub(super) stiffness: f32,
    pub(super) damping: f32,
    pub(super) padding: u32,
}

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Role {
    pub(super) element: u32,
    pub(super) place: u32,
    pub(super) triangle_one: u32,
    pub(super) triangle_two: u32,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shader_checks::{checked, same_layout};

    #[test]
    fn structs_lie_as_in_the_shader() {
        let shader = checked("paper/sheet.wgsl", &SHARED.join("\n"));
        same_layout!(&shader, Settings { time_step });
        same_layout!(&shader, Node { rest, fixed_in_place, beams, creases, corners });
        same_layout!(&shader, Motion { displacement, velocity });
        same_layout!(&shader, Triangle { nodes, sides, angles });
        same_layout!(&shader, Crease { nodes, along, triangle_one, to_one, triangle_two, to_two });
        same_layout!(&shader, Spring { angle, target_angle, stiffness, per_height, foot });
        same_layout!(&shader, BeamEnd { rest, rest_length, other, stiffness, damping });
        same_layout!(&shader, Role { element, place, triangle_one, triangle_two });
    }
}
