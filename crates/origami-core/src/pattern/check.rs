//! The invariants of a crease pattern.

use std::collections::HashMap;

use super::crease_pattern::{Assignment, CreasePattern};
use crate::ids::VertexId;

impl CreasePattern {
    /// Walks all that holds of every pattern that [`CreasePattern::from_frame`] builds, for tests.
    ///
    /// # Errors
    /// The first invariant that does not hold, and where.
    #[doc(hidden)]
    pub fn sanity_check(&self) -> Result<(), String> {
        self.check_vertices()?;
        let edges = self.check_edges()?;
        let sides = self.check_faces(&edges)?;
        for (index, edge) in self.edges.iter().enumerate().filter(|(_, edge)| edge.alias_of.is_none()) {
            let count = sides.get(&index).map_or(0, Vec::len);
            let boundary = edge.assignment == Assignment::Boundary;
            require(!(boundary && count == 2), || format!("boundary edge {index} has two faces"))?;
            require(boundary || count != 1, || format!("edge {index} has one face and is no boundary"))?;
            require(edge.fold_angle.is_none() || count == 2, || format!("edge {index} folds without two faces"))?;
        }
        Ok(())
    }

    fn live(&self, vertex: VertexId) -> bool {
        self.alias_of.get(vertex.index()) == Some(&None)
    }

    fn check_vertices(&self) -> Result<(), String> {
        require(self.alias_of.len() == self.vertices.len(), || "vertex aliases of another length".into())?;
        require(self.vertices_in_file <= self.vertices.len(), || "fewer vertices than in the file".into())?;
        require(self.edges_in_file <= self.edges.len(), || "fewer edges than in the file".into())?;
        require(self.vertices.iter().all(|v| v.is_finite()), || "a vertex is not finite".into())?;
        require(self.alias_of.iter().flatten().all(|&v| self.live(v)), || "alias of an alias".into())?;
        require(self.fixed.iter().all(|&v| self.live(v)), || "a fixed vertex is an alias".into())?;
        require(self.fixed.is_sorted_by(|a, b| a < b), || "fixed vertices out of order".into())
    }

    /// The live edge between two vertices, the lower first.
    fn check_edges(&self) -> Result<HashMap<[VertexId; 2], usize>, String> {
        let mut edges = HashMap::new();
        for (index, edge) in self.edges.iter().enumerate() {
            if let Some(alias) = edge.alias_of {
                let stands = self.edges.get(alias.index()).is_some_and(|edge| edge.alias_of.is_none());
                require(stands, || format!("edge {index} is an alias of an alias"))?;
                continue;
            }
            let [a, b] = edge.vertices;
            require(a != b && self.live(a) && self.live(b), || format!("edge {index} has bad ends {a:?} {b:?}"))?;
            let twin = edges.insert([a.min(b), a.max(b)], index);
            require(twin.is_none(), || format!("edges {twin:?} and {index} have the same ends"))?;
            let driven = matches!(edge.assignment, Assignment::Boundary | Assignment::Unassigned);
            require(!driven || edge.fold_angle.is_none(), || format!("edge {index} folds though it is free"))?;
            require(edge.fold_angle.is_none_or(f64::is_finite), || format!("edge {index} folds by no number"))?;
        }
        Ok(edges)
    }

    /// The faces at each edge, with the direction in which they run along it.
    fn check_faces(&self, edges: &HashMap<[VertexId; 2], usize>) -> Result<HashMap<usize, Vec<bool>>, String> {
        let mut sides: HashMap<usize, Vec<bool>> = HashMap::new();
        for (index, face) in self.faces.iter().enumerate() {
            require(face.len() >= 3, || format!("face {index} has {} corners", face.len()))?;
            for (&a, &b) in face.iter().zip(face.iter().cycle().skip(1)) {
                let edge = edges.get(&[a.min(b), a.max(b)]);
                let edge = *edge.ok_or_else(|| format!("face {index} has no edge for {a:?} {b:?}"))?;
                sides.entry(edge).or_default().push(a < b);
            }
        }
        for (edge, sides) in &sides {
            let agree = matches!(sides.as_slice(), [_] | [true, false] | [false, true]);
            require(agree, || format!("the faces at edge {edge} run along it in directions {sides:?}"))?;
        }
        Ok(sides)
    }
}

fn require(holds: bool, what: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(what()) }
}
