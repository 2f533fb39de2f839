//! WebAssembly's vectors: two of them are four numbers, and every one of the portable lanes' bits.

use core::arch::wasm32::{
    f64x2_abs, f64x2_add, f64x2_div, f64x2_lt, f64x2_mul, f64x2_pmax, f64x2_pmin, f64x2_splat, f64x2_sqrt, f64x2_sub,
    i64x2_all_true, i64x2_shuffle, v128, v128_and, v128_bitselect,
};

use crate::kernel::blocks::{CREASES, NODES};
use crate::kernel::lane::{GatherScatter, Lane};
use crate::kernel::lookup::{moment, node};
use crate::kernel::near::Near;
use crate::kernel::real::Quad64;

/// Four numbers of 64 bits. A product and a sum are rounded each: there is no instruction that does both at once.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct Twice2;

#[inline(always)]
fn numbers(vectors: [v128; 2]) -> [f64; 4] {
    bytemuck::cast(vectors)
}

#[inline(always)]
fn vectors(numbers: [f64; 4]) -> [v128; 2] {
    bytemuck::cast(numbers)
}

/// Vectors of four elements as x, y and z of all of them.
#[inline(always)]
fn turned(rows: [[v128; 2]; 4]) -> [[v128; 2]; 3] {
    let [[a, az], [b, bz], [c, cz], [d, dz]] = rows;
    [
        [i64x2_shuffle::<0, 2>(a, b), i64x2_shuffle::<0, 2>(c, d)],
        [i64x2_shuffle::<1, 3>(a, b), i64x2_shuffle::<1, 3>(c, d)],
        [i64x2_shuffle::<0, 2>(az, bz), i64x2_shuffle::<0, 2>(cz, dz)],
    ]
}

impl Lane for Twice2 {
    type Real = f64;
    type Raw = [v128; 2];
    type Mask = [v128; 2];
    const WIDTH: usize = 4;

    #[inline(always)]
    fn splat(self, x: f64) -> [v128; 2] {
        [f64x2_splat(x); 2]
    }

    #[inline(always)]
    fn load(self, from: &[f64]) -> [v128; 2] {
        vectors(*from.first_chunk().expect("as many as there are lanes"))
    }

    #[inline(always)]
    fn store(self, raw: [v128; 2], to: &mut [f64]) {
        *to.first_chunk_mut().expect("as many as there are lanes") = numbers(raw);
    }

    #[inline(always)]
    fn add(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        [f64x2_add(a[0], b[0]), f64x2_add(a[1], b[1])]
    }

    #[inline(always)]
    fn sub(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        [f64x2_sub(a[0], b[0]), f64x2_sub(a[1], b[1])]
    }

    #[inline(always)]
    fn mul(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        [f64x2_mul(a[0], b[0]), f64x2_mul(a[1], b[1])]
    }

    #[inline(always)]
    fn div(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        [f64x2_div(a[0], b[0]), f64x2_div(a[1], b[1])]
    }

    #[inline(always)]
    fn mul_add(self, a: [v128; 2], b: [v128; 2], c: [v128; 2]) -> [v128; 2] {
        self.add(self.mul(a, b), c)
    }

    #[inline(always)]
    fn mul_sub(self, a: [v128; 2], b: [v128; 2], c: [v128; 2]) -> [v128; 2] {
        self.sub(self.mul(a, b), c)
    }

    #[inline(always)]
    fn sub_mul(self, a: [v128; 2], b: [v128; 2], c: [v128; 2]) -> [v128; 2] {
        self.sub(c, self.mul(a, b))
    }

    #[inline(always)]
    fn max(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        // As x86 has it: the second where they cannot be compared.
        [f64x2_pmax(b[0], a[0]), f64x2_pmax(b[1], a[1])]
    }

    #[inline(always)]
    fn min(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        [f64x2_pmin(b[0], a[0]), f64x2_pmin(b[1], a[1])]
    }

    #[inline(always)]
    fn sqrt(self, [a, b]: [v128; 2]) -> [v128; 2] {
        [f64x2_sqrt(a), f64x2_sqrt(b)]
    }

    #[inline(always)]
    fn abs(self, [a, b]: [v128; 2]) -> [v128; 2] {
        [f64x2_abs(a), f64x2_abs(b)]
    }

    #[inline(always)]
    fn less(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        [f64x2_lt(a[0], b[0]), f64x2_lt(a[1], b[1])]
    }

    #[inline(always)]
    fn and(self, a: [v128; 2], b: [v128; 2]) -> [v128; 2] {
        [v128_and(a[0], b[0]), v128_and(a[1], b[1])]
    }

    #[inline(always)]
    fn all(self, [a, b]: [v128; 2]) -> bool {
        i64x2_all_true(a) && i64x2_all_true(b)
    }

    #[inline(always)]
    fn select(self, [m, n]: [v128; 2], [a, b]: [v128; 2], [c, d]: [v128; 2]) -> [v128; 2] {
        [v128_bitselect(a, c, m), v128_bitselect(b, d, n)]
    }
}

impl GatherScatter for Twice2 {
    type Node = Self;
    type Position = Self;

    #[inline(always)]
    fn node(self) -> Self {
        self
    }

    #[inline(always)]
    fn position(self) -> Self {
        self
    }

    #[inline(always)]
    fn load_node(self, from: Quad64) -> [v128; 2] {
        vectors(from.0)
    }

    #[inline(always)]
    fn store_node(self, raw: [v128; 2]) -> Quad64 {
        Quad64(numbers(raw))
    }

    #[inline(always)]
    fn load_position(self, from: Quad64) -> [v128; 2] {
        vectors(from.0)
    }

    #[inline(always)]
    fn store_position(self, raw: [v128; 2]) -> Quad64 {
        Quad64(numbers(raw))
    }

    #[inline(always)]
    fn widen(self, raw: [v128; 2]) -> [v128; 2] {
        raw
    }

    #[inline(always)]
    fn place(self, raw: [v128; 2]) -> Quad64 {
        Quad64(numbers(raw))
    }

    #[inline(always)]
    fn gather_differences(self, near: &Near<f64>, from: &[u8], to: &[u8]) -> [[v128; 2]; 3] {
        let row = |i: usize| {
            let (from, to) = (node(&near.places, from[i]).0, node(&near.places, to[i]).0);
            self.sub(vectors(to), vectors(from))
        };
        turned([row(0), row(1), row(2), row(3)])
    }

    #[inline(always)]
    fn gather_velocity_differences(self, of_nodes: &[Quad64; NODES], from: &[u8], to: &[u8]) -> [[v128; 2]; 3] {
        let row = |i: usize| {
            let (from, to) = (node(of_nodes, from[i]).0, node(of_nodes, to[i]).0);
            self.sub(vectors(to), vectors(from))
        };
        turned([row(0), row(1), row(2), row(3)])
    }

    #[inline(always)]
    fn gather(self, values: &[f64; CREASES], at: &[u16]) -> [v128; 2] {
        vectors([moment(values, at[0]), moment(values, at[1]), moment(values, at[2]), moment(values, at[3])])
    }

    #[inline(always)]
    fn scatter(self, [x, y, z]: [[v128; 2]; 3], to: &mut [Quad64]) {
        let none = f64x2_splat(0.0);
        for half in 0..2 {
            let pair = |low, high| Quad64(numbers([low, high]));
            to[2 * half] = pair(i64x2_shuffle::<0, 2>(x[half], y[half]), i64x2_shuffle::<0, 2>(z[half], none));
            to[2 * half + 1] = pair(i64x2_shuffle::<1, 3>(x[half], y[half]), i64x2_shuffle::<1, 3>(z[half], none));
        }
    }
}
