//! What the passes compute with: several numbers side by side. The passes are written once, over [`Num`] and [`Vec3`]; a
//! [`Lane`] says what an instruction set does with them.

use std::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

use super::blocks::{CREASES, NODES};
use super::near::Near;
use super::real::Real;

/// Numbers of one kind side by side, and what an instruction set does with them. Every operation is element by element, so
/// results do not depend on how many there are.
pub(crate) trait Lane: Copy {
    type Real: Real;
    type Raw: Copy;
    type Mask: Copy;
    /// How many numbers lie side by side.
    const WIDTH: usize;

    fn splat(self, x: Self::Real) -> Self::Raw;
    /// The first numbers of a slice, which has as many.
    fn load(self, from: &[Self::Real]) -> Self::Raw;
    fn store(self, raw: Self::Raw, to: &mut [Self::Real]);
    fn add(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn sub(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn mul(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn div(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    /// `a b + c`, rounded once where the instruction set can do that.
    fn mul_add(self, a: Self::Raw, b: Self::Raw, c: Self::Raw) -> Self::Raw;
    /// `a b - c`.
    fn mul_sub(self, a: Self::Raw, b: Self::Raw, c: Self::Raw) -> Self::Raw;
    /// `c - a b`.
    fn sub_mul(self, a: Self::Raw, b: Self::Raw, c: Self::Raw) -> Self::Raw;
    fn max(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn min(self, a: Self::Raw, b: Self::Raw) -> Self::Raw;
    fn sqrt(self, a: Self::Raw) -> Self::Raw;
    fn abs(self, a: Self::Raw) -> Self::Raw;
    /// False where one of them is not a number.
    fn less(self, a: Self::Raw, b: Self::Raw) -> Self::Mask;
    fn and(self, a: Self::Mask, b: Self::Mask) -> Self::Mask;
    fn all(self, mask: Self::Mask) -> bool;
    fn select(self, mask: Self::Mask, yes: Self::Raw, no: Self::Raw) -> Self::Raw;
}

/// A lane that gathers from nodes, which lie one after the other, into elements side by side, and scatters back.
pub(crate) trait GatherScatter: Lane {
    /// Coordinates of one node, in the numbers of the springs; the fourth is 0.
    type Node: Lane<Real = Self::Real>;
    /// The position of one node.
    type Position: Lane<Real = f64>;

    fn node(self) -> Self::Node;
    fn position(self) -> Self::Position;
    fn load_node(self, from: <Self::Real as Real>::Quad) -> <Self::Node as Lane>::Raw;
    fn store_node(self, raw: <Self::Node as Lane>::Raw) -> <Self::Real as Real>::Quad;
    fn load_position(self, from: <f64 as Real>::Quad) -> <Self::Position as Lane>::Raw;
    fn store_position(self, raw: <Self::Position as Lane>::Raw) -> <f64 as Real>::Quad;
    fn widen(self, raw: <Self::Node as Lane>::Raw) -> <Self::Position as Lane>::Raw;

    /// A position, or a number of units, as the springs keep it.
    fn place(self, raw: <Self::Position as Lane>::Raw) -> <Self::Real as Real>::Place;

    /// Differences of nodes' positions, `to - from`.
    fn gather_differences(self, near: &Near<Self::Real>, from: &[u8], to: &[u8]) -> [Self::Raw; 3];
    /// The sides of triangles, from the first corner to the second, from there to the third, and back.
    #[inline(always)]
    fn gather_sides(self, near: &Near<Self::Real>, [a, b, c]: [&[u8]; 3]) -> [[Self::Raw; 3]; 3] {
        [self.gather_differences(near, a, b), self.gather_differences(near, b, c), self.gather_differences(near, c, a)]
    }
    /// Differences of nodes' velocities, `to - from`.
    fn gather_velocity_differences(
        self,
        vectors: &[<Self::Real as Real>::Quad; NODES],
        from: &[u8],
        to: &[u8],
    ) -> [Self::Raw; 3];
    /// Numbers of the elements `at`.
    fn gather(self, values: &[Self::Real; CREASES], at: &[u16]) -> Self::Raw;
    /// Writes vectors where [`row`] says; the fourth number of each is 0.
    fn scatter(self, vectors: [Self::Raw; 3], to: &mut [<Self::Real as Real>::Quad]);
}

/// Where a lane of `width` scatters vector `i`: i, i + 4 and so on lie one after the other, since shuffles are quick within
/// sixteen bytes, and slow across.
pub(super) const fn row(width: usize, i: usize) -> usize {
    i % 4 * (width / 4) + i / 4
}

/// Numbers side by side.
#[derive(Clone, Copy)]
pub(super) struct Num<L: Lane> {
    pub(super) lane: L,
    pub(super) raw: L::Raw,
}

/// Truths side by side.
#[derive(Clone, Copy)]
pub(super) struct Mask<L: Lane> {
    lane: L,
    raw: L::Mask,
}

impl<L: Lane> Num<L> {
    #[inline(always)]
    pub(super) fn splat(lane: L, x: f64) -> Self {
        Self { lane, raw: lane.splat(L::Real::of(x)) }
    }

    #[inline(always)]
    pub(super) fn of(lane: L, x: L::Real) -> Self {
        Self { lane, raw: lane.splat(x) }
    }

    #[inline(always)]
    pub(super) fn load(lane: L, from: &[L::Real]) -> Self {
        Self { lane, raw: lane.load(from) }
    }

    #[inline(always)]
    pub(super) fn store(self, to: &mut [L::Real]) {
        self.lane.store(self.raw, to);
    }

    /// `self b + c`.
    #[inline(always)]
    pub(super) fn mul_add(self, b: Self, c: Self) -> Self {
        Self { raw: self.lane.mul_add(self.raw, b.raw, c.raw), ..self }
    }

    /// `self b - c`.
    #[inline(always)]
    pub(super) fn mul_sub(self, b: Self, c: Self) -> Self {
        Self { raw: self.lane.mul_sub(self.raw, b.raw, c.raw), ..self }
    }

    /// `c - self b`.
    #[inline(always)]
    pub(super) fn sub_mul(self, b: Self, c: Self) -> Self {
        Self { raw: self.lane.sub_mul(self.raw, b.raw, c.raw), ..self }
    }

    #[inline(always)]
    pub(super) fn max(self, b: Self) -> Self {
        Self { raw: self.lane.max(self.raw, b.raw), ..self }
    }

    #[inline(always)]
    pub(super) fn min(self, b: Self) -> Self {
        Self { raw: self.lane.min(self.raw, b.raw), ..self }
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        Self { raw: self.lane.sqrt(self.raw), ..self }
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        Self { raw: self.lane.abs(self.raw), ..self }
    }

    /// To the nearest whole number, where it is not too large for whole numbers to be told apart.
    #[inline(always)]
    pub(super) fn round(self) -> Self {
        let rounding = Self::of(self.lane, L::Real::ROUNDING);
        self + rounding - rounding
    }

    #[inline(always)]
    pub(super) fn less(self, b: Self) -> Mask<L> {
        Mask { lane: self.lane, raw: self.lane.less(self.raw, b.raw) }
    }
}

impl<L: Lane> Mask<L> {
    #[inline(always)]
    pub(super) fn select(self, yes: Num<L>, no: Num<L>) -> Num<L> {
        Num { lane: self.lane, raw: self.lane.select(self.raw, yes.raw, no.raw) }
    }

    #[inline(always)]
    pub(super) fn all(self) -> bool {
        self.lane.all(self.raw)
    }
}

impl<L: Lane> BitAnd for Mask<L> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self { raw: self.lane.and(self.raw, other.raw), ..self }
    }
}

macro_rules! operator {
    ($name:ident, $function:ident) => {
        impl<L: Lane> $name for Num<L> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self { raw: self.lane.$function(self.raw, other.raw), ..self }
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<L: Lane> Neg for Num<L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::splat(self.lane, 0.0) - self
    }
}

/// Vectors side by side.
#[derive(Clone, Copy)]
pub(super) struct Vec3<L: Lane> {
    pub(super) x: Num<L>,
    pub(super) y: Num<L>,
    pub(super) z: Num<L>,
}

impl<L: Lane> Vec3<L> {
    #[inline(always)]
    pub(super) fn new(lane: L, [x, y, z]: [L::Raw; 3]) -> Self {
        Self { x: Num { lane, raw: x }, y: Num { lane, raw: y }, z: Num { lane, raw: z } }
    }

    #[inline(always)]
    pub(super) fn raw(self) -> [L::Raw; 3] {
        [self.x.raw, self.y.raw, self.z.raw]
    }

    #[inline(always)]
    pub(super) fn dot(self, b: Self) -> Num<L> {
        self.z.mul_add(b.z, self.y.mul_add(b.y, self.x * b.x))
    }

    #[inline(always)]
    pub(super) fn cross(self, b: Self) -> Self {
        Self {
            x: self.y.mul_sub(b.z, self.z * b.y),
            y: self.z.mul_sub(b.x, self.x * b.z),
            z: self.x.mul_sub(b.y, self.y * b.x),
        }
    }

    /// `self k + c`.
    #[inline(always)]
    pub(super) fn mul_add(self, k: Num<L>, c: Self) -> Self {
        Self { x: self.x.mul_add(k, c.x), y: self.y.mul_add(k, c.y), z: self.z.mul_add(k, c.z) }
    }

    /// `c - self k`.
    #[inline(always)]
    pub(super) fn sub_mul(self, k: Num<L>, c: Self) -> Self {
        Self { x: self.x.sub_mul(k, c.x), y: self.y.sub_mul(k, c.y), z: self.z.sub_mul(k, c.z) }
    }
}

impl<L: Lane> Add for Vec3<L> {
    type Output = Self;

    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self { x: self.x + b.x, y: self.y + b.y, z: self.z + b.z }
    }
}

impl<L: Lane> Mul<Num<L>> for Vec3<L> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, k: Num<L>) -> Self {
        Self { x: self.x * k, y: self.y * k, z: self.z * k }
    }
}

impl<L: Lane> Neg for Vec3<L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}
