// What contact does on the way, by instance.

struct Touch {
    // Whether a move was shortened in this evaluation, and whether a node is so far from where it was listed that the list is spent.
    limited_now: atomic<u32>,
    spent: atomic<u32>,
    // Evaluations in which a move was shortened, and the last of them.
    limited: u32,
    last_limited: u32,
    // The part of the ramp at which that was so first.
    first_limited: u32,
    // The last evaluation before the end of the ramp.
    arrived: u32,
    // How far a node may be from where it was listed before the list is spent.
    lasts: f32,
}

@group(0) @binding(36) var<storage, read_write> touch: array<Touch>;
