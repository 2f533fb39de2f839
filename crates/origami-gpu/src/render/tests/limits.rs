//! Tiles, adapters that cannot do everything, and nonsense.

use origami_picture::{Camera, LineSet, Projection, Theme};

use super::super::tiles::Tiles;
use super::super::{DrawError, GpuRenderer};
use super::*;

#[test]
fn tiles_equal_one_piece() {
    let Some(whole) = renderer() else { return };
    let figure = figure("crane", 90.0);
    for (projection, tile) in [(Projection::Orthographic, 100), (Projection::Perspective(50.0), 67)] {
        let camera = Camera { projection, ..Camera::default() };
        let picture = Picture { camera, theme: Theme::mono(), edges: LineSet::ALL, ..small() };
        let tiled = GpuRenderer::with(&whole.gpu, tile, whole.multisampled.is_some()).unwrap();
        let (is, should_be) = (tiled.draw(&picture, &figure).unwrap(), whole.draw(&picture, &figure).unwrap());
        // Rounding of depths where a line and a face are equally near.
        let differ = is.pixels.iter().zip(&should_be.pixels).filter(|(a, b)| a.abs_diff(**b) > 1).count();
        assert!(differ < is.pixels.len() / 2000, "{differ} of {}", is.pixels.len());
        check(&format!("tiles-{tile}"), &is, &should_be);
    }
}

#[test]
fn tiles_cover_every_pixel_once() {
    for (width, height, most, factor) in [(400, 320, 100, 2), (1, 1, 1, 1), (7, 5, 3, 4), (2048, 3000, 2048, 1)] {
        let picture = Picture { width, height, ..Picture::default() };
        let tiles = Tiles::new(&picture, most, factor);
        assert!(tiles.largest().into_iter().all(|side| side <= most.max(factor)), "{tiles:?}");
        let mut seen = vec![0; (width * height) as usize];
        for tile in tiles.all() {
            for y in tile.top..tile.top + tile.height {
                (tile.left..tile.left + tile.width).for_each(|x| seen[(y * width + x) as usize] += 1);
            }
        }
        assert!(seen.into_iter().all(|times| times == 1), "{tiles:?}");
    }
}

#[test]
fn without_multisampling_it_looks_the_same() {
    let Some(whole) = renderer() else { return };
    let plain = GpuRenderer::with(&whole.gpu, 4096, false).unwrap();
    let figure = figure("kresling", 90.0);
    check("single", &plain.draw(&small(), &figure).unwrap(), &Processor.draw(&small(), &figure).unwrap());
}

#[test]
fn nonsense_is_refused_as_on_the_processor() {
    let Some(renderer) = renderer() else { return };
    let right = figure("miura", 60.0);
    let refused = |picture: &Picture, figure: &Figure| {
        let text = match renderer.draw(picture, figure) {
            Err(DrawError::Invalid(error)) => error.to_string(),
            other => panic!("{other:?}"),
        };
        assert_eq!(text, Processor.draw(picture, figure).unwrap_err().to_string());
    };
    refused(&Picture { samples: 5, ..small() }, &right);
    refused(&Picture { width: 100_000, ..small() }, &right);
    refused(&Picture { width: 0, ..small() }, &right);
    let mut wrong = right.clone();
    wrong.triangles[3] = [0, 1, 9999];
    refused(&small(), &wrong);
    let mut wrong = right.clone();
    wrong.positions[3][1] = f32::NAN;
    let view = small().view(&right, right.positions.iter().copied()).unwrap();
    assert!(matches!(renderer.draw_from(&small(), &wrong, &view), Err(DrawError::Invalid(_))));
}

#[test]
fn degenerate_scenes_are_drawn() {
    let Some(renderer) = renderer() else { return };
    let empty = renderer.draw(&small(), &Figure::default()).unwrap();
    assert_eq!(empty, Processor.draw(&small(), &Figure::default()).unwrap(), "nothing but the ground");
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1e6, -1e6, 3.0], [0.0, 1e17, 0.0], [-1e-30, 0.0, 0.0]];
    let triangles = vec![[0, 1, 2], [0, 0, 1], [4, 0, 3], [2, 3, 4], [1, 1, 1]];
    let figure = Figure { positions: positions.to_vec(), triangles, ..Figure::default() };
    for zoom in [1.0, 1000.0] {
        for projection in [Projection::Orthographic, Projection::Perspective(60.0)] {
            let picture = Picture { camera: Camera { zoom, projection, ..Camera::default() }, ..small() };
            assert_eq!(renderer.draw(&picture, &figure).unwrap().pixels.len(), 4 * 400 * 320);
        }
    }
}
