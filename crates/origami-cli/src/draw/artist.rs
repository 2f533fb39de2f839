//! What draws: the processor, or a GPU where one is at hand.

use std::cell::RefCell;

use origami::Error;
use origami::picture::{DrawError, Figure, Image, Picture, Processor, Renderer, View};

use super::Style;
use crate::backend::Backend;

/// What a command draws with, and how it shall look. What a GPU fails at the processor draws instead.
#[derive(Default)]
pub(crate) struct Artist {
    pub(super) style: Style,
    gpu: Option<Box<dyn Renderer>>,
    trouble: RefCell<Option<String>>,
}

impl Artist {
    /// Draws on the GPU of `backend`, if there is one; without a backend on the processor.
    pub(crate) fn new(style: Style, backend: Option<&Backend>) -> Self {
        let (gpu, trouble) = match backend.and_then(Backend::renderer) {
            None => (None, None),
            Some(Ok(renderer)) => (Some(renderer), None),
            Some(Err(why)) => (None, Some(why)),
        };
        Self { style, gpu, trouble: trouble.into() }
    }

    /// Why pictures that a GPU was to draw came from the processor.
    pub(crate) fn trouble(&self) -> Option<String> {
        self.trouble.borrow().clone()
    }

    /// Draws the figure as this view shows it.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a picture or figure that makes no sense.
    pub(super) fn draw(&self, picture: &Picture, figure: &Figure, view: &View) -> Result<Image, Error> {
        if let Some(gpu) = &self.gpu {
            match gpu.draw_from(picture, figure, view) {
                Ok(image) => return Ok(image),
                Err(DrawError::Invalid(error)) => return Err(error),
                Err(error) => *self.trouble.borrow_mut() = Some(error.to_string()),
            }
        }
        Processor.draw_from(picture, figure, view).map_err(|error| match error {
            DrawError::Invalid(error) => error,
            other => Error::invalid("pictures", other.to_string(), "a picture by the processor"),
        })
    }
}
