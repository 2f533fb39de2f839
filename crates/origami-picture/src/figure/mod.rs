//! A folded figure, for any renderer: plain arrays, indices into them, no colours but the values of a map.

mod build;
pub(crate) mod chains;
mod lines;
pub(crate) mod lips;

pub use lines::{Line, LineKind, LineSet};

use origami_core::Error;

use crate::layers::Layer;
use crate::map::{Map, Values};
use crate::openness::Openness;

/// A sheet in one state, as a renderer needs it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// By node, in radii of the sheet.
    pub positions: Vec<[f32; 3]>,
    /// Nodes of each triangle, counterclockwise seen from the front of the paper.
    pub triangles: Vec<[u32; 3]>,
    /// Where layers lie upon each other and depth cannot tell which is on top: how each triangle is moved in depth, and
    /// nowhere else. Empty where no layers do.
    pub layers: Vec<Layer>,
    /// Pairs of triangles, the first under the second (along [`Layer::up`]), that lie upon each other in a circle, as the
    /// flaps of a box do: no depths show them all where they belong. A renderer compares the depths that such triangles have
    /// without their layers, and where these differ by less than [`NEAR`](crate::layers::NEAR) looks here; one that cannot
    /// may leave them to [`Figure::layers`].
    pub circles: Vec<[u32; 2]>,
    /// Creases, borders and what else is drawn as a line.
    pub lines: Vec<Line>,
    /// How much light from all around reaches each place; empty where all of it does, as in diagrams. It belongs to these
    /// positions, as the layers do.
    pub openness: Openness,
    /// Values that are shown as colours in place of the paper's own.
    pub map: Option<Map>,
}

impl Figure {
    /// Whether every index leads somewhere and every position is a finite number.
    ///
    /// # Errors
    /// [`Error::Invalid`] naming the first place where that is not so.
    pub fn check(&self) -> Result<(), Error> {
        let nodes = self.positions.len();
        let node = |n: &u32| (*n as usize) < nodes;
        let wrong = |place: String, problem: &str, expected: String| Err(Error::invalid(place, problem, expected));
        if let Some(i) = self.positions.iter().position(|p| !p.iter().all(|x| x.is_finite() && x.abs() < 1e18)) {
            return wrong(format!("position {i}"), "is not a sensible number", "finite coordinates".into());
        }
        if let Some(i) = self.triangles.iter().position(|t| !t.iter().all(node)) {
            return wrong(format!("triangle {i}"), "names a node that is not there", format!("nodes below {nodes}"));
        }
        if !self.layers.is_empty() && self.layers.len() != self.triangles.len() {
            return wrong("layers".into(), "have another length", "one for each triangle, or none".into());
        }
        let faces = |l: &Line| l.triangles.iter().flatten().all(|t| (*t as usize) < self.triangles.len());
        if let Some(i) = self.lines.iter().position(|l| !l.nodes.iter().all(node) || !faces(l)) {
            return wrong(format!("line {i}"), "names a node or triangle that is not there", "indices in range".into());
        }
        if let Some(i) = self.circles.iter().position(|c| c.iter().any(|t| *t as usize >= self.triangles.len())) {
            return wrong(format!("circle {i}"), "names a triangle that is not there", "indices in range".into());
        }
        self.openness.check(self.triangles.len())?;
        let values = self.map.as_ref().map(|map| match &map.values {
            Values::Nodes(values) => (values.len(), nodes),
            Values::Triangles(values) => (values.len(), self.triangles.len()),
        });
        match values {
            Some((is, should)) if is != should => {
                wrong("map".into(), &format!("has {is} values"), format!("{should}, one for each node or triangle"))
            }
            _ => Ok(()),
        }
    }
}
