//! Lanes of AVX2 with FMA, and of AVX-512. The intrinsics are pulp's, which are safe: its tokens can only be had where the
//! processor has the instructions. No closures here, nor in the passes: the compiler may leave one outside of the functions
//! that are compiled for these instructions, and calls then cost more than what they do.

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

/// Nodes, one after the other: lanes `$node` of numbers `$raw`, kept as `$quad`. `$token` is AVX2's token, of `$own` lanes.
macro_rules! nodes {
    ($node:ident, $raw:ty, $quad:ident; |$own:ident| $token:expr; widen($lane:ident, $narrow:ident) = $wide:expr;) => {
        type Node = $node;
        type Position = D4;

        #[inline(always)]
        fn node(self) -> $node {
            let $own = self;
            $node($token)
        }

        #[inline(always)]
        fn position(self) -> D4 {
            let $own = self;
            D4($token)
        }

        #[inline(always)]
        fn load_node(self, from: $quad) -> $raw {
            cast(from.0)
        }

        #[inline(always)]
        fn store_node(self, raw: $raw) -> $quad {
            $quad(cast(raw))
        }

        #[inline(always)]
        fn load_position(self, from: Quad64) -> __m256d {
            cast(from.0)
        }

        #[inline(always)]
        fn store_position(self, raw: __m256d) -> Quad64 {
            Quad64(cast(raw))
        }

        #[inline(always)]
        fn widen(self, $narrow: $raw) -> __m256d {
            let $lane = self.node();
            $wide
        }
    };
}

mod avx2;
mod avx512;
mod rows;
mod wide_rows;

pub(in crate::kernel) use avx2::{D4, S8};
pub(in crate::kernel) use avx512::{D8, S16};
