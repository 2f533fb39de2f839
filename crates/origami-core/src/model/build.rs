//! From pattern and mesh to springs.

use std::sync::Arc;

use glam::DVec3;

use super::{Beam, CornerAngles, Crease, DEGENERATE, Inventory, Material, Model, Sheet, StiffnessSource};
use crate::error::{Error, ErrorCode, Place, Short};
use crate::ids::{NodeId, SideId, TriangleId};
use crate::mesh::{Mesh, Side};
use crate::pattern::{Assignment, CreasePattern, PatternEdge, fold_angle};

pub(super) fn build(pattern: &CreasePattern, sheet: Arc<Sheet>, material: &Material) -> Result<Model, Error> {
    material.check()?;
    let Sheet { mesh, rest, .. } = &*sheet;
    let mut inventory = Inventory::default();

    let beams = beams(pattern, mesh, material, rest)?;
    inventory.built("beams", beams.len());
    let creases = creases(pattern, mesh, material, rest, &mut inventory);
    let corner_angles = corner_angles(mesh, material, rest, &mut inventory);
    let per_length = |crease: &Crease| {
        let [.., i, j] = crease.nodes.map(|n| rest[n.index()]);
        crease.stiffness / i.distance(j)
    };
    let stiffest_crease = creases.iter().map(per_length).fold(0.0, f64::max);
    areas(mesh, material, stiffest_crease, &mut inventory);

    let mut fixed: Vec<NodeId> = pattern.fixed.iter().filter_map(|v| mesh.node_of_vertex[v.index()]).collect();
    fixed.sort_unstable();
    fixed.dedup();
    inventory.built("fixed vertices", fixed.len());
    if fixed.is_empty() {
        inventory.without("fixed vertices", "the pattern has none");
    }
    let isolated = pattern.vertices.len() - mesh.node_count() - pattern.alias_of.iter().flatten().count();
    inventory.left_out("vertices", isolated, "no edge or face uses them");

    Ok(Model { sheet, material: *material, beams, creases, corner_angles, stiffest_crease, fixed, inventory })
}

fn edge_of<'p>(pattern: &'p CreasePattern, side: &Side) -> Option<&'p PatternEdge> {
    side.edge.map(|e| &pattern.edges[e.index()])
}

fn beams(pattern: &CreasePattern, mesh: &Mesh, material: &Material, rest: &[DVec3]) -> Result<Vec<Beam>, Error> {
    let beam = |side: &Side| {
        let [i, j] = side.nodes;
        let rest_length = rest[i.index()].distance(rest[j.index()]);
        let own = edge_of(pattern, side).and_then(|e| e.ea);
        let ea = own.unwrap_or(material.ea);
        let stiffness = ea / rest_length;
        if !(stiffness.is_finite() && stiffness > 0.0) {
            return Err(Error::new(
                ErrorCode::EdgeWithoutLength,
                Place::Vertices([i, j].map(|n| mesh.vertex_of_node[n.index()]).to_vec()),
                format!(
                    "the edge between them has length {} of the sheet's radius and rigidity {}",
                    Short(rest_length),
                    Short(ea)
                ),
                "two different places and a rigidity above 0",
            ));
        }
        Ok(Beam { nodes: side.nodes, rest_length, stiffness, own: own.is_some() })
    };
    mesh.sides.iter().map(beam).collect()
}

/// Why a hinge has no spring.
#[derive(Clone, Copy, PartialEq, Eq)]
enum NoSpring {
    Undriven,
    ZeroStiffness,
    Degenerate,
}

fn creases(
    pattern: &CreasePattern,
    mesh: &Mesh,
    material: &Material,
    rest: &[DVec3],
    inventory: &mut Inventory,
) -> Vec<Crease> {
    let mut creases = Vec::new();
    let mut folds = 0;
    let mut missing = Vec::new();
    for (i, side) in mesh.sides.iter().enumerate() {
        let [Some(one), Some(two)] = side.apexes else { continue };
        let nodes = [one, two, side.nodes[0], side.nodes[1]];
        match crease(edge_of(pattern, side), nodes, SideId::new(i), material, rest) {
            Ok((crease, kind)) => {
                creases.push(crease);
                folds += usize::from(kind == Kind::Fold);
            }
            Err(why) => missing.push(why),
        }
    }
    let count = |why| missing.iter().filter(|w| **w == why).count();
    inventory.built("mountain and valley creases", folds);
    inventory.built("facet creases", creases.len() - folds);
    inventory.left_out("crease springs", count(NoSpring::Undriven), "their edges are undriven");
    inventory.left_out("crease springs", count(NoSpring::ZeroStiffness), "their stiffness is 0");
    inventory.left_out("crease springs", count(NoSpring::Degenerate), "a triangle beside them is too thin");
    creases
}

/// Which of the material's two stiffnesses a crease takes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Fold,
    Facet,
}

fn crease(
    edge: Option<&PatternEdge>,
    nodes: [NodeId; 4],
    side: SideId,
    material: &Material,
    rest: &[DVec3],
) -> Result<(Crease, Kind), NoSpring> {
    let points = nodes.map(|n| rest[n.index()]);
    let length = points[3].distance(points[2]);
    let heights = [points[0], points[1]].map(|p| (points[3] - points[2]).cross(p - points[2]).length() / length);
    let thick = length >= DEGENERATE && heights.iter().all(|h| *h >= DEGENERATE);
    let rest_angle = thick.then(|| fold_angle(points[0], points[1], points[2], points[3]));
    let (kind, target) = match edge {
        // A diagonal keeps the angle that the sheet has there: 0 on a flat pattern.
        None => (Kind::Facet, rest_angle.unwrap_or(0.0)),
        Some(edge) => {
            let target = edge.fold_angle.ok_or(NoSpring::Undriven)?;
            match edge.assignment {
                Assignment::Mountain | Assignment::Valley => (Kind::Fold, target),
                Assignment::Flat | Assignment::Join if target == 0.0 => (Kind::Facet, target),
                Assignment::Flat | Assignment::Join => (Kind::Fold, target),
                Assignment::Boundary | Assignment::Unassigned => return Err(NoSpring::Undriven),
            }
        }
    };
    let of_material = if kind == Kind::Fold { material.k_fold } else { material.k_facet };
    let own = edge.and_then(|e| e.k_crease);
    let per_length = own.unwrap_or(of_material);
    if per_length == 0.0 {
        return Err(NoSpring::ZeroStiffness);
    }
    let rest_angle = with_turn(rest_angle.ok_or(NoSpring::Degenerate)?, target);
    let source = match (own, kind) {
        (Some(_), _) => StiffnessSource::Own,
        (None, Kind::Fold) => StiffnessSource::Fold,
        (None, Kind::Facet) => StiffnessSource::Facet,
    };
    Ok((Crease { nodes, stiffness: length * per_length, source, full_target: target, rest_angle, side }, kind))
}

/// An angle measured within half a turn, with the turn that the target suggests: a crease folded flat may lie a little past
/// half a turn, and its faces then look as if it were folded flat the other way.
fn with_turn(measured: f64, target: f64) -> f64 {
    const NEARLY_FLAT: f64 = 160.0;
    let past = measured * target < 0.0 && measured.abs() > NEARLY_FLAT.to_radians();
    if past { measured + std::f64::consts::TAU.copysign(target) } else { measured }
}

/// Areas have no table of their own: whether they have springs is all that there is to say.
fn areas(mesh: &Mesh, material: &Material, stiffest_crease: f64, inventory: &mut Inventory) {
    if material.collapse == 0.0 {
        inventory.left_out("areas", mesh.triangles.len(), "collapse is 0");
    } else if stiffest_crease == 0.0 {
        inventory.left_out("areas", mesh.triangles.len(), "there is no crease that could squeeze them");
    } else {
        inventory.built("areas", mesh.triangles.len());
    }
}

fn corner_angles(mesh: &Mesh, material: &Material, rest: &[DVec3], inventory: &mut Inventory) -> Vec<CornerAngles> {
    if material.k_face == 0.0 {
        inventory.left_out("corner angles", 3 * mesh.triangles.len(), "k_face is 0");
        return Vec::new();
    }
    let corners = |(t, nodes): (usize, &[NodeId; 3])| {
        let p = nodes.map(|n| rest[n.index()]);
        let sides = [p[1] - p[0], p[2] - p[1], p[0] - p[2]];
        let doubled_area = sides[0].cross(-sides[2]).length();
        let longest = sides.iter().map(|s| s.length()).fold(0.0, f64::max);
        // The smallest height stands on the longest side.
        (doubled_area >= DEGENERATE * longest && longest >= DEGENERATE).then(|| {
            let rest = [(-sides[2], sides[0]), (-sides[0], sides[1])].map(|(u, v)| {
                let (cos, sin) = (u.dot(v), u.cross(v).length());
                let length = cos.hypot(sin);
                (cos / length, sin / length)
            });
            CornerAngles { nodes: *nodes, rest, triangle: TriangleId::new(t) }
        })
    };
    let built: Vec<CornerAngles> = mesh.triangles.iter().enumerate().filter_map(corners).collect();
    inventory.built("corner angles", 3 * built.len());
    inventory.left_out("corner angles", 3 * (mesh.triangles.len() - built.len()), "their triangles are too thin");
    built
}
