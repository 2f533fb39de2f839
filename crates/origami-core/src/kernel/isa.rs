//! Which instructions the processor has, found out when the program runs.

use std::marker::PhantomData;

use super::lane::GatherScatter;
use super::lanes::portable::{FUSES, Portable};
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use super::lanes::simd128::Twice2;
#[cfg(target_arch = "x86_64")]
use super::lanes::x86::{D4, D8, S8, S16};
use super::real::Real;
#[cfg(test)]
use super::tests::Counting;
#[cfg(target_arch = "x86_64")]
use pulp::x86::{V3, V4};

/// A set of instructions that this processor has.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Isa {
    /// Those that every processor has.
    Portable,
    /// The same, with products and sums rounded once: as the others are, but slow.
    #[cfg(test)]
    PortableFused,
    /// The same, and what is done is counted.
    #[cfg(test)]
    Counting,
    /// WebAssembly's vectors.
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    Simd128,
    /// AVX2 with FMA.
    #[cfg(target_arch = "x86_64")]
    Avx2(V3),
    /// AVX-512.
    #[cfg(target_arch = "x86_64")]
    Avx512(V4),
}

impl Isa {
    /// All that this processor has, the best one last; those of tests are never the best.
    pub(crate) fn all() -> Vec<Self> {
        let all = std::iter::once(Self::Portable);
        #[cfg(test)]
        let all = [Self::PortableFused, Self::Counting].into_iter().chain(all);
        #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
        let all = all.chain([Self::Simd128]);
        #[cfg(target_arch = "x86_64")]
        let all = all.chain(V3::try_new().map(Self::Avx2)).chain(V4::try_new().map(Self::Avx512));
        all.collect()
    }

    /// What to call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            #[cfg(test)]
            Self::PortableFused => "portable, fused",
            #[cfg(test)]
            Self::Counting => "counting",
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Self::Simd128 => "simd128",
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(_) => "AVX2",
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(_) => "AVX-512",
        }
    }

    /// The one that is fastest.
    pub(crate) fn best() -> Self {
        Self::all().pop().unwrap_or(Self::Portable)
    }
}

/// One pass over the nodes or elements of a sheet, to be compiled for each set of instructions.
pub(crate) trait Pass<R: Real> {
    type Output;

    fn run<L: GatherScatter<Real = R>>(self, lane: L) -> Self::Output;
}

/// Numbers for which there are lanes.
pub(crate) trait Compute: Real {
    /// How many elements lie side by side.
    fn width(isa: Isa) -> usize;
    fn run<P: Pass<Self>>(isa: Isa, pass: P) -> P::Output;
}

#[cfg(target_arch = "x86_64")]
struct With<L, P>(L, P);

#[cfg(target_arch = "x86_64")]
impl<L: GatherScatter, P: Pass<L::Real>> pulp::NullaryFnOnce for With<L, P> {
    type Output = P::Output;

    #[inline(always)]
    fn call(self) -> P::Output {
        self.1.run(self.0)
    }
}

macro_rules! compute {
    ($real:ident, $avx2:ident x $four:literal, $avx512:ident x $eight:literal, $simd128:expr) => {
        impl Compute for $real {
            fn width(isa: Isa) -> usize {
                match isa {
                    Isa::Portable => 4,
                    #[cfg(test)]
                    Isa::PortableFused | Isa::Counting => 4,
                    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
                    Isa::Simd128 => 4,
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx2(_) => $four,
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx512(_) => $eight,
                }
            }

            fn run<P: Pass<$real>>(isa: Isa, pass: P) -> P::Output {
                match isa {
                    Isa::Portable => pass.run(Portable::<$real, FUSES>(PhantomData)),
                    #[cfg(test)]
                    Isa::PortableFused => pass.run(Portable::<$real, true>(PhantomData)),
                    #[cfg(test)]
                    Isa::Counting => pass.run(Counting(Portable::<$real, true>(PhantomData))),
                    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
                    Isa::Simd128 => pass.run($simd128),
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx2(token) => token.vectorize(With($avx2(token), pass)),
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx512(token) => token.vectorize(With($avx512(token), pass)),
                }
            }
        }
    };
}

compute!(f64, D4 x 4, D8 x 8, Twice2);
compute!(f32, S8 x 8, S16 x 16, Portable::<f32, FUSES>(PhantomData));
