//! The colour bar.

use origami_core::Error;

use crate::image::Image;
use crate::map::Scale;
use crate::text;
use crate::theme::Theme;

/// The share of a picture's width that a bar may take; where it would take more it is left out.
const MOST: f32 = 0.4;
/// As wide as a number beside a bar gets.
const WIDEST: &str = "≥ 0.0005";

/// Where the bar and its numbers go, in pixels.
#[derive(Clone, Debug)]
pub(crate) struct Legend {
    scale: Scale,
    size: f32,
    bar: [f32; 2],
    /// How much of the picture it takes at the right.
    pub(crate) width: f32,
}

impl Legend {
    /// For a picture of this size; `None` where there is no room for it.
    pub(crate) fn new(scale: &Scale, width: u32, height: u32) -> Option<Self> {
        fits(&scale.label, width, height).then(|| Self::with(scale, width, height))
    }

    fn with(scale: &Scale, width: u32, height: u32) -> Self {
        let size = text_size(width, height);
        // Beside a tall picture it is no longer than the sheet can be.
        let bar = [(0.9 * size).round(), (0.55 * height.min(width.saturating_mul(5) / 4) as f32).round()];
        let numbers = { scale.ticks().into_iter() }.map(|(_, text)| text::width(&text, size)).fold(0.0, f32::max);
        Self { scale: scale.clone(), size, bar, width: width_of(&scale.label, numbers, size) }
    }

    /// Draws it along the right border.
    pub(crate) fn draw(&self, image: &mut Image, theme: &Theme) {
        let [bar_width, bar_height] = self.bar;
        let left = (image.width as f32 - self.width + self.size).round();
        let top = (0.5 * (image.height as f32 - bar_height) + 0.6 * self.size).round();
        text::draw(image, &self.scale.label, [left, top - 0.9 * self.size], self.size, theme.text);
        let line = (self.size / 14.0).round().max(1.0);
        image.fill(
            (left - line) as i64,
            (top - line) as i64,
            (bar_width + 2.0 * line) as i64,
            (bar_height + 2.0 * line) as i64,
            theme.text,
        );
        for row in 0..bar_height as i64 {
            let share = 1.0 - (row as f64 + 0.5) / f64::from(bar_height);
            image.fill(left as i64, top as i64 + row, bar_width as i64, 1, self.scale.colours.colour(share));
        }
        for (share, number) in self.scale.ticks() {
            let y = top + (1.0 - share as f32) * (bar_height - line);
            image.fill((left + bar_width) as i64, y as i64, (0.4 * self.size) as i64, line as i64, theme.text);
            let at = [left + bar_width + 0.7 * self.size, y + 0.36 * self.size];
            text::draw(image, &number, at, self.size, theme.text);
        }
    }
}

/// How wide a bar with this label and numbers of this width is, in pixels; `size` is that of its letters.
fn width_of(label: &str, numbers: f32, size: f32) -> f32 {
    let inner = text::width(label, size).max(0.9 * size + 0.7 * size + numbers);
    (inner + 2.0 * size).ceil()
}

/// Whether a picture of this size has room for a bar with this label beside the sheet: it is left out where it would take
/// more than two fifths of the width. Whatever its numbers are, so that it is known beforehand.
#[must_use]
pub fn fits(label: &str, width: u32, height: u32) -> bool {
    let size = text_size(width, height);
    width_of(label, text::width(WIDEST, size), size) <= MOST * width as f32
}

/// How many pixels across [`bar`] is beside pictures of this size.
#[must_use]
pub fn bar_width(label: &str, width: u32, height: u32) -> u32 {
    let size = text_size(width, height);
    width_of(label, text::width(WIDEST, size), size) as u32
}

/// A colour bar by itself, to stand beside several pictures of this size that share a scale; `tall` pixels high.
///
/// # Errors
/// As for [`Image::new`].
pub fn bar(scale: &Scale, theme: &Theme, [width, height]: [u32; 2], tall: u32) -> Result<Image, Error> {
    let legend = Legend::with(scale, width, height);
    let mut image = Image::new(bar_width(&scale.label, width, height), tall, theme.background)?;
    Legend { width: image.width as f32, ..legend }.draw(&mut image, theme);
    Ok(image)
}

/// The size of letters in a picture of this size.
pub(crate) fn text_size(width: u32, height: u32) -> f32 {
    (width.min(height) as f32 * 0.027).round().max(11.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::ColourMap;

    #[test]
    fn a_bar_leaves_most_of_the_picture_to_the_sheet() {
        let scale = |clip| Scale { colours: ColourMap::Viridis, clip, label: "energy density".into(), beyond: true };
        for (width, height) in [(120, 100), (300, 200), (400, 1600), (1000, 800), (3000, 300)] {
            for clip in [1.0, 0.0005, 2e-6, 1500.0] {
                let legend = Legend::new(&scale(clip), width, height);
                assert_eq!(legend.is_some(), fits("energy density", width, height));
                if let Some(legend) = legend {
                    assert!(legend.width < 0.45 * width as f32 && legend.bar[1] < 0.7 * width as f32, "{width} {clip}");
                }
            }
        }
        assert!(!fits("energy density", 120, 100) && fits("strain, %", 300, 200));
        let alone = bar(&scale(1.5), &Theme::paper(), [480, 384], 500).unwrap();
        assert_eq!((alone.width, alone.height), (bar_width("energy density", 480, 384), 500));
        assert!(alone.pixels.chunks(4).any(|p| p[0] > 240 && p[2] < 50), "the last colour of the map");
    }
}
