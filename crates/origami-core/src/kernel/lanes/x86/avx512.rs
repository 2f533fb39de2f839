//! Eight f64, or sixteen f32: what AVX2 does with either half of them, where they come from nodes.

use std::arch::x86_64::{__m128, __m256, __m256d, __m512, __m512d, _CMP_LT_OQ};

use bytemuck::cast;
use pulp::x86::V4;

use super::avx2::{D4, S4};
use super::rows::{apart_s8, between_d4, between_s8, first_mut, halves, pick_d4, pick_s8, rows_d4, rows_s8};
use crate::kernel::lane::{Lane, Mesh};
use crate::kernel::real::{Quad32, Quad64};

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

impl D8 {
    #[inline(always)]
    fn low(self, [x, y, z]: [__m512d; 3]) -> [__m256d; 3] {
        let v = self.0;
        [v.avx512f._mm512_castpd512_pd256(x), v.avx512f._mm512_castpd512_pd256(y), v.avx512f._mm512_castpd512_pd256(z)]
    }

    #[inline(always)]
    fn high(self, [x, y, z]: [__m512d; 3]) -> [__m256d; 3] {
        let v = self.0;
        [
            v.avx512f._mm512_extractf64x4_pd::<1>(x),
            v.avx512f._mm512_extractf64x4_pd::<1>(y),
            v.avx512f._mm512_extractf64x4_pd::<1>(z),
        ]
    }

    #[inline(always)]
    fn join(self, low: __m256d, high: __m256d) -> __m512d {
        self.0.avx512f._mm512_insertf64x4::<1>(self.0.avx512f._mm512_castpd256_pd512(low), high)
    }
}

impl S16 {
    #[inline(always)]
    fn low(self, [x, y, z]: [__m512; 3]) -> [__m256; 3] {
        let v = self.0;
        [v.avx512f._mm512_castps512_ps256(x), v.avx512f._mm512_castps512_ps256(y), v.avx512f._mm512_castps512_ps256(z)]
    }

    #[inline(always)]
    fn high(self, [x, y, z]: [__m512; 3]) -> [__m256; 3] {
        let v = self.0;
        [
            v.avx512dq._mm512_extractf32x8_ps::<1>(x),
            v.avx512dq._mm512_extractf32x8_ps::<1>(y),
            v.avx512dq._mm512_extractf32x8_ps::<1>(z),
        ]
    }

    #[inline(always)]
    fn join(self, low: __m256, high: __m256) -> __m512 {
        self.0.avx512dq._mm512_insertf32x8::<1>(self.0.avx512f._mm512_castps256_ps512(low), high)
    }
}

impl Mesh for D8 {
    nodes_of_f64!(|own| *own.0);

    #[inline(always)]
    fn between(self, places: &[Quad64], from: &[u32], to: &[u32]) -> [__m512d; 3] {
        let ([from, from_high], [to, to_high]) = (halves(from), halves(to));
        let (low, high) = (between_d4(*self.0, places, from, to), between_d4(*self.0, places, from_high, to_high));
        [self.join(low[0], high[0]), self.join(low[1], high[1]), self.join(low[2], high[2])]
    }

    #[inline(always)]
    fn apart(self, vectors: &[Quad64], from: &[u32], to: &[u32]) -> [__m512d; 3] {
        self.between(vectors, from, to)
    }

    #[inline(always)]
    fn pick(self, values: &[f64], at: &[u32]) -> __m512d {
        let [low, high] = halves(at);
        self.join(pick_d4(*self.0, values, low), pick_d4(*self.0, values, high))
    }

    #[inline(always)]
    fn spread(self, vectors: [__m512d; 3], to: &mut [Quad64]) {
        let (low, high) = to.split_at_mut(4);
        rows_d4(*self.0, self.low(vectors), first_mut(low));
        rows_d4(*self.0, self.high(vectors), first_mut(high));
    }
}

impl Mesh for S16 {
    nodes_of_f32!(|own| *own.0);

    #[inline(always)]
    fn between(self, places: &[Quad64], from: &[u32], to: &[u32]) -> [__m512; 3] {
        let ([from, from_high], [to, to_high]) = (halves(from), halves(to));
        let (low, high) = (between_s8(*self.0, places, from, to), between_s8(*self.0, places, from_high, to_high));
        [self.join(low[0], high[0]), self.join(low[1], high[1]), self.join(low[2], high[2])]
    }

    #[inline(always)]
    fn apart(self, vectors: &[Quad32], from: &[u32], to: &[u32]) -> [__m512; 3] {
        let ([from, from_high], [to, to_high]) = (halves(from), halves(to));
        let (low, high) = (apart_s8(*self.0, vectors, from, to), apart_s8(*self.0, vectors, from_high, to_high));
        [self.join(low[0], high[0]), self.join(low[1], high[1]), self.join(low[2], high[2])]
    }

    #[inline(always)]
    fn pick(self, values: &[f32], at: &[u32]) -> __m512 {
        let [low, high] = halves(at);
        self.join(pick_s8(*self.0, values, low), pick_s8(*self.0, values, high))
    }

    #[inline(always)]
    fn spread(self, vectors: [__m512; 3], to: &mut [Quad32]) {
        let (low, high) = to.split_at_mut(8);
        rows_s8(*self.0, self.low(vectors), first_mut(low));
        rows_s8(*self.0, self.high(vectors), first_mut(high));
    }
}
