//! A sheet whose layers push each other away.

use std::mem::offset_of;

use origami_core::Model;

use super::Engine;
use super::buffers::{buffers, check_counts};
use super::passes::Passes;
use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::Touch;
use crate::outside::Outside;
use crate::pair_arrays::{self, PairArrays};
use crate::pipeline::buffer;
use crate::route::Route;
use crate::sheet_arrays::SheetArrays;
use crate::variant::{InContact, Scheme, Variant};

/// Pairs for which there is room before the first list.
const FIRST_PAIRS: usize = 1024;

impl Engine {
    /// For one sheet of `model` whose layers push each other away; by passes over all elements. It needs a list of pairs before
    /// its first step.
    ///
    /// # Errors
    /// As [`Engine::new`].
    pub(crate) fn in_contact(
        gpu: &Gpu,
        model: &Model,
        outside: &Outside,
        contact: InContact,
    ) -> Result<Self, GpuError> {
        let arrays = SheetArrays::with_outside(model, outside);
        let plain = Variant::new(&arrays, Scheme::Relax, Some(model.material));
        let variant = Variant { contact: Some(contact), ..plain };
        check_counts(&variant)?;
        gpu.scoped(|| {
            let mut buffers = buffers(gpu, &arrays, &variant, &Route::Passes, 1)?;
            for (binding, size) in pair_arrays::sizes(variant.nodes, FIRST_PAIRS) {
                buffers.insert(binding, buffer(gpu, binding, size, &[])?);
            }
            let passes = Passes::new(gpu, &variant, None, &buffers, false);
            let engine = Self::plain(gpu, variant, buffers, Vec::new());
            Ok(Self { load_slots: arrays.load_slots.clone(), passes, ..engine })
        })?
    }

    /// Takes another list of pairs; every node is where it is listed.
    ///
    /// # Errors
    /// [`GpuError::TooManyElements`] where a dispatch does not count so many pairs, and as [`Engine::new`].
    pub(crate) fn list(&mut self, PairArrays { pairs, rows, lasts }: &PairArrays) -> Result<(), GpuError> {
        let allowed = 65_535 * u64::from(self.variant.workgroup);
        let count = u32::try_from(pairs.len()).ok().filter(|count| u64::from(*count) <= allowed);
        let count = count.ok_or(GpuError::TooManyElements { count: pairs.len() as u64, allowed })?;
        let gpu = self.gpu.clone();
        gpu.scoped(|| {
            let needed = size_of_val(&pairs[..]) as u64;
            if needed > self.buffers[&Binding::Pairs].size() {
                // Lists grow as the sheet folds.
                let room = 2 * pairs.len();
                let of_pairs = [Binding::Pairs, Binding::Nears, Binding::Pushes, Binding::Shares];
                let sizes = pair_arrays::sizes(self.variant.nodes, room).into_iter();
                for (binding, size) in sizes.filter(|(binding, _)| of_pairs.contains(binding)) {
                    self.buffers.insert(binding, buffer(&gpu, binding, size, &[])?);
                }
                let buffers = &self.buffers;
                self.passes.all_mut().for_each(|pass| pass.rebind(&gpu, buffers));
            }
            self.passes.all_mut().for_each(|pass| pass.set_pairs(count));
            self.write(Binding::Pairs, pairs);
            self.write(Binding::PairRows, rows);
            let at = offset_of!(Touch, lasts) as u64;
            gpu.queue().write_buffer(&self.buffers[&Binding::Touch], at, bytemuck::bytes_of(lasts));
            self.write(Binding::Ways, &vec![[0.0_f32; 4]; self.variant.nodes]);
            Ok(())
        })?
    }

    /// Before a fold nothing has been in the way.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn forget_contact(&self) -> Result<(), GpuError> {
        self.gpu.scoped(|| self.write(Binding::Touch, &[Touch::default()]))
    }

    /// Lets the first instance go on that waited for a list, after all that has been submitted.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn go_on(&self) -> Result<(), GpuError> {
        // The first word of its control block.
        self.gpu.scoped(|| self.write(Binding::Control, &[0_u32]))
    }
}
