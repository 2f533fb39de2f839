//! Moving pictures: frames are handed over one by one and written at once, so that memory does not grow with their
//! number.

mod apng;
mod gif;

use std::io::Write;

use origami_core::Error;

use crate::image::Image;

/// The kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Animated PNG: all colours.
    Apng,
    /// GIF: 256 colours a frame, no half transparent pixels, read everywhere.
    Gif,
}

impl Format {
    /// The format that a file's extension (without its dot) stands for.
    #[must_use]
    pub fn of_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "apng" | "png" => Some(Self::Apng),
            "gif" => Some(Self::Gif),
            _ => None,
        }
    }
}

/// What an animation is like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Animation {
    /// The kind of file.
    pub format: Format,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// How many frames there will be.
    pub frames: u32,
    /// Whether something shines through.
    pub transparent: bool,
}

/// Writes an animation that runs over and over.
pub struct Frames<W: Write> {
    what: Animation,
    written: u32,
    encoder: Encoder<W>,
}

enum Encoder<W: Write> {
    Apng(apng::Apng<W>),
    Gif(gif::Gif<W>),
}

impl Animation {
    /// Writes what comes before the frames.
    ///
    /// # Errors
    /// [`Error::Invalid`] for no frames, or a size that the format has no room for; [`Error::Io`] with path `-` if writing
    /// fails.
    pub fn write<W: Write>(self, writer: W) -> Result<Frames<W>, Error> {
        if self.frames == 0 {
            return Err(Error::invalid("frames", "0", "at least one"));
        }
        // Holds it to the limits of pictures.
        Image::new(self.width, self.height, None)?;
        let encoder = match self.format {
            Format::Apng => Encoder::Apng(apng::Apng::new(writer, &self)?),
            Format::Gif => Encoder::Gif(gif::Gif::new(writer, &self)?),
        };
        Ok(Frames { what: self, written: 0, encoder })
    }
}

impl<W: Write> Frames<W> {
    /// Adds a frame that is shown for so many milliseconds (GIF has hundredths of a second).
    ///
    /// # Errors
    /// [`Error::Invalid`] for a frame of another size or one too many; [`Error::Io`] with path `-` if writing fails.
    pub fn push(&mut self, image: &Image, milliseconds: u16) -> Result<(), Error> {
        let place = || format!("frame {}", self.written);
        let Animation { width, height, frames, .. } = self.what;
        if (image.width, image.height) != (width, height) {
            let problem = format!("{} x {} pixels", image.width, image.height);
            return Err(Error::invalid(place(), problem, format!("{width} x {height}, as the animation")));
        }
        if self.written == frames {
            return Err(Error::invalid(place(), "is one too many", format!("{frames} frames")));
        }
        self.written += 1;
        match &mut self.encoder {
            Encoder::Apng(apng) => apng.push(image, milliseconds),
            Encoder::Gif(gif) => gif.push(image, milliseconds),
        }
    }

    /// Writes what comes after the frames.
    ///
    /// # Errors
    /// [`Error::Invalid`] if frames are missing; [`Error::Io`] with path `-` if writing fails.
    pub fn finish(self) -> Result<(), Error> {
        if self.written < self.what.frames {
            let problem = format!("{} have been written", self.written);
            return Err(Error::invalid("frames", problem, self.what.frames.to_string()));
        }
        match self.encoder {
            Encoder::Apng(apng) => apng.finish(),
            Encoder::Gif(gif) => gif.finish(),
        }
    }
}

/// The name of a numbered frame, such as `crane-007.png` for frame 7 of 120 of `crane.png`: names sort as frames do.
#[must_use]
pub fn numbered(stem: &str, frame: u32, frames: u32) -> String {
    let digits = frames.saturating_sub(1).to_string().len().max(3);
    format!("{stem}-{frame:0digits$}.png")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::Rgb;

    fn frame(shade: u8) -> Image {
        let mut image = Image::new(20, 10, Some(Rgb::WHITE)).unwrap();
        image.fill(2, 2, 5, 5, Rgb(shade, 0, 255 - shade));
        image
    }

    fn written(format: Format, transparent: bool, images: &[Image]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let animation = Animation { format, width: 20, height: 10, frames: images.len() as u32, transparent };
        let mut frames = animation.write(&mut bytes).unwrap();
        images.iter().for_each(|image| frames.push(image, 40).unwrap());
        frames.finish().unwrap();
        bytes
    }

    #[test]
    fn apng_has_all_frames_as_they_were() {
        let images = [frame(0), frame(100), frame(255)];
        let bytes = written(Format::Apng, false, &images);
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        let control = *reader.info().animation_control().unwrap();
        assert_eq!((control.num_frames, control.num_plays), (3, 0));
        for image in &images {
            let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut pixels).unwrap();
            let rgb: Vec<u8> = image.pixels.chunks(4).flat_map(|p| p[..3].to_vec()).collect();
            assert_eq!(pixels, rgb);
            assert_eq!(reader.info().frame_control().unwrap().delay_num, 40);
        }
    }

    #[test]
    fn gif_has_all_frames_and_few_colours_exactly() {
        let mut clear = Image::new(20, 10, None).unwrap();
        clear.fill(0, 0, 3, 3, Rgb(9, 8, 7));
        for images in [vec![frame(0), frame(100), frame(255)], vec![clear]] {
            let bytes = written(Format::Gif, true, &images);
            let mut options = ::gif::DecodeOptions::new();
            options.set_color_output(::gif::ColorOutput::RGBA);
            let mut decoder = options.read_info(&bytes[..]).unwrap();
            assert_eq!(decoder.repeat(), ::gif::Repeat::Infinite);
            for image in &images {
                let frame = decoder.read_next_frame().unwrap().unwrap();
                assert_eq!(frame.delay, 4);
                let same = frame.buffer.chunks(4).zip(image.pixels.chunks(4));
                assert!(same.clone().all(|(a, b)| a == b || (a[3] == 0 && b[3] == 0)));
            }
            assert!(decoder.read_next_frame().unwrap().is_none());
        }
    }

    #[test]
    fn gif_keeps_the_ground_exactly_where_colours_are_many() {
        let mut image = Image::new(64, 64, Some(Rgb(250, 251, 252))).unwrap();
        for x in 8..56 {
            for y in 8..56 {
                image.blend(x, y, Rgb(x as u8 * 4, y as u8 * 4, (x * y) as u8), 1.0);
            }
        }
        let mut bytes = Vec::new();
        let animation = Animation { format: Format::Gif, width: 64, height: 64, frames: 1, transparent: false };
        let mut frames = animation.write(&mut bytes).unwrap();
        frames.push(&image, 100).unwrap();
        frames.finish().unwrap();
        let mut options = ::gif::DecodeOptions::new();
        options.set_color_output(::gif::ColorOutput::RGBA);
        let mut decoder = options.read_info(&bytes[..]).unwrap();
        let shown = decoder.read_next_frame().unwrap().unwrap().buffer.to_vec();
        let differences = shown.iter().zip(&image.pixels).map(|(a, b)| f64::from(a.abs_diff(*b)));
        assert!(differences.sum::<f64>() / (shown.len() as f64) < 6.0);
        assert_eq!(shown[..3], [250, 251, 252]);
    }

    #[test]
    fn wrong_frames_are_refused() {
        let animation = Animation { format: Format::Gif, width: 20, height: 10, frames: 1, transparent: false };
        let mut frames = animation.write(Vec::new()).unwrap();
        assert!(frames.push(&Image::new(3, 3, None).unwrap(), 40).is_err());
        frames.push(&frame(1), 40).unwrap();
        let error = frames.push(&frame(1), 40).unwrap_err().to_string();
        assert_eq!(error, "frame 1: is one too many; expected 1 frames");
        assert!(animation.write(Vec::new()).unwrap().finish().is_err(), "its frame is missing");
        assert!(Animation { frames: 0, ..animation }.write(Vec::new()).is_err());
        assert_eq!(numbered("crane", 7, 120), "crane-007.png");
        assert_eq!(numbered("crane", 7, 12_000), "crane-00007.png");
    }
}
