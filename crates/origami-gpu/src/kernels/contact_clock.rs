//! The last pass under contact: keeps count.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `contact_clock.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "contact_clock",
    entry: "contact_clock",
    text: wgsl::CONTACT_CLOCK,
    shared: SHARED,
    parts: |_| vec![wgsl::TOUCH],
    uses: &[Binding::Control, Binding::Touch],
    springs: false,
    per: Per::Instance,
};

#[cfg(test)]
mod tests {
    use origami_core::contact::Contact;
    use origami_core::solve::contact_patience;
    use origami_core::twins::checkpoint::COPY_EVERY;

    use super::*;
    use crate::layout::{Control, HELD_UP, SPENT, Touch};
    use crate::testing::gpu;
    use crate::testing::layers::{Layers, model};

    #[test]
    fn it_counts_disturbs_and_stops() {
        let Some(gpu) = gpu() else { return };
        let model = model("bird-base");
        let layers = Layers::new(&gpu, &model, &model.rest, Contact::default());
        let passes = layers.passes(&[&KERNEL]);
        let before = layers.control();
        let run = |control: Control, touch: Touch| -> (Control, Touch) {
            layers.engine.write(Binding::Control, &[control]);
            layers.engine.write(Binding::Touch, &[touch]);
            layers.run(&passes);
            (layers.control(), layers.read(Binding::Touch, 1)[0])
        };
        // At the final targets, with a window that has seen something.
        let settling = Control {
            step: 500,
            checks: 9,
            window_end: 30,
            settled_windows: 3,
            window_is_sound: 1,
            disturbed_at: 2,
            distance: 0.5,
            ..before
        };
        assert_eq!(run(settling, Touch::default()), (settling, Touch::default()), "nothing was in the way");
        let limited = Touch { limited_now: 1, limited: 4, last_limited: 100, first_limited: 7, ..Touch::default() };
        let (control, touch) = run(settling, limited);
        let mut disturbed = settling;
        disturbed.disturb();
        assert_eq!(control, Control { distance: 1e30, ..disturbed }, "as the core");
        assert_eq!(touch, Touch { limited_now: 0, limited: 5, last_limited: 500, ..limited });
        let (control, _) = run(settling, Touch { spent: 1, ..Touch::default() });
        assert_eq!(control, Control { stop: SPENT, ..settling });
        // On the ramp.
        let rising = Control { ramp_step: 4, ramp_before: 3, ramp_length: 10, ..settling };
        let (control, touch) = run(rising, Touch { limited_now: 1, ..Touch::default() });
        assert_eq!(control, rising, "no window has begun");
        assert_eq!(touch, Touch { limited: 1, last_limited: 500, first_limited: 3, arrived: 500, ..Touch::default() });
        // Held up for long.
        let patience = u32::try_from(contact_patience(&model)).expect("small");
        let late = |past: u32, since: u32| {
            let arrived = Control { step: 700 + past, ..settling };
            let touch = Touch { limited: 1, last_limited: arrived.step - since, arrived: 700, ..Touch::default() };
            run(arrived, touch).0.stop
        };
        let recent = u32::try_from(COPY_EVERY).expect("small");
        assert_eq!(late(patience + 1, recent), HELD_UP);
        assert_eq!(late(patience, recent), 0, "not yet");
        assert_eq!(late(patience + 1, recent + 1), 0, "nothing is in the way any more");
    }
}
