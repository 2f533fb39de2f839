//! Which way the steps of a sheet go.

use origami_core::twins::safe_time_step;

use crate::blocks::Blocks;
use crate::device::Abilities;
use crate::purpose::{Dispatch, Purpose, WORKGROUP_NODES};
use crate::sheet_arrays::SheetArrays;
use crate::variant::{Small, Variant};

/// Loop iterations that one dispatch may take: software adapters end every loop at 65 535, silently.
const MOST_ITERATIONS: usize = 50_000;

/// A [`Dispatch`] that has been decided on.
#[derive(Clone, Debug)]
pub(crate) enum Route {
    Passes,
    /// One workgroup a sheet: one block.
    Workgroup(Blocks),
    Blocks(Blocks),
}

impl Route {
    /// The way that is wanted, where it can be had, else by passes.
    pub(crate) fn new(arrays: &SheetArrays, purpose: Purpose, abilities: Abilities) -> Self {
        let workgroup = || small(arrays, abilities.workgroup_storage).map(Self::Workgroup);
        let blocks = || Blocks::new(arrays).map(Self::Blocks);
        let wanted = match purpose.dispatch {
            Dispatch::Passes => None,
            Dispatch::Workgroup => workgroup(),
            Dispatch::Blocks => blocks(),
            Dispatch::Auto if arrays.nodes <= WORKGROUP_NODES => workgroup(),
            Dispatch::Auto if abilities.hardware => blocks(),
            Dispatch::Auto => None,
        };
        wanted.unwrap_or(Self::Passes)
    }

    /// Its name.
    pub(crate) fn dispatch(&self) -> Dispatch {
        match self {
            Self::Passes => Dispatch::Passes,
            Self::Workgroup(_) => Dispatch::Workgroup,
            Self::Blocks(_) => Dispatch::Blocks,
        }
    }

    /// The blocks of a sheet that has some.
    pub(crate) fn blocks(&self) -> Option<&Blocks> {
        match self {
            Self::Passes => None,
            Self::Workgroup(blocks) | Self::Blocks(blocks) => Some(blocks),
        }
    }

    /// Of a sheet that goes this way.
    pub(crate) fn variant(&self, plain: &Variant) -> Variant {
        self.blocks().map_or_else(|| plain.clone(), |blocks| plain.in_blocks(blocks))
    }
}

/// Invocations of a workgroup that has a whole sheet: one a node.
fn invocations(nodes: usize) -> usize {
    nodes.next_power_of_two().clamp(32, 256)
}

/// The sheet as one block, where a workgroup with so many bytes of memory holds it with its lists.
fn small(arrays: &SheetArrays, memory: usize) -> Option<Blocks> {
    let whole = Blocks::whole(arrays)?;
    let needed = whole.extent.room.memory_of_whole(whole.words.len(), invocations(arrays.nodes));
    (needed <= memory && iterations(arrays, &whole) <= MOST_ITERATIONS).then_some(whole)
}

/// The variant of the kernel of a workgroup that has the whole sheet, for up to `most` steps in one dispatch.
pub(crate) fn small_variant(
    arrays: &SheetArrays,
    blocks: &Blocks,
    variant: &Variant,
    safe: bool,
    most: u64,
) -> Variant {
    let steps = (MOST_ITERATIONS / iterations(arrays, blocks)).clamp(1, usize::try_from(most).unwrap_or(1));
    let renewal = if safe { safe_time_step::RENEWAL } else { 0 };
    #[expect(clippy::cast_possible_truncation, reason = "at most 256, and at most a batch")]
    let (workgroup, steps) = (invocations(arrays.nodes) as u32, steps as u32);
    Variant { workgroup, small: Small { steps, words: blocks.words.len(), renewal }, ..variant.clone() }
}

/// Loop iterations of one invocation in one step, at most: every loop of the kernels counted as written.
fn iterations(arrays: &SheetArrays, blocks: &Blocks) -> usize {
    let invocations = invocations(arrays.nodes);
    let rounds = |count: usize| count.div_ceil(invocations);
    let (creases, faces, loose) =
        (rounds(blocks.copies.of.len()), rounds(arrays.faces.len()), rounds(arrays.loose_beams.len()));
    let sum = 3 + arrays.most_slots();
    let forces = creases + 7 * 3 * faces + loose + sum;
    let row_sums = 6 * 3 * faces + loose + sum;
    // Forces once more for the stopping rule, and a tree of sums for either.
    2 * forces + row_sums + 2 * 8 + 4
}

#[cfg(test)]
mod tests {
    use origami_core::generate::Miura;
    use origami_core::{Material, Model};

    use super::*;
    use crate::blocks::MEMORY;
    use crate::testing::bench::EULER;
    use crate::testing::cases::miura;
    use crate::testing::sheets;

    const SOFTWARE: Abilities = Abilities { hardware: false, workgroup_storage: MEMORY };

    fn way(model: &Model, dispatch: Dispatch, abilities: Abilities) -> Dispatch {
        let purpose = Purpose { scheme: EULER, safe: true, softens: false, dispatch };
        Route::new(&SheetArrays::new(model), purpose, abilities).dispatch()
    }

    fn sheet(panels: usize) -> Model {
        let pattern = Miura { columns: panels, rows: panels, ..Miura::default() }.pattern().expect("a pattern");
        Model::new(&pattern, &Material::default()).expect("a model")
    }

    #[test]
    fn a_workgroup_takes_a_sheet_that_its_memory_holds() {
        let is_taken = |model: &Model, dispatch, abilities| way(model, dispatch, abilities) == Dispatch::Workgroup;
        let small = miura();
        assert!(is_taken(&small, Dispatch::Auto, SOFTWARE) && is_taken(&small, Dispatch::Workgroup, SOFTWARE));
        assert!(!is_taken(&small, Dispatch::Passes, SOFTWARE));
        assert!(is_taken(&sheets::loose_beams(), Dispatch::Workgroup, SOFTWARE));
        let larger = Abilities { workgroup_storage: 2 * MEMORY, ..SOFTWARE };
        let fits = |abilities| (2..20).rev().find(|side| is_taken(&sheet(*side), Dispatch::Workgroup, abilities));
        let nodes = [SOFTWARE, larger].map(|abilities| fits(abilities).map(|side| (side + 1) * (side + 1)));
        assert_eq!(nodes, [Some(64), Some(121)], "nodes of the largest square Miura in 16 and in 32 KiB");
    }

    #[test]
    fn hardware_takes_blocks_where_a_sheet_is_not_small() {
        let hardware = Abilities { hardware: true, ..SOFTWARE };
        let large = sheet(20);
        assert!(large.node_count() > WORKGROUP_NODES);
        assert_eq!(way(&large, Dispatch::Auto, hardware), Dispatch::Blocks);
        assert_eq!(way(&large, Dispatch::Auto, SOFTWARE), Dispatch::Passes);
        assert_eq!(way(&miura(), Dispatch::Auto, hardware), Dispatch::Workgroup);
    }

    #[test]
    fn loops_of_a_dispatch_stay_below_the_cap() {
        for model in [miura(), sheets::loose_beams(), sheet(9)] {
            let arrays = SheetArrays::new(&model);
            let blocks = Blocks::whole(&arrays).expect("small");
            let variant = Variant::new(&arrays, EULER, Some(model.material)).in_blocks(&blocks);
            let steps = |most| small_variant(&arrays, &blocks, &variant, true, most).small.steps as usize;
            assert_eq!((steps(20), steps(100)), (20, 100), "all of a batch");
            assert!(steps(u64::MAX) * iterations(&arrays, &blocks) <= MOST_ITERATIONS);
        }
    }
}
