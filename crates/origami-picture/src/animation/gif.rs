//! GIF: each frame with colours of its own.

use std::collections::BTreeMap;
use std::io::{self, Write};

use color_quant::NeuQuant;
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};
use origami_core::Error;

use super::Animation;
use crate::image::Image;

/// Colours of a frame, one of which is kept for what is transparent.
const COLOURS: usize = 255;

pub(super) struct Gif<W: Write> {
    encoder: Encoder<W>,
    size: [u16; 2],
}

impl<W: Write> Gif<W> {
    pub(super) fn new(writer: W, what: &Animation) -> Result<Self, Error> {
        let side = |side: u32| {
            u16::try_from(side).map_err(|_| Error::invalid("size", format!("{side} pixels"), "at most 65535 in a GIF"))
        };
        let size = [side(what.width)?, side(what.height)?];
        let mut encoder = Encoder::new(writer, size[0], size[1], &[]).map_err(unwritable)?;
        encoder.set_repeat(Repeat::Infinite).map_err(unwritable)?;
        Ok(Self { encoder, size })
    }

    pub(super) fn push(&mut self, image: &Image, milliseconds: u16) -> Result<(), Error> {
        let (palette, indices, transparent) = quantise(image);
        let frame = Frame {
            delay: milliseconds.div_ceil(10),
            dispose: if transparent { DisposalMethod::Background } else { DisposalMethod::Keep },
            transparent: transparent.then_some(COLOURS as u8),
            width: self.size[0],
            height: self.size[1],
            palette: Some(palette),
            buffer: indices.into(),
            ..Frame::default()
        };
        self.encoder.write_frame(&frame).map_err(unwritable)
    }

    pub(super) fn finish(self) -> Result<(), Error> {
        let mut writer = self.encoder.into_inner().map_err(unwritable)?;
        writer.flush().map_err(|source| Error::Io { path: "-".into(), source })
    }
}

/// A palette, the place of each pixel in it, and whether any is transparent: these have the last place.
///
/// Few colours are kept as they are. Of many, the most frequent are kept (the ground would flicker otherwise) and the
/// others brought together by A. Dekker's neural network (Network 5, 1994, 351).
fn quantise(image: &Image) -> (Vec<u8>, Vec<u8>, bool) {
    const KEPT: usize = 15;
    let opaque = |p: &[u8]| p[3] >= 128;
    let mut counts: BTreeMap<[u8; 3], u32> = BTreeMap::new();
    for pixel in image.pixels.chunks_exact(4).filter(|p| opaque(p)) {
        *counts.entry([pixel[0], pixel[1], pixel[2]]).or_default() += 1;
    }
    let mut colours: Vec<([u8; 3], u32)> = counts.into_iter().collect();
    colours.sort_by_key(|(colour, count)| (std::cmp::Reverse(*count), *colour));
    let kept = if colours.len() <= COLOURS { colours.len() } else { KEPT };
    let mut palette: Vec<u8> = colours[..kept].iter().flat_map(|(colour, _)| *colour).collect();
    let mut place: BTreeMap<[u8; 3], u8> = BTreeMap::new();
    place.extend(colours[..kept].iter().enumerate().map(|(i, (colour, _))| (*colour, i as u8)));
    if kept < colours.len() {
        // Each colour in proportion to the root of how often it occurs: small coloured lines matter more than their area.
        let samples: Vec<u8> = colours[kept..]
            .iter()
            .flat_map(|([r, g, b], count)| [*r, *g, *b, 255].repeat(f64::from(*count).sqrt().ceil() as usize))
            .collect();
        let network = NeuQuant::new(3, COLOURS - kept, &samples);
        palette.extend(network.color_map_rgb());
        for ([r, g, b], _) in &colours[kept..] {
            place.insert([*r, *g, *b], (kept + network.index_of(&[*r, *g, *b, 255])) as u8);
        }
    }
    palette.resize(3 * (COLOURS + 1), 0);
    let mut transparent = false;
    let indices = image.pixels.chunks_exact(4).map(|p| {
        transparent |= !opaque(p);
        if opaque(p) { place.get(&[p[0], p[1], p[2]]).copied().unwrap_or_default() } else { COLOURS as u8 }
    });
    let indices = indices.collect();
    (palette, indices, transparent)
}

fn unwritable(error: EncodingError) -> Error {
    let source = match error {
        EncodingError::Io(source) => source,
        other => io::Error::other(other),
    };
    Error::Io { path: "-".into(), source }
}
