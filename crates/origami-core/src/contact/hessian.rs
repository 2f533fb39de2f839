//! The second derivatives of the energy of a gap.
//!
//! With the distance d of a pair, its barrier b(d - closed) and the factor m that eases parallel edges out
//!
//! ```text
//! H = m (b'' grad d grad d^T + b' H_d) + b' (grad m grad d^T + grad d grad m^T) + b H_m
//! ```
//!
//! The distance is that of the nearest points, which slide along their faces and edges as the nodes move. One formula has
//! all its regions: [`of_distance`].

use faer::{Mat, Side};
use glam::{DMat3, DVec3};

use super::barrier::Barrier;
use super::distance::Nearest;
use super::layers::Layers;
use super::pairs::Pair;
use crate::ids::NodeId;

/// `d2E / dx_i dx_j` of the four points of a pair.
pub(super) type Blocks = [[DMat3; 4]; 4];

/// Directions with a Gram determinant below this share of the product of their squared lengths are one.
const ONE_DIRECTION: f64 = 1e-14;

/// Tells `add` the blocks of the Hessian of all gaps, at the positions that the layers were last measured at: of each pair of
/// different nodes one block for each way in which they are near, and one of each node with itself. `projected`: without the
/// directions in which the energy of a pair is curved downwards.
pub(crate) fn blocks(
    layers: &Layers,
    positions: &[DVec3],
    projected: bool,
    add: &mut dyn FnMut(NodeId, NodeId, DMat3),
) {
    for (pair, _) in layers.pushing() {
        let exact = of_pair(pair, &pair.points(positions), layers.stiffness());
        let blocks = if projected { without_negative(&exact) } else { exact };
        for (i, row) in blocks.iter().enumerate() {
            for (j, block) in row.iter().enumerate().take(i + 1) {
                add(pair.nodes[i], pair.nodes[j], *block);
            }
        }
    }
}

/// The pairs of different nodes that push each other, where the layers were last measured; some more than once.
pub(crate) fn pairs(layers: &Layers) -> impl Iterator<Item = [NodeId; 2]> {
    let of_pair = |[a, b, c, d]: [NodeId; 4]| [[a, b], [a, c], [a, d], [b, c], [b, d], [c, d]];
    layers.pushing().flat_map(move |(pair, _)| of_pair(pair.nodes)).map(|[a, b]| [a.min(b), a.max(b)])
}

/// The Hessian of the energy of one pair.
pub(super) fn of_pair(pair: &Pair, points: &[DVec3; 4], stiffness: f64) -> Blocks {
    let nearest = pair.nearest(points);
    let distance = nearest.apart.length();
    let normal = nearest.apart / distance;
    let Barrier { energy, slope, curvature } = Barrier::of(distance - pair.closed, pair.width, stiffness);
    let (factor, of_factor, second) = eased(pair, points);
    let of_distance = of_distance(points, pair.split, &nearest);
    let gradient = nearest.weights.map(|weight| weight * normal);
    block(|i, j| {
        factor * (curvature * outer(gradient[i], gradient[j]) + slope * of_distance[i][j])
            + slope * (outer(of_factor[i], gradient[j]) + outer(gradient[i], of_factor[j]))
            + energy * second[i][j]
    })
}

/// The Hessian of the distance, `|r|` with `r = sum of w_i x_i`.
///
/// The nearest point of a thing lies on the face, edge or corner of which the weights are not 0, and may slide along each
/// direction `d_a = sum of c_ia x_i` between two of its corners. With `n = r / |r|` and `G_ab = d_a . d_b` the least distance is
/// curved by
///
/// ```text
/// w_i w_j (I - n n^T) / |r| - |r| sum over a, b of s_ia (G^-1)_ab s_jb^T        s_ia = w_i d_a / |r| + c_ia n
/// ```
///
/// of which the second part is what sliding gives way.
fn of_distance(points: &[DVec3; 4], split: usize, nearest: &Nearest) -> Blocks {
    let Nearest { weights, apart } = *nearest;
    let distance = apart.length();
    let normal = apart / distance;
    let across = (DMat3::IDENTITY - outer(normal, normal)) * distance.recip();
    let slides: Vec<[f64; 4]> = [0..split, split..4]
        .into_iter()
        .flat_map(|thing| {
            let used: Vec<usize> = thing.filter(|i| weights[*i] != 0.0).collect();
            let from = used.first().copied().unwrap_or_default();
            used.into_iter().skip(1).map(move |to| {
                let mut slide = [0.0; 4];
                (slide[from], slide[to]) = (-1.0, 1.0);
                slide
            })
        })
        .collect();
    let directions: Vec<DVec3> = slides.iter().map(|c| points.iter().zip(c).map(|(x, c)| *x * *c).sum()).collect();
    let gives =
        |(direction, slide): (&DVec3, &[f64; 4]), i: usize| weights[i] / distance * *direction + slide[i] * normal;
    let ways = || directions.iter().zip(&slides);
    let inverse = inverse_gram(&directions);
    block(|i, j| {
        let mut own = weights[i] * weights[j] * across;
        for (one, row) in ways().zip(&inverse) {
            for (other, entry) in ways().zip(row) {
                own -= distance * entry * outer(gives(one, i), gives(other, j));
            }
        }
        own
    })
}

/// The inverse of the products of up to two directions.
fn inverse_gram(directions: &[DVec3]) -> [[f64; 2]; 2] {
    let first = |d: DVec3| [[d.length_squared().recip(), 0.0], [0.0, 0.0]];
    match *directions {
        [d] => first(d),
        [d, e] => {
            let (a, b, c) = (d.length_squared(), d.dot(e), e.length_squared());
            let det = a * c - b * b;
            if det <= ONE_DIRECTION * a * c { first(d) } else { [[c / det, -b / det], [-b / det, a / det]] }
        }
        _ => [[0.0; 2]; 2],
    }
}

/// The factor of [`super::barrier::mollifier`] and its derivatives: `(2 - x) x` with `x = |u x v|^2 / least` for the edges u
/// and v. 1, and nothing, for a point and a triangle.
fn eased(pair: &Pair, points: &[DVec3; 4]) -> (f64, [DVec3; 4], Blocks) {
    let none = (1.0, [DVec3::ZERO; 4], block(|_, _| DMat3::ZERO));
    if pair.split == 1 {
        return none;
    }
    let [p, q, r, s] = *points;
    let (u, v, least) = (q - p, s - r, pair.eased);
    let x = u.cross(v).length_squared() / least;
    if x >= 1.0 {
        return none;
    }
    let (a, b, c) = (u.length_squared(), u.dot(v), v.length_squared());
    // Of |u x v|^2 = a c - b^2.
    let (by_u, by_v) = (2.0 * (c * u - b * v), 2.0 * (a * v - b * u));
    let by_uu = 2.0 * (c * DMat3::IDENTITY - outer(v, v));
    let by_vv = 2.0 * (a * DMat3::IDENTITY - outer(u, u));
    let by_uv = 2.0 * (2.0 * outer(u, v) - outer(v, u) - b * DMat3::IDENTITY);
    let (slope, curvature) = ((2.0 - 2.0 * x) / least, -2.0 / (least * least));
    let second = [
        [slope * by_uu + curvature * outer(by_u, by_u), slope * by_uv + curvature * outer(by_u, by_v)],
        [slope * by_uv.transpose() + curvature * outer(by_v, by_u), slope * by_vv + curvature * outer(by_v, by_v)],
    ];
    // Of p, q, r and s: which of u and v they are the ends of, and the sign.
    let ends = [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0)];
    let gradient = ends.map(|(edge, sign)| sign * slope * [by_u, by_v][edge]);
    let second = block(|i, j| ends[i].1 * ends[j].1 * second[ends[i].0][ends[j].0]);
    ((2.0 - x) * x, gradient, second)
}

/// The nearest matrix without negative eigenvalues.
fn without_negative(blocks: &Blocks) -> Blocks {
    let full = Mat::from_fn(12, 12, |row, column| blocks[row / 3][column / 3].col(column % 3)[row % 3]);
    // Of numbers that are none there is nothing to be made; who assembles them sees that.
    let Ok(decomposed) = full.self_adjoint_eigen(Side::Lower) else { return *blocks };
    let (vectors, values) = (decomposed.U(), decomposed.S().column_vector());
    let mut sum = block(|_, _| DMat3::ZERO);
    for (k, value) in values.iter().enumerate().filter(|(_, value)| **value > 0.0) {
        let part: [DVec3; 4] =
            std::array::from_fn(|i| DVec3::from_array(std::array::from_fn(|x| vectors[(3 * i + x, k)])));
        sum = block(|i, j| sum[i][j] + *value * outer(part[i], part[j]));
    }
    sum
}

fn block(of: impl Fn(usize, usize) -> DMat3) -> Blocks {
    std::array::from_fn(|i| std::array::from_fn(|j| of(i, j)))
}

/// `a b^T`.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

#[cfg(test)]
mod tests {
    use super::super::barrier::mollifier;
    use super::*;

    const STIFFNESS: f64 = 50.0;

    /// Minus the forces on the four points.
    fn gradient(pair: &Pair, points: &[DVec3; 4]) -> [DVec3; 4] {
        let Nearest { weights, apart } = pair.nearest(points);
        let Barrier { energy, slope, .. } = Barrier::of(apart.length() - pair.closed, pair.width, STIFFNESS);
        let (factor, of_factor) = if pair.split == 2 { mollifier(points, pair.eased) } else { (1.0, [DVec3::ZERO; 4]) };
        std::array::from_fn(|i| factor * slope * weights[i] * apart.normalize() + energy * of_factor[i])
    }

    /// The largest difference between the Hessian and differences of the gradient, as a share of its largest entry.
    fn error(pair: &Pair, points: &[DVec3; 4], hessian: &Blocks) -> f64 {
        let size = hessian.iter().flatten().flat_map(|m| m.to_cols_array()).fold(0.0, |a: f64, b| a.max(b.abs()));
        let mut worst = 0.0_f64;
        for j in 0..4 {
            for axis in 0..3 {
                let at = |h: f64| {
                    let mut moved = *points;
                    moved[j][axis] += h;
                    gradient(pair, &moved)
                };
                let h = 1e-6;
                let (near, far) = ([at(h), at(-h)], [at(2.0 * h), at(-2.0 * h)]);
                for (i, row) in hessian.iter().enumerate() {
                    let slope = (8.0 * (near[0][i] - near[1][i]) - (far[0][i] - far[1][i])) / (12.0 * h);
                    worst = worst.max((slope - row[j].col(axis)).abs().max_element());
                }
            }
        }
        worst / size
    }

    fn pair(split: usize, eased: f64) -> Pair {
        let nodes = [0, 1, 2, 3].map(NodeId);
        Pair { nodes, split, closed: 0.05, width: 0.4, eased }
    }

    /// One pair of each region: the name, the points of the first and second thing, how many of each have a weight.
    fn regions() -> Vec<(&'static str, Pair, [DVec3; 4], [usize; 2])> {
        let v = DVec3::new;
        let triangle = [v(0.0, 0.0, 0.0), v(1.0, 0.1, 0.0), v(0.2, 0.9, 0.1)];
        let face = |p: DVec3| [p, triangle[0], triangle[1], triangle[2]];
        let edges = |r: DVec3, s: DVec3| [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.1), r, s];
        let (point, edge, parallel) = (pair(1, 0.0), pair(2, 1e-3), pair(2, 0.5));
        vec![
            ("point-face", point, face(v(0.35, 0.3, 0.25)), [1, 3]),
            ("point-edge", point, face(v(0.5, -0.1, 0.15)), [1, 2]),
            ("point-point", point, face(v(-0.1, -0.15, 0.12)), [1, 1]),
            ("edge-edge", edge, edges(v(0.4, -0.5, 0.25), v(0.5, 0.6, 0.3)), [2, 2]),
            ("edge-end", edge, edges(v(0.4, 0.15, 0.15), v(0.5, 0.9, 0.4)), [2, 1]),
            ("end-edge", edge, edges(v(-0.1, -0.5, 0.1), v(-0.15, 0.6, 0.2)), [1, 2]),
            ("end-end", edge, edges(v(-0.1, 0.1, 0.1), v(-0.6, 0.9, 0.4)), [1, 1]),
            ("eased inside", parallel, edges(v(-0.2, -0.1, 0.25), v(0.9, 0.4, 0.3)), [2, 2]),
            ("eased at an end", parallel, edges(v(0.4, 0.15, 0.15), v(1.2, 0.4, 0.4)), [2, 1]),
        ]
    }

    #[test]
    fn it_is_the_derivative_of_the_gradient_in_every_region() {
        for (name, pair, points, used) in regions() {
            let Nearest { weights, apart } = pair.nearest(&points);
            let count = |thing: &[f64]| thing.iter().filter(|w| **w != 0.0).count();
            assert_eq!([count(&weights[..pair.split]), count(&weights[pair.split..])], used, "{name}: {weights:?}");
            assert!(apart.length() > pair.closed && apart.length() - pair.closed < pair.width, "{name}: {apart}");
            if name.starts_with("eased") {
                let factor = mollifier(&points, pair.eased).0;
                assert!(factor > 0.05 && factor < 0.95, "{name}: {factor}");
            }
            let hessian = of_pair(&pair, &points, STIFFNESS);
            let off = error(&pair, &points, &hessian);
            assert!(off < 1e-7, "{name}: {off}");
            // What is wrong by a ten-thousandth is seen.
            let mut wrong = hessian;
            wrong[0][0] *= 1.0001;
            assert!(error(&pair, &points, &wrong) > 1e-6, "{name}: the comparison sees nothing");
        }
    }

    #[test]
    fn the_projected_form_has_no_negative_eigenvalue_and_keeps_the_others() {
        let mut cut = 0;
        for (name, pair, points, _) in regions() {
            let hessian = of_pair(&pair, &points, STIFFNESS);
            let (projected, twice) = (without_negative(&hessian), without_negative(&without_negative(&hessian)));
            let full = |blocks: &Blocks| {
                let entry = |row: usize, column: usize| blocks[row / 3][column / 3].col(column % 3)[row % 3];
                Mat::from_fn(12, 12, entry).self_adjoint_eigenvalues(Side::Lower).expect("finite")
            };
            let (exact, kept) = (full(&hessian), full(&projected));
            let size = exact.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            for (exact, kept) in exact.iter().zip(&kept) {
                assert!((exact.max(0.0) - kept).abs() < 1e-12 * size, "{name}: {exact} and {kept}");
                cut += usize::from(*exact < -1e-3 * size);
            }
            let apart = projected.iter().flatten().zip(twice.iter().flatten());
            assert!(apart.clone().all(|(a, b)| a.abs_diff_eq(*b, 1e-11 * size)), "{name}");
        }
        assert!(cut > 5, "there was something to cut: {cut}");
    }
}
