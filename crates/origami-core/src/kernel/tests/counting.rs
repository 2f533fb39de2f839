//! A lane that counts what another one does.

use std::cell::Cell;

use crate::kernel::blocks::{CREASES, NODES};
use crate::kernel::lane::{GatherScatter, Lane};
use crate::kernel::near::Near;
use crate::kernel::real::{Quad64, Real};

/// What was done, number by number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Counts {
    /// Sums, differences and products; a product that is added counts as two.
    pub(crate) flops: u64,
    /// Divisions and roots.
    pub(crate) divisions: u64,
    /// Comparisons, choices and signs.
    pub(crate) choices: u64,
}

thread_local! {
    static COUNTS: Cell<Counts> = const { Cell::new(Counts { flops: 0, divisions: 0, choices: 0 }) };
}

/// What this thread did in `work`.
pub(crate) fn count(work: impl FnOnce()) -> Counts {
    COUNTS.set(Counts::default());
    work();
    COUNTS.take()
}

/// Counts what `L` does.
#[derive(Clone, Copy)]
pub(crate) struct Counting<L>(pub(crate) L);

impl<L: Lane> Counting<L> {
    /// The fourth number of a vector of a node is counted as well.
    fn note(self, add: impl FnOnce(&mut Counts, u64)) {
        let mut counts = COUNTS.get();
        add(&mut counts, L::WIDTH as u64);
        COUNTS.set(counts);
    }
}

macro_rules! counted {
    ($($field:ident += $times:literal: $name:ident($($a:ident),*);)*) => {
        $(fn $name(self, $($a: L::Raw),*) -> L::Raw {
            self.note(|counts, width| counts.$field += $times * width);
            self.0.$name($($a),*)
        })*
    };
}

impl<L: Lane> Lane for Counting<L> {
    type Real = L::Real;
    type Raw = L::Raw;
    type Mask = L::Mask;
    const WIDTH: usize = L::WIDTH;

    counted! {
        flops += 1: add(a, b);
        flops += 1: sub(a, b);
        flops += 1: mul(a, b);
        flops += 2: mul_add(a, b, c);
        flops += 2: mul_sub(a, b, c);
        flops += 2: sub_mul(a, b, c);
        divisions += 1: div(a, b);
        divisions += 1: sqrt(a);
        choices += 1: max(a, b);
        choices += 1: min(a, b);
        choices += 1: abs(a);
    }

    fn splat(self, x: L::Real) -> L::Raw {
        self.0.splat(x)
    }

    fn load(self, from: &[L::Real]) -> L::Raw {
        self.0.load(from)
    }

    fn store(self, raw: L::Raw, to: &mut [L::Real]) {
        self.0.store(raw, to);
    }

    fn less(self, a: L::Raw, b: L::Raw) -> L::Mask {
        self.note(|counts, width| counts.choices += width);
        self.0.less(a, b)
    }

    fn and(self, a: L::Mask, b: L::Mask) -> L::Mask {
        self.0.and(a, b)
    }

    fn all(self, mask: L::Mask) -> bool {
        self.0.all(mask)
    }

    fn select(self, mask: L::Mask, yes: L::Raw, no: L::Raw) -> L::Raw {
        self.note(|counts, width| counts.choices += width);
        self.0.select(mask, yes, no)
    }
}

impl<L: GatherScatter> GatherScatter for Counting<L> {
    type Node = Counting<L::Node>;
    type Position = Counting<L::Position>;

    fn node(self) -> Self::Node {
        Counting(self.0.node())
    }

    fn position(self) -> Self::Position {
        Counting(self.0.position())
    }

    fn load_node(self, from: <L::Real as Real>::Quad) -> <L::Node as Lane>::Raw {
        self.0.load_node(from)
    }

    fn store_node(self, raw: <L::Node as Lane>::Raw) -> <L::Real as Real>::Quad {
        self.0.store_node(raw)
    }

    fn load_position(self, from: Quad64) -> <L::Position as Lane>::Raw {
        self.0.load_position(from)
    }

    fn store_position(self, raw: <L::Position as Lane>::Raw) -> Quad64 {
        self.0.store_position(raw)
    }

    fn widen(self, raw: <L::Node as Lane>::Raw) -> <L::Position as Lane>::Raw {
        self.0.widen(raw)
    }

    fn place(self, raw: <L::Position as Lane>::Raw) -> <L::Real as Real>::Place {
        self.0.place(raw)
    }

    fn gather_differences(self, near: &Near<L::Real>, from: &[u8], to: &[u8]) -> [L::Raw; 3] {
        self.note(|counts, width| counts.flops += 3 * width);
        self.0.gather_differences(near, from, to)
    }

    fn gather_sides(self, near: &Near<L::Real>, corners: [&[u8]; 3]) -> [[L::Raw; 3]; 3] {
        self.note(|counts, width| counts.flops += 9 * width);
        self.0.gather_sides(near, corners)
    }

    fn gather_velocity_differences(
        self,
        vectors: &[<L::Real as Real>::Quad; NODES],
        from: &[u8],
        to: &[u8],
    ) -> [L::Raw; 3] {
        self.note(|counts, width| counts.flops += 3 * width);
        self.0.gather_velocity_differences(vectors, from, to)
    }

    fn gather(self, values: &[L::Real; CREASES], at: &[u16]) -> L::Raw {
        self.0.gather(values, at)
    }

    fn scatter(self, vectors: [L::Raw; 3], to: &mut [<L::Real as Real>::Quad]) {
        self.0.scatter(vectors, to);
    }
}
