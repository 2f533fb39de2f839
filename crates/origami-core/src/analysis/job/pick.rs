//! Which vertices an entry of a job means.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::error::{Error, ErrorCode, Place, Short};
use crate::ids::{NodeId, VertexId};
use crate::model::Model;
use crate::pattern::CreasePattern;

/// Vertices by number, by place or by box: one of the three. Places are in the file's own unit.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Pick {
    /// Numbers of vertices, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<u32>>,
    /// Where one vertex is, to a millionth of the sheet's size.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 3]>,
    /// The least and the largest coordinates; null where there is no bound.
    #[serde(default, rename = "box", skip_serializing_if = "Option::is_none")]
    pub within: Option<[[Option<f64>; 3]; 2]>,
}

/// How far from its place a vertex may be, in radii of the sheet.
const NEAR: f64 = 1e-6;

impl Pick {
    /// The nodes, in order, each once; `place` is the entry's, such as `supports[2]`.
    pub(super) fn nodes(&self, place: &str, pattern: &CreasePattern, model: &Model) -> Result<Vec<NodeId>, Error> {
        let mut nodes = match (&self.vertices, &self.at, &self.within) {
            (Some(vertices), None, None) => {
                let node =
                    |(i, vertex): (usize, &u32)| node_of(&format!("{place}.vertices[{i}]"), *vertex, pattern, model);
                vertices.iter().enumerate().map(node).collect::<Result<_, _>>()?
            }
            (None, Some(at), None) => vec![nearest(place, DVec3::from_array(*at), pattern, model)?],
            (None, None, Some([least, largest])) => {
                let inside = |p: DVec3| {
                    (0..3).all(|i| least[i].is_none_or(|x| p[i] >= x) && largest[i].is_none_or(|x| p[i] <= x))
                };
                let rest = model.rest.iter().map(|p| model.normalisation.to_file(*p)).enumerate();
                rest.filter(|(_, p)| inside(*p)).map(|(i, _)| NodeId::new(i)).collect()
            }
            _ => {
                let (problem, expected) =
                    ("picks no vertices, or in two ways", "`vertices`, `at` or `box`, one of them");
                return Err(Error::new(ErrorCode::MissingKey, Place::key(place.to_owned()), problem, expected));
            }
        };
        nodes.sort_unstable();
        nodes.dedup();
        if nodes.is_empty() {
            let place = Place::key(format!("{place}.box"));
            return Err(Error::new(ErrorCode::WrongValue, place, "no vertex is in it", "one or more"));
        }
        Ok(nodes)
    }
}

/// The node of a vertex of the file.
pub(super) fn node_of(place: &str, vertex: u32, pattern: &CreasePattern, model: &Model) -> Result<NodeId, Error> {
    let own = VertexId(vertex);
    let stands = pattern.alias_of.get(own.index()).copied().flatten().unwrap_or(own);
    model.node(stands).ok_or_else(|| {
        let expected = format!("one of the file's {} vertices that is part of the sheet", pattern.vertices_in_file);
        Error::new(ErrorCode::NoSuchVertex, Place::key(place.to_owned()), format!("is vertex {vertex}"), expected)
    })
}

fn nearest(place: &str, at: DVec3, pattern: &CreasePattern, model: &Model) -> Result<NodeId, Error> {
    let own = model.normalisation.to_model(at);
    let distances = model.rest.iter().map(|p| p.distance(own)).enumerate();
    let best = distances.min_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, distance)| distance.is_finite());
    match best {
        Some((i, distance)) if distance <= NEAR => Ok(NodeId::new(i)),
        _ => {
            let place = Place::key(format!("{place}.at"));
            let problem = format!("no vertex is at [{}, {}, {}]", Short(at.x), Short(at.y), Short(at.z));
            let expected = best.map_or_else(String::new, |(i, _)| {
                let vertex = model.mesh.vertex_of_node[i];
                let p = pattern.vertices[vertex.index()];
                format!("the place of a vertex: {} is nearest, at [{}, {}, {}]", vertex.0, p.x, p.y, p.z)
            });
            Err(Error::new(ErrorCode::NoSuchVertex, place, problem, expected))
        }
    }
}
