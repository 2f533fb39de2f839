//! Second pass: the forces of beams, creases, corner angles and damping on the corners of every triangle.
//!
//! Two triangles share the beam on a side: each does half. A crease acts on a triangle along its normal N only: with the moment t,
//! the side's length l and g = t / (l |N|^2), the corner opposite to it feels g l^2 N, each end -g N times the dot product
//! at the other end (paper 2.3 with cotangents written out). The corner angles (2.4) on a side pull along N x side. The
//! forces of each triangle sum to zero.

use std::ops::Range;
use std::slice::ChunksExact;

use super::angle::small_angle_of;
use super::areas;
use super::blocks::{CREASES, NODES};
use super::isa::Pass;
use super::lane::{GatherScatter, Lane, Mask, Num, Vec3};
use super::layout::{Layout, Starts};
use super::near::Near;
use super::real::{Quad64, Real};
use super::scratch::take_positions;

/// Writes the forces on the corners of these triangles of a block.
#[inline(always)]
pub(super) fn triangle_forces<L: GatherScatter>(
    lane: L,
    input: &Input<'_, L::Real>,
    triangles: Range<usize>,
    forces: &mut [<L::Real as Real>::Quad],
) {
    let Layout { corners, beams, damping, angles, creases, .. } = input.layout;
    let corners = corners[3 * triangles.start..3 * triangles.end].chunks_exact(3 * L::WIDTH);
    let beams = beams[6 * triangles.start..6 * triangles.end].chunks_exact(6 * L::WIDTH);
    let damping = if input.damped { &damping[3 * triangles.start..3 * triangles.end] } else { &[] };
    let mut others = Others {
        damping: damping.chunks_exact(3 * L::WIDTH),
        angles: of(angles, &triangles).chunks_exact(3 * L::WIDTH),
        creases: of(creases, &triangles).chunks_exact(3 * L::WIDTH),
    };
    for ((corners, beams), to) in corners.zip(beams).zip(forces.chunks_exact_mut(3 * L::WIDTH)) {
        let forces = input.forces(lane, corners, beams, &mut others);
        for (force, to) in forces.iter().zip(to.chunks_exact_mut(L::WIDTH)) {
            lane.scatter(force.raw(), to);
        }
    }
}

/// What there is in some scenes only, chunk by chunk.
struct Others<'a, R> {
    damping: ChunksExact<'a, R>,
    angles: ChunksExact<'a, R>,
    creases: ChunksExact<'a, u16>,
}

/// Three numbers of each of these triangles, where they have them at all.
fn of<'a, T>(list: &'a [T], triangles: &Range<usize>) -> &'a [T] {
    list.get(3 * triangles.start..3 * triangles.end).unwrap_or_default()
}

/// The fields of one chunk of a list.
#[inline(always)]
fn fields<const N: usize, L: GatherScatter>(lane: L, own: &[L::Real]) -> [Num<L>; N] {
    let mut fields = [Num::splat(lane, 0.0); N];
    for (field, own) in fields.iter_mut().zip(own.chunks_exact(L::WIDTH)) {
        *field = Num::load(lane, own);
    }
    fields
}

/// The inverses of three lengths and of a doubled area. 0 for 0: what has shrunk to nothing has no direction, and so no force.
#[inline(always)]
fn inverses<L: GatherScatter>([a, b, c]: [Num<L>; 3], area: Num<L>) -> [Num<L>; 4] {
    let lane = a.lane;
    let [zero, one] = [0.0, 1.0].map(|x| Num::splat(lane, x));
    // The product of two such numbers does not vanish.
    let least = Num::splat(lane, L::Real::LEAST.sqrt());
    if least.less(a.min(b).min(c.min(area))).all() {
        let ([a, b], [c, area]) = (two_inverses(a, b), two_inverses(c, area));
        return [a, b, c, area];
    }
    let none = [a.less(least), b.less(least), c.less(least), area.less(least)];
    let ([a, b], [c, area]) = (
        two_inverses(none[0].select(one, a), none[1].select(one, b)),
        two_inverses(none[2].select(one, c), none[3].select(one, area)),
    );
    [none[0].select(zero, a), none[1].select(zero, b), none[2].select(zero, c), none[3].select(zero, area)]
}

/// The inverses of two numbers, by one division.
#[inline(always)]
fn two_inverses<L: GatherScatter>(a: Num<L>, b: Num<L>) -> [Num<L>; 2] {
    let both = Num::splat(a.lane, 1.0) / (a * b);
    [both * b, both * a]
}

/// The angle at a corner less that at rest, by turning its cosine and sine back. The products are rounded before their
/// difference is: of equals it is 0.
#[inline(always)]
fn deviation<L: GatherScatter>(cosine: Num<L>, sine: Num<L>, doubled_area: Num<L>, along: Num<L>) -> Num<L> {
    small_angle_of(doubled_area * cosine - along * sine, along.mul_add(cosine, doubled_area * sine))
}

#[inline(always)]
fn thirds<L: Lane, T>(chunk: &[T]) -> [&[T]; 3] {
    let (a, others) = chunk.split_at(L::WIDTH);
    let (b, c) = others.split_at(L::WIDTH);
    [a, b, c]
}

/// Whether two angles differ by a few roundings, each as a number along and one across.
#[inline(always)]
fn nearly_same<L: GatherScatter>(nearly: Num<L>, rest: (Num<L>, Num<L>), own: (Num<L>, Num<L>)) -> Mask<L> {
    let error = (own.1 * rest.0 - own.0 * rest.1).abs();
    error.less(nearly * own.0.mul_add(rest.0, own.1 * rest.1))
}

/// Triangles, side by side.
struct Shape<L: Lane> {
    /// From a to b, from b to c, from c to a; squares and lengths are in the same order.
    sides: [Vec3<L>; 3],
    squares: [Num<L>; 3],
    lengths: [Num<L>; 3],
    /// The product of the two sides at each corner.
    dots: [Num<L>; 3],
    normal: Vec3<L>,
    doubled_area: Num<L>,
}

impl<L: GatherScatter> Shape<L> {
    #[inline(always)]
    fn of(lane: L, near: &Near<L::Real>, corners: &[u8]) -> Self {
        let [ab, bc, ca] = lane.gather_sides(near, thirds::<L, _>(corners));
        let (ab, bc, ca) = (Vec3::new(lane, ab), Vec3::new(lane, bc), Vec3::new(lane, ca));
        let squares = [ab.dot(ab), bc.dot(bc), ca.dot(ca)];
        let dots = [-ab.dot(ca), -ab.dot(bc), -bc.dot(ca)];
        let normal = ca.cross(ab);
        let doubled_area = normal.dot(normal).sqrt();
        let lengths = [squares[0].sqrt(), squares[1].sqrt(), squares[2].sqrt()];
        Self { sides: [ab, bc, ca], squares, lengths, dots, normal, doubled_area }
    }

    /// Puts its own numbers in place of `angles`, where both angles are nearly the same.
    #[inline(always)]
    fn replace_angles(&self, nearly: Num<L>, angles: &mut [L::Real]) {
        let [along_a, along_b, area] = fields(self.doubled_area.lane, angles);
        let same = nearly_same(nearly, (along_a, area), (self.dots[0], self.doubled_area))
            & nearly_same(nearly, (along_b, area), (self.dots[1], self.doubled_area));
        same.select(self.dots[0], along_a).store(angles);
        same.select(self.dots[1], along_b).store(&mut angles[L::WIDTH..]);
        same.select(self.doubled_area, area).store(&mut angles[2 * L::WIDTH..]);
    }
}

/// Replaces rest lengths and angles by what the second pass computes for the sheet at rest, so that no rounding pulls at it
/// there. A value that a model has set apart from its positions at rest stays.
pub(super) struct AtRest<'a, R: Real> {
    pub(super) blocks: &'a [Starts],
    pub(super) block_nodes: &'a [u32],
    pub(super) corners: &'a [u8],
    /// Of the sheet, by node.
    pub(super) positions: &'a [Quad64],
    pub(super) near: &'a mut Near<R>,
    pub(super) beams: &'a mut [R],
    pub(super) angles: &'a mut [R],
}

impl<R: Real> Pass<R> for AtRest<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) {
        let nearly = Num::splat(lane, 8.0 * R::EPSILON);
        let mut corners = self.corners.chunks_exact(3 * L::WIDTH);
        let mut beams = self.beams.chunks_exact_mut(6 * L::WIDTH);
        let mut angles = self.angles.chunks_exact_mut(3 * L::WIDTH);
        for own in self.blocks.windows(2) {
            take_positions(lane, self.near, self.positions, &self.block_nodes[own[0].nodes..own[1].nodes]);
            let near = &*self.near;
            // As far as two lengths may differ because positions do.
            let slack = Num::of(lane, near.unit) * Num::splat(lane, 4.0);
            let chunks = (own[1].triangles - own[0].triangles) / L::WIDTH;
            for (corners, beams) in corners.by_ref().zip(beams.by_ref()).take(chunks) {
                let shape = Shape::of(lane, near, corners);
                for i in 0..3 {
                    let own = &mut beams[i * L::WIDTH..][..L::WIDTH];
                    let (length, rest) = (shape.lengths[i], Num::load(lane, own));
                    (length - rest).abs().less(nearly.mul_add(rest, slack)).select(length, rest).store(own);
                }
                if let Some(angles) = angles.next() {
                    let shortest = shape.lengths[0].min(shape.lengths[1]).min(shape.lengths[2]);
                    shape.replace_angles(nearly + slack / shortest, angles);
                }
            }
        }
    }
}

/// What the pass reads: the nodes and moments are those of one block.
pub(super) struct Input<'a, R: Real> {
    pub(super) layout: &'a Layout<R>,
    pub(super) near: &'a Near<R>,
    pub(super) damped: bool,
    pub(super) velocities: &'a [R::Quad; NODES],
    pub(super) moments: &'a [R; CREASES],
}

impl<R: Real> Input<'_, R> {
    #[inline(always)]
    fn forces<L: GatherScatter<Real = R>>(
        &self,
        lane: L,
        corners: &[u8],
        beams: &[R],
        others: &mut Others<'_, R>,
    ) -> [Vec3<L>; 3] {
        let [a, b, c] = thirds::<L, _>(corners);
        let Shape { sides: [ab, bc, ca], squares, lengths: [l_ab, l_bc, l_ca], dots, normal, doubled_area } =
            Shape::of(lane, self.near, corners);
        let [over_ab, over_bc, over_ca, over_area] = inverses([l_ab, l_bc, l_ca], doubled_area);

        // The beams: forces over lengths, k (l - l0) / l.
        let [rest_ab, rest_bc, rest_ca, k_ab, k_bc, k_ca] = fields(lane, beams);
        let on_ab = k_ab * (l_ab - rest_ab) * over_ab;
        let on_bc = k_bc * (l_bc - rest_bc) * over_bc;
        let on_ca = k_ca * (l_ca - rest_ca) * over_ca;
        let mut at_a = ca.sub_mul(on_ca, ab * on_ab);
        let mut at_b = ab.sub_mul(on_ab, bc * on_bc);

        if let Some(damping) = others.damping.next() {
            let [c_ab, c_bc, c_ca] = fields(lane, damping);
            let ab = Vec3::new(lane, lane.gather_velocity_differences(self.velocities, a, b));
            let bc = Vec3::new(lane, lane.gather_velocity_differences(self.velocities, b, c));
            // From c to a it is minus the sum of these two.
            at_a = (ab + bc).mul_add(c_ca, ab.mul_add(c_ab, at_a));
            at_b = bc.mul_add(c_bc, ab.sub_mul(c_ab, at_b));
        }

        if let Some(angles) = others.angles.next() {
            let [rest_a, rest_b, rest_area] = fields(lane, angles);
            let one = deviation(rest_a, rest_area, doubled_area, dots[0]);
            let two = deviation(rest_b, rest_area, doubled_area, dots[1]);
            let three = -(one + two);
            let stiff = over_area * Num::of(lane, self.layout.k_face);
            let on_ab = stiff * (two - one) * (over_ab * over_ab);
            let on_bc = stiff * (three - two) * (over_bc * over_bc);
            let on_ca = stiff * (one - three) * (over_ca * over_ca);
            at_a = at_a + normal.cross(ca.sub_mul(on_ca, ab * on_ab));
            at_b = at_b + normal.cross(ab.sub_mul(on_ab, bc * on_bc));
        }

        if self.layout.k_area > 0.0
            && let Some(pull) = areas::pull(self.layout.k_area, [rest_ab, rest_bc, rest_ca], doubled_area, over_area)
        {
            at_a = normal.cross(bc).mul_add(pull, at_a);
            at_b = normal.cross(ca).mul_add(pull, at_b);
        }

        if let Some(creases) = others.creases.next() {
            let over_square = over_area * over_area;
            let [on_ab, on_bc, on_ca] = thirds::<L, _>(creases);
            let g_ab = Num { lane, raw: lane.gather(self.moments, on_ab) } * over_ab * over_square;
            let g_bc = Num { lane, raw: lane.gather(self.moments, on_bc) } * over_bc * over_square;
            let g_ca = Num { lane, raw: lane.gather(self.moments, on_ca) } * over_ca * over_square;
            let across_a = g_ca.sub_mul(dots[2], g_ab.sub_mul(dots[1], g_bc * squares[1]));
            let across_b = g_bc.sub_mul(dots[2], g_ab.sub_mul(dots[0], g_ca * squares[2]));
            at_a = normal.mul_add(across_a, at_a);
            at_b = normal.mul_add(across_b, at_b);
        }
        [at_a, at_b, -(at_a + at_b)]
    }
}
