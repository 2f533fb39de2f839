//! From a model in one state to a figure.

use origami_core::glam::DVec3;
use origami_core::{CreasePattern, Model, State};

use super::{Figure, Line, LineKind, chains, lips};
use crate::camera::Camera;
use crate::layers::stack;
use crate::map::Map;
use crate::openness::Openness;

impl Figure {
    /// The sheet with its nodes at `positions` (in radii). A position that is missing counts as the one at rest. Which of two
    /// layers is on top follows from the folds that the pattern asks for; [`of_state`](Self::of_state) knows better.
    #[must_use]
    pub fn new(pattern: &CreasePattern, model: &Model, positions: &[DVec3]) -> Self {
        let mut figure = Self::of_sheet(pattern, model);
        figure.move_to(model, positions);
        figure
    }

    /// The sheet in a state, whose own fold angles tell which layer is on top: folded the other way, it lies the other way.
    #[must_use]
    pub fn of_state(pattern: &CreasePattern, model: &Model, state: &State) -> Self {
        let mut figure = Self::of_sheet(pattern, model);
        figure.move_to_state(model, state);
        figure
    }

    /// The same sheet elsewhere: positions and layers change, and the openness where there is one.
    pub fn move_to(&mut self, model: &Model, positions: &[DVec3]) {
        self.place(model, positions, &[]);
    }

    /// The same sheet in another state.
    pub fn move_to_state(&mut self, model: &Model, state: &State) {
        self.place(model, &state.positions, &state.fold_angles);
    }

    fn of_sheet(pattern: &CreasePattern, model: &Model) -> Self {
        Self {
            triangles: model.mesh.triangles.iter().map(|t| t.map(|node| node.0)).collect(),
            lines: lines(pattern, model),
            ..Self::default()
        }
    }

    fn place(&mut self, model: &Model, positions: &[DVec3], angles: &[f64]) {
        let all = positions.iter().chain(model.rest.iter().skip(positions.len()));
        self.positions.clear();
        self.positions.extend(all.take(model.rest.len()).map(|p| p.to_array().map(|x| x as f32)));
        let stack = stack(model, positions, angles);
        (self.layers, self.circles) = (stack.layers, stack.circles);
        if !self.openness.is_empty() {
            self.shade();
        }
    }
}

impl Figure {
    /// Where to see it from if nothing is said: [`Camera::facing`] its triangles.
    #[must_use]
    pub fn camera(&self) -> Camera {
        let corners = self.triangles.iter().flatten();
        Camera::facing(corners.filter_map(|n| self.positions.get(*n as usize).copied()))
    }

    /// Finds out how open the sheet is where it is now, for soft shading: valleys and what lies under a flap grow darker.
    /// Nothing happens where an index leads nowhere.
    pub fn shade(&mut self) {
        self.openness = Openness::of(&self.positions, &self.triangles);
    }
}

impl Figure {
    /// The same figure with values in place of the paper's colours.
    #[must_use]
    pub fn with_map(self, map: Map) -> Self {
        Self { map: Some(map), ..self }
    }
}

/// One for each side of the triangulation.
fn lines(pattern: &CreasePattern, model: &Model) -> Vec<Line> {
    let rim = model.mesh.sides.iter().map(|side| {
        let single = side.triangles.iter().flatten().count() == 1;
        single.then(|| side.nodes.map(|n| model.rest[n.index()]))
    });
    let lips = lips::find(&rim.collect::<Vec<_>>());
    let lines = model.mesh.sides.iter().zip(&lips).map(|(side, lip)| {
        let kind = side.edge.and_then(|edge| pattern.edges.get(edge.index())).map_or(LineKind::Facet, LineKind::of);
        Line {
            nodes: side.nodes.map(|node| node.0),
            along: [0.0; 2],
            kind: if *lip && kind == LineKind::Boundary { LineKind::Cut } else { kind },
            triangles: side.triangles.map(|triangle| triangle.map(|t| t.0)),
        }
    });
    let mut lines: Vec<Line> = lines.collect();
    chains::measure(&mut lines, &model.rest);
    lines
}
