//! Pictures on whatever adapter there is, held against the processor's.

mod agreement;
mod limits;
mod sessions;
mod shaders;

use std::fs::{self, File};
use std::path::PathBuf;
use std::sync::OnceLock;

use origami_core::generate::catalog;
use origami_core::{CreasePattern, Material, Model, Relax, Solver, State};
use origami_picture::difference::{Difference, TOLERANCE, compare};
use origami_picture::{Figure, Image, Picture, Processor, Renderer};

use super::GpuRenderer;
use crate::testing::gpu;

/// One for all tests, if there is an adapter.
fn renderer() -> Option<&'static GpuRenderer> {
    static SHARED: OnceLock<Option<GpuRenderer>> = OnceLock::new();
    SHARED.get_or_init(|| gpu().map(|gpu| GpuRenderer::new(&gpu).expect("every adapter draws"))).as_ref()
}

fn folded(name: &str, percent: f64) -> (CreasePattern, Model, State) {
    let pattern = catalog::generate(name, &[]).unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    let state = Relax::default().fold_from_rest(&model, percent).unwrap().state;
    (pattern, model, state)
}

fn figure(name: &str, percent: f64) -> Figure {
    let (pattern, model, state) = folded(name, percent);
    Figure::new(&pattern, &model, &state.positions)
}

fn small() -> Picture {
    Picture { width: 400, height: 320, ..Picture::default() }
}

/// Where pictures are left that are worth a look.
fn folder() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let folder = test.ancestors().nth(2).unwrap().join("pictures");
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn write(name: &str, image: &Image) {
    image.write_png(File::create(folder().join(format!("{name}.png"))).unwrap()).unwrap();
}

/// Holds a picture against the one that it should be. Where they differ, both and their difference are left in
/// [`folder`]; with `ORIGAMI_KEEP_PICTURES` they always are.
fn check(name: &str, is: &Image, should_be: &Image) {
    let (difference, shown) = compare(is, should_be).unwrap();
    let fails = !difference.within(&TOLERANCE);
    if fails || std::env::var_os("ORIGAMI_KEEP_PICTURES").is_some() {
        for (what, image) in [("is", is), ("should-be", should_be), ("difference", &shown)] {
            write(&format!("{name}-{what}"), image);
        }
    }
    assert!(!fails, "{name}: {difference:?}, more than {TOLERANCE:?}; see {}", folder().display());
}

/// What [`check`] looks at.
fn differ(one: &Image, two: &Image) -> Difference {
    compare(one, two).unwrap().0
}
