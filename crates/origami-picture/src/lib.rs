//! Pictures of folded sheets, drawn without a GPU.
//!
//! A [`Scene`] says what there is (triangles, lines, values for a map), a [`Camera`] from where it is seen and a [`Theme`]
//! in which colours: plain data, from which any renderer may draw. The one here is a small rasteriser on the CPU; equal input
//! gives equal bits, whatever the number of threads.
//!
//! ```
//! use origami_core::{Material, Model, Relax, generate::BirdBase};
//! use origami_picture::{Picture, Scene};
//!
//! let pattern = BirdBase::default().pattern()?;
//! let model = Model::new(&pattern, &Material::default())?;
//! let folded = Relax::default().fold_from_rest(&model, 60.0)?;
//! let scene = Scene::new(&pattern, &model, &folded.state.positions);
//! let mut png = Vec::new();
//! Picture { width: 400, height: 300, ..Picture::default() }.draw(&scene)?.write_png(&mut png)?;
//! assert!(png.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | to make | take |
//! |---|---|
//! | a picture of a folded sheet | [`Scene`] and [`Picture`] |
//! | a map of strain, angle errors or energy | [`Map`], with a [`Quantity`] and a [`ColourMap`] |
//! | a crease pattern as it lies, or as SVG | [`pattern`] |
//! | several states in one picture | [`contact_sheet`] |
//! | a film as APNG, GIF or numbered PNG | [`Animation`] |
//! | a file for viewers, the folding as morph targets | [`Glb`] |
//!
//! Layers that lie on each other are drawn in an order that is found from the folded state ([`layers`]). `gpu::render` of the
//! facade `origami` draws the same scenes on a GPU.
#![forbid(unsafe_code)]

pub mod animation;
pub mod camera;
pub mod colour;
pub mod difference;
pub mod glb;
pub mod image;
pub mod layers;
mod legend;
pub mod map;
pub mod pattern;
mod picture;
pub mod raster;
pub mod scene;
pub mod shade;
mod sheet;
pub mod text;
pub mod theme;

pub use animation::{Animation, Format, Frames};
pub use camera::{Camera, Frame, Projection, View};
pub use colour::Rgb;
pub use glb::Glb;
pub use image::Image;
pub use map::{ColourMap, Map, Quantity};
pub use picture::Picture;
pub use scene::{Line, LineKind, LineSet, Scene};
pub use sheet::contact_sheet;
pub use theme::{LineStyle, Theme};
