//! Four f64, or eight f32.

use std::arch::x86_64::{__m128, __m256, __m256d, _CMP_LT_OQ};

use bytemuck::cast;
use pulp::x86::V3;

use super::rows::{
    first, first_mut, gather_d4, gather_differences_d4, gather_differences_s8, gather_s8, gather_sides_s8,
    gather_velocity_differences_s8, rows_d4, rows_s8,
};
use crate::kernel::blocks::{CREASES, NODES};
use crate::kernel::lane::{GatherScatter, Lane};
use crate::kernel::near::Near;
use crate::kernel::real::{Quad32, Quad64, Whole32};

/// Four f64.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct D4(pub(in crate::kernel) V3);
/// Eight f32.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct S8(pub(in crate::kernel) V3);
/// Four f32: one node.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct S4(pub(super) V3);

lane! {
    D4: f64 x 4, __m256d, __m256d;
    avx: _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_sqrt_pd, _mm256_set1_pd, _mm256_max_pd, _mm256_min_pd;
    fma: _mm256_fmadd_pd, _mm256_fmsub_pd, _mm256_fnmadd_pd;
    abs(lane, a) = lane.0.avx._mm256_andnot_pd(lane.splat(-0.0), a);
    less(lane, a, b) = lane.0.avx._mm256_cmp_pd::<_CMP_LT_OQ>(a, b);
    and(lane, a, b) = lane.0.avx._mm256_and_pd(a, b);
    all(lane, mask) = lane.0.avx._mm256_movemask_pd(mask) == 0xf;
    select(lane, mask, yes, no) = lane.0.avx._mm256_blendv_pd(no, yes, mask);
}

lane! {
    S8: f32 x 8, __m256, __m256;
    avx: _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps, _mm256_sqrt_ps, _mm256_set1_ps, _mm256_max_ps, _mm256_min_ps;
    fma: _mm256_fmadd_ps, _mm256_fmsub_ps, _mm256_fnmadd_ps;
    abs(lane, a) = lane.0.avx._mm256_andnot_ps(lane.splat(-0.0), a);
    less(lane, a, b) = lane.0.avx._mm256_cmp_ps::<_CMP_LT_OQ>(a, b);
    and(lane, a, b) = lane.0.avx._mm256_and_ps(a, b);
    all(lane, mask) = lane.0.avx._mm256_movemask_ps(mask) == 0xff;
    select(lane, mask, yes, no) = lane.0.avx._mm256_blendv_ps(no, yes, mask);
}

lane! {
    S4: f32 x 4, __m128, __m128;
    sse: _mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_div_ps, _mm_sqrt_ps, _mm_set1_ps, _mm_max_ps, _mm_min_ps;
    fma: _mm_fmadd_ps, _mm_fmsub_ps, _mm_fnmadd_ps;
    abs(lane, a) = lane.0.sse._mm_andnot_ps(lane.splat(-0.0), a);
    less(lane, a, b) = lane.0.avx._mm_cmp_ps::<_CMP_LT_OQ>(a, b);
    and(lane, a, b) = lane.0.sse._mm_and_ps(a, b);
    all(lane, mask) = lane.0.sse._mm_movemask_ps(mask) == 0xf;
    select(lane, mask, yes, no) = lane.0.sse4_1._mm_blendv_ps(no, yes, mask);
}

impl GatherScatter for D4 {
    nodes! {
        D4, __m256d, Quad64; |own| own.0;
        widen(_lane, raw) = raw;
    }

    #[inline(always)]
    fn place(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn gather_differences(self, near: &Near<f64>, from: &[u8], to: &[u8]) -> [__m256d; 3] {
        gather_differences_d4(self.0, &near.places, first(from), first(to))
    }

    #[inline(always)]
    fn gather_velocity_differences(self, vectors: &[Quad64; NODES], from: &[u8], to: &[u8]) -> [__m256d; 3] {
        gather_differences_d4(self.0, vectors, first(from), first(to))
    }

    #[inline(always)]
    fn gather(self, values: &[f64; CREASES], at: &[u16]) -> __m256d {
        gather_d4(self.0, values, first(at))
    }

    #[inline(always)]
    fn scatter(self, vectors: [__m256d; 3], to: &mut [Quad64]) {
        rows_d4(self.0, vectors, first_mut(to));
    }
}

impl GatherScatter for S8 {
    nodes! {
        S4, __m128, Quad32; |own| own.0;
        widen(lane, raw) = lane.0.avx._mm256_cvtps_pd(raw);
    }

    #[inline(always)]
    fn place(self, raw: __m256d) -> Whole32 {
        Whole32(cast(self.0.avx._mm256_cvtpd_epi32(raw)))
    }

    #[inline(always)]
    fn gather_differences(self, near: &Near<f32>, from: &[u8], to: &[u8]) -> [__m256; 3] {
        gather_differences_s8(self.0, near, first(from), first(to))
    }

    #[inline(always)]
    fn gather_sides(self, near: &Near<f32>, [a, b, c]: [&[u8]; 3]) -> [[__m256; 3]; 3] {
        gather_sides_s8(self.0, near, [first(a), first(b), first(c)])
    }

    #[inline(always)]
    fn gather_velocity_differences(self, vectors: &[Quad32; NODES], from: &[u8], to: &[u8]) -> [__m256; 3] {
        gather_velocity_differences_s8(self.0, vectors, first(from), first(to))
    }

    #[inline(always)]
    fn gather(self, values: &[f32; CREASES], at: &[u16]) -> __m256 {
        gather_s8(self.0, values, first(at))
    }

    #[inline(always)]
    fn scatter(self, vectors: [__m256; 3], to: &mut [Quad32]) {
        rows_s8(self.0, vectors, first_mut(to));
    }
}
