//! What every picture must keep to, whatever it shows.

use origami_core::generate::catalog;
use origami_core::{Material, Model, Relax, Solver, glam};
use origami_picture::layers::Layer;
use origami_picture::{
    Camera, ColourMap, Figure, Image, Line, LineKind, LineSet, Map, Picture, Processor, Projection, Renderer, Rgb,
    Theme, map,
};
use proptest::prelude::*;

/// The square from -1 to 1 at a height, facing up.
fn square(z: f32) -> Figure {
    Figure {
        positions: vec![[-1.0, -1.0, z], [1.0, -1.0, z], [1.0, 1.0, z], [-1.0, 1.0, z]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Figure::default()
    }
}

/// Both, one after the other.
fn both(one: &Figure, two: &Figure) -> Figure {
    let (nodes, triangles) = (one.positions.len() as u32, one.triangles.len() as u32);
    let mut figure = one.clone();
    figure.positions.extend(&two.positions);
    figure.triangles.extend(two.triangles.iter().map(|t| t.map(|n| n + nodes)));
    figure.lines.extend(two.lines.iter().map(|line| Line {
        nodes: line.nodes.map(|n| n + nodes),
        triangles: line.triangles.map(|t| t.map(|t| t + triangles)),
        ..*line
    }));
    figure
}

fn line(a: u32, b: u32, triangles: [Option<u32>; 2]) -> Line {
    Line { nodes: [a, b], along: [0.0, 2.0], kind: LineKind::Mountain, triangles }
}

fn plain() -> Picture {
    Picture {
        width: 100,
        height: 100,
        camera: Camera::top(),
        line_width: 3.0,
        theme: Theme { shading: 0.0, background: None, ..Theme::paper() },
        ..Picture::default()
    }
}

/// How much of the picture is of a colour, in pixels; colours between count for neither.
fn area(image: &Image, colour: Rgb) -> f64 {
    let same = |p: &&[u8]| p[..3] == [colour.0, colour.1, colour.2];
    image.pixels.chunks(4).filter(same).map(|p| f64::from(p[3]) / 255.0).sum()
}

#[test]
fn two_triangles_leave_no_seam_and_cover_what_they_should() {
    for roll in [0.0, 10.0, 45.0, 77.0] {
        for samples in [1, 4, 8, 16] {
            let mut picture = Picture { samples, ..plain() };
            picture.camera.roll = roll;
            picture.theme.back = picture.theme.front;
            let image = Processor.draw(&picture, &square(0.0)).unwrap();
            let cover: f64 = image.pixels.chunks(4).map(|p| f64::from(p[3]) / 255.0).sum();
            let view = picture.view(&square(0.0), square(0.0).positions.into_iter()).unwrap();
            let side = 2.0 / f64::from(view.pixel);
            assert!((cover / (side * side) - 1.0).abs() < 0.01, "{roll} {samples}: {cover} of {}", side * side);
            // Along the diagonal, away from the corners.
            let middle = |t: f64| 50.0 + t * 0.5 * side * (roll.to_radians() + std::f64::consts::FRAC_PI_4).cos() * 1.3;
            let across = |t: f64| 50.0 - t * 0.5 * side * (roll.to_radians() + std::f64::consts::FRAC_PI_4).sin() * 1.3;
            for step in -20..=20 {
                let t = f64::from(step) / 25.0;
                assert_eq!(image.pixel(middle(t) as u32, across(t) as u32)[3], 255, "{roll} {samples} {t}");
            }
        }
    }
}

#[test]
fn front_and_back_have_their_colours() {
    let theme = plain().theme;
    for (elevation, colour) in [(90.0, theme.front), (-90.0, theme.back)] {
        let camera = Camera { elevation, ..Camera::top() };
        let image = Processor.draw(&Picture { camera, ..plain() }, &square(0.0)).unwrap();
        assert!(area(&image, colour) > 7000.0, "{elevation}");
    }
}

#[test]
fn lines_are_as_wide_as_asked_at_every_size_and_angle() {
    for (width, roll) in [(100, 0.0), (100, 30.0), (400, 0.0), (400, 71.0)] {
        let mut picture = Picture { width, height: width, ..plain() };
        picture.camera.roll = roll;
        let mut figure = square(0.0);
        figure.lines.push(line(0, 2, [Some(0), Some(1)]));
        let red = picture.theme.line(LineKind::Mountain);
        let wide = f64::from(red.width * picture.line_scale());
        let view = picture.view(&figure, figure.positions.iter().copied()).unwrap();
        let length = 8.0_f64.sqrt() / f64::from(view.pixel);
        // Red light that the line adds, over what paper has.
        let bare = Processor.draw(&picture, &square(0.0)).unwrap();
        let drawn = Processor.draw(&picture, &figure).unwrap();
        let [paper, ink] = [picture.theme.front, red.colour].map(|c| f64::from(c.linear()[2]));
        let light = |p: &[u8]| f64::from(Rgb(p[0], p[1], p[2]).linear()[2]);
        let covered: f64 = { bare.pixels.chunks(4).zip(drawn.pixels.chunks(4)) }
            .filter(|(bare, _)| bare[3] == 255)
            .map(|(bare, drawn)| (light(bare) - light(drawn)) / (paper - ink))
            .sum();
        assert!((covered / (wide * length) - 1.0).abs() < 0.05, "{width} {roll}: {covered} of {}", wide * length);
    }
}

#[test]
fn lines_show_on_their_faces_and_not_through_those_in_front() {
    let mut lined = square(0.0);
    lined.lines = vec![line(0, 1, [Some(0), None]), line(0, 2, [Some(0), Some(1)])];
    let red = plain().theme.line(LineKind::Mountain).colour;
    for projection in [Projection::Orthographic, Projection::Perspective(60.0)] {
        for elevation in [90.0, 60.0, 15.0, 5.0] {
            if elevation < 10.0 && projection != Projection::Orthographic {
                // Near the horizon half a line's width is more than what covers it.
                continue;
            }
            let camera = Camera { elevation, projection, ..Camera::top() };
            let picture = Picture { camera, ..plain() };
            let seen = area(&Processor.draw(&picture, &lined).unwrap(), red);
            assert!(seen > 60.0, "swallowed at {elevation}: {seen}");
            // A larger sheet just above hides them; so does one at the very same place that is a layer above.
            let mut cover = square(0.02);
            cover.positions.iter_mut().for_each(|p| [p[0], p[1]] = [p[0] * 1.4, p[1] * 3.0]);
            assert_eq!(
                area(&Processor.draw(&picture, &both(&lined, &cover)).unwrap(), red),
                0.0,
                "shows through at {elevation}"
            );
            cover.positions.iter_mut().for_each(|p| p[2] = 0.0);
            let mut stack = both(&lined, &cover);
            let layer = |height: f64| Layer { up: [0.0, 0.0, 1.0], heights: [height as f32; 3] };
            let heights = [0.0, 0.0, 1.0, 1.0].map(|n| n * origami_picture::layers::LAYER);
            stack.layers = heights.map(layer).to_vec();
            assert_eq!(
                area(&Processor.draw(&picture, &stack).unwrap(), red),
                0.0,
                "shows through a layer at {elevation}"
            );
            stack.layers = heights.map(|h| layer(-h)).to_vec();
            let seen = area(&Processor.draw(&picture, &stack).unwrap(), red);
            assert!(seen > 50.0, "swallowed by the layer below at {elevation}: {seen}");
        }
    }
}

#[test]
fn only_the_lines_asked_for_are_drawn() {
    let mut figure = square(0.0);
    figure.lines = vec![line(0, 2, [Some(0), Some(1)])];
    let none = Picture { edges: LineSet::default().with(LineKind::Facet), ..plain() };
    let red = |picture: Picture| {
        area(&Processor.draw(&picture, &figure).unwrap(), Theme::paper().line(LineKind::Mountain).colour)
    };
    assert!(red(none.clone()) > 50.0);
    assert_eq!(red(Picture { edges: "VBFCU".parse().unwrap(), ..none }), 0.0);
}

#[test]
fn threads_do_not_change_a_picture() {
    let pattern = catalog::generate("crane", &[]).unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    let state = Relax::default().fold_from_rest(&model, 95.0).unwrap().state;
    let drawn = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let figure = Figure::new(&pattern, &model, &state.positions);
            Processor.draw(&Picture { width: 300, height: 240, ..Picture::default() }, &figure).unwrap()
        })
    };
    let first = drawn(1);
    assert!([1, 2, 5].into_iter().all(|threads| drawn(threads) == first));
}

/// The crane's wings hang on its body, flat upon itself: in front of their roots there is nothing but wing.
#[test]
fn no_layer_comes_before_what_hangs_on_its_stack() {
    let pattern = catalog::generate("crane", &[]).unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    for percent in [99.0, 100.0] {
        let positions = Relax::default().fold_from_rest(&model, percent).unwrap().state.positions;
        let figure = Figure::new(&pattern, &model, &positions);
        // Triangles that stand off from the plane of the body are wing; the body's plane is that of most paper.
        let corners = |t: usize| model.mesh.triangles[t].map(|n| positions[n.index()]);
        let across = |t: usize| {
            let [a, b, c] = corners(t);
            (b - a).cross(c - a)
        };
        let count = figure.triangles.len();
        let body = |normal: glam::DVec3| -> f64 { (0..count).map(|t| across(t).dot(normal).abs()).sum() };
        let most = (0..count).map(|t| across(t).normalize()).max_by(|a, b| body(*a).total_cmp(&body(*b))).unwrap();
        let wings: Vec<usize> = (0..count).filter(|t| across(*t).normalize().dot(most).abs() < 0.7).collect();
        assert!(wings.len() > 2 && wings.len() < count / 2);
        // Wings alone, and the same wings before the body: where the body is behind, they look alike.
        let coloured = |only_wings: bool| {
            let theme = Theme { shading: 0.0, back: Theme::paper().front, background: None, ..Theme::paper() };
            let values = (0..count).map(|t| if wings.contains(&t) { 1.0 } else { 0.0 }).collect();
            let scale = map::Scale { colours: ColourMap::Viridis, clip: 1.0, label: String::new(), beyond: false };
            let mut figure = figure.clone().with_map(Map { values: map::Values::Triangles(values), scale });
            if only_wings {
                // The body shrinks to a point.
                let hidden = figure.triangles.iter_mut().enumerate().filter(|(t, _)| !wings.contains(t));
                hidden.for_each(|(_, nodes)| *nodes = [nodes[0]; 3]);
            }
            // From the front of a wing, where its root has the body behind it.
            let picture = Picture { edges: LineSet::NONE, legend: false, theme, samples: 4, ..Picture::default() };
            let view = picture.view(&figure, positions.iter().map(|p| p.to_array().map(|x| x as f32))).unwrap();
            area(&Processor.draw_from(&picture, &figure, &view).unwrap(), ColourMap::Viridis.colour(1.0))
        };
        let (alone, together) = (coloured(true), coloured(false));
        assert!(together > 0.97 * alone, "{percent} %: {together} of {alone} pixels of wing are seen");
    }
}

#[test]
fn nonsense_is_refused_by_its_name() {
    let refused = |figure: &Figure, picture: &Picture| Processor.draw(picture, figure).unwrap_err().to_string();
    let mut figure = square(0.0);
    figure.triangles.push([0, 1, 9]);
    assert_eq!(refused(&figure, &plain()), "triangle 2: names a node that is not there; expected nodes below 4");
    let mut figure = square(0.0);
    figure.positions[3][1] = f32::NAN;
    assert!(refused(&figure, &plain()).starts_with("position 3: "));
    let mut figure = square(0.0);
    figure.lines.push(line(0, 1, [Some(7), None]));
    assert!(refused(&figure, &plain()).starts_with("line 0: "));
    let mut figure = square(0.0);
    figure.layers.push(Layer::default());
    assert!(refused(&figure, &plain()).starts_with("layers: "));
    assert!(
        refused(&square(0.0), &Picture { samples: 5, ..plain() }).starts_with("samples: 5; expected 1, 4, 8 or 16")
    );
    assert!(refused(&square(0.0), &Picture { width: 100_000, ..plain() }).starts_with("size: 100000 x 100 pixels"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    /// Degenerate, huge and tiny triangles, and cameras close to them.
    #[test]
    fn no_figure_makes_it_panic(
        places in prop::collection::vec(prop::array::uniform3(prop_oneof![
            -1.0_f32..1.0,
            Just(0.0),
            Just(1e17),
            Just(-1e-30),
            -1e6_f32..1e6,
        ]), 3..12),
        triangles in prop::collection::vec(prop::array::uniform3(0_u32..12), 0..12),
        zoom in prop_oneof![Just(1.0), Just(1000.0), Just(0.001)],
        perspective in any::<bool>(),
    ) {
        let count = places.len() as u32;
        let projection = if perspective { Projection::Perspective(60.0) } else { Projection::Orthographic };
        let triangles: Vec<[u32; 3]> = triangles.into_iter().map(|t| t.map(|n| n % count)).collect();
        let lines = triangles.iter().map(|[a, b, _]| line(*a, *b, [Some(0), None])).collect();
        let figure = Figure { positions: places, triangles, lines, ..Figure::default() };
        let camera = Camera { zoom, projection, ..Camera::default() };
        let image = Processor.draw(&Picture { width: 40, height: 30, camera, ..Picture::default() }, &figure).unwrap();
        prop_assert_eq!(image.pixels.len(), 4 * 40 * 30);
    }
}
