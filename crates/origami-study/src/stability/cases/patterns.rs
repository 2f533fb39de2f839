//! Patterns that no generator makes, since nobody would fold them.

use std::f64::consts::{FRAC_PI_2, TAU};

use origami_core::glam::DVec3;
use origami_core::ids::VertexId;
use origami_core::pattern::{Assignment, PatternEdge};
use origami_core::{CreasePattern, Error};

/// A pattern of polygons; edges between them that are not among `creases` (ends, fold angle in radians) stay flat.
fn sheet(vertices: Vec<DVec3>, creases: &[([usize; 2], f64)], faces: Vec<Vec<usize>>) -> CreasePattern {
    #[expect(clippy::cast_possible_truncation, reason = "the sheets of this file are small")]
    let vertex = |i: usize| VertexId(i as u32);
    let edge = |(ends, angle): &([usize; 2], f64)| PatternEdge {
        vertices: ends.map(vertex),
        assignment: if *angle < 0.0 { Assignment::Mountain } else { Assignment::Valley },
        fold_angle: Some(*angle),
        k_crease: None,
        ea: None,
        alias_of: None,
    };
    CreasePattern {
        alias_of: vec![None; vertices.len()],
        vertices_in_file: vertices.len(),
        edges_in_file: creases.len(),
        edges: creases.iter().map(edge).collect(),
        faces: faces.into_iter().map(|face| face.into_iter().map(vertex).collect()).collect(),
        vertices,
        ..CreasePattern::default()
    }
}

/// A single crease of length 2 between apexes at `height` over its middle: in the model's units as it stands, as long as
/// the height is at most 1.
pub(crate) fn hinge(height: f64, angle: f64) -> CreasePattern {
    let points = [(-1.0, 0.0), (1.0, 0.0), (0.0, height), (0.0, -height)];
    let vertices = points.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
    sheet(vertices, &[([0, 1], angle)], vec![vec![0, 1, 2], vec![1, 0, 3]])
}

/// A triangle, without creases.
#[cfg(test)]
pub(crate) fn triangle() -> CreasePattern {
    let vertices = (0..3).map(|i| DVec3::from((DVec3::X.truncate().rotate(turn(i, 3)), 0.0))).collect();
    sheet(vertices, &[], vec![vec![0, 1, 2]])
}

fn turn(i: usize, of: usize) -> origami_core::glam::DVec2 {
    origami_core::glam::DVec2::from_angle(TAU * i as f64 / of as f64)
}

/// A regular polygon with a crease from the middle to each corner, of the letters that `sign` gives, also of odd valence.
pub(super) fn hub(valence: usize, sign: impl Fn(usize) -> f64) -> CreasePattern {
    let mut vertices = vec![DVec3::ZERO];
    vertices.extend((0..valence).map(|i| DVec3::from((turn(i, valence), 0.0))));
    let creases: Vec<_> = (0..valence).map(|i| ([0, 1 + i], sign(i) * FRAC_PI_2)).collect();
    let faces = (0..valence).map(|i| vec![0, 1 + i, 1 + (i + 1) % valence]).collect();
    sheet(vertices, &creases, faces)
}

/// Letters of a hub in turn; of an odd one the last is its neighbour's.
pub(super) fn in_turn(i: usize) -> f64 {
    if i.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Three panels of height 1 along parallel creases, the middle one as narrow as `width`: thin triangles in a sheet.
pub(super) fn narrow_pleat(width: f64) -> CreasePattern {
    let columns = [0.0, 1.0, 1.0 + width, 2.0 + width];
    let vertices = columns.iter().flat_map(|x| [DVec3::new(*x, 0.0, 0.0), DVec3::new(*x, 1.0, 0.0)]).collect();
    let faces = (0..3).map(|i| vec![2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]).collect();
    sheet(vertices, &[([2, 3], FRAC_PI_2), ([4, 5], -FRAC_PI_2)], faces)
}

/// Squares in squares, each a tenth of the next, down to a side of 1 / `ratio` of the border's; creases along the
/// diagonals, valley and mountain in turn from square to square.
pub(super) fn nested_squares(ratio: f64) -> CreasePattern {
    let mut vertices = vec![DVec3::ZERO];
    let (mut creases, mut faces) = (Vec::new(), Vec::new());
    let mut half = 1.0 / ratio;
    let mut ring = 0;
    loop {
        let first = vertices.len();
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        vertices.extend(corners.map(|(x, y)| DVec3::new(half * x, half * y, 0.0)));
        for i in 0..4 {
            let (a, b) = (first + i, first + (i + 1) % 4);
            let angle = in_turn(ring + i) * FRAC_PI_2;
            if ring == 0 {
                creases.push(([0, a], angle));
                faces.push(vec![0, a, b]);
            } else {
                creases.push(([a - 4, a], angle));
                faces.push(vec![a - 4, a, b, b - 4]);
            }
        }
        if half > 0.99 {
            return sheet(vertices, &creases, faces);
        }
        half = (10.0 * half).min(1.0);
        ring += 1;
    }
}

/// `pattern` with a letter drawn for each crease.
pub(super) fn random_letters(mut pattern: CreasePattern, seed: u64) -> CreasePattern {
    let mut bits = seed;
    for edge in &mut pattern.edges {
        bits = mixed(bits);
        if let Some(angle) = edge.fold_angle.filter(|angle| *angle != 0.0) {
            let sign = if bits >> 63 == 0 { 1.0 } else { -1.0 };
            edge.fold_angle = Some(sign * angle.abs());
            edge.assignment = if sign > 0.0 { Assignment::Valley } else { Assignment::Mountain };
        }
    }
    pattern
}

/// `SplitMix64` (Steele, Lea and Flood, OOPSLA 2014).
fn mixed(bits: u64) -> u64 {
    let bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// `pattern` with its coordinates multiplied by `scale` and then moved by `shift`.
pub(super) fn placed(mut pattern: CreasePattern, scale: f64, shift: f64) -> CreasePattern {
    for vertex in &mut pattern.vertices {
        *vertex = *vertex * scale + DVec3::new(shift, 0.3 * shift, 0.0);
    }
    pattern
}

/// Both patterns on one sheet, not connected.
pub(super) fn beside(mut one: CreasePattern, other: &CreasePattern) -> Result<CreasePattern, Error> {
    let many = |_| Error::invalid("vertices", one.vertices.len().to_string(), "fewer");
    let offset = u32::try_from(one.vertices.len()).map_err(many)?;
    let vertex = |v: &VertexId| VertexId(v.0 + offset);
    one.faces.extend(other.faces.iter().map(|face| face.iter().map(vertex).collect()));
    let moved = |edge: &PatternEdge| PatternEdge { vertices: edge.vertices.map(|v| vertex(&v)), ..edge.clone() };
    one.edges.extend(other.edges.iter().map(moved));
    one.vertices.extend(&other.vertices);
    one.alias_of = vec![None; one.vertices.len()];
    (one.vertices_in_file, one.edges_in_file) = (one.vertices.len(), one.edges.len());
    Ok(one)
}

#[cfg(test)]
mod tests {
    use origami_core::generate::miura;
    use origami_core::{Material, Model};

    use super::*;

    fn model(pattern: &CreasePattern) -> Model {
        Model::new(pattern, &Material::default()).expect("a sheet")
    }

    #[test]
    fn all_are_sheets() {
        for valence in [3, 4, 5, 256] {
            let hub = model(&hub(valence, in_turn));
            assert_eq!((hub.node_count(), hub.creases.len()), (valence + 1, valence));
        }
        let pleat = model(&narrow_pleat(1e-3));
        assert_eq!((pleat.node_count(), pleat.creases.len()), (8, 5), "two creases and three diagonals");
        let nested = model(&nested_squares(1e6));
        let lengths: Vec<f64> = nested.beams.iter().map(|b| b.rest_length).collect();
        let (least, most) = lengths.iter().fold((f64::MAX, 0.0_f64), |(a, b), l| (a.min(*l), b.max(*l)));
        assert!(most / least > 1e6, "{most} and {least}");
        let both = model(&beside(hub(5, in_turn), &placed(miura(2, 2).expect("a sheet"), 1.0, 5.0)).expect("few"));
        assert_eq!(both.node_count(), 6 + 9);
    }

    #[test]
    fn a_hinge_is_in_the_models_units() {
        let hinge = model(&hinge(0.25, 1.0));
        assert_eq!((hinge.rest[2], hinge.creases[0].full_target), (DVec3::new(0.0, 0.25, 0.0), 1.0));
        assert_eq!(hinge.creases[0].stiffness, 2.0 * 0.7);
    }

    #[test]
    fn letters_are_drawn_by_seed() {
        let letters = |seed| {
            let pattern = random_letters(miura(4, 4).expect("a sheet"), seed);
            pattern.edges.iter().map(|e| e.assignment.letter()).collect::<String>()
        };
        assert_eq!(letters(1), letters(1));
        assert_ne!(letters(1), letters(2));
    }
}
