//! Finished pictures, and PNG.

use std::io::Write;

use origami_core::Error;

use crate::colour::Rgb;

/// A picture: 8 bits a channel, sRGB, alpha not multiplied in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Red, green, blue and alpha of each pixel, row by row from the top.
    pub pixels: Vec<u8>,
}

impl Image {
    /// The most pixels that a side may have.
    pub const LONGEST: u32 = 16_384;
    /// The most pixels that a picture may have: 400 MB.
    pub const MOST: u64 = 100_000_000;

    /// One of a single colour; `None` is transparent.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a picture without pixels, or beyond [`Image::LONGEST`] or [`Image::MOST`].
    pub fn new(width: u32, height: u32, colour: Option<Rgb>) -> Result<Self, Error> {
        let count = u64::from(width) * u64::from(height);
        if width == 0 || height == 0 || width > Self::LONGEST || height > Self::LONGEST || count > Self::MOST {
            let expected =
                format!("1 to {} a side and at most {} million in all", Self::LONGEST, Self::MOST / 1_000_000);
            return Err(Error::invalid("size", format!("{width} x {height} pixels"), expected));
        }
        let pixel = colour.map_or([0; 4], |Rgb(r, g, b)| [r, g, b, 255]);
        Ok(Self { width, height, pixels: pixel.repeat(count as usize) })
    }

    /// Red, green, blue and alpha; transparent outside.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        let inside = x < self.width && y < self.height;
        let start = 4 * (y as usize * self.width as usize + x as usize);
        let pixel = self.pixels.get(start..start + 4).filter(|_| inside);
        pixel.and_then(|p| p.try_into().ok()).unwrap_or_default()
    }

    /// Lays `colour` over a pixel, covering this share of it (0 to 1); nothing happens outside.
    pub fn blend(&mut self, x: i64, y: i64, colour: Rgb, cover: f32) {
        let (Ok(column), Ok(row)) = (u32::try_from(x), u32::try_from(y)) else { return };
        if column >= self.width || row >= self.height || cover.is_nan() || cover <= 0.0 {
            return;
        }
        let start = 4 * (row as usize * self.width as usize + column as usize);
        let Some(pixel) = self.pixels.get_mut(start..start + 4) else { return };
        let cover = cover.min(1.0);
        let below = f32::from(pixel[3]) / 255.0 * (1.0 - cover);
        let alpha = cover + below;
        for (channel, value) in pixel.iter_mut().zip([colour.0, colour.1, colour.2]) {
            *channel = ((f32::from(value) * cover + f32::from(*channel) * below) / alpha + 0.5) as u8;
        }
        pixel[3] = (alpha * 255.0 + 0.5) as u8;
    }

    /// Fills a rectangle; what lies outside the picture is left out.
    pub fn fill(&mut self, left: i64, top: i64, width: i64, height: i64, colour: Rgb) {
        let clamp = |x: i64, most: u32| x.clamp(0, i64::from(most));
        for y in clamp(top, self.height)..clamp(top.saturating_add(height), self.height) {
            for x in clamp(left, self.width)..clamp(left.saturating_add(width), self.width) {
                self.blend(x, y, colour, 1.0);
            }
        }
    }

    /// Copies another picture into this one, its upper left corner at these pixels; what does not fit is left out.
    pub fn place(&mut self, other: &Self, left: u32, top: u32) {
        let columns = other.width.min(self.width.saturating_sub(left)) as usize;
        for row in 0..other.height.min(self.height.saturating_sub(top)) {
            let from = 4 * row as usize * other.width as usize;
            let to = 4 * ((top + row) as usize * self.width as usize + left as usize);
            let source = other.pixels.get(from..from + 4 * columns);
            if let (Some(source), Some(target)) = (source, self.pixels.get_mut(to..to + 4 * columns)) {
                target.copy_from_slice(source);
            }
        }
    }

    /// Whether nothing shines through.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.pixels.iter().skip(3).step_by(4).all(|alpha| *alpha == 255)
    }

    /// Writes it as PNG: RGB where it is opaque, else RGBA.
    ///
    /// # Errors
    /// [`Error::Io`] with path `-` if writing fails.
    pub fn write_png(&self, writer: impl Write) -> Result<(), Error> {
        let opaque = self.is_opaque();
        let mut encoder = png::Encoder::new(writer, self.width, self.height);
        encoder.set_color(if opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header().map_err(unwritable)?;
        if opaque {
            let rgb: Vec<u8> = self.pixels.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
            writer.write_image_data(&rgb).map_err(unwritable)?;
        } else {
            writer.write_image_data(&self.pixels).map_err(unwritable)?;
        }
        writer.finish().map_err(unwritable)
    }
}

/// Names the output by `-` until [`write_whole`](origami_core::export::write_whole) knows better.
pub(crate) fn unwritable(error: png::EncodingError) -> Error {
    let source = match error {
        png::EncodingError::IoError(source) => source,
        other => std::io::Error::other(other),
    };
    Error::Io { path: "-".into(), source }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> (png::ColorType, Vec<u8>) {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!(reader.info().srgb, Some(png::SrgbRenderingIntent::Perceptual));
        (info.color_type, pixels)
    }

    #[test]
    fn what_is_written_is_read_again() {
        let mut image = Image::new(3, 2, Some(Rgb(10, 20, 30))).unwrap();
        image.blend(1, 1, Rgb(200, 100, 0), 1.0);
        let mut bytes = Vec::new();
        image.write_png(&mut bytes).unwrap();
        let (colours, pixels) = read(&bytes);
        assert_eq!((colours, &pixels[12..15]), (png::ColorType::Rgb, &[200, 100, 0][..]));
        let mut image = Image::new(3, 2, None).unwrap();
        image.blend(0, 0, Rgb(200, 100, 0), 0.5);
        let mut bytes = Vec::new();
        image.write_png(&mut bytes).unwrap();
        assert_eq!(read(&bytes), (png::ColorType::Rgba, image.pixels.clone()));
        assert_eq!(image.pixel(0, 0), [200, 100, 0, 128], "the colour is not darkened by what is not there");
    }

    #[test]
    fn sizes_beyond_sense_are_refused() {
        for (width, height) in [(0, 5), (5, 0), (16_385, 1), (16_000, 16_000), (u32::MAX, u32::MAX)] {
            let error = Image::new(width, height, None).unwrap_err().to_string();
            assert!(error.starts_with(&format!("size: {width} x {height} pixels; expected ")), "{error}");
        }
    }

    #[test]
    fn painting_stays_inside() {
        let mut image = Image::new(4, 4, None).unwrap();
        image.fill(-5, -5, 7, i64::MAX, Rgb::BLACK);
        image.blend(i64::MIN, 0, Rgb::BLACK, 1.0);
        assert_eq!(image.pixels.chunks(4).filter(|p| p[3] == 255).count(), 8);
        let other = Image::new(3, 3, Some(Rgb::WHITE)).unwrap();
        image.place(&other, 2, 3);
        assert_eq!((image.pixel(3, 3), image.pixel(1, 3)), ([255; 4], [0, 0, 0, 255]));
        image.place(&other, 9, 9);
        assert_eq!(image.pixel(9, 9), [0; 4]);
    }
}
