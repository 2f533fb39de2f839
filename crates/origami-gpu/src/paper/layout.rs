//! The structs of `paper/sheet.wgsl`, and which buffer of them has which binding.

use bytemuck::{Pod, Zeroable};

/// A buffer, by its binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub(super) enum Slot {
    Settings,
    Status,
    Nodes,
    Motions,
    NextVelocities,
    Triangles,
    FaceNormals,
    Creases,
    Springs,
    BeamEnds,
    Roles,
}

impl Slot {
    pub(super) const ALL: [Self; 11] = [
        Self::Settings,
        Self::Status,
        Self::Nodes,
        Self::Motions,
        Self::NextVelocities,
        Self::Triangles,
        Self::FaceNormals,
        Self::Creases,
        Self::Springs,
        Self::BeamEnds,
        Self::Roles,
    ];

    /// What its buffer is called where it does not fit.
    pub(super) fn what(self) -> &'static str {
        match self {
            Self::Settings => "the settings",
            Self::Status => "the status",
            Self::Nodes => "the list of nodes",
            Self::Motions => "the motion of the nodes",
            Self::NextVelocities => "the next velocities of the nodes",
            Self::Triangles => "the list of triangles",
            Self::FaceNormals => "the normals of the triangles",
            Self::Creases => "the list of creases",
            Self::Springs => "the springs of the creases",
            Self::BeamEnds => "the list of beams at nodes",
            Self::Roles => "the list of creases and triangles at nodes",
        }
    }

    /// How kernels see it.
    pub(super) fn binding_type(self) -> wgpu::BufferBindingType {
        match self {
            Self::Settings => wgpu::BufferBindingType::Uniform,
            Self::Nodes | Self::Triangles | Self::Creases | Self::BeamEnds | Self::Roles => {
                wgpu::BufferBindingType::Storage { read_only: true }
            }
            Self::Status | Self::Motions | Self::NextVelocities | Self::FaceNormals | Self::Springs => {
                wgpu::BufferBindingType::Storage { read_only: false }
            }
        }
    }
}

/// No node is out of bounds.
pub(super) const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Settings {
    pub(super) nodes: u32,
    pub(super) triangles: u32,
    pub(super) creases: u32,
    pub(super) time_step: f32,
    pub(super) k_face: f32,
}

#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Status {
    /// The first node out of bounds, or [`NONE`].
    pub(super) bad_node: u32,
    /// Steps done.
    pub(super) steps: u32,
    pub(super) running: u32,
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
    use std::collections::BTreeSet;

    use super::*;
    use crate::paper::passes::PASSES;
    use crate::shader_checks::{bindings, checked, read_only, same_layout};

    #[test]
    fn structs_lie_as_in_the_shader() {
        let shader = checked("paper/sheet.wgsl", origami_shaders::paper::SHEET);
        same_layout!(&shader, Settings { nodes, triangles, creases, time_step, k_face });
        same_layout!(&shader, Status { bad_node, steps, running });
        same_layout!(&shader, Node { rest, fixed_in_place, beams, creases, corners });
        same_layout!(&shader, Motion { displacement, velocity });
        same_layout!(&shader, Triangle { nodes, sides, angles });
        same_layout!(&shader, Crease { nodes, along, triangle_one, to_one, triangle_two, to_two });
        same_layout!(&shader, Spring { angle, target_angle, stiffness, per_height, foot });
        same_layout!(&shader, BeamEnd { rest, rest_length, other, stiffness, damping });
        same_layout!(&shader, Role { element, place, triangle_one, triangle_two });
    }

    #[test]
    fn each_pass_is_valid_and_touches_what_it_is_given() {
        for pass in PASSES {
            let shader = checked(pass.name, &pass.text());
            let given: BTreeSet<u32> = pass.slots.iter().map(|slot| *slot as u32).collect();
            assert_eq!(bindings(&shader, pass.name), given, "{}: in the shader, in Rust", pass.name);
            let storage = pass.slots.iter().filter(|slot| slot.binding_type() != wgpu::BufferBindingType::Uniform);
            assert!(storage.count() <= 8, "{} fits the default limits", pass.name);
            let constant =
                Slot::ALL.iter().filter(|s| s.binding_type() == wgpu::BufferBindingType::Storage { read_only: true });
            let constant: BTreeSet<u32> = constant.map(|slot| *slot as u32).collect();
            assert_eq!(read_only(&shader), constant);
        }
    }

    #[test]
    fn slots_are_in_the_order_of_their_bindings() {
        for (i, slot) in Slot::ALL.into_iter().enumerate() {
            assert_eq!(slot as usize, i);
        }
    }
}
