//! Animated PNG.

use std::io::Write;

use origami_core::Error;

use super::Animation;
use crate::image::{Image, unwritable};

pub(super) struct Apng<W: Write> {
    writer: png::Writer<W>,
    transparent: bool,
}

impl<W: Write> Apng<W> {
    pub(super) fn new(writer: W, what: &Animation) -> Result<Self, Error> {
        let mut encoder = png::Encoder::new(writer, what.width, what.height);
        encoder.set_color(if what.transparent { png::ColorType::Rgba } else { png::ColorType::Rgb });
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        encoder.set_animated(what.frames, 0).map_err(unwritable)?;
        Ok(Self { writer: encoder.write_header().map_err(unwritable)?, transparent: what.transparent })
    }

    pub(super) fn push(&mut self, image: &Image, milliseconds: u16) -> Result<(), Error> {
        self.writer.set_frame_delay(milliseconds, 1000).map_err(unwritable)?;
        if self.transparent {
            return self.writer.write_image_data(&image.pixels).map_err(unwritable);
        }
        let rgb: Vec<u8> = image.pixels.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
        self.writer.write_image_data(&rgb).map_err(unwritable)
    }

    pub(super) fn finish(self) -> Result<(), Error> {
        self.writer.finish().map_err(unwritable)
    }
}
