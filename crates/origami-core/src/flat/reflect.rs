//! The flat-folded sheet: every face reflected across the creases on the way to it from the first one.

use glam::{DVec2, DVec3};

use super::Role;
use super::corners::Edges;
use super::lay::{Hinge, lay};
use crate::csr::Csr;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;
use crate::pattern::plane;

/// How well a sheet closes when it is folded flat.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Closure {
    /// How far an image of a vertex, by one of its faces, lies from the mean of all its images, at the most; in radii of the
    /// sheet. Rounding alone stays far below 1e-9.
    pub spread: f64,
    /// The vertex where that is; `None` where all images agree to the bit.
    pub vertex: Option<VertexId>,
}

/// A sheet folded flat, its layers in one plane.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Reflected {
    /// By vertex of the pattern, in the file's unit: the mean of its images by all its faces. The first face of each
    /// connected piece stays where it is; vertices of no face too.
    pub positions: Vec<DVec3>,
    /// By face: whether it lies as it did, and not turned over.
    pub face_up: Vec<bool>,
    /// How well it closes.
    pub closure: Closure,
}

impl CreasePattern {
    /// The sheet folded flat by reflecting its faces, in linear time; layers are not looked at. `None` for a sheet that is
    /// not flat, or has a crease between two faces that is asked for an angle other than half a turn or 0, or for none.
    ///
    /// ```
    /// use origami_core::generate::Miura;
    ///
    /// let miura = Miura::default().pattern()?;
    /// let folded = miura.reflected().expect("it folds flat");
    /// assert!(folded.closure.spread < 1e-12);
    /// assert_eq!(folded.face_up.iter().filter(|up| **up).count(), miura.faces.len() / 2);
    /// # Ok::<(), origami_core::Error>(())
    /// ```
    #[must_use]
    pub fn reflected(&self) -> Option<Reflected> {
        if !self.is_flat() {
            return None;
        }
        let radius = plane::radius(&self.vertices);
        let low = self.vertices.iter().copied().reduce(DVec3::min)?;
        let centre = (low + 0.5 * plane::extent(&self.vertices)).truncate();
        let points: Vec<DVec2> = self.vertices.iter().map(|p| (p.truncate() - centre) / radius).collect();
        let corners = self.faces.iter().enumerate().flat_map(|(f, face)| face.iter().map(move |v| (f, v.0)));
        let laid = lay(&points, &Csr::from_entries(self.faces.len(), corners), &self.hinges()?, std::iter::empty());
        let position = |(point, own): (&DVec2, &DVec3)| (centre + *point * radius).extend(own.z);
        Some(Reflected {
            positions: laid.points.iter().zip(&self.vertices).map(position).collect(),
            face_up: laid.turned_over.iter().map(|over| !over).collect(),
            closure: Closure {
                spread: laid.worst.map_or(0.0, |(_, spread)| spread),
                vertex: laid.worst.map(|(vertex, _)| VertexId::new(vertex)),
            },
        })
    }

    /// What joins the faces, by edge; `None` where an edge between two is asked for another angle or for none.
    fn hinges(&self) -> Option<Vec<Hinge>> {
        let edges = Edges::of(self);
        let sides = |(face, corners): (usize, &Vec<VertexId>)| {
            let sides = corners.iter().zip(corners.iter().cycle().skip(1));
            let edges = sides.filter_map(|(a, b)| edges.between(*a, *b)).collect::<Vec<_>>();
            edges.into_iter().map(move |edge| (edge.index(), face as u32))
        };
        let all: Vec<(usize, u32)> = self.faces.iter().enumerate().flat_map(sides).collect();
        let faces_of_edge = Csr::from_entries(self.edges.len(), all.iter().copied());
        let mut hinges = Vec::new();
        for (faces, edge) in faces_of_edge.iter().zip(&self.edges) {
            let &[one, two] = faces else { continue };
            // A crease that ends inside a face has that face on both sides, and folds nothing.
            if one == two {
                continue;
            }
            let folded = match Role::of(edge) {
                Role::Flat => false,
                Role::Folded { .. } => true,
                Role::Partial | Role::Free | Role::Rim => return None,
            };
            hinges.push(Hinge { faces: [one, two], ends: edge.vertices.map(|v| v.0), folded });
        }
        Some(hinges)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::catalog;

    /// A strip of paper, folded `creases` times at a distance of 1 each.
    fn strip(creases: u32) -> CreasePattern {
        let text = {
            let columns = creases + 2;
            let vertices: Vec<String> = (0..columns).flat_map(|x| [format!("[{x}, 0]"), format!("[{x}, 1]")]).collect();
            let (mut edges, mut letters) = (Vec::new(), Vec::new());
            for x in 0..columns {
                edges.push(format!("[{}, {}]", 2 * x, 2 * x + 1));
                letters.push(if x == 0 || x == columns - 1 { "\"B\"" } else { "\"V\"" });
                for y in (0..2).filter(|_| x + 1 < columns) {
                    edges.push(format!("[{}, {}]", 2 * x + y, 2 * x + y + 2));
                    letters.push("\"B\"");
                }
            }
            let (vertices, edges, letters) = (vertices.join(","), edges.join(","), letters.join(","));
            format!(
                r#"{{"vertices_coords": [{vertices}], "edges_vertices": [{edges}], "edges_assignment": [{letters}]}}"#
            )
        };
        let document = crate::fold::Document::from_slice(text.as_bytes()).expect("FOLD");
        CreasePattern::from_document(&document, 0).expect("a pattern")
    }

    #[test]
    fn a_strip_runs_to_and_fro_over_one_square() {
        let strip = strip(1000);
        let folded = strip.reflected().expect("it folds flat");
        for (v, p) in folded.positions.iter().enumerate() {
            // The first face stays: which one that is, the pattern says.
            let column = (v / 2) as f64;
            let first = strip.faces[0].iter().map(|c| (c.index() / 2) as f64).fold(f64::INFINITY, f64::min);
            let expected = first + (column - first).rem_euclid(2.0);
            assert!((p.x - expected).abs() < 1e-9 && (p.y - (v % 2) as f64).abs() < 1e-9, "{v}: {p}");
        }
        assert!(folded.closure.spread < 1e-12, "{:?}", folded.closure);
    }

    #[test]
    fn lengths_of_all_edges_stay_and_generated_patterns_close() {
        for name in ["miura", "bird-base", "square-twist"] {
            let pattern = catalog::generate(name, &[]).expect(name);
            let Some(folded) = pattern.reflected() else { panic!("{name} folds flat") };
            assert!(folded.closure.spread < 1e-9, "{name}: {:?}", folded.closure);
            for edge in &pattern.edges {
                let length = |at: &[DVec3]| at[edge.vertices[0].index()].distance(at[edge.vertices[1].index()]);
                assert!((length(&folded.positions) - length(&pattern.vertices)).abs() < 1e-9 * pattern.size());
            }
        }
    }

    #[test]
    fn a_vertex_that_breaks_kawasakis_rule_is_where_it_does_not_close() {
        let mut pattern = catalog::generate("miura", &[]).expect("a pattern");
        let rings = super::super::rings::rings(&pattern);
        let moved = rings[rings.len() / 2].vertex;
        pattern.vertices[moved.index()].x += 0.1 * pattern.size();
        let flat = super::super::FlatFoldability::of(&pattern);
        assert!(flat.closure.expect("it is asked to fold flat").spread > 1e-2);
        let (worst, off) = flat.farthest_from_kawasaki.expect("checked");
        assert!(off > 0.05 && flat.faults.iter().any(|fault| fault.vertex == moved), "{worst:?} {off}");
    }
}
