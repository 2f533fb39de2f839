//! Second pass: the forces of beams, creases, corner angles and damping on the corners of every triangle.
//!
//! A side has the beam of two faces: each does half. A crease acts on a face along its normal N only: with the moment t,
//! the side's length l and g = t / (l |N|^2), the corner opposite to it feels g l^2 N, each end -g N times the dot product
//! at the other end (paper 2.3 with cotangents written out). The corner angles (2.4) on a side pull along N x side. Each
//! face's forces sum to zero.

use super::angle::small_angle_of;
use super::isa::Pass;
use super::lane::{Mesh, Num, Vec3};
use super::real::{Quad64, Real};
use super::sheet::Sheet;

/// Writes the forces on the three corners of each face.
pub(super) struct Faces<'a, R: Real> {
    pub(super) sheet: &'a Sheet<R>,
    pub(super) places: &'a [Quad64],
    /// Empty: no damping.
    pub(super) velocities: &'a [R::Quad],
    pub(super) moments: &'a [R],
    pub(super) slots: &'a mut [R::Quad],
}

impl<R: Real> Pass<R> for Faces<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: Mesh<Real = R>>(self, lane: L) {
        let Self { sheet, places, velocities, moments, slots } = self;
        let corners = sheet.corners.chunks_exact(3 * L::WIDTH);
        let input = Input { sheet, places, velocities, moments };
        let slots = slots.chunks_exact_mut(3 * L::WIDTH);
        for (chunk, (corners, slots)) in corners.zip(slots).enumerate() {
            let forces = input.face(lane, chunk, corners);
            for (force, slots) in forces.into_iter().zip(slots.chunks_exact_mut(L::WIDTH)) {
                lane.spread(force.raw(), slots);
            }
        }
    }
}

/// Fields of a chunk.
#[inline(always)]
fn fields<const N: usize, L: Mesh>(lane: L, list: &[L::Real], chunk: usize) -> [Num<L>; N] {
    let own = &list[chunk * N * L::WIDTH..][..N * L::WIDTH];
    std::array::from_fn(|i| Num::load(lane, &own[i * L::WIDTH..]))
}

/// What is read.
struct Input<'a, R: Real> {
    sheet: &'a Sheet<R>,
    places: &'a [Quad64],
    velocities: &'a [R::Quad],
    moments: &'a [R],
}

impl<R: Real> Input<'_, R> {
    #[inline(always)]
    fn face<L: Mesh<Real = R>>(&self, lane: L, chunk: usize, corners: &[u32]) -> [Vec3<L>; 3] {
        let zero = Num::splat(lane, 0.0);
        let (a, bc) = corners.split_at(L::WIDTH);
        let (b, c) = bc.split_at(L::WIDTH);
        let way = |from, to| Vec3::new(lane, lane.between(self.places, from, to));
        let sides = [way(a, b), way(b, c), way(c, a)];
        let [ab, bc, ca] = sides;
        let squares = sides.map(|side| side.dot(side));
        let dots = [-ab.dot(ca), -ab.dot(bc), -bc.dot(ca)];
        let normal = ca.cross(ab);
        let normal_squared = normal.dot(normal);
        let doubled_area = normal_squared.sqrt();
        // What has shrunk to nothing has no direction, and so no force.
        let inverse = |x: Num<L>| Num::splat(lane, R::LEAST).less(x).select(Num::splat(lane, 1.0) / x, zero);
        let lengths = squares.map(Num::sqrt);
        let over_lengths = lengths.map(inverse);

        // The beams: forces over lengths, k (l - l0) / l.
        let [rest_ab, rest_bc, rest_ca, k_ab, k_bc, k_ca] = fields(lane, &self.sheet.beams, chunk);
        let tension = |i: usize, rest: Num<L>, k: Num<L>| k * (lengths[i] - rest) * over_lengths[i];
        let tensions = [tension(0, rest_ab, k_ab), tension(1, rest_bc, k_bc), tension(2, rest_ca, k_ca)];
        let mut at_a = ca.sub_mul(tensions[2], ab * tensions[0]);
        let mut at_b = ab.sub_mul(tensions[0], bc * tensions[1]);

        if !self.velocities.is_empty() {
            let [c_ab, c_bc, c_ca] = fields(lane, &self.sheet.damping, chunk);
            let (a, bc) = corners.split_at(L::WIDTH);
            let (b, c) = bc.split_at(L::WIDTH);
            let apart = |from, to| Vec3::new(lane, lane.apart(self.velocities, from, to));
            let (ab, bc) = (apart(a, b), apart(b, c));
            // c to a: minus their sum.
            at_a = (ab + bc).mul_add(c_ca, ab.mul_add(c_ab, at_a));
            at_b = bc.mul_add(c_bc, ab.sub_mul(c_ab, at_b));
        }

        let over_area = inverse(doubled_area);
        if !self.sheet.angles.is_empty() {
            let [cos_a, sin_a, cos_b, sin_b] = fields(lane, &self.sheet.angles, chunk);
            // A corner's cosine and sine, turned back by its angle at rest.
            let deviation = |cos: Num<L>, sin: Num<L>, dot: Num<L>| {
                small_angle_of(doubled_area.mul_sub(cos, dot * sin), dot.mul_add(cos, doubled_area * sin))
            };
            let (one, two) = (deviation(cos_a, sin_a, dots[0]), deviation(cos_b, sin_b, dots[1]));
            let three = -(one + two);
            let stiff = over_area * Num::splat(lane, self.sheet.k_face);
            let pull = |i: usize, excess: Num<L>| stiff * excess * (over_lengths[i] * over_lengths[i]);
            let (on_ab, on_bc, on_ca) = (pull(0, two - one), pull(1, three - two), pull(2, one - three));
            at_a = at_a + normal.cross(ca.sub_mul(on_ca, ab * on_ab));
            at_b = at_b + normal.cross(ab.sub_mul(on_ab, bc * on_bc));
        }

        if !self.sheet.creases.is_empty() {
            let own = &self.sheet.creases[chunk * 3 * L::WIDTH..][..3 * L::WIDTH];
            let over_square = over_area * over_area;
            let g = |i: usize| {
                let moment = Num { lane, raw: lane.pick(self.moments, &own[i * L::WIDTH..][..L::WIDTH]) };
                moment * over_lengths[i] * over_square
            };
            let [g_ab, g_bc, g_ca] = [g(0), g(1), g(2)];
            let across_a = g_ca.sub_mul(dots[2], g_ab.sub_mul(dots[1], g_bc * squares[1]));
            let across_b = g_bc.sub_mul(dots[2], g_ab.sub_mul(dots[0], g_ca * squares[2]));
            at_a = normal.mul_add(across_a, at_a);
            at_b = normal.mul_add(across_b, at_b);
        }
        [at_a, at_b, -(at_a + at_b)]
    }
}
