//! What draws: the processor, or a GPU where one is at hand.

use origami::Error;
use origami::picture::{Image, Picture, Scene, View};

/// The processor unless it was given a GPU's renderer. What the GPU fails at the processor draws instead.
#[derive(Default)]
pub(crate) struct Brush {
    #[cfg(feature = "gpu")]
    gpu: Option<origami::gpu::render::Renderer>,
    trouble: std::cell::RefCell<Option<String>>,
}

impl Brush {
    /// Draws on this GPU.
    #[cfg(feature = "gpu")]
    pub(crate) fn on(gpu: &origami::gpu::Gpu) -> Self {
        match origami::gpu::render::Renderer::new(gpu) {
            Ok(renderer) => Self { gpu: Some(renderer), ..Self::default() },
            Err(error) => Self { trouble: Some(error.to_string()).into(), ..Self::default() },
        }
    }

    /// Why pictures that a GPU was to draw came from the processor.
    pub(crate) fn trouble(&self) -> Option<String> {
        self.trouble.borrow().clone()
    }

    /// Draws the scene as this view shows it.
    ///
    /// # Errors
    /// As for [`Picture::draw_from`].
    pub(super) fn draw(&self, picture: &Picture, scene: &Scene, view: &View) -> Result<Image, Error> {
        #[cfg(feature = "gpu")]
        if let Some(renderer) = &self.gpu {
            match renderer.draw_from(picture, scene, view) {
                Ok(image) => return Ok(image),
                Err(origami::gpu::render::DrawError::Scene(error)) => return Err(error),
                Err(error) => *self.trouble.borrow_mut() = Some(error.to_string()),
            }
        }
        picture.draw_from(scene, view)
    }
}
