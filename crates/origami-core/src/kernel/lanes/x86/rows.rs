//! From nodes, one after the other, to elements side by side, and back.

use std::arch::x86_64::{__m256, __m256d, __m256i};

use bytemuck::cast;
use pulp::x86::V3;

use crate::kernel::blocks::{CREASES, NODES};
use crate::kernel::lookup::{four_moments, node};
use crate::kernel::near::Near;
use crate::kernel::real::{Quad32, Quad64, Whole32};

/// Four rows of four numbers, of which the last is not wanted, to three columns.
#[inline(always)]
pub(super) fn columns_d4(v: V3, [a, b, c, d]: [__m256d; 4]) -> [__m256d; 3] {
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
pub(super) fn rows_d4(v: V3, [x, y, z]: [__m256d; 3], to: &mut [Quad64; 4]) {
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
pub(super) fn columns_s8(v: V3, [a, b, c, d]: [__m256; 4]) -> [__m256; 3] {
    let (xy_ab, zw_ab) = (v.avx._mm256_unpacklo_ps(a, b), v.avx._mm256_unpackhi_ps(a, b));
    let (xy_cd, zw_cd) = (v.avx._mm256_unpacklo_ps(c, d), v.avx._mm256_unpackhi_ps(c, d));
    [
        v.avx._mm256_shuffle_ps::<0x44>(xy_ab, xy_cd),
        v.avx._mm256_shuffle_ps::<0xee>(xy_ab, xy_cd),
        v.avx._mm256_shuffle_ps::<0x44>(zw_ab, zw_cd),
    ]
}

/// Three columns and one of zeros to eight rows: 0 and 4, 1 and 5, and so on.
#[inline(always)]
pub(super) fn rows_s8(v: V3, [x, y, z]: [__m256; 3], to: &mut [Quad32; 8]) {
    let zero = v.avx._mm256_setzero_ps();
    let (xy_01, xy_23) = (v.avx._mm256_unpacklo_ps(x, y), v.avx._mm256_unpackhi_ps(x, y));
    let (zw_01, zw_23) = (v.avx._mm256_unpacklo_ps(z, zero), v.avx._mm256_unpackhi_ps(z, zero));
    let (pairs, _) = to.as_chunks_mut::<2>();
    pairs[0] = cast(v.avx._mm256_shuffle_ps::<0x44>(xy_01, zw_01));
    pairs[1] = cast(v.avx._mm256_shuffle_ps::<0xee>(xy_01, zw_01));
    pairs[2] = cast(v.avx._mm256_shuffle_ps::<0x44>(xy_23, zw_23));
    pairs[3] = cast(v.avx._mm256_shuffle_ps::<0xee>(xy_23, zw_23));
}

/// The difference between two nodes.
#[inline(always)]
pub(super) fn difference_d4(v: V3, vectors: &[Quad64; NODES], from: u8, to: u8) -> __m256d {
    v.avx._mm256_sub_pd(cast(node(vectors, to).0), cast(node(vectors, from).0))
}

/// The differences between four pairs of nodes.
#[inline(always)]
pub(super) fn gather_differences_d4(v: V3, vectors: &[Quad64; NODES], from: &[u8; 4], to: &[u8; 4]) -> [__m256d; 3] {
    let (a, b) = (difference_d4(v, vectors, from[0], to[0]), difference_d4(v, vectors, from[1], to[1]));
    let (c, d) = (difference_d4(v, vectors, from[2], to[2]), difference_d4(v, vectors, from[3], to[3]));
    columns_d4(v, [a, b, c, d])
}

/// The whole numbers of nodes i and i + 4.
#[inline(always)]
fn pair_of_places(v: V3, places: &[Whole32; NODES], nodes: &[u8; 8], i: usize) -> __m256i {
    v.avx._mm256_set_m128i(cast(node(places, nodes[i + 4]).0), cast(node(places, nodes[i]).0))
}

/// Whole numbers, eight of each coordinate.
#[inline(always)]
fn whole_columns_s8(v: V3, [a, b, c, d]: [__m256i; 4]) -> [__m256i; 3] {
    let [x, y, z] = columns_s8(v, [cast(a), cast(b), cast(c), cast(d)]);
    [cast(x), cast(y), cast(z)]
}

/// What so many units are.
#[inline(always)]
fn lengths_s8(v: V3, [x, y, z]: [__m256i; 3], unit: f32) -> [__m256; 3] {
    let unit = v.avx._mm256_set1_ps(unit);
    [
        v.avx._mm256_mul_ps(v.avx._mm256_cvtepi32_ps(x), unit),
        v.avx._mm256_mul_ps(v.avx._mm256_cvtepi32_ps(y), unit),
        v.avx._mm256_mul_ps(v.avx._mm256_cvtepi32_ps(z), unit),
    ]
}

/// The differences between eight pairs of nodes.
#[inline(always)]
pub(super) fn gather_differences_s8(v: V3, near: &Near<f32>, from: &[u8; 8], to: &[u8; 8]) -> [__m256; 3] {
    let p = &near.places;
    let a = v.avx2._mm256_sub_epi32(pair_of_places(v, p, to, 0), pair_of_places(v, p, from, 0));
    let b = v.avx2._mm256_sub_epi32(pair_of_places(v, p, to, 1), pair_of_places(v, p, from, 1));
    let c = v.avx2._mm256_sub_epi32(pair_of_places(v, p, to, 2), pair_of_places(v, p, from, 2));
    let d = v.avx2._mm256_sub_epi32(pair_of_places(v, p, to, 3), pair_of_places(v, p, from, 3));
    lengths_s8(v, whole_columns_s8(v, [a, b, c, d]), near.unit)
}

/// The sides of eight triangles. Whole numbers sum to exactly 0 around a triangle: so two sides tell the third.
#[inline(always)]
pub(super) fn gather_sides_s8(v: V3, near: &Near<f32>, [a, b, c]: [&[u8; 8]; 3]) -> [[__m256; 3]; 3] {
    let p = &near.places;
    let (a_0, a_1) = (pair_of_places(v, p, a, 0), pair_of_places(v, p, a, 1));
    let (a_2, a_3) = (pair_of_places(v, p, a, 2), pair_of_places(v, p, a, 3));
    let ab = [
        v.avx2._mm256_sub_epi32(pair_of_places(v, p, b, 0), a_0),
        v.avx2._mm256_sub_epi32(pair_of_places(v, p, b, 1), a_1),
        v.avx2._mm256_sub_epi32(pair_of_places(v, p, b, 2), a_2),
        v.avx2._mm256_sub_epi32(pair_of_places(v, p, b, 3), a_3),
    ];
    let ca = [
        v.avx2._mm256_sub_epi32(a_0, pair_of_places(v, p, c, 0)),
        v.avx2._mm256_sub_epi32(a_1, pair_of_places(v, p, c, 1)),
        v.avx2._mm256_sub_epi32(a_2, pair_of_places(v, p, c, 2)),
        v.avx2._mm256_sub_epi32(a_3, pair_of_places(v, p, c, 3)),
    ];
    let (ab, ca) = (whole_columns_s8(v, ab), whole_columns_s8(v, ca));
    let zero = v.avx._mm256_setzero_si256();
    let bc = [
        v.avx2._mm256_sub_epi32(v.avx2._mm256_sub_epi32(zero, ab[0]), ca[0]),
        v.avx2._mm256_sub_epi32(v.avx2._mm256_sub_epi32(zero, ab[1]), ca[1]),
        v.avx2._mm256_sub_epi32(v.avx2._mm256_sub_epi32(zero, ab[2]), ca[2]),
    ];
    [lengths_s8(v, ab, near.unit), lengths_s8(v, bc, near.unit), lengths_s8(v, ca, near.unit)]
}

/// Vectors i and i + 4.
#[inline(always)]
pub(super) fn pair_s8(v: V3, vectors: &[Quad32; NODES], nodes: &[u8; 8], i: usize) -> __m256 {
    v.avx._mm256_set_m128(cast(node(vectors, nodes[i + 4]).0), cast(node(vectors, nodes[i]).0))
}

/// The differences between eight pairs of vectors.
#[inline(always)]
pub(super) fn gather_velocity_differences_s8(
    v: V3,
    vectors: &[Quad32; NODES],
    from: &[u8; 8],
    to: &[u8; 8],
) -> [__m256; 3] {
    let a = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 0), pair_s8(v, vectors, from, 0));
    let b = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 1), pair_s8(v, vectors, from, 1));
    let c = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 2), pair_s8(v, vectors, from, 2));
    let d = v.avx._mm256_sub_ps(pair_s8(v, vectors, to, 3), pair_s8(v, vectors, from, 3));
    columns_s8(v, [a, b, c, d])
}

#[inline(always)]
pub(super) fn gather_d4(v: V3, values: &[f64; CREASES], at: &[u16; 4]) -> __m256d {
    let [a, b, c, d] = four_moments(values, at);
    v.avx._mm256_set_pd(d, c, b, a)
}

#[inline(always)]
pub(super) fn gather_s8(v: V3, values: &[f32; CREASES], at: &[u16; 8]) -> __m256 {
    let [low, high] = halves(at);
    let ([a, b, c, d], [e, f, g, h]) = (four_moments(values, low), four_moments(values, high));
    v.avx._mm256_set_ps(h, g, f, e, d, c, b, a)
}

/// The first `N` items of a list that is at least as long.
#[inline(always)]
pub(super) fn first<const N: usize, T>(list: &[T]) -> &[T; N] {
    list.first_chunk().expect("as many as there are lanes")
}

#[inline(always)]
pub(super) fn first_mut<const N: usize, T>(list: &mut [T]) -> &mut [T; N] {
    list.first_chunk_mut().expect("as many as there are lanes")
}

/// The two halves of a list of `2 N` items.
#[inline(always)]
pub(super) fn halves<const N: usize, T>(list: &[T]) -> [&[T; N]; 2] {
    [first(list), first(&list[N..])]
}
