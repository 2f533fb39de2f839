//! Values of options for pictures. A build that draws no pictures keeps lines and colours as they are written.

#[cfg(feature = "render")]
pub(crate) use origami::picture::{LineSet, Rgb};

/// Lines to draw, as they are written.
#[cfg(not(feature = "render"))]
pub(crate) type LineSet = String;
/// A colour, as it is written.
#[cfg(not(feature = "render"))]
pub(crate) type Rgb = String;

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

/// Whether a picture may be so large; any may that nothing draws.
///
/// # Errors
/// That it may not, and what was expected.
pub(crate) fn check_size([width, height]: [u32; 2]) -> Result<(), String> {
    #[cfg(feature = "render")]
    {
        use origami::picture::Image;

        let pixels = u64::from(width) * u64::from(height);
        if width.max(height) > Image::LONGEST || pixels > Image::MOST {
            let (side, million) = (Image::LONGEST, Image::MOST / 1_000_000);
            return Err(format!(
                "{width} x {height} pixels are too many; expected at most {side} a side and {million} million in all"
            ));
        }
    }
    #[cfg(not(feature = "render"))]
    let _ = (width, height);
    Ok(())
}
