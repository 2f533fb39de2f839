//! Four numbers in an array: right everywhere, and as fast as the compiler makes it.

use crate::kernel::blocks::{CREASES, NODES};
use crate::kernel::lane::{GatherScatter, Lane};
use crate::kernel::lookup::{moment, node};
use crate::kernel::near::Near;
use crate::kernel::real::{Quad64, Real, Whole32};

/// Four numbers. `FUSED`: products and sums are rounded once, as the other lanes do it; slow where the processor cannot.
#[derive(Clone, Copy)]
pub(in crate::kernel) struct Portable<R, const FUSED: bool>(pub(in crate::kernel) std::marker::PhantomData<R>);

/// Whether all processors that this is compiled for round a product and a sum once.
pub(in crate::kernel) const FUSES: bool = cfg!(any(target_arch = "aarch64", target_feature = "fma"));

macro_rules! portable {
    (
        $real:ty;
        place($raw:ident) = $place:expr;
        difference($from:ident, $to:ident, $c:ident, $unit:ident) = $difference:expr;
    ) => {
        impl<const FUSED: bool> Lane for Portable<$real, FUSED> {
            type Real = $real;
            type Raw = [$real; 4];
            type Mask = [bool; 4];
            const WIDTH: usize = 4;

            #[inline(always)]
            fn splat(self, x: $real) -> [$real; 4] {
                [x; 4]
            }

            #[inline(always)]
            fn load(self, from: &[$real]) -> [$real; 4] {
                *from.first_chunk().expect("as many as there are lanes")
            }

            #[inline(always)]
            fn store(self, raw: [$real; 4], to: &mut [$real]) {
                *to.first_chunk_mut().expect("as many as there are lanes") = raw;
            }

            #[inline(always)]
            fn add(self, a: [$real; 4], b: [$real; 4]) -> [$real; 4] {
                [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]]
            }

            #[inline(always)]
            fn sub(self, a: [$real; 4], b: [$real; 4]) -> [$real; 4] {
                [a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]]
            }

            #[inline(always)]
            fn mul(self, a: [$real; 4], b: [$real; 4]) -> [$real; 4] {
                [a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]]
            }

            #[inline(always)]
            fn div(self, a: [$real; 4], b: [$real; 4]) -> [$real; 4] {
                [a[0] / b[0], a[1] / b[1], a[2] / b[2], a[3] / b[3]]
            }

            #[inline(always)]
            fn mul_add(self, a: [$real; 4], b: [$real; 4], c: [$real; 4]) -> [$real; 4] {
                [
                    if FUSED { a[0].mul_add(b[0], c[0]) } else { a[0] * b[0] + c[0] },
                    if FUSED { a[1].mul_add(b[1], c[1]) } else { a[1] * b[1] + c[1] },
                    if FUSED { a[2].mul_add(b[2], c[2]) } else { a[2] * b[2] + c[2] },
                    if FUSED { a[3].mul_add(b[3], c[3]) } else { a[3] * b[3] + c[3] },
                ]
            }

            #[inline(always)]
            fn mul_sub(self, a: [$real; 4], b: [$real; 4], c: [$real; 4]) -> [$real; 4] {
                [
                    if FUSED { a[0].mul_add(b[0], -c[0]) } else { a[0] * b[0] - c[0] },
                    if FUSED { a[1].mul_add(b[1], -c[1]) } else { a[1] * b[1] - c[1] },
                    if FUSED { a[2].mul_add(b[2], -c[2]) } else { a[2] * b[2] - c[2] },
                    if FUSED { a[3].mul_add(b[3], -c[3]) } else { a[3] * b[3] - c[3] },
                ]
            }

            #[inline(always)]
            fn sub_mul(self, a: [$real; 4], b: [$real; 4], c: [$real; 4]) -> [$real; 4] {
                [
                    if FUSED { (-a[0]).mul_add(b[0], c[0]) } else { c[0] - a[0] * b[0] },
                    if FUSED { (-a[1]).mul_add(b[1], c[1]) } else { c[1] - a[1] * b[1] },
                    if FUSED { (-a[2]).mul_add(b[2], c[2]) } else { c[2] - a[2] * b[2] },
                    if FUSED { (-a[3]).mul_add(b[3], c[3]) } else { c[3] - a[3] * b[3] },
                ]
            }

            #[inline(always)]
            fn max(self, a: [$real; 4], b: [$real; 4]) -> [$real; 4] {
                // As x86 has it: the second where they cannot be compared.
                [
                    if a[0] > b[0] { a[0] } else { b[0] },
                    if a[1] > b[1] { a[1] } else { b[1] },
                    if a[2] > b[2] { a[2] } else { b[2] },
                    if a[3] > b[3] { a[3] } else { b[3] },
                ]
            }

            #[inline(always)]
            fn min(self, a: [$real; 4], b: [$real; 4]) -> [$real; 4] {
                [
                    if a[0] < b[0] { a[0] } else { b[0] },
                    if a[1] < b[1] { a[1] } else { b[1] },
                    if a[2] < b[2] { a[2] } else { b[2] },
                    if a[3] < b[3] { a[3] } else { b[3] },
                ]
            }

            #[inline(always)]
            fn sqrt(self, a: [$real; 4]) -> [$real; 4] {
                [a[0].sqrt(), a[1].sqrt(), a[2].sqrt(), a[3].sqrt()]
            }

            #[inline(always)]
            fn abs(self, a: [$real; 4]) -> [$real; 4] {
                [a[0].abs(), a[1].abs(), a[2].abs(), a[3].abs()]
            }

            #[inline(always)]
            fn less(self, a: [$real; 4], b: [$real; 4]) -> [bool; 4] {
                [a[0] < b[0], a[1] < b[1], a[2] < b[2], a[3] < b[3]]
            }

            #[inline(always)]
            fn and(self, a: [bool; 4], b: [bool; 4]) -> [bool; 4] {
                [a[0] & b[0], a[1] & b[1], a[2] & b[2], a[3] & b[3]]
            }

            #[inline(always)]
            fn all(self, mask: [bool; 4]) -> bool {
                mask == [true; 4]
            }

            #[inline(always)]
            fn select(self, mask: [bool; 4], yes: [$real; 4], no: [$real; 4]) -> [$real; 4] {
                [
                    if mask[0] { yes[0] } else { no[0] },
                    if mask[1] { yes[1] } else { no[1] },
                    if mask[2] { yes[2] } else { no[2] },
                    if mask[3] { yes[3] } else { no[3] },
                ]
            }
        }

        impl<const FUSED: bool> GatherScatter for Portable<$real, FUSED> {
            type Node = Self;
            type Position = Portable<f64, FUSED>;

            #[inline(always)]
            fn node(self) -> Self {
                self
            }

            #[inline(always)]
            fn position(self) -> Portable<f64, FUSED> {
                Portable(std::marker::PhantomData)
            }

            #[inline(always)]
            fn load_node(self, from: <$real as Real>::Quad) -> [$real; 4] {
                from.0
            }

            #[inline(always)]
            fn store_node(self, raw: [$real; 4]) -> <$real as Real>::Quad {
                <$real>::quad(raw)
            }

            #[inline(always)]
            fn load_position(self, from: Quad64) -> [f64; 4] {
                from.0
            }

            #[inline(always)]
            fn store_position(self, raw: [f64; 4]) -> Quad64 {
                Quad64(raw)
            }

            #[inline(always)]
            fn widen(self, raw: [$real; 4]) -> [f64; 4] {
                [raw[0].to_f64(), raw[1].to_f64(), raw[2].to_f64(), raw[3].to_f64()]
            }

            #[inline(always)]
            fn place(self, $raw: [f64; 4]) -> <$real as Real>::Place {
                $place
            }

            #[inline(always)]
            fn gather_differences(self, near: &Near<$real>, from: &[u8], to: &[u8]) -> [[$real; 4]; 3] {
                let mut differences = [[0.0; 4]; 3];
                for i in 0..4 {
                    let ($from, $to) = (node(&near.places, from[i]).0, node(&near.places, to[i]).0);
                    for c in 0..3 {
                        let $c = c;
                        let $unit = near.unit;
                        differences[c][i] = $difference;
                    }
                }
                differences
            }

            #[inline(always)]
            fn gather_velocity_differences(
                self,
                vectors: &[<$real as Real>::Quad; NODES],
                from: &[u8],
                to: &[u8],
            ) -> [[$real; 4]; 3] {
                let mut differences = [[0.0; 4]; 3];
                for i in 0..4 {
                    let (from, to) = (node(vectors, from[i]).0, node(vectors, to[i]).0);
                    for c in 0..3 {
                        differences[c][i] = to[c] - from[c];
                    }
                }
                differences
            }

            #[inline(always)]
            fn gather(self, values: &[$real; CREASES], at: &[u16]) -> [$real; 4] {
                [moment(values, at[0]), moment(values, at[1]), moment(values, at[2]), moment(values, at[3])]
            }

            #[inline(always)]
            fn scatter(self, [x, y, z]: [[$real; 4]; 3], to: &mut [<$real as Real>::Quad]) {
                for i in 0..4 {
                    to[i] = <$real>::quad([x[i], y[i], z[i], 0.0]);
                }
            }
        }
    };
}

portable! {
    f64;
    place(raw) = Quad64(raw);
    difference(from, to, c, _unit) = to[c] - from[c];
}

portable! {
    f32;
    place(raw) = Whole32([rounded(raw[0]), rounded(raw[1]), rounded(raw[2]), 0]);
    difference(from, to, c, unit) = to[c].wrapping_sub(from[c]) as f32 * unit;
}

/// The nearest whole number, as all lanes round: beside so large a number, the last bits of a sum are its.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "the other bits are of the large number")]
fn rounded(x: f64) -> i32 {
    (x + f64::ROUNDING).to_bits() as i32
}
