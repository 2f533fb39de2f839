//! Gradients of a result by what a structure is made of: one solve with the factors of the tangent for all parameters.
//!
//! An equilibrium x satisfies `g(x, p) = 0`, so that a result J(x) changes with a parameter p by `-a . dg/dp`, where
//! `K a = dJ/dx` on the free degrees of freedom. Each member has one number of its own in a: how fast it is stretched or turned
//! when the nodes move as a.

use glam::DVec3;

use super::structure::Structure;
use super::tangent::Tangent;
use super::{Configuration, HingeLaw, Refused};
use crate::forces::creases;

/// How a result changes with each parameter, at equilibrium.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gradient {
    /// By rest angle, by hinge, for a radian.
    pub rest_angles: Vec<f64>,
    /// By stiffness of the whole hinge, by hinge.
    pub hinge_stiffnesses: Vec<f64>,
    /// By rest length, by bar.
    pub rest_lengths: Vec<f64>,
    /// By rigidity EA, by bar.
    pub rigidities: Vec<f64>,
    /// By a load at load factor 1 on each node, whether it has one or not.
    pub loads: Vec<DVec3>,
    /// By the load factor.
    pub load_factor: f64,
    /// By the place where each node is held, along axes that are held or moved; 0 along others.
    pub held: Vec<DVec3>,
}

impl Structure {
    /// The gradient of a result at `at`, an equilibrium under `load_factor` times the loads. `by_positions` is the result's
    /// own derivative by the nodes' positions.
    ///
    /// # Errors
    /// [`Refused::Singular`] at limit points and bifurcations, where the state does not depend smoothly on the parameters;
    /// others where the structure is wrong.
    pub fn gradient(&self, at: &Configuration, load_factor: f64, by_positions: &[DVec3]) -> Result<Gradient, Refused> {
        if by_positions.len() != self.nodes.len() {
            let problem = format!("{} entries", by_positions.len());
            return Err(Refused::at(
                "by_positions",
                problem,
                format!("one for each of the {} nodes", self.nodes.len()),
            ));
        }
        let mut tangent = self.tangent(at, load_factor)?;
        if tangent.inertia().neutral > 0 {
            return Err(Refused::Singular { at: format!("load factor {load_factor}") });
        }
        Ok(tangent.gradient(at, load_factor, by_positions))
    }
}

impl Tangent<'_> {
    fn gradient(&mut self, at: &Configuration, load_factor: f64, by_positions: &[DVec3]) -> Gradient {
        let adjoint = self.solve(by_positions);
        let structure = self.equations.structure;
        let mut gradient = Gradient {
            loads: adjoint.iter().map(|a| *a * load_factor).collect(),
            load_factor: self
                .equations
                .load(at)
                .iter()
                .zip(self.equations.rows.gather(&adjoint))
                .map(|(l, a)| l * a)
                .sum(),
            ..Gradient::default()
        };
        for bar in &structure.bars {
            let [i, j] = bar.nodes.map(|n| n.index());
            let along = at.positions[j] - at.positions[i];
            let length = along.length();
            let response = bar.law.respond(bar.rigidity, bar.rest_length, length);
            let stretched = if length > 0.0 { along.dot(adjoint[j] - adjoint[i]) / length } else { 0.0 };
            gradient.rigidities.push(-stretched * response.slope / bar.rigidity);
            // The tension depends on length over rest length.
            gradient.rest_lengths.push(stretched * response.curvature * length / bar.rest_length);
        }
        let size = self.equations.size;
        for (hinge, angle) in structure.hinges.iter().zip(&at.fold_angles) {
            let points = hinge.nodes.map(|n| at.positions[n.index()] / size);
            let turned = creases::hinge(points).map_or(0.0, |geometry| {
                let pairs = geometry.gradient.iter().zip(hinge.nodes);
                pairs.map(|(by_node, n)| by_node.dot(adjoint[n.index()])).sum::<f64>() / size
            });
            let unit = hinge.law.respond(1.0, hinge.rest_angle, *angle);
            let by_rest = match hinge.law {
                HingeLaw::Linear | HingeLaw::Stiffened { .. } => hinge.stiffness,
                HingeLaw::Power { .. } => hinge.stiffness * unit.curvature,
            };
            gradient.rest_angles.push(turned * by_rest);
            gradient.hinge_stiffnesses.push(-turned * unit.slope);
        }
        let pulled = self.equations.stiffness_times(at, &adjoint);
        let mut held = vec![DVec3::ZERO; structure.nodes.len()];
        for dof in self.equations.rows.held() {
            held[dof.node.index()][dof.axis.index()] = dof.of(by_positions) - dof.of(&pulled);
        }
        gradient.held = held;
        gradient
    }
}

impl Structure {
    /// The derivative of the energy stored at `at` by what members are made of, where nothing moves.
    pub(super) fn energy_slopes(&self, at: &Configuration) -> Gradient {
        let mut slopes = Gradient::zero(self);
        for (i, bar) in self.bars.iter().enumerate() {
            let [from, to] = bar.nodes.map(|n| at.positions[n.index()]);
            let length = from.distance(to);
            let response = bar.law.respond(bar.rigidity, bar.rest_length, length);
            slopes.rigidities[i] = response.energy / bar.rigidity;
            // The energy is the rest length times a function of length over rest length.
            slopes.rest_lengths[i] = (response.energy - response.slope * length) / bar.rest_length;
        }
        for (i, (hinge, angle)) in self.hinges.iter().zip(&at.fold_angles).enumerate() {
            let unit = hinge.law.respond(1.0, hinge.rest_angle, *angle);
            slopes.hinge_stiffnesses[i] = unit.energy;
            slopes.rest_angles[i] = -hinge.stiffness
                * match hinge.law {
                    // What makes it stiffer does not know where it is at rest.
                    HingeLaw::Linear | HingeLaw::Stiffened { .. } => angle - hinge.rest_angle,
                    HingeLaw::Power { .. } => unit.slope,
                };
        }
        slopes
    }
}

impl Gradient {
    /// Nothing changes with anything.
    pub(super) fn zero(structure: &Structure) -> Self {
        let (bars, hinges, nodes) = (structure.bars.len(), structure.hinges.len(), structure.nodes.len());
        Self {
            rest_angles: vec![0.0; hinges],
            hinge_stiffnesses: vec![0.0; hinges],
            rest_lengths: vec![0.0; bars],
            rigidities: vec![0.0; bars],
            loads: vec![DVec3::ZERO; nodes],
            load_factor: 0.0,
            held: vec![DVec3::ZERO; nodes],
        }
    }

    /// Adds `share` times another one of the same structure.
    pub(super) fn add(&mut self, share: f64, other: &Self) {
        let add = |own: &mut [f64], other: &[f64]| own.iter_mut().zip(other).for_each(|(x, o)| *x += share * o);
        add(&mut self.rest_angles, &other.rest_angles);
        add(&mut self.hinge_stiffnesses, &other.hinge_stiffnesses);
        add(&mut self.rest_lengths, &other.rest_lengths);
        add(&mut self.rigidities, &other.rigidities);
        let add = |own: &mut [DVec3], other: &[DVec3]| own.iter_mut().zip(other).for_each(|(x, o)| *x += *o * share);
        add(&mut self.loads, &other.loads);
        add(&mut self.held, &other.held);
        self.load_factor += share * other.load_factor;
    }

    /// The gradient by the drawn position of each node, where rest lengths and rest angles are those of the drawn sheet and
    /// stiffnesses of hinges grow with their length; supports hold where nodes are drawn.
    ///
    /// # Errors
    /// [`Refused`] for structures with corner springs, whose angles at rest have no gradient here.
    pub fn by_drawn_positions(&self, structure: &Structure) -> Result<Vec<DVec3>, Refused> {
        if !structure.corners.is_empty() {
            return Err(Refused::at("corners", "they have rest angles too", "bars and hinges alone"));
        }
        let mut gradient = self.held.clone();
        let nodes = &structure.nodes;
        for (bar, by_length) in structure.bars.iter().zip(&self.rest_lengths) {
            let [i, j] = bar.nodes.map(|n| n.index());
            let direction = (nodes[j] - nodes[i]).normalize_or_zero();
            gradient[i] -= direction * *by_length;
            gradient[j] += direction * *by_length;
        }
        let size = structure.size();
        for (k, hinge) in structure.hinges.iter().enumerate() {
            let points = hinge.nodes.map(|n| nodes[n.index()]);
            let Some(geometry) = creases::hinge(points.map(|p| p / size)) else { continue };
            for (n, by_node) in hinge.nodes.iter().zip(geometry.gradient) {
                gradient[n.index()] += by_node * (self.rest_angles[k] / size);
            }
            let along = points[3] - points[2];
            let by_end = along * (self.hinge_stiffnesses[k] * hinge.stiffness / along.length_squared());
            gradient[hinge.nodes[2].index()] -= by_end;
            gradient[hinge.nodes[3].index()] += by_end;
        }
        Ok(gradient)
    }
}
