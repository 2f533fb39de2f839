//! One picture of one scene.

use origami_core::Error;

use crate::camera::{Camera, Frame, View};
use crate::image::Image;
use crate::raster;
use crate::scene::{LineSet, Scene};
use crate::theme::Theme;

/// How a scene is to be drawn.
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
    /// How much wider or thinner lines are than the theme has them. Default 1.
    pub line_width: f32,
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
            line_width: 1.0,
        }
    }
}

impl Picture {
    /// Draws the scene, which fills the picture.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a size, camera or scene that makes no sense.
    pub fn draw(&self, scene: &Scene) -> Result<Image, Error> {
        let view = self.view(scene.positions.iter().copied())?;
        self.draw_from(scene, &view)
    }

    /// The view in which `points` fill the picture; for the frames of an animation, the points of all of them.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a size or camera that makes no sense.
    pub fn view(&self, points: impl Iterator<Item = [f32; 3]>) -> Result<View, Error> {
        let margin = 0.05 * f64::from(self.width.min(self.height));
        let frame = Frame { width: self.width, height: self.height, margins: [margin; 4] };
        self.camera.view(points, &frame)
    }

    /// Draws the scene as this view shows it.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a size or scene that makes no sense.
    pub fn draw_from(&self, scene: &Scene, view: &View) -> Result<Image, Error> {
        raster::draw(self, scene, view)
    }

    /// Width of a line of the theme's width 1, in pixels.
    #[must_use]
    pub fn line_scale(&self) -> f32 {
        Theme::line_scale(self.width, self.height) * self.line_width
    }
}
