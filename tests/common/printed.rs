//! The step with the formulas as the paper prints them: each beam, each crease and each corner angle by itself, an arc
//! tangent for every angle, in one thread and one number at a time. What a first program does, and a second opinion on ours.

use std::f64::consts::TAU;

use origami::forces::damping;
use origami::glam::DVec3;
use origami::{Model, State};

/// The sheet, and memory for its forces.
pub(crate) struct Printed<'m> {
    model: &'m Model,
    damping: Vec<f64>,
    /// By triangle with corner angles, in radians.
    rest: Vec<[f64; 3]>,
    forces: Vec<DVec3>,
}

impl<'m> Printed<'m> {
    pub(crate) fn new(model: &'m Model) -> Self {
        let rest = model.corner_angles.iter().map(|corners| {
            let [first, second] = corners.rest.map(|(cos, sin)| sin.atan2(cos));
            [first, second, 0.5 * TAU - first - second]
        });
        Self {
            model,
            damping: damping::coefficients(model),
            rest: rest.collect(),
            forces: vec![DVec3::ZERO; model.node_count()],
        }
    }

    /// `v += dt F`, `x += dt v`, masses 1 (paper 2.5).
    pub(crate) fn step(&mut self, state: &mut State, targets: &[f64], dt: f64) {
        self.forces(state, targets);
        for ((x, v), f) in state.positions.iter_mut().zip(&mut state.velocities).zip(&self.forces) {
            *v += *f * dt;
            *x += *v * dt;
        }
    }

    /// The forces of springs and damping, by node.
    pub(crate) fn forces(&mut self, state: &mut State, targets: &[f64]) -> &[DVec3] {
        self.forces.fill(DVec3::ZERO);
        self.beams(state);
        self.creases(state, targets);
        self.corner_angles(state);
        for node in &self.model.fixed {
            self.forces[node.index()] = DVec3::ZERO;
        }
        &self.forces
    }

    /// Paper 2.2, and the damping of 2.5.
    fn beams(&mut self, state: &State) {
        for (beam, c) in self.model.beams.iter().zip(&self.damping) {
            let [i, j] = beam.nodes.map(|n| n.index());
            let along = state.positions[j] - state.positions[i];
            let length = along.length();
            let force = along / length * (beam.stiffness * (length - beam.rest_length));
            let force = force + (state.velocities[j] - state.velocities[i]) * *c;
            self.forces[i] += force;
            self.forces[j] -= force;
        }
    }

    /// Paper 2.3, with its cotangents.
    fn creases(&mut self, state: &mut State, targets: &[f64]) {
        for ((crease, target), angle) in self.model.creases.iter().zip(targets).zip(&mut state.fold_angles) {
            let nodes = crease.nodes.map(|n| n.index());
            let [p1, p2, p3, p4] = nodes.map(|n| state.positions[n]);
            let edge = p4 - p3;
            let (n1, n2) = (edge.cross(p1 - p3).normalize(), (p2 - p3).cross(edge).normalize());
            let now = edge.normalize().dot(n2.cross(n1)).atan2(n1.dot(n2));
            *angle = now + TAU * ((*angle - now) / TAU).round();
            let moment = crease.stiffness * (target - *angle);
            let height = |apex: DVec3| edge.cross(apex - p3).length() / edge.length();
            let (h1, h2) = (height(p1), height(p2));
            let (at_3_of_1, at_4_of_1) = (cotangent(p3, p4, p1), cotangent(p4, p3, p1));
            let (at_3_of_2, at_4_of_2) = (cotangent(p3, p4, p2), cotangent(p4, p3, p2));
            let (g1, g2) = (n1 / h1, n2 / h2);
            let g3 = -g1 * (at_4_of_1 / (at_3_of_1 + at_4_of_1)) - g2 * (at_4_of_2 / (at_3_of_2 + at_4_of_2));
            let g4 = -g1 * (at_3_of_1 / (at_3_of_1 + at_4_of_1)) - g2 * (at_3_of_2 / (at_3_of_2 + at_4_of_2));
            for (n, gradient) in nodes.into_iter().zip([g1, g2, g3, g4]) {
                self.forces[n] += gradient * moment;
            }
        }
    }

    /// Paper 2.4, each corner by itself.
    fn corner_angles(&mut self, state: &State) {
        for (corners, rest) in self.model.corner_angles.iter().zip(&self.rest) {
            let nodes = corners.nodes.map(|n| n.index());
            for (corner, rest) in rest.iter().enumerate() {
                let [p, q, r] = [0, 1, 2].map(|i| nodes[(corner + i) % 3]);
                let (to_q, to_r) = (state.positions[q] - state.positions[p], state.positions[r] - state.positions[p]);
                let across = to_q.cross(to_r);
                let (normal, angle) = (across.normalize(), across.length().atan2(to_q.dot(to_r)));
                let moment = -self.model.material.k_face * (angle - rest);
                let at_q = -normal.cross(to_q) / to_q.length_squared();
                let at_r = normal.cross(to_r) / to_r.length_squared();
                self.forces[q] += at_q * moment;
                self.forces[r] += at_r * moment;
                self.forces[p] -= (at_q + at_r) * moment;
            }
        }
    }
}

/// Of the angle at `p` between `q` and `r`.
fn cotangent(p: DVec3, q: DVec3, r: DVec3) -> f64 {
    let (to_q, to_r) = (q - p, r - p);
    to_q.dot(to_r) / to_q.cross(to_r).length()
}
