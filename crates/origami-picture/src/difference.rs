//! How much two pictures differ to the eye.

use origami_core::Error;

use crate::colour::{Rgb, to_linear};
use crate::image::Image;

/// Differences in CIELAB (CIE 1976): about 1 can just be told by an eye that sees both colours side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Over the whole picture.
    pub mean: f64,
    /// Over the worst square of 8 x 8 pixels: a line that is missing, a layer in the wrong place.
    pub block: f64,
}

/// Edges may fall on another sample where rounding differs between machines, or between a processor and a GPU: a share of
/// a pixel here and there. A colour that is off by one in 255 everywhere is 0.4 at most.
pub const TOLERANCE: Difference = Difference { mean: 0.4, block: 4.0 };

impl Difference {
    /// Whether it is no more than the other in both.
    #[must_use]
    pub fn within(&self, tolerance: &Self) -> bool {
        self.mean <= tolerance.mean && self.block <= tolerance.block
    }
}

/// The difference of two pictures of one size, what is transparent on white, and what it looks like: red on white.
///
/// # Errors
/// [`Error::Invalid`] for pictures of different sizes.
pub fn compare(a: &Image, b: &Image) -> Result<(Difference, Image), Error> {
    const BLOCK: u32 = 8;
    if (a.width, a.height) != (b.width, b.height) {
        let problem = format!("{} x {} and {} x {} pixels", a.width, a.height, b.width, b.height);
        return Err(Error::invalid("size", problem, "two pictures of one size"));
    }
    let (blurred_a, blurred_b) = (blurred(a), blurred(b));
    let mut shown = Image::new(a.width, a.height, Some(Rgb::WHITE))?;
    let columns = a.width.div_ceil(BLOCK) as usize;
    let mut blocks = vec![(0.0, 0.0); columns * a.height.div_ceil(BLOCK) as usize];
    for (i, (a_light, b_light)) in blurred_a.iter().zip(&blurred_b).enumerate() {
        let (x, y) = (i as u32 % a.width, i as u32 / a.width);
        let [p, q] = [a_light, b_light].map(|light| lab(*light));
        let far = (0..3).map(|c| (p[c] - q[c]).powi(2)).sum::<f64>().sqrt();
        let block = &mut blocks[(y / BLOCK) as usize * columns + (x / BLOCK) as usize];
        *block = (block.0 + far, block.1 + 1.0);
        shown.blend(i64::from(x), i64::from(y), Rgb(255, 0, 0), (far / 20.0) as f32);
    }
    let sum: f64 = blocks.iter().map(|(sum, _)| sum).sum();
    let mean = sum / f64::from(a.width * a.height);
    let block = blocks.iter().map(|(sum, count)| sum / count).fold(0.0, f64::max);
    Ok((Difference { mean, block }, shown))
}

/// Linear light on white, over squares of 3 x 3 pixels: an eye does not see single ones.
fn blurred(image: &Image) -> Vec<[f64; 3]> {
    let light = |x: i64, y: i64| {
        let clamp = |v: i64, most: u32| v.clamp(0, i64::from(most) - 1) as u32;
        let [r, g, b, alpha] = image.pixel(clamp(x, image.width), clamp(y, image.height));
        let alpha = f64::from(alpha) / 255.0;
        [r, g, b].map(|c| f64::from(to_linear(f32::from(c) / 255.0)) * alpha + 1.0 - alpha)
    };
    let places = (0..i64::from(image.height)).flat_map(|y| (0..i64::from(image.width)).map(move |x| (x, y)));
    let mean = |(x, y): (i64, i64)| {
        let mut sum = [0.0; 3];
        for (dx, dy) in (-1..2).flat_map(|dx| (-1..2).map(move |dy| (dx, dy))) {
            let here = light(x + dx, y + dy);
            (0..3).for_each(|c| sum[c] += here[c] / 9.0);
        }
        sum
    };
    places.map(mean).collect()
}

/// CIE L*a*b* of linear sRGB, under D65.
fn lab([r, g, b]: [f64; 3]) -> [f64; 3] {
    let x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505;
    let y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089;
    let f = |t: f64| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 };
    [116.0 * f(y) - 16.0, 500.0 * (f(x) - f(y)), 200.0 * (f(y) - f(z))]
}
