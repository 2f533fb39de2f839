//! The flat-folded state without any motion that leads to it.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use glam::{DVec2, DVec3};

use super::largest::largest;
use super::{DEFAULT_TOLERANCE, Failed, Folded, Progress, Solver, State, Stop};
use crate::csr::Csr;
use crate::flat::{ANGLE_TOLERANCE, Hinge, lay};
use crate::forces::Forces;
use crate::model::{Inventory, Model};
use crate::scene::{NotFlat, Refusal, Scene};

/// Heights of a sheet that count as one, in radii.
const SAME_HEIGHT: f64 = 1e-9;

/// The exact flat-folded state, by reflecting the facets across the creases between them: no motion, no layers, linear time.
///
/// It folds a flat sheet whose creases are all asked for half a turn or for 0, at 100 or -100 %, and refuses all else by
/// name. Strain is that of the file's own misfit; whether the paper could pass through itself on the way there is not asked.
///
/// ```
/// use origami_core::generate::BirdBase;
/// use origami_core::measure::Strain;
/// use origami_core::solve::Reflect;
/// use origami_core::{Material, Model, Solver};
///
/// let model = Model::new(&BirdBase::default().pattern()?, &Material::default())?;
/// let flat = Reflect::default().fold_from_rest(&model, 100.0)?;
/// assert!(Strain::of(&model, &flat.state.positions).beams.max < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Reflect {
    /// How far an image of a vertex, by one of its facets, may lie from the mean of all of them, in radii. Larger: files of
    /// fewer digits are taken, and strained so much. Default 1e-4.
    pub tolerance: f64,
}

impl Default for Reflect {
    fn default() -> Self {
        Self { tolerance: DEFAULT_TOLERANCE }
    }
}

impl Solver for Reflect {
    /// `start` and `observe` have no part in it. The estimated distance of the result is by how much the sheet misses itself.
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        _observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let (state, spread) = self.state(model, scene).map_err(|refusal| Failed::refused(refusal, start))?;
        let mut forces = Forces::in_scene(model, scene);
        let residual = largest(forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles.clone()));
        Ok(Folded {
            state,
            targets: scene.targets.clone(),
            stop: Stop::Converged,
            steps: 0,
            time_step: 0.0,
            residual,
            distance: spread,
            attempts: 1,
            saddles: 0,
            factorisations: 0,
            reactions: forces.reactions().to_vec(),
        })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        let mut inventory = model.inventory.clone();
        inventory.without("damping", "the flat-folded state is constructed, and nothing moves");
        inventory
    }
}

impl Reflect {
    /// The state, and by how much the sheet misses itself.
    fn state(&self, model: &Model, scene: &Scene) -> Result<(State, f64), Refusal> {
        scene.check(model)?;
        let acting = [
            ("supports", scene.supports.is_empty()),
            ("loads", scene.loads.is_empty()),
            ("forces", scene.forces.is_empty()),
        ];
        if let Some((what, _)) = acting.into_iter().find(|(_, none)| !none) {
            return Err(Refusal::Unsupported {
                what,
                backend: "reflect",
                expected: "`Relax` from the flat-folded state",
            });
        }
        let targets = scene.targets.of(model)?;
        let height = model.rest.first().map_or(0.0, |p| p.z);
        if model.rest.iter().any(|p| (p.z - height).abs() > SAME_HEIGHT) {
            return Err(NotFlat::Sheet.into());
        }
        let points: Vec<DVec2> = model.rest.iter().map(|p| p.truncate()).collect();
        let triangles = &model.mesh.triangles;
        let corners = triangles.iter().enumerate().flat_map(|(t, corners)| corners.map(|n| (t, n.0)));
        let laid = lay(&points, &Csr::from_entries(triangles.len(), corners), &hinges(model, &targets)?, roots(model));
        let (node, spread) = laid.worst.unwrap_or((0, 0.0));
        if spread > self.tolerance {
            let vertex = model.mesh.vertex_of_node[node];
            return Err(NotFlat::Open { spread, vertex, tolerance: self.tolerance }.into());
        }
        let positions: Vec<DVec3> = laid.points.iter().zip(&model.rest).map(|(p, rest)| p.extend(rest.z)).collect();
        for node in &model.fixed {
            let distance = positions[node.index()].distance(model.rest[node.index()]);
            if distance > self.tolerance {
                return Err(NotFlat::Held { vertex: model.mesh.vertex_of_node[node.index()], distance }.into());
            }
        }
        // Beside the targets, fold angles find the turn that they are in.
        let unturned = State { fold_angles: targets.clone(), targets, ..State::at_rest(model) };
        Ok((unturned.moved_to(model, positions), spread))
    }
}

/// What joins the triangles.
fn hinges(model: &Model, targets: &[f64]) -> Result<Vec<Hinge>, NotFlat> {
    let mut target_of_side = vec![None; model.mesh.sides.len()];
    for (crease, target) in model.creases.iter().zip(targets) {
        target_of_side[crease.side.index()] = Some(*target);
    }
    let mut hinges = Vec::new();
    for (side, target) in model.mesh.sides.iter().zip(target_of_side) {
        let [Some(one), Some(two)] = side.triangles else { continue };
        let vertices = side.nodes.map(|n| model.mesh.vertex_of_node[n.index()]);
        let [face, other] = [one, two].map(|t| model.mesh.face_of_triangle[t.index()]);
        let folded = match target {
            Some(angle) if angle.abs() < ANGLE_TOLERANCE => false,
            Some(angle) if (angle.abs() - PI).abs() < ANGLE_TOLERANCE => true,
            Some(angle) => return Err(NotFlat::Angle { vertices, degrees: angle.to_degrees() }),
            // Inside a face, where a triangle is too thin for a spring.
            None if face == other => false,
            None => return Err(NotFlat::Undriven(vertices)),
        };
        hinges.push(Hinge { faces: [one.0, two.0], ends: side.nodes.map(|n| n.0), folded });
    }
    Ok(hinges)
}

/// Triangles that stay where they are: those with the most nodes that do not move come first.
fn roots(model: &Model) -> impl Iterator<Item = usize> {
    let mut fixed = vec![false; model.node_count()];
    model.fixed.iter().for_each(|n| fixed[n.index()] = true);
    let triangles = &model.mesh.triangles;
    let held = move |t: usize| triangles[t].iter().filter(|n| fixed[n.index()]).count();
    let mut roots: Vec<(usize, usize)> = (0..triangles.len()).map(|t| (held(t), t)).filter(|(n, _)| *n > 0).collect();
    roots.sort_by_key(|(n, t)| (std::cmp::Reverse(*n), *t));
    roots.into_iter().map(|(_, t)| t)
}
