//! From a model in one state to a scene.

use origami_core::glam::DVec3;
use origami_core::{CreasePattern, Model};

use super::{Line, LineKind, Scene, chains};
use crate::layers::layers;
use crate::map::Map;

impl Scene {
    /// The sheet with its nodes at `positions` (in radii). A position that is missing counts as the one at rest.
    #[must_use]
    pub fn new(pattern: &CreasePattern, model: &Model, positions: &[DVec3]) -> Self {
        let mut scene = Self {
            triangles: model.mesh.triangles.iter().map(|t| t.map(|node| node.0)).collect(),
            lines: lines(pattern, model),
            ..Self::default()
        };
        scene.move_to(model, positions);
        scene
    }

    /// The same sheet in another state: positions and layers change.
    pub fn move_to(&mut self, model: &Model, positions: &[DVec3]) {
        let all = positions.iter().chain(model.rest.iter().skip(positions.len()));
        self.positions.clear();
        self.positions.extend(all.take(model.rest.len()).map(|p| p.to_array().map(|x| x as f32)));
        self.layers = layers(model, positions);
    }
}

impl Scene {
    /// The same scene with values in place of the paper's colours.
    #[must_use]
    pub fn with_map(self, map: Map) -> Self {
        Self { map: Some(map), ..self }
    }
}

/// One for each side of the triangulation.
fn lines(pattern: &CreasePattern, model: &Model) -> Vec<Line> {
    let lips = lips_of_cuts(model);
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

/// Which sides are one of two that lie at one place while the sheet is flat: an opened cut has left them.
fn lips_of_cuts(model: &Model) -> Vec<bool> {
    let rim = |i: &usize| model.mesh.sides[*i].triangles.iter().flatten().count() == 1;
    let place = |i: usize| {
        let mut ends = model.mesh.sides[i].nodes.map(|n| model.rest[n.index()].to_array().map(f64::to_bits));
        ends.sort_unstable();
        ends
    };
    let mut places: Vec<_> = (0..model.mesh.sides.len()).filter(rim).map(|i| (place(i), i)).collect();
    places.sort_unstable();
    let mut lips = vec![false; model.mesh.sides.len()];
    for pair in places.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        lips[pair[0].1] = true;
        lips[pair[1].1] = true;
    }
    lips
}
