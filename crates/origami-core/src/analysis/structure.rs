//! A structure of bars and hinges as an engineer says it: nodes, members, supports, loads, masses, in whatever units.

use glam::DVec3;

use super::{Axis, BarLaw, Configuration, Dof, HingeLaw};
use crate::forces::creases;
use crate::ids::NodeId;
use crate::model::{CornerAngles, Model, StiffnessSource};
use crate::scene::Axes;

/// A straight member that resists stretching.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Its ends, two different nodes.
    pub nodes: [NodeId; 2],
    /// Length at which it has no tension. Above 0.
    pub rest_length: f64,
    /// Axial rigidity EA, a force. Larger: less strain. Above 0.
    pub rigidity: f64,
    /// How its tension depends on its length.
    pub law: BarLaw,
}

/// What a hinge stands for. It makes no difference but to the sums in which its energy counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HingeKind {
    /// A crease of the pattern.
    Crease,
    /// A line along which a facet bends.
    Facet,
}

/// Two triangles with a rotational spring between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hinge {
    /// Apexes 1 and 2, then the ends 3 and 4 of the line between; triangle (3, 4, 1) lies to the left of the line from 3 to 4,
    /// seen from the front, as in [`crate::model::Crease`].
    pub nodes: [NodeId; 4],
    /// Fold angle at which it has no moment, in radians, 0 flat, valley positive.
    pub rest_angle: f64,
    /// Stiffness of the whole hinge, a moment per radian. Larger: it turns less. At least 0.
    pub stiffness: f64,
    /// How its moment depends on its angle.
    pub law: HingeLaw,
    /// What it stands for.
    pub kind: HingeKind,
}

/// Springs that keep the corner angles of a triangle (paper 2.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners {
    /// The triangle, with its angles at rest.
    pub angles: CornerAngles,
    /// Stiffness of each angle, a moment per radian. Larger: less shear. At least 0.
    pub stiffness: f64,
}

/// Where a structure is held, and where its supports are moved to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Supports {
    /// Degrees of freedom that stay where they are drawn.
    pub fixed: Vec<Dof>,
    /// Degrees of freedom with their displacements at load factor 1, from where they are drawn. In between they are in
    /// proportion.
    pub moved: Vec<(Dof, f64)>,
}

/// What acts on a structure at load factor 1. At others all of it is in proportion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loads {
    /// Dead loads: forces that keep their direction and size.
    pub points: Vec<(NodeId, DVec3)>,
    /// Pressures on triangles (three nodes, counterclockwise seen from the front): a force per area that acts along the front
    /// normal and follows it as the triangle turns and stretches, shared by its corners.
    pub pressures: Vec<([NodeId; 3], f64)>,
}

/// Bars and hinges with their supports and loads. Plain data in consistent units of the caller's own: a force is a
/// rigidity, a moment a force times a length. What is wrong with it is said when it is analysed, or by [`Structure::check`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Structure {
    /// Where the nodes are drawn: where paths begin, and from where displacements count.
    pub nodes: Vec<DVec3>,
    /// Members along lines.
    pub bars: Vec<Bar>,
    /// Members that turn.
    pub hinges: Vec<Hinge>,
    /// Members that resist shear.
    pub corners: Vec<Corners>,
    /// Where it is held. Default: nowhere.
    pub supports: Supports,
    /// What acts on it. Default: nothing.
    pub loads: Loads,
    /// Mass of each node, above 0; only vibrations know them. Empty, the default: 1 each.
    pub masses: Vec<f64>,
}

impl Structure {
    /// The springs of a model in its own units: lengths in radii of the sheet, forces as
    /// [`Material::ea`](crate::Material::ea). Hinges are at rest at the angles that the file gives them; the vertices that
    /// the pattern fixes are held; nothing acts.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let bar = |beam: &crate::model::Beam| Bar {
            nodes: beam.nodes,
            rest_length: beam.rest_length,
            rigidity: beam.stiffness * beam.rest_length,
            law: BarLaw::Linear,
        };
        let hinge = |crease: &crate::model::Crease| Hinge {
            nodes: crease.nodes,
            rest_angle: crease.rest_angle,
            stiffness: crease.stiffness,
            law: HingeLaw::Linear,
            kind: if is_facet(crease) { HingeKind::Facet } else { HingeKind::Crease },
        };
        let stiffness = model.material.k_face;
        let mut structure = Self {
            nodes: model.rest.clone(),
            bars: model.beams.iter().map(bar).collect(),
            hinges: model.creases.iter().map(hinge).collect(),
            corners: model.corner_angles.iter().map(|angles| Corners { angles: *angles, stiffness }).collect(),
            ..Self::default()
        };
        model.fixed.iter().for_each(|node| structure.hold(*node, Axes::ALL));
        structure
    }

    /// Holds a node along some axes where it is drawn.
    pub fn hold(&mut self, node: NodeId, axes: Axes) {
        let held = Axis::ALL.into_iter().zip(axes.to_array()).filter(|(_, held)| *held);
        self.supports.fixed.extend(held.map(|(axis, _)| Dof::new(node, axis)));
    }

    /// Where the nodes are drawn, with the angles that the hinges have there, within half a turn of their rest angles.
    #[must_use]
    pub fn as_drawn(&self) -> Configuration {
        let nearest: Vec<f64> = self.hinges.iter().map(|hinge| hinge.rest_angle).collect();
        Configuration { fold_angles: self.fold_angles(&self.nodes, &nearest), positions: self.nodes.clone() }
    }

    /// The fold angle of each hinge at `positions`, whole turns chosen by the angles `previous`; in radians.
    #[must_use]
    pub fn fold_angles(&self, positions: &[DVec3], previous: &[f64]) -> Vec<f64> {
        let size = self.size();
        let angle = |(hinge, previous): (&Hinge, &f64)| {
            let points = hinge.nodes.map(|n| positions[n.index()] / size);
            let angle = creases::hinge(points).map(|hinge| hinge.angle());
            angle.map_or(*previous, |angle| crate::forces::unwrapped(angle, *previous))
        };
        self.hinges.iter().zip(previous).map(angle).collect()
    }

    /// Half the diagonal of the box around the nodes as drawn, by which small and large are told; 1 where they are all in one
    /// place.
    #[must_use]
    pub fn size(&self) -> f64 {
        let corners =
            self.nodes.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(a, b), p| (a.min(*p), b.max(*p)));
        let half = 0.5 * (corners.1 - corners.0).length();
        if half > 0.0 && half.is_finite() { half } else { 1.0 }
    }
}

/// Whether a crease is one of a facet; with a stiffness of its own it is where it is to be flat.
fn is_facet(crease: &crate::model::Crease) -> bool {
    match crease.source {
        StiffnessSource::Facet => true,
        StiffnessSource::Fold => false,
        StiffnessSource::Own => crease.full_target == 0.0,
    }
}
