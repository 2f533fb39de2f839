//! How much paper a pattern has, and in how many pieces.

use super::crease_pattern::CreasePattern;
use super::plane::area_vector;

/// The paper of a pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Paper {
    /// How many pieces it is in: faces hang together where they share an edge.
    pub pieces: usize,
    /// Its area, the sum over all faces, in the square of the file's unit.
    pub area: f64,
    /// Area that the lines of a flat pattern span and its faces do not: that of the convex hull of the lines less that of
    /// the faces. 0 where all lines are on paper. In the square of the file's unit.
    pub lost: f64,
}

impl CreasePattern {
    /// Its paper: pieces, area, and the area that was lost when the file was read.
    #[must_use]
    pub fn paper(&self) -> Paper {
        let corners =
            |face: &Vec<crate::ids::VertexId>| area_vector(face.iter().map(|v| self.vertices[v.index()])).length();
        Paper { pieces: self.pieces(), area: 0.5 * self.faces.iter().map(corners).sum::<f64>(), lost: self.lost_area }
    }

    fn pieces(&self) -> usize {
        let mut sides: Vec<_> = Vec::new();
        for (index, face) in self.faces.iter().enumerate() {
            let next = face.iter().cycle().skip(1);
            sides.extend(face.iter().zip(next).map(|(&a, &b)| ([a.min(b), a.max(b)], index)));
        }
        sides.sort_unstable();
        let mut group: Vec<usize> = (0..self.faces.len()).collect();
        let mut pieces = group.len();
        for pair in sides.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            let [a, b] = [pair[0].1, pair[1].1].map(|face| root(&mut group, face));
            if a != b {
                group[a.max(b)] = a.min(b);
                pieces -= 1;
            }
        }
        pieces
    }
}

/// The face that stands for all that hang together with this one; halves paths.
fn root(group: &mut [usize], mut face: usize) -> usize {
    while group[face] != face {
        group[face] = group[group[face]];
        face = group[face];
    }
    face
}
