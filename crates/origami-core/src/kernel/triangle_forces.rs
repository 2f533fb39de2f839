//! Second pass: the forces of beams, creases, corner angles and damping on the corners of every triangle.
//!
//! Two triangles share the beam on a side: each does half. A crease acts on a triangle along its normal N only: with the moment t,
//! the side's length l and g = t / (l |N|^2), the corner opposite to it feels g l^2 N, each end -g N times the dot product
//! at the other end (paper 2.3 with cotangents written out). The corner angles (2.4) on a side pull along N x side. The
//! forces of each triangle sum to zero.

use super::angle::small_angle_of;
use super::areas;
use super::isa::{Compute, Pass};
use super::lane::{GatherScatter, Lane, Num, Vec3};
use super::layout::Layout;
use super::real::{Quad64, Real};
use super::share::Cut;

/// Writes the forces on the three corners of each triangle.
pub(super) struct TriangleForces<'a, R: Real> {
    pub(super) layout: &'a Layout<R>,
    pub(super) positions: &'a [Quad64],
    /// Empty: no damping.
    pub(super) velocities: &'a [R::Quad],
    pub(super) moments: &'a [R],
    /// The first triangle of this pass.
    pub(super) first: usize,
    /// The slots of these triangles alone.
    pub(super) slots: &'a mut [R::Quad],
}

impl<R: Real> Pass<R> for TriangleForces<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) {
        let Self { layout, positions, velocities, moments, first, slots } = self;
        let corners = layout.corners[3 * first..].chunks_exact(3 * L::WIDTH);
        let input = Input { layout, positions, velocities, moments };
        let slots = slots.chunks_exact_mut(3 * L::WIDTH);
        for (chunk, (corners, slots)) in (first / L::WIDTH..).zip(corners.zip(slots)) {
            let forces = input.forces(lane, chunk, corners);
            for (i, force) in forces.iter().enumerate() {
                lane.scatter(force.raw(), &mut slots[i * L::WIDTH..][..L::WIDTH]);
            }
        }
    }
}

impl<R: Compute> Cut<R> for TriangleForces<'_, R> {
    fn elements(&self) -> usize {
        self.slots.len() / 3
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (slots, others) = self.slots.split_at_mut(3 * at);
        (Self { slots, ..self }, Self { first: self.first + at, slots: others, ..self })
    }

    fn both((): (), (): ()) {}
}

/// The `N` fields of one chunk of a list.
#[inline(always)]
fn fields<const N: usize, L: GatherScatter>(lane: L, list: &[L::Real], chunk: usize) -> [Num<L>; N] {
    let own = &list[chunk * N * L::WIDTH..][..N * L::WIDTH];
    let mut fields = [Num::splat(lane, 0.0); N];
    for (i, field) in fields.iter_mut().enumerate() {
        *field = Num::load(lane, &own[i * L::WIDTH..]);
    }
    fields
}

/// The inverses of two numbers, by one division. 0 for 0: what has shrunk to nothing has no direction, and so no force.
#[inline(always)]
fn inverses<L: GatherScatter>(a: Num<L>, b: Num<L>) -> [Num<L>; 2] {
    let lane = a.lane;
    let [zero, one] = [0.0, 1.0].map(|x| Num::splat(lane, x));
    // The product of two such numbers does not vanish.
    let least = Num::splat(lane, L::Real::LEAST.sqrt());
    let (no_a, no_b) = (a.less(least), b.less(least));
    let (a, b) = (no_a.select(one, a), no_b.select(one, b));
    let both = one / (a * b);
    [no_a.select(zero, both * b), no_b.select(zero, both * a)]
}

/// The angle at a corner less that at rest, by turning its cosine and sine back. The products are rounded before their
/// difference is: of equals it is 0.
#[inline(always)]
fn deviation<L: GatherScatter>(cosine: Num<L>, sine: Num<L>, doubled_area: Num<L>, along: Num<L>) -> Num<L> {
    small_angle_of(doubled_area * cosine - along * sine, along.mul_add(cosine, doubled_area * sine))
}

#[inline(always)]
fn thirds<L: Lane>(corners: &[u32]) -> (&[u32], &[u32], &[u32]) {
    let (a, others) = corners.split_at(L::WIDTH);
    let (b, c) = others.split_at(L::WIDTH);
    (a, b, c)
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
    fn of(lane: L, positions: &[Quad64], corners: &[u32]) -> Self {
        let (a, b, c) = thirds::<L>(corners);
        let ab = Vec3::new(lane, lane.gather_differences(positions, a, b));
        let bc = Vec3::new(lane, lane.gather_differences(positions, b, c));
        let ca = Vec3::new(lane, lane.gather_differences(positions, c, a));
        let squares = [ab.dot(ab), bc.dot(bc), ca.dot(ca)];
        let dots = [-ab.dot(ca), -ab.dot(bc), -bc.dot(ca)];
        let normal = ca.cross(ab);
        let doubled_area = normal.dot(normal).sqrt();
        let lengths = [squares[0].sqrt(), squares[1].sqrt(), squares[2].sqrt()];
        Self { sides: [ab, bc, ca], squares, lengths, dots, normal, doubled_area }
    }
}

/// Replaces rest lengths and angles by what the second pass computes for the sheet at rest, so that no rounding pulls at it
/// there. A value that a model has set apart from its positions at rest stays.
pub(super) struct AtRest<'a, R: Real> {
    pub(super) corners: &'a [u32],
    pub(super) positions: &'a [Quad64],
    pub(super) beams: &'a mut [R],
    pub(super) angles: &'a mut [R],
}

impl<R: Real> Pass<R> for AtRest<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) {
        let nearly = Num::splat(lane, 8.0 * R::EPSILON);
        let corners = self.corners.chunks_exact(3 * L::WIDTH);
        let mut angles = self.angles.chunks_exact_mut(4 * L::WIDTH);
        for (corners, beams) in corners.zip(self.beams.chunks_exact_mut(6 * L::WIDTH)) {
            let shape = Shape::of(lane, self.positions, corners);
            for i in 0..3 {
                let own = &mut beams[i * L::WIDTH..][..L::WIDTH];
                let (length, rest) = (shape.lengths[i], Num::load(lane, own));
                (length - rest).abs().less(nearly * rest).select(length, rest).store(own);
            }
            let Some(angles) = angles.next() else { continue };
            for i in 0..2 {
                let (cosines, sines) = angles[2 * i * L::WIDTH..][..2 * L::WIDTH].split_at_mut(L::WIDTH);
                let (cosine, sine) = (Num::load(lane, cosines), Num::load(lane, sines));
                let (along, area) = (shape.dots[i], shape.doubled_area);
                // The pair is no longer of unit length; only its quotient is used.
                let error = (area * cosine - along * sine).abs();
                let same = error.less(nearly * along.mul_add(cosine, area * sine));
                same.select(along, cosine).store(cosines);
                same.select(area, sine).store(sines);
            }
        }
    }
}

/// What the pass reads.
struct Input<'a, R: Real> {
    layout: &'a Layout<R>,
    positions: &'a [Quad64],
    velocities: &'a [R::Quad],
    moments: &'a [R],
}

impl<R: Real> Input<'_, R> {
    #[inline(always)]
    fn forces<L: GatherScatter<Real = R>>(&self, lane: L, chunk: usize, corners: &[u32]) -> [Vec3<L>; 3] {
        let (a, b, c) = thirds::<L>(corners);
        let Shape { sides: [ab, bc, ca], squares, lengths: [l_ab, l_bc, l_ca], dots, normal, doubled_area } =
            Shape::of(lane, self.positions, corners);
        let ([over_ab, over_bc], [over_ca, over_area]) = (inverses(l_ab, l_bc), inverses(l_ca, doubled_area));

        // The beams: forces over lengths, k (l - l0) / l.
        let [rest_ab, rest_bc, rest_ca, k_ab, k_bc, k_ca] = fields(lane, &self.layout.beams, chunk);
        let on_ab = k_ab * (l_ab - rest_ab) * over_ab;
        let on_bc = k_bc * (l_bc - rest_bc) * over_bc;
        let on_ca = k_ca * (l_ca - rest_ca) * over_ca;
        let mut at_a = ca.sub_mul(on_ca, ab * on_ab);
        let mut at_b = ab.sub_mul(on_ab, bc * on_bc);

        if !self.velocities.is_empty() {
            let [c_ab, c_bc, c_ca] = fields(lane, &self.layout.damping, chunk);
            let ab = Vec3::new(lane, lane.gather_velocity_differences(self.velocities, a, b));
            let bc = Vec3::new(lane, lane.gather_velocity_differences(self.velocities, b, c));
            // From c to a it is minus the sum of these two.
            at_a = (ab + bc).mul_add(c_ca, ab.mul_add(c_ab, at_a));
            at_b = bc.mul_add(c_bc, ab.sub_mul(c_ab, at_b));
        }

        if !self.layout.angles.is_empty() {
            let [cos_a, sin_a, cos_b, sin_b] = fields(lane, &self.layout.angles, chunk);
            let one = deviation(cos_a, sin_a, doubled_area, dots[0]);
            let two = deviation(cos_b, sin_b, doubled_area, dots[1]);
            let three = -(one + two);
            let stiff = over_area * Num::splat(lane, self.layout.k_face);
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

        if !self.layout.creases.is_empty() {
            let own = &self.layout.creases[chunk * 3 * L::WIDTH..][..3 * L::WIDTH];
            let over_square = over_area * over_area;
            let (on_ab, others) = own.split_at(L::WIDTH);
            let (on_bc, on_ca) = others.split_at(L::WIDTH);
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
