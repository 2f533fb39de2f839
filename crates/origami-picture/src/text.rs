//! Words and numbers in pictures, in `DejaVu` Sans (its licence is that of Bitstream Vera: free to embed).

use std::sync::OnceLock;

use ab_glyph::{Font, FontRef, Glyph, PxScale, ScaleFont, point};

use crate::colour::Rgb;
use crate::image::Image;

/// The font; `None` cannot be: a test reads it.
fn font() -> Option<&'static FontRef<'static>> {
    static FONT: OnceLock<Option<FontRef<'static>>> = OnceLock::new();
    FONT.get_or_init(|| FontRef::try_from_slice(dejavu::sans::regular()).ok()).as_ref()
}

/// The glyphs of a line of text and how wide it is; `size` is that of an em, in pixels.
fn layout(text: &str, size: f32) -> (Vec<Glyph>, f32) {
    let Some(font) = font() else { return (Vec::new(), 0.0) };
    let em = font.units_per_em().unwrap_or(2048.0);
    let font = font.as_scaled(PxScale::from(size * font.height_unscaled() / em));
    let (mut glyphs, mut x, mut last) = (Vec::new(), 0.0, None);
    for letter in text.chars() {
        let id = font.glyph_id(letter);
        if let Some(last) = last.replace(id) {
            x += font.kern(last, id);
        }
        glyphs.push(id.with_scale_and_position(font.scale(), point(x, 0.0)));
        x += font.h_advance(id);
    }
    (glyphs, x)
}

/// Characters of a text that the font does not have, each once: they are drawn as boxes.
#[must_use]
pub fn missing(text: &str) -> String {
    let Some(font) = font() else { return String::new() };
    let mut missing = String::new();
    for letter in text.chars() {
        if font.glyph_id(letter).0 == 0 && !missing.contains(letter) {
            missing.push(letter);
        }
    }
    missing
}

/// How wide a line of text is, in pixels; `size` is that of an em.
#[must_use]
pub fn width(text: &str, size: f32) -> f32 {
    layout(text, size).1
}

/// Draws a line of text from `x` on, standing on `y`, both in pixels.
pub fn draw(image: &mut Image, text: &str, [x, y]: [f32; 2], size: f32, colour: Rgb) {
    let Some(font) = font() else { return };
    for mut glyph in layout(text, size).0 {
        // Whole pixels up and down keep stems and bars alike.
        glyph.position = point(glyph.position.x + x, y.round());
        if let Some(outline) = font.outline_glyph(glyph) {
            let corner = outline.px_bounds().min;
            let (left, top) = (corner.x as i64, corner.y as i64);
            outline.draw(|dx, dy, cover| image.blend(left + i64::from(dx), top + i64::from(dy), colour, cover));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_all_that_is_written() {
        let font = font().unwrap();
        for letter in "0123456789.,-+%°≥ abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ".chars() {
            assert_ne!(font.glyph_id(letter).0, 0, "{letter}");
        }
    }

    #[test]
    fn what_cannot_be_written_is_named() {
        assert_eq!(missing("Faltung 漢字, 字: – α ≥"), "漢字");
        assert_eq!(missing("Kranich, 90 %"), "");
    }

    #[test]
    fn ink_lies_where_it_should() {
        let mut image = Image::new(100, 40, Some(Rgb::WHITE)).unwrap();
        draw(&mut image, "Hp", [10.0, 25.0], 20.0, Rgb::BLACK);
        let dark = |x: u32, y: u32| image.pixel(x, y)[0] < 128;
        let right = 10 + width("Hp", 20.0).ceil() as u32;
        let ink: Vec<(u32, u32)> =
            (0..100).flat_map(|x| (0..40).map(move |y| (x, y))).filter(|(x, y)| dark(*x, *y)).collect();
        assert!(ink.len() > 30 && ink.iter().all(|(x, y)| (10..right).contains(x) && (9..31).contains(y)), "{ink:?}");
        assert!(ink.iter().any(|(_, y)| *y > 26), "the p hangs below the line");
        assert!(width("mm", 20.0) > 1.9 * width("m", 20.0) && width("", 20.0) == 0.0);
        draw(&mut image, "far away", [-1e9, 1e9], 20.0, Rgb::BLACK);
    }
}
