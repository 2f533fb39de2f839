//! Whoever draws: the processor, a GPU, or anything else that makes an image of a figure.

use origami_core::Error;

use crate::camera::View;
use crate::figure::Figure;
use crate::image::Image;
use crate::picture::Picture;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DrawError {
    /// The picture or the figure makes no sense, whoever is to draw it.
    #[error(transparent)]
    Invalid(#[from] Error),
    /// This renderer's device cannot draw it, or stopped; another renderer may.
    #[error(transparent)]
    Device(Box<dyn std::error::Error + Send + Sync>),
}

/// Draws pictures of figures: [`Processor`](crate::raster::Processor) does, and so does the GPU of `origami-gpu`.
pub trait Renderer {
    /// Draws `figure` as `view` shows it.
    ///
    /// # Errors
    /// [`DrawError::Invalid`] for a size or figure that makes no sense; what the renderer's device says.
    fn draw_from(&self, picture: &Picture, figure: &Figure, view: &View) -> Result<Image, DrawError>;

    /// Draws `figure` so that it fills the picture.
    ///
    /// # Errors
    /// As for [`Renderer::draw_from`], and for a camera that makes no sense.
    fn draw(&self, picture: &Picture, figure: &Figure) -> Result<Image, DrawError> {
        let view = picture.view(figure, figure.positions.iter().copied())?;
        self.draw_from(picture, figure, &view)
    }
}
