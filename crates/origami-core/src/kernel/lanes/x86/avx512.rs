//! Eight f64, or sixteen f32.

use std::arch::x86_64::{__m128, __m256d, __m512, __m512d, _CMP_LT_OQ};

use bytemuck::cast;
use pulp::x86::V4;

use super::avx2::{D4, S4};
use super::rows::{first, first_mut, gather_d4, gather_s8, halves};
use super::wide_rows::{
    gather_differences_d8, gather_differences_s16, gather_sides_s16, gather_velocity_differences_s16, join_d8,
    join_s16, rows_d8, rows_s16,
};
use crate::kernel::blocks::{CREASES, NODES};
use crate::kernel::lane::{GatherScatter, Lane};
use crate::kernel::near::Near;
use crate::kernel::real::{Quad32, Quad64, Whole32};

/// Eight f64.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct D8(pub(in crate::kernel) V4);
/// Sixteen f32.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct S16(pub(in crate::kernel) V4);

lane! {
    D8: f64 x 8, __m512d, u8;
    avx512f: _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_sqrt_pd, _mm512_set1_pd, _mm512_max_pd, _mm512_min_pd;
    avx512f: _mm512_fmadd_pd, _mm512_fmsub_pd, _mm512_fnmadd_pd;
    abs(lane, a) = lane.0.avx512f._mm512_abs_pd(a);
    less(lane, a, b) = lane.0.avx512f._mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b);
    and(lane, a, b) = {
        let _ = lane;
        a & b
    };
    all(lane, mask) = {
        let _ = lane;
        mask == u8::MAX
    };
    select(lane, mask, yes, no) = lane.0.avx512f._mm512_mask_blend_pd(mask, no, yes);
}

lane! {
    S16: f32 x 16, __m512, u16;
    avx512f: _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps, _mm512_sqrt_ps, _mm512_set1_ps, _mm512_max_ps, _mm512_min_ps;
    avx512f: _mm512_fmadd_ps, _mm512_fmsub_ps, _mm512_fnmadd_ps;
    abs(lane, a) = lane.0.avx512f._mm512_abs_ps(a);
    less(lane, a, b) = lane.0.avx512f._mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b);
    and(lane, a, b) = {
        let _ = lane;
        a & b
    };
    all(lane, mask) = {
        let _ = lane;
        mask == u16::MAX
    };
    select(lane, mask, yes, no) = lane.0.avx512f._mm512_mask_blend_ps(mask, no, yes);
}

impl GatherScatter for D8 {
    nodes! {
        D4, __m256d, Quad64; |own| *own.0;
        widen(_lane, raw) = raw;
    }

    #[inline(always)]
    fn place(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn gather_differences(self, near: &Near<f64>, from: &[u8], to: &[u8]) -> [__m512d; 3] {
        gather_differences_d8(self.0, &near.places, first(from), first(to))
    }

    #[inline(always)]
    fn gather_velocity_differences(self, vectors: &[Quad64; NODES], from: &[u8], to: &[u8]) -> [__m512d; 3] {
        gather_differences_d8(self.0, vectors, first(from), first(to))
    }

    #[inline(always)]
    fn gather(self, values: &[f64; CREASES], at: &[u16]) -> __m512d {
        let [low, high] = halves(at);
        join_d8(self.0, gather_d4(*self.0, values, low), gather_d4(*self.0, values, high))
    }

    #[inline(always)]
    fn scatter(self, vectors: [__m512d; 3], to: &mut [Quad64]) {
        rows_d8(self.0, vectors, first_mut(to));
    }
}

impl GatherScatter for S16 {
    nodes! {
        S4, __m128, Quad32; |own| *own.0;
        widen(lane, raw) = lane.0.avx._mm256_cvtps_pd(raw);
    }

    #[inline(always)]
    fn place(self, raw: __m256d) -> Whole32 {
        Whole32(cast(self.0.avx._mm256_cvtpd_epi32(raw)))
    }

    #[inline(always)]
    fn gather_differences(self, near: &Near<f32>, from: &[u8], to: &[u8]) -> [__m512; 3] {
        gather_differences_s16(self.0, near, first(from), first(to))
    }

    #[inline(always)]
    fn gather_sides(self, near: &Near<f32>, [a, b, c]: [&[u8]; 3]) -> [[__m512; 3]; 3] {
        gather_sides_s16(self.0, near, [first(a), first(b), first(c)])
    }

    #[inline(always)]
    fn gather_velocity_differences(self, vectors: &[Quad32; NODES], from: &[u8], to: &[u8]) -> [__m512; 3] {
        gather_velocity_differences_s16(self.0, vectors, first(from), first(to))
    }

    #[inline(always)]
    fn gather(self, values: &[f32; CREASES], at: &[u16]) -> __m512 {
        let [low, high] = halves(at);
        join_s16(self.0, gather_s8(*self.0, values, low), gather_s8(*self.0, values, high))
    }

    #[inline(always)]
    fn scatter(self, vectors: [__m512; 3], to: &mut [Quad32]) {
        rows_s16(self.0, vectors, first_mut(to));
    }
}
