//! Pictures of folded sheets, drawn without a GPU.
//!
//! A [`Figure`] says what there is (triangles, lines, values for a map), a [`Camera`] from where it is seen and a [`Theme`]
//! in which colours: plain data, from which any [`Renderer`] may draw. The one here, [`Processor`], is a small rasteriser;
//! equal input gives equal bits, whatever the number of threads. The feature `render` of `origami-gpu` has another.
//!
//! ```
//! use origami_core::{Material, Model, Relax, Solver, generate::BirdBase};
//! use origami_picture::{Figure, Picture, Processor, Renderer};
//!
//! let pattern = BirdBase::default().pattern()?;
//! let model = Model::new(&pattern, &Material::default())?;
//! let folded = Relax::default().fold_from_rest(&model, 60.0)?;
//! let figure = Figure::new(&pattern, &model, &folded.state.positions);
//! let mut png = Vec::new();
//! let picture = Picture { width: 400, height: 300, ..Picture::default() };
//! Processor.draw(&picture, &figure)?.write_png(&mut png)?;
//! assert!(png.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | to make | take |
//! |---|---|
//! | a picture of a folded sheet | [`Figure`] and [`Picture`] |
//! | soft shadows, where paper lies before paper | [`Figure::shade`] |
//! | a map of strain, angle errors or energy | [`Map`], with a [`Quantity`] and a [`ColourMap`] |
//! | a crease pattern as it lies, or as SVG | [`pattern`] |
//! | several states in one picture | [`contact_sheet`] |
//! | a film as APNG, GIF or numbered PNG | [`Animation`] |
//! | a file for viewers, the folding as morph targets | [`Glb`] |
//!
//! Layers that lie on each other are drawn in an order that is found from the folded state ([`layers`]). `gpu::render` of the
//! facade `origami` draws the same figures on a GPU.
#![forbid(unsafe_code)]

pub mod animation;
pub mod camera;
pub mod colour;
pub mod difference;
mod extent;
pub mod figure;
pub mod glb;
pub mod image;
pub mod layers;
pub mod legend;
pub mod map;
pub mod marks;
pub mod openness;
pub mod pattern;
mod picture;
pub mod raster;
mod renderer;
pub mod shade;
mod sheet;
pub mod text;
pub mod theme;

pub use animation::{Animation, Format, Frames};
pub use camera::{Camera, Frame, Projection, View};
pub use colour::Rgb;
pub use figure::{Figure, Line, LineKind, LineSet};
pub use glb::Glb;
pub use image::Image;
pub use map::{ColourMap, Map, Quantity};
pub use marks::{MarkKind, Marks};
pub use openness::Openness;
pub use picture::Picture;
pub use raster::Processor;
pub use renderer::{DrawError, Renderer};
pub use sheet::contact_sheet;
pub use theme::{LineStyle, Theme};
