//! Which way the steps of a sheet go.

use origami_core::twins::safe_time_step;

use crate::blocks::Blocks;
use crate::plan::CHECK_INTERVAL;
use crate::purpose::{Dispatch, Purpose, WORKGROUP_NODES};
use crate::sheet_arrays::SheetArrays;
use crate::variant::Variant;

/// Loop iterations that one dispatch may take: software adapters end every loop at 65 535, silently.
const MOST_ITERATIONS: usize = 50_000;

/// A [`Dispatch`] that has been decided on.
#[derive(Clone, Debug)]
pub(crate) enum Route {
    Passes,
    /// One workgroup a sheet; its kernel's variant.
    Workgroup(Variant),
    Blocks(Blocks),
}

impl Route {
    /// The way that is wanted, where it can be had, else by passes. `hardware`: whether the adapter is.
    pub(crate) fn new(arrays: &SheetArrays, variant: &Variant, purpose: Purpose, hardware: bool) -> Self {
        let workgroup = || workgroup_variant(arrays, variant, purpose).map(Self::Workgroup);
        let blocks = || Blocks::new(arrays).map(Self::Blocks);
        let wanted = match purpose.dispatch {
            Dispatch::Passes => None,
            Dispatch::Workgroup => workgroup(),
            Dispatch::Blocks => blocks(),
            Dispatch::Auto if arrays.nodes <= WORKGROUP_NODES => workgroup(),
            Dispatch::Auto if hardware => blocks(),
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

    /// Of a sheet that goes this way.
    pub(crate) fn variant(&self, plain: &Variant) -> Variant {
        match self {
            Self::Passes => plain.clone(),
            Self::Workgroup(own) => Variant { steps: own.steps, ..plain.clone() },
            Self::Blocks(blocks) => plain.in_blocks(blocks),
        }
    }
}

/// The variant of the one-workgroup kernel, where it can be had.
fn workgroup_variant(arrays: &SheetArrays, variant: &Variant, purpose: Purpose) -> Option<Variant> {
    // Eight buffers are all that every adapter has, and these sheets need more.
    if variant.rigidities || variant.loose_beams > 0 {
        return None;
    }
    let most = arrays.nodes.max(arrays.hinges.len()).max(arrays.faces.len());
    #[expect(clippy::cast_possible_truncation, reason = "at most 256")]
    let workgroup = most.next_power_of_two().clamp(32, 256) as u32;
    let most = (MOST_ITERATIONS / iterations(arrays, workgroup as usize)) as u64;
    // Whole dispatches fill the interval after which the stopping rule is checked, and that of the safe step's renewal.
    let renewal = if purpose.safe { safe_time_step::RENEWAL } else { CHECK_INTERVAL };
    let whole = |steps: &u64| CHECK_INTERVAL.is_multiple_of(*steps) && renewal.is_multiple_of(*steps);
    let steps = (1..=CHECK_INTERVAL.min(most)).rev().find(whole)?;
    #[expect(clippy::cast_possible_truncation, reason = "at most a checks")]
    let steps = steps as u32;
    Some(Variant { workgroup, steps, ..variant.clone() })
}

/// Loop iterations of one invocation in one step, at most: every loop of the kernel counted as written.
fn iterations(arrays: &SheetArrays, workgroup: usize) -> usize {
    let rounds = |count: usize| count.div_ceil(workgroup);
    let of_a_face = 1 + 3 + 3 + 3 + 3 + 3 + 3;
    let of_a_node = 1 + arrays.most_slots() + 1;
    1 + rounds(arrays.hinges.len()) + rounds(arrays.faces.len()) * of_a_face + rounds(arrays.nodes) * of_a_node + 8
}

#[cfg(test)]
mod tests {
    use origami_core::generate::Miura;
    use origami_core::{Material, Model};

    use super::*;
    use crate::testing::bench::EULER;
    use crate::testing::cases::miura;
    use crate::testing::sheets;

    const BY_WORKGROUP: Purpose = Purpose { scheme: EULER, safe: true, dispatch: Dispatch::Workgroup };

    fn arrays_and_variant(model: &Model) -> (SheetArrays, Variant) {
        let arrays = SheetArrays::new(model);
        let variant = Variant::new(&arrays, EULER, Some(model.material));
        (arrays, variant)
    }

    #[test]
    fn loops_in_a_workgroup_stay_below_the_cap_and_fill_whole_intervals() {
        let (mut arrays, variant) = arrays_and_variant(&miura());
        let mut steps = Vec::new();
        for faces in [1, 100, 10_000, 40_000, 100_000, 400_000, 4_000_000] {
            arrays.faces.resize(faces, arrays.faces[0]);
            let renewing = workgroup_variant(&arrays, &variant, BY_WORKGROUP).map(|built| u64::from(built.steps));
            assert!(renewing.is_none_or(|steps| safe_time_step::RENEWAL.is_multiple_of(steps)), "{renewing:?}");
            let constant = Purpose { safe: false, ..BY_WORKGROUP };
            let Some(built) = workgroup_variant(&arrays, &variant, constant) else {
                assert!(iterations(&arrays, 256) > MOST_ITERATIONS, "{faces} faces: one step would fit");
                continue;
            };
            let made = built.steps as usize * iterations(&arrays, built.workgroup as usize);
            assert!(made <= MOST_ITERATIONS, "{faces} faces: {made} iterations");
            assert!(CHECK_INTERVAL.is_multiple_of(u64::from(built.steps)), "{faces} faces: {} steps", built.steps);
            steps.push(built.steps);
        }
        assert_eq!((steps.first(), steps.is_sorted_by(|a, b| a >= b)), (Some(&20), true), "{steps:?}");
        assert!(steps.iter().any(|s| (1..20).contains(s)), "some are between: {steps:?}");
        assert!(steps.len() < 7, "too many faces even for one step");
    }

    #[test]
    fn a_workgroup_takes_a_sheet_where_its_buffers_suffice_and_it_is_small() {
        let is_taken = |model: &Model, dispatch| {
            let (arrays, variant) = arrays_and_variant(model);
            matches!(Route::new(&arrays, &variant, Purpose { dispatch, ..BY_WORKGROUP }, false), Route::Workgroup(_))
        };
        let small = miura();
        assert!(is_taken(&small, Dispatch::Auto) && is_taken(&small, Dispatch::Workgroup));
        assert!(!is_taken(&small, Dispatch::Passes));
        assert!(!is_taken(&sheets::loose_beams(), Dispatch::Workgroup), "it would need a ninth buffer");
        let large = Miura { columns: 20, rows: 20, ..Miura::default() }.pattern().expect("a pattern");
        let large = Model::new(&large, &Material::default()).expect("a model");
        assert!(large.node_count() > WORKGROUP_NODES);
        assert!(!is_taken(&large, Dispatch::Auto) && is_taken(&large, Dispatch::Workgroup));
    }
}
