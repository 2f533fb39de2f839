//! The numbers of the springs, and the vectors of the nodes.

use std::fmt::Debug;

use bytemuck::{Pod, Zeroable};
use glam::DVec3;

/// The numbers in which springs are computed: f64, or f32 where positions alone are f64.
pub(crate) trait Real: Pod + Default + Debug + Send + Sync {
    /// Three coordinates and a 0, aligned so that they are read at once.
    type Quad: Pod + Default + Debug + Send + Sync;
    /// Where a node is, in its block (see [`near`](super::near)).
    type Place: Copy + Default + Debug + Send + Sync;
    /// Whether places are whole numbers.
    const WHOLE: bool;
    /// The nodes of the filling, a sound hinge: ends, then apexes.
    const FILLING: [Self::Place; 4];
    /// The least that has all its digits.
    const LEAST: f64;
    /// The distance from 1 to the next number.
    const EPSILON: f64;
    /// Adding it and taking it away rounds to a whole number.
    const ROUNDING: Self;
    /// `(atan t / t - 1) / t^2` by powers of `t^2`, fitted to `|t| <= tan(pi / 8)` (Remez), highest power first.
    const ARCTANGENT: &'static [f64];
    /// The same of Taylor's series, for `|t| < 0.1`.
    const SHORT_ARCTANGENT: &'static [f64];

    fn of(x: f64) -> Self;
    fn to_f64(self) -> f64;
    fn quad(numbers: [Self; 4]) -> Self::Quad;
    fn numbers(quad: Self::Quad) -> [Self; 4];

    fn quad_of(v: DVec3) -> Self::Quad {
        Self::quad([v.x, v.y, v.z, 0.0].map(Self::of))
    }

    fn vector(quad: Self::Quad) -> DVec3 {
        let [x, y, z, _] = Self::numbers(quad).map(Self::to_f64);
        DVec3::new(x, y, z)
    }
}

/// Of f64.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C, align(32))]
pub(crate) struct Quad64(pub(super) [f64; 4]);

/// Of f32.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C, align(16))]
pub(crate) struct Quad32(pub(super) [f32; 4]);

/// Three whole numbers and a 0.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C, align(16))]
pub(crate) struct Whole32(pub(super) [i32; 4]);

impl Real for f64 {
    type Quad = Quad64;
    type Place = Quad64;
    const WHOLE: bool = false;
    const FILLING: [Quad64; 4] = [
        Quad64([0.0, 0.0, 0.0, 0.0]),
        Quad64([1.0, 0.0, 0.0, 0.0]),
        Quad64([0.5, 1.0, 0.0, 0.0]),
        Quad64([0.5, -1.0, 0.0, 0.0]),
    ];
    const LEAST: f64 = f64::MIN_POSITIVE;
    const EPSILON: f64 = f64::EPSILON;
    const ROUNDING: f64 = 6_755_399_441_055_744.0;
    const ARCTANGENT: &'static [f64] = &[
        0.021259847946894866,
        -0.043590956524437834,
        0.056925391671597776,
        -0.06641121231628062,
        0.07690068305680631,
        -0.0909078241284395,
        0.11111106653603098,
        -0.14285714195261662,
        0.19999999999088958,
        -0.3333333333333015,
    ];
    const SHORT_ARCTANGENT: &'static [f64] =
        &[-1.0 / 15.0, 1.0 / 13.0, -1.0 / 11.0, 1.0 / 9.0, -1.0 / 7.0, 1.0 / 5.0, -1.0 / 3.0];

    #[inline(always)]
    fn of(x: f64) -> f64 {
        x
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline(always)]
    fn quad(numbers: [f64; 4]) -> Quad64 {
        Quad64(numbers)
    }

    #[inline(always)]
    fn numbers(quad: Quad64) -> [f64; 4] {
        quad.0
    }
}

impl Real for f32 {
    type Quad = Quad32;
    type Place = Whole32;
    const WHOLE: bool = true;
    const FILLING: [Whole32; 4] = {
        let half = 1 << 24;
        [
            Whole32([0; 4]),
            Whole32([2 * half, 0, 0, 0]),
            Whole32([half, 2 * half, 0, 0]),
            Whole32([half, -2 * half, 0, 0]),
        ]
    };
    const LEAST: f64 = f32::MIN_POSITIVE as f64;
    const EPSILON: f64 = f32::EPSILON as f64;
    const ROUNDING: f32 = 12_582_912.0;
    const ARCTANGENT: &'static [f64] =
        &[-0.060_782_212_6, 0.105_938_136_6, -0.142_435_333_3, 0.199_984_715_1, -0.333_333_151_9];
    const SHORT_ARCTANGENT: &'static [f64] = &[-1.0 / 7.0, 1.0 / 5.0, -1.0 / 3.0];

    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "rounding is what is asked for")]
    fn of(x: f64) -> f32 {
        x as f32
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }

    #[inline(always)]
    fn quad(numbers: [f32; 4]) -> Quad32 {
        Quad32(numbers)
    }

    #[inline(always)]
    fn numbers(quad: Quad32) -> [f32; 4] {
        quad.0
    }
}
