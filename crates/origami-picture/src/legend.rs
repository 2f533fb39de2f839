//! The colour bar.

use crate::image::Image;
use crate::map::Scale;
use crate::text;
use crate::theme::Theme;

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
    /// For a picture of this size.
    pub(crate) fn new(scale: &Scale, width: u32, height: u32) -> Self {
        let size = text_size(width, height);
        let bar = [(0.9 * size).round(), (0.55 * height as f32).round()];
        let numbers = { scale.ticks().into_iter() }.map(|(_, text)| text::width(&text, size)).fold(0.0, f32::max);
        let label = text::width(&scale.label, size);
        let inner = label.max(bar[0] + 0.7 * size + numbers);
        Self { scale: scale.clone(), size, bar, width: (inner + 2.0 * size).ceil() }
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

/// The size of letters in a picture of this size.
pub(crate) fn text_size(width: u32, height: u32) -> f32 {
    (width.min(height) as f32 * 0.027).round().max(11.0)
}
