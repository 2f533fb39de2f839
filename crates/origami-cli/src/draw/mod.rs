//! Pictures, where this build has them.

#[cfg(not(feature = "render"))]
mod absent;
#[cfg(feature = "render")]
mod brush;
#[cfg(feature = "render")]
mod contact;
#[cfg(feature = "render")]
mod film;
#[cfg(feature = "render")]
mod limits;
#[cfg(feature = "render")]
mod still;
#[cfg(feature = "render")]
mod style;

#[cfg(not(feature = "render"))]
pub(crate) use absent::*;
#[cfg(feature = "render")]
pub(crate) use {
    brush::Brush,
    contact::contact,
    film::film,
    limits::{check_contact, check_film, check_size},
    origami::picture::{LineSet, Rgb},
    still::{glb, pattern_png, png, svg},
    style::Style,
};

use origami::{CreasePattern, Model, State};

/// What a command draws with, and how it shall look.
#[derive(Default)]
pub(crate) struct Artist {
    #[cfg_attr(not(feature = "render"), expect(dead_code, reason = "nothing draws"))]
    pub(crate) style: Style,
    pub(crate) brush: Brush,
}

/// A folded sheet and the states that it went through.
#[derive(Clone, Copy)]
#[cfg_attr(not(feature = "render"), expect(dead_code, reason = "nothing draws"))]
pub(crate) struct Subject<'a> {
    pub(crate) pattern: &'a CreasePattern,
    pub(crate) model: &'a Model,
    /// With the percentage of each; at least one.
    pub(crate) states: &'a [(f64, &'a State)],
}

/// A film that is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Film {
    /// Pictures of one round of the camera.
    pub(crate) turntable: Option<u32>,
    /// Pictures in a second.
    pub(crate) fps: Option<u16>,
}

/// What a picture's ground may be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Ground {
    Transparent,
    Plain(Rgb),
}

impl Ground {
    /// From a colour or `transparent`.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let expected = "expected `transparent`, `white`, `black` or a colour such as #ffcc00";
        match text {
            "transparent" => Ok(Self::Transparent),
            _ => text.parse().map(Self::Plain).map_err(|_| expected.to_owned()),
        }
    }
}
