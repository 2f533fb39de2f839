//! From nodes, one after the other, to elements side by side, and back, over the whole width of AVX-512: shuffles are what
//! the passes spend most on, and one of these moves twice as much.

use std::arch::x86_64::{__m128, __m128i, __m256, __m256d, __m512, __m512d, __m512i};

use bytemuck::cast;
use pulp::x86::V4;

use crate::kernel::blocks::NODES;
use crate::kernel::lookup::node;
use crate::kernel::near::Near;
use crate::kernel::real::{Quad32, Quad64, Whole32};

/// Two rows of four numbers.
#[inline(always)]
fn two_d4(v: V4, vectors: &[Quad64; NODES], low: u8, high: u8) -> __m512d {
    join_d8(v, cast(node(vectors, low).0), cast(node(vectors, high).0))
}

/// The differences between pairs i and j of nodes.
#[inline(always)]
fn two_differences_d4(v: V4, vectors: &[Quad64; NODES], from: &[u8], to: &[u8], i: usize, j: usize) -> __m512d {
    v.avx512f._mm512_sub_pd(two_d4(v, vectors, to[i], to[j]), two_d4(v, vectors, from[i], from[j]))
}

/// The differences between eight pairs of nodes.
#[inline(always)]
pub(super) fn gather_differences_d8(v: V4, vectors: &[Quad64; NODES], from: &[u8; 8], to: &[u8; 8]) -> [__m512d; 3] {
    let rows_02 = two_differences_d4(v, vectors, from, to, 0, 2);
    let rows_13 = two_differences_d4(v, vectors, from, to, 1, 3);
    let rows_46 = two_differences_d4(v, vectors, from, to, 4, 6);
    let rows_57 = two_differences_d4(v, vectors, from, to, 5, 7);
    let (xz_0123, yw_0123) =
        (v.avx512f._mm512_unpacklo_pd(rows_02, rows_13), v.avx512f._mm512_unpackhi_pd(rows_02, rows_13));
    let (xz_4567, yw_4567) =
        (v.avx512f._mm512_unpacklo_pd(rows_46, rows_57), v.avx512f._mm512_unpackhi_pd(rows_46, rows_57));
    [
        v.avx512f._mm512_shuffle_f64x2::<0x88>(xz_0123, xz_4567),
        v.avx512f._mm512_shuffle_f64x2::<0x88>(yw_0123, yw_4567),
        v.avx512f._mm512_shuffle_f64x2::<0xdd>(xz_0123, xz_4567),
    ]
}

/// Three columns and one of zeros to eight rows: 0 and 4, 1 and 5, and so on.
#[inline(always)]
pub(super) fn rows_d8(v: V4, columns: [__m512d; 3], to: &mut [Quad64; 8]) {
    let (pairs, _) = to.as_chunks_mut();
    two_rows(v, columns, [0, 8, 0, 0, 4, 12, 0, 0], [0, 0, 0, 0, 0, 0, 4, 0], &mut pairs[0]);
    two_rows(v, columns, [1, 9, 0, 0, 5, 13, 0, 0], [0, 0, 1, 0, 0, 0, 5, 0], &mut pairs[1]);
    two_rows(v, columns, [2, 10, 0, 0, 6, 14, 0, 0], [0, 0, 2, 0, 0, 0, 6, 0], &mut pairs[2]);
    two_rows(v, columns, [3, 11, 0, 0, 7, 15, 0, 0], [0, 0, 3, 0, 0, 0, 7, 0], &mut pairs[3]);
}

/// From where in the columns x and y, and from where in z.
#[inline(always)]
fn two_rows(v: V4, [x, y, z]: [__m512d; 3], of_xy: [i64; 8], of_z: [i64; 8], to: &mut [Quad64; 2]) {
    let xy = v.avx512f._mm512_maskz_permutex2var_pd(0b0011_0011, x, cast(of_xy), y);
    *to = cast(v.avx512f._mm512_mask_permutexvar_pd(xy, 0b0100_0100, cast(of_z), z));
}

/// Sixteen rows of four numbers, of which the last is not wanted, to three columns: `a` holds rows 0, 4, 8 and 12, `b` the
/// next ones.
#[inline(always)]
fn columns_s16(v: V4, [a, b, c, d]: [__m512; 4]) -> [__m512; 3] {
    let (xy_ab, zw_ab) = (v.avx512f._mm512_unpacklo_ps(a, b), v.avx512f._mm512_unpackhi_ps(a, b));
    let (xy_cd, zw_cd) = (v.avx512f._mm512_unpacklo_ps(c, d), v.avx512f._mm512_unpackhi_ps(c, d));
    [
        v.avx512f._mm512_shuffle_ps::<0x44>(xy_ab, xy_cd),
        v.avx512f._mm512_shuffle_ps::<0xee>(xy_ab, xy_cd),
        v.avx512f._mm512_shuffle_ps::<0x44>(zw_ab, zw_cd),
    ]
}

/// The whole numbers of nodes i, i + 4, i + 8 and i + 12.
#[inline(always)]
fn four_places(v: V4, places: &[Whole32; NODES], nodes: &[u8; 16], i: usize) -> __m512i {
    let [a, b, c, d]: [__m128i; 4] = [
        cast(node(places, nodes[i]).0),
        cast(node(places, nodes[i + 4]).0),
        cast(node(places, nodes[i + 8]).0),
        cast(node(places, nodes[i + 12]).0),
    ];
    let all = v.avx512f._mm512_inserti32x4::<1>(v.avx512f._mm512_castsi128_si512(a), b);
    v.avx512f._mm512_inserti32x4::<3>(v.avx512f._mm512_inserti32x4::<2>(all, c), d)
}

/// Whole numbers, sixteen of each coordinate.
#[inline(always)]
fn whole_columns_s16(v: V4, [a, b, c, d]: [__m512i; 4]) -> [__m512i; 3] {
    let [x, y, z] = columns_s16(v, [cast(a), cast(b), cast(c), cast(d)]);
    [cast(x), cast(y), cast(z)]
}

/// What so many units are.
#[inline(always)]
fn lengths_s16(v: V4, [x, y, z]: [__m512i; 3], unit: f32) -> [__m512; 3] {
    let unit = v.avx512f._mm512_set1_ps(unit);
    [
        v.avx512f._mm512_mul_ps(v.avx512f._mm512_cvtepi32_ps(x), unit),
        v.avx512f._mm512_mul_ps(v.avx512f._mm512_cvtepi32_ps(y), unit),
        v.avx512f._mm512_mul_ps(v.avx512f._mm512_cvtepi32_ps(z), unit),
    ]
}

/// The differences between sixteen pairs of nodes.
#[inline(always)]
pub(super) fn gather_differences_s16(v: V4, near: &Near<f32>, from: &[u8; 16], to: &[u8; 16]) -> [__m512; 3] {
    let p = &near.places;
    let a = v.avx512f._mm512_sub_epi32(four_places(v, p, to, 0), four_places(v, p, from, 0));
    let b = v.avx512f._mm512_sub_epi32(four_places(v, p, to, 1), four_places(v, p, from, 1));
    let c = v.avx512f._mm512_sub_epi32(four_places(v, p, to, 2), four_places(v, p, from, 2));
    let d = v.avx512f._mm512_sub_epi32(four_places(v, p, to, 3), four_places(v, p, from, 3));
    lengths_s16(v, whole_columns_s16(v, [a, b, c, d]), near.unit)
}

/// The sides of sixteen triangles, of which two tell the third.
#[inline(always)]
pub(super) fn gather_sides_s16(v: V4, near: &Near<f32>, [a, b, c]: [&[u8; 16]; 3]) -> [[__m512; 3]; 3] {
    let p = &near.places;
    let (a_0, a_1) = (four_places(v, p, a, 0), four_places(v, p, a, 1));
    let (a_2, a_3) = (four_places(v, p, a, 2), four_places(v, p, a, 3));
    let ab = [
        v.avx512f._mm512_sub_epi32(four_places(v, p, b, 0), a_0),
        v.avx512f._mm512_sub_epi32(four_places(v, p, b, 1), a_1),
        v.avx512f._mm512_sub_epi32(four_places(v, p, b, 2), a_2),
        v.avx512f._mm512_sub_epi32(four_places(v, p, b, 3), a_3),
    ];
    let ca = [
        v.avx512f._mm512_sub_epi32(a_0, four_places(v, p, c, 0)),
        v.avx512f._mm512_sub_epi32(a_1, four_places(v, p, c, 1)),
        v.avx512f._mm512_sub_epi32(a_2, four_places(v, p, c, 2)),
        v.avx512f._mm512_sub_epi32(a_3, four_places(v, p, c, 3)),
    ];
    let (ab, ca) = (whole_columns_s16(v, ab), whole_columns_s16(v, ca));
    let zero = v.avx512f._mm512_setzero_si512();
    let bc = [
        v.avx512f._mm512_sub_epi32(v.avx512f._mm512_sub_epi32(zero, ab[0]), ca[0]),
        v.avx512f._mm512_sub_epi32(v.avx512f._mm512_sub_epi32(zero, ab[1]), ca[1]),
        v.avx512f._mm512_sub_epi32(v.avx512f._mm512_sub_epi32(zero, ab[2]), ca[2]),
    ];
    [lengths_s16(v, ab, near.unit), lengths_s16(v, bc, near.unit), lengths_s16(v, ca, near.unit)]
}

/// Vectors i, i + 4, i + 8 and i + 12.
#[inline(always)]
fn four_s4(v: V4, vectors: &[Quad32; NODES], nodes: &[u8; 16], i: usize) -> __m512 {
    let [a, b, c, d]: [__m128; 4] = [
        cast(node(vectors, nodes[i]).0),
        cast(node(vectors, nodes[i + 4]).0),
        cast(node(vectors, nodes[i + 8]).0),
        cast(node(vectors, nodes[i + 12]).0),
    ];
    let all = v.avx512f._mm512_insertf32x4::<1>(v.avx512f._mm512_castps128_ps512(a), b);
    v.avx512f._mm512_insertf32x4::<3>(v.avx512f._mm512_insertf32x4::<2>(all, c), d)
}

/// The differences between sixteen pairs of vectors.
#[inline(always)]
pub(super) fn gather_velocity_differences_s16(
    v: V4,
    vectors: &[Quad32; NODES],
    from: &[u8; 16],
    to: &[u8; 16],
) -> [__m512; 3] {
    let a = v.avx512f._mm512_sub_ps(four_s4(v, vectors, to, 0), four_s4(v, vectors, from, 0));
    let b = v.avx512f._mm512_sub_ps(four_s4(v, vectors, to, 1), four_s4(v, vectors, from, 1));
    let c = v.avx512f._mm512_sub_ps(four_s4(v, vectors, to, 2), four_s4(v, vectors, from, 2));
    let d = v.avx512f._mm512_sub_ps(four_s4(v, vectors, to, 3), four_s4(v, vectors, from, 3));
    columns_s16(v, [a, b, c, d])
}

/// Three columns and one of zeros to sixteen rows: 0, 4, 8 and 12, then the next ones.
#[inline(always)]
pub(super) fn rows_s16(v: V4, [x, y, z]: [__m512; 3], to: &mut [Quad32; 16]) {
    let zero = v.avx512f._mm512_setzero_ps();
    let (xy_01, xy_23) = (v.avx512f._mm512_unpacklo_ps(x, y), v.avx512f._mm512_unpackhi_ps(x, y));
    let (zw_01, zw_23) = (v.avx512f._mm512_unpacklo_ps(z, zero), v.avx512f._mm512_unpackhi_ps(z, zero));
    let (fours, _) = to.as_chunks_mut::<4>();
    fours[0] = cast(v.avx512f._mm512_shuffle_ps::<0x44>(xy_01, zw_01));
    fours[1] = cast(v.avx512f._mm512_shuffle_ps::<0xee>(xy_01, zw_01));
    fours[2] = cast(v.avx512f._mm512_shuffle_ps::<0x44>(xy_23, zw_23));
    fours[3] = cast(v.avx512f._mm512_shuffle_ps::<0xee>(xy_23, zw_23));
}

/// Four numbers each.
#[inline(always)]
pub(super) fn join_d8(v: V4, low: __m256d, high: __m256d) -> __m512d {
    v.avx512f._mm512_insertf64x4::<1>(v.avx512f._mm512_castpd256_pd512(low), high)
}

/// Eight numbers each.
#[inline(always)]
pub(super) fn join_s16(v: V4, low: __m256, high: __m256) -> __m512 {
    v.avx512dq._mm512_insertf32x8::<1>(v.avx512f._mm512_castps256_ps512(low), high)
}
