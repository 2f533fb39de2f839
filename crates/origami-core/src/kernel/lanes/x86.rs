//! Lanes of AVX2 with FMA, and of AVX-512. The intrinsics are pulp's, which are safe: its tokens can only be had where the
//! processor has the instructions. No closures here, nor in the passes: the compiler may leave one outside of the functions
//! that are compiled for these instructions, and calls then cost more than what they do.

use std::arch::x86_64::{__m128, __m256, __m256d, __m512, __m512d, _CMP_LT_OQ};

use bytemuck::cast;
use pulp::x86::{V3, V4};

use crate::kernel::lane::{Lane, Mesh};
use crate::kernel::real::{Quad32, Quad64};

/// Four f64.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct D4(pub(in crate::kernel) V3);
/// Eight f32.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct S8(pub(in crate::kernel) V3);
/// Four f32: one node.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct S4(V3);
/// Eight f64.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct D8(pub(in crate::kernel) V4);
/// Sixteen f32.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct S16(pub(in crate::kernel) V4);

macro_rules! lane {
    (
        $name:ident: $real:ident x $width:literal, $raw:ty, $mask:ty;
        $base:ident: $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident, $splat:ident, $max:ident, $min:ident;
        $fused:ident: $mul_add:ident, $mul_sub:ident, $sub_mul:ident;
        abs($abs:ident, $of:ident) = $absolute:expr;
        less($l:ident, $la:ident, $lb:ident) = $less:expr;
        and($n:ident, $na:ident, $nb:ident) = $and:expr;
        all($w:ident, $all_of:ident) = $all:expr;
        select($s:ident, $by:ident, $yes:ident, $no:ident) = $select:expr;
    ) => {
        impl Lane for $name {
            type Real = $real;
            type Raw = $raw;
            type Mask = $mask;
            const WIDTH: usize = $width;

            #[inline(always)]
            fn splat(self, x: $real) -> $raw {
                self.0.$base.$splat(x)
            }

            #[inline(always)]
            fn load(self, from: &[$real]) -> $raw {
                let from: &[$real; $width] = from.first_chunk().expect("as many as there are lanes");
                cast(*from)
            }

            #[inline(always)]
            fn store(self, raw: $raw, to: &mut [$real]) {
                *to.first_chunk_mut::<$width>().expect("as many as there are lanes") = cast(raw);
            }

            #[inline(always)]
            fn add(self, a: $raw, b: $raw) -> $raw {
                self.0.$base.$add(a, b)
            }

            #[inline(always)]
            fn sub(self, a: $raw, b: $raw) -> $raw {
                self.0.$base.$sub(a, b)
            }

            #[inline(always)]
            fn mul(self, a: $raw, b: $raw) -> $raw {
                self.0.$base.$mul(a, b)
            }

            #[inline(always)]
            fn div(self, a: $raw, b: $raw) -> $raw {
                self.0.$base.$div(a, b)
            }

            #[inline(always)]
            fn mul_add(self, a: $raw, b: $raw, c: $raw) -> $raw {
                self.0.$fused.$mul_add(a, b, c)
            }

            #[inline(always)]
            fn mul_sub(self, a: $raw, b: $raw, c: $raw) -> $raw {
                self.0.$fused.$mul_sub(a, b, c)
            }

            #[inline(always)]
            fn sub_mul(self, a: $raw, b: $raw, c: $raw) -> $raw {
                self.0.$fused.$sub_mul(a, b, c)
            }

            #[inline(always)]
            fn max(self, a: $raw, b: $raw) -> $raw {
                self.0.$base.$max(a, b)
            }

            #[inline(always)]
            fn min(self, a: $raw, b: $raw) -> $raw {
                self.0.$base.$min(a, b)
            }

            #[inline(always)]
            fn sqrt(self, a: $raw) -> $raw {
                self.0.$base.$sqrt(a)
            }

            #[inline(always)]
            fn abs(self, $of: $raw) -> $raw {
                let $abs = self;
                $absolute
            }

            #[inline(always)]
            fn less(self, $la: $raw, $lb: $raw) -> $mask {
                let $l = self;
                $less
            }

            #[inline(always)]
            fn and(self, $na: $mask, $nb: $mask) -> $mask {
                let $n = self;
                $and
            }

            #[inline(always)]
            fn all(self, $all_of: $mask) -> bool {
                let $w = self;
                $all
            }

            #[inline(always)]
            fn select(self, $by: $mask, $yes: $raw, $no: $raw) -> $raw {
                let $s = self;
                $select
            }
        }
    };
}

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

/// Four rows of four numbers, of which the last is not wanted, to three columns.
#[inline(always)]
fn columns_d4(v: V3, [a, b, c, d]: [__m256d; 4]) -> [__m256d; 3] {
    let (xz_ab, yw_ab) = (v.avx._mm256_unpacklo_pd(a, b), v.avx._mm256_unpackhi_pd(a, b));
    let (xz_cd, yw_cd) = (v.avx._mm256_unpacklo_pd(c, d), v.avx._mm256_unpackhi_pd(c, d));
    [
        v.avx._mm256_permute2f128_pd::<0x20>(xz_ab, xz_cd),
        v.avx._mm256_permute2f128_pd::<0x20>(yw_ab, yw_cd),
        v.avx._mm256_permute2f128_pd::<0x31>(xz_ab, xz_cd),
    ]
}

/// Three columns and one of zeros to four rows.
#[inline(always)]
fn rows_d4(v: V3, [x, y, z]: [__m256d; 3], to: &mut [Quad64; 4]) {
    let zero = v.avx._mm256_setzero_pd();
    let (xy_02, xy_13) = (v.avx._mm256_unpacklo_pd(x, y), v.avx._mm256_unpackhi_pd(x, y));
    let (zw_02, zw_13) = (v.avx._mm256_unpacklo_pd(z, zero), v.avx._mm256_unpackhi_pd(z, zero));
    to[0] = Quad64(cast(v.avx._mm256_permute2f128_pd::<0x20>(xy_02, zw_02)));
    to[1] = Quad64(cast(v.avx._mm256_permute2f128_pd::<0x20>(xy_13, zw_13)));
    to[2] = Quad64(cast(v.avx._mm256_permute2f128_pd::<0x31>(xy_02, zw_02)));
    to[3] = Quad64(cast(v.avx._mm256_permute2f128_pd::<0x31>(xy_13, zw_13)));
}

/// Eight rows of four numbers, of which the last is not wanted, to three columns. Each of `pairs` holds rows i and i + 4.
#[inline(always)]
fn columns_s8(v: V3, [a, b, c, d]: [__m256; 4]) -> [__m256; 3] {
    let (xy_ab, zw_ab) = (v.avx._mm256_unpacklo_ps(a, b), v.avx._mm256_unpackhi_ps(a, b));
    let (xy_cd, zw_cd) = (v.avx._mm256_unpacklo_ps(c, d), v.avx._mm256_unpackhi_ps(c, d));
    [
        v.avx._mm256_shuffle_ps::<0x44>(xy_ab, xy_cd),
        v.avx._mm256_shuffle_ps::<0xee>(xy_ab, xy_cd),
        v.avx._mm256_shuffle_ps::<0x44>(zw_ab, zw_cd),
    ]
}

/// Three columns and one of zeros to eight rows.
#[inline(always)]
fn rows_s8(v: V3, [x, y, z]: [__m256; 3], to: &mut [Quad32; 8]) {
    let zero = v.avx._mm256_setzero_ps();
    let (xy_01, xy_23) = (v.avx._mm256_unpacklo_ps(x, y), v.avx._mm256_unpackhi_ps(x, y));
    let (zw_01, zw_23) = (v.avx._mm256_unpacklo_ps(z, zero), v.avx._mm256_unpackhi_ps(z, zero));
    rows_of_pair(v, v.avx._mm256_shuffle_ps::<0x44>(xy_01, zw_01), 0, to);
    rows_of_pair(v, v.avx._mm256_shuffle_ps::<0xee>(xy_01, zw_01), 1, to);
    rows_of_pair(v, v.avx._mm256_shuffle_ps::<0x44>(xy_23, zw_23), 2, to);
    rows_of_pair(v, v.avx._mm256_shuffle_ps::<0xee>(xy_23, zw_23), 3, to);
}

/// Rows i and i + 4.
#[inline(always)]
fn rows_of_pair(v: V3, pair: __m256, i: usize, to: &mut [Quad32; 8]) {
    to[i] = Quad32(cast(v.avx._mm256_castps256_ps128(pair)));
    to[i + 4] = Quad32(cast(v.avx._mm256_extractf128_ps::<1>(pair)));
}

/// The way between two nodes.
#[inline(always)]
fn way_d4(v: V3, vectors: &[Quad64], from: u32, to: u32) -> __m256d {
    v.avx._mm256_sub_pd(cast(vectors[to as usize].0), cast(vectors[from as usize].0))
}

/// The ways between four pairs of nodes.
#[inline(always)]
fn between_d4(v: V3, vectors: &[Quad64], from: &[u32; 4], to: &[u32; 4]) -> [__m256d; 3] {
    let (a, b) = (way_d4(v, vectors, from[0], to[0]), way_d4(v, vectors, from[1], to[1]));
    let (c, d) = (way_d4(v, vectors, from[2], to[2]), way_d4(v, vectors, from[3], to[3]));
    columns_d4(v, [a, b, c, d])
}

/// The ways between pairs i and i + 4 of nodes, in f32.
#[inline(always)]
fn ways_s8(v: V3, places: &[Quad64], from: &[u32; 8], to: &[u32; 8], i: usize) -> __m256 {
    let low = v.avx._mm256_cvtpd_ps(way_d4(v, places, from[i], to[i]));
    let high = v.avx._mm256_cvtpd_ps(way_d4(v, places, from[i + 4], to[i + 4]));
    v.avx._mm256_set_m128(high, low)
}

/// The ways between eight pairs of nodes, in f32.
#[inline(always)]
fn between_s8(v: V3, places: &[Quad64], from: &[u32; 8], to: &[u32; 8]) -> [__m256; 3] {
    let (a, b) = (ways_s8(v, places, from, to, 0), ways_s8(v, places, from, to, 1));
    let (c, d) = (ways_s8(v, places, from, to, 2), ways_s8(v, places, from, to, 3));
    columns_s8(v, [a, b, c, d])
}

/// Vectors i and i + 4.
#[inline(always)]
fn pair_s8(v: V3, vectors: &[Quad32], nodes: &[u32; 8], i: usize) -> __m256 {
    v.avx._mm256_set_m128(cast(vectors[nodes[i + 4] as usize].0), cast(vectors[nodes[i] as usize].0))
}

/// The differences between eight pairs of vectors.
#[inline(always)]
fn apart_s8(v: V3, vectors: &[Quad32], from: &[u32; 8], to: &[u32; 8]) -> [__m256; 3] {
    let a = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 0), pair_s8(v, vectors, from, 0));
    let b = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 1), pair_s8(v, vectors, from, 1));
    let c = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 2), pair_s8(v, vectors, from, 2));
    let d = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 3), pair_s8(v, vectors, from, 3));
    columns_s8(v, [a, b, c, d])
}

#[inline(always)]
fn pick_d4(v: V3, values: &[f64], at: &[u32; 4]) -> __m256d {
    let [a, b, c, d] = *at;
    v.avx._mm256_set_pd(values[d as usize], values[c as usize], values[b as usize], values[a as usize])
}

#[inline(always)]
fn pick_s8(v: V3, values: &[f32], at: &[u32; 8]) -> __m256 {
    let [a, b, c, d, e, f, g, h] = *at;
    let (a, b, c, d) = (values[a as usize], values[b as usize], values[c as usize], values[d as usize]);
    let (e, f, g, h) = (values[e as usize], values[f as usize], values[g as usize], values[h as usize]);
    v.avx._mm256_set_ps(h, g, f, e, d, c, b, a)
}

/// The first places of a list that has as many.
#[inline(always)]
fn first<const N: usize, T>(list: &[T]) -> &[T; N] {
    list.first_chunk().expect("as many as there are lanes")
}

#[inline(always)]
fn first_mut<const N: usize, T>(list: &mut [T]) -> &mut [T; N] {
    list.first_chunk_mut().expect("as many as there are lanes")
}

/// The two halves of a list of places.
#[inline(always)]
fn halves<const N: usize, T>(list: &[T]) -> [&[T; N]; 2] {
    [first(list), first(&list[N..])]
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

impl Mesh for D4 {
    type Node = D4;
    type Place = D4;

    #[inline(always)]
    fn node(self) -> D4 {
        D4(self.0)
    }

    #[inline(always)]
    fn place(self) -> D4 {
        D4(self.0)
    }

    #[inline(always)]
    fn load_node(self, from: Quad64) -> __m256d {
        cast(from.0)
    }

    #[inline(always)]
    fn store_node(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn load_place(self, from: Quad64) -> __m256d {
        cast(from.0)
    }

    #[inline(always)]
    fn store_place(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn widen(self, raw: __m256d) -> __m256d {
        raw
    }

    #[inline(always)]
    fn between(self, places: &[Quad64], from: &[u32], to: &[u32]) -> [__m256d; 3] {
        between_d4(self.0, places, first(from), first(to))
    }

    #[inline(always)]
    fn apart(self, vectors: &[Quad64], from: &[u32], to: &[u32]) -> [__m256d; 3] {
        between_d4(self.0, vectors, first(from), first(to))
    }

    #[inline(always)]
    fn pick(self, values: &[f64], at: &[u32]) -> __m256d {
        pick_d4(self.0, values, first(at))
    }

    #[inline(always)]
    fn spread(self, vectors: [__m256d; 3], to: &mut [Quad64]) {
        rows_d4(self.0, vectors, first_mut(to));
    }
}

impl Mesh for S8 {
    type Node = S4;
    type Place = D4;

    #[inline(always)]
    fn node(self) -> S4 {
        S4(self.0)
    }

    #[inline(always)]
    fn place(self) -> D4 {
        D4(self.0)
    }

    #[inline(always)]
    fn load_node(self, from: Quad32) -> __m128 {
        cast(from.0)
    }

    #[inline(always)]
    fn store_node(self, raw: __m128) -> Quad32 {
        Quad32(cast(raw))
    }

    #[inline(always)]
    fn load_place(self, from: Quad64) -> __m256d {
        cast(from.0)
    }

    #[inline(always)]
    fn store_place(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn widen(self, raw: __m128) -> __m256d {
        self.0.avx._mm256_cvtps_pd(raw)
    }

    #[inline(always)]
    fn between(self, places: &[Quad64], from: &[u32], to: &[u32]) -> [__m256; 3] {
        between_s8(self.0, places, first(from), first(to))
    }

    #[inline(always)]
    fn apart(self, vectors: &[Quad32], from: &[u32], to: &[u32]) -> [__m256; 3] {
        apart_s8(self.0, vectors, first(from), first(to))
    }

    #[inline(always)]
    fn pick(self, values: &[f32], at: &[u32]) -> __m256 {
        pick_s8(self.0, values, first(at))
    }

    #[inline(always)]
    fn spread(self, vectors: [__m256; 3], to: &mut [Quad32]) {
        rows_s8(self.0, vectors, first_mut(to));
    }
}

impl Mesh for D8 {
    type Node = D4;
    type Place = D4;

    #[inline(always)]
    fn node(self) -> D4 {
        D4(*self.0)
    }

    #[inline(always)]
    fn place(self) -> D4 {
        D4(*self.0)
    }

    #[inline(always)]
    fn load_node(self, from: Quad64) -> __m256d {
        cast(from.0)
    }

    #[inline(always)]
    fn store_node(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn load_place(self, from: Quad64) -> __m256d {
        cast(from.0)
    }

    #[inline(always)]
    fn store_place(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn widen(self, raw: __m256d) -> __m256d {
        raw
    }

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
    type Node = S4;
    type Place = D4;

    #[inline(always)]
    fn node(self) -> S4 {
        S4(*self.0)
    }

    #[inline(always)]
    fn place(self) -> D4 {
        D4(*self.0)
    }

    #[inline(always)]
    fn load_node(self, from: Quad32) -> __m128 {
        cast(from.0)
    }

    #[inline(always)]
    fn store_node(self, raw: __m128) -> Quad32 {
        Quad32(cast(raw))
    }

    #[inline(always)]
    fn load_place(self, from: Quad64) -> __m256d {
        cast(from.0)
    }

    #[inline(always)]
    fn store_place(self, raw: __m256d) -> Quad64 {
        Quad64(cast(raw))
    }

    #[inline(always)]
    fn widen(self, raw: __m128) -> __m256d {
        self.0.avx._mm256_cvtps_pd(raw)
    }

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
