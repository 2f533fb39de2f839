//! How a picture shall look; a [`Renderer`](crate::Renderer) draws it.

use origami_core::Error;

use crate::camera::{Camera, Frame, View};
use crate::figure::{Figure, LineSet};
use crate::image::Image;
use crate::legend::{Legend, text_size};
use crate::text;
use crate::theme::Theme;

/// How a figure shall be drawn, by whichever renderer.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels across. Default 1000.
    pub width: u32,
    /// Pixels down. Default 800.
    pub height: u32,
    /// Samples of each pixel: 1, 4, 8 or 16; more are smoother and slower. Default 16.
    pub samples: u32,
    /// From where. Default [`Camera::default`].
    pub camera: Camera,
    /// In which colours. Default [`Theme::paper`].
    pub theme: Theme,
    /// Which lines. Default: all but facets.
    pub edges: LineSet,
    /// Whether lines have the dashes of the theme, as in crease patterns; on folded paper they are drawn through. Default
    /// false.
    pub dashed: bool,
    /// How much wider or thinner lines are than the theme has them. Default 1.
    pub line_width: f32,
    /// Whether a figure with a map has its colour bar beside it, where there is room ([`legend::fits`](crate::legend::fits)). Default true.
    pub legend: bool,
    /// A line of text below the sheet. Default: none.
    pub caption: String,
}

impl Default for Picture {
    fn default() -> Self {
        Self {
            width: 1000,
            height: 800,
            samples: 16,
            camera: Camera::default(),
            theme: Theme::default(),
            edges: LineSet::default(),
            dashed: false,
            line_width: 1.0,
            legend: true,
            caption: String::new(),
        }
    }
}

impl Picture {
    /// The view in which `points` fill the picture, beside the colour bar if the figure has a map. For the frames of an
    /// animation: the points of all of them.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a size or camera that makes no sense.
    pub fn view(&self, figure: &Figure, points: impl Iterator<Item = [f32; 3]>) -> Result<View, Error> {
        let mut margins = [0.05 * f64::from(self.width.min(self.height)); 4];
        if let Some(legend) = self.legend_of(figure) {
            margins[2] = f64::from(legend.width);
        }
        if !self.caption.is_empty() {
            margins[3] += 1.5 * f64::from(text_size(self.width, self.height));
        }
        self.camera.view(points, &Frame { width: self.width, height: self.height, margins })
    }

    /// Adds the colour bar and the caption: what lies in the plane of the picture, whoever has drawn the sheet.
    pub fn annotate(&self, figure: &Figure, image: &mut Image) {
        if let Some(legend) = self.legend_of(figure) {
            legend.draw(image, &self.theme);
        }
        if !self.caption.is_empty() {
            let size = text_size(self.width, self.height);
            let right = self.width as f32 - self.legend_of(figure).map_or(0.0, |legend| legend.width);
            let left = 0.5 * (right - text::width(&self.caption, size));
            text::draw(image, &self.caption, [left, self.height as f32 - 1.1 * size], size, self.theme.text);
        }
    }

    fn legend_of(&self, figure: &Figure) -> Option<Legend> {
        let map = figure.map.as_ref().filter(|_| self.legend)?;
        Legend::new(&map.scale, self.width, self.height)
    }

    /// Width of a line of the theme's width 1, in pixels.
    #[must_use]
    pub fn line_scale(&self) -> f32 {
        Theme::line_scale(self.width, self.height) * self.line_width
    }
}
