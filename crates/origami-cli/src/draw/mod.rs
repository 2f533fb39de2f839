//! Pictures, where this build has them.

#[cfg(not(feature = "render"))]
mod absent;
#[cfg(feature = "render")]
mod artist;
#[cfg(feature = "render")]
mod beforehand;
#[cfg(feature = "render")]
mod contact;
#[cfg(feature = "render")]
mod film;
#[cfg(feature = "render")]
mod formats;
#[cfg(feature = "render")]
mod limits;
#[cfg(feature = "render")]
mod orders;
#[cfg(feature = "render")]
mod still;
#[cfg(feature = "render")]
mod style;

#[cfg(not(feature = "render"))]
pub(crate) use absent::*;
#[cfg(feature = "render")]
pub(crate) use {
    artist::Artist,
    beforehand::check_drawable,
    film::film,
    formats::{faulty_pattern, pattern, sheet},
    limits::{check_contact, check_film},
    orders::orders,
    style::{Style, oddities},
};

use origami::glam::DVec3;
use origami::layers::FaceOrder;
use origami::{CreasePattern, Model, State};
use serde_json::{Value, json};

/// Orders of faces as FOLD has them.
pub(crate) fn listed(orders: &[FaceOrder]) -> Value {
    orders.iter().map(|order| json!([order.faces[0].0, order.faces[1].0, order.side])).collect()
}

/// A folded sheet and the states that it went through.
#[derive(Clone, Copy)]
#[cfg_attr(not(feature = "render"), expect(dead_code, reason = "nothing draws"))]
pub(crate) struct Subject<'a> {
    pub(crate) pattern: &'a CreasePattern,
    pub(crate) model: &'a Model,
    /// With the percentage of each; at least one.
    pub(crate) states: &'a [(f64, &'a State)],
    /// Of a sequence the step that each of them shows; else empty.
    pub(crate) steps: &'a [String],
}

/// What is marked on a crease pattern.
#[cfg_attr(not(feature = "render"), expect(dead_code, reason = "nothing draws"))]
pub(crate) enum Faults<'a> {
    /// Nothing.
    None,
    /// What is wrong with it as a pattern.
    Found,
    /// No sheet can be made of these lines.
    Refused {
        /// Why not.
        why: &'a str,
        /// Where a line ends that nothing else touches.
        open_ends: &'a [DVec3],
        /// What the reason names.
        blamed: &'a [DVec3],
    },
}

/// A film that is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Film {
    /// Pictures of one round of the camera.
    pub(crate) turntable: Option<u32>,
    /// How many pictures are shown in a second.
    pub(crate) fps: Option<u16>,
}
