//! The GPU draws what the processor draws.

use origami_picture::{Camera, ColourMap, LineKind, LineSet, Map, Projection, Quantity, Theme};

use super::*;

#[test]
fn six_patterns_look_as_on_the_processor() {
    let Some(renderer) = renderer() else { return };
    for (name, percent) in [
        ("bird-base", 100.0),
        ("miura", 60.0),
        ("kresling", 90.0),
        ("crane", 90.0),
        ("hypar", 80.0),
        ("curved-pleat", 80.0),
    ] {
        let figure = figure(name, percent);
        let on_gpu = renderer.draw(&small(), &figure).unwrap();
        assert_eq!(on_gpu, renderer.draw(&small(), &figure).unwrap(), "{name}: two runs are identical");
        check(name, &on_gpu, &Processor.draw(&small(), &figure).unwrap());
    }
}

#[test]
fn layers_have_their_order_from_everywhere() {
    let Some(renderer) = renderer() else { return };
    let figure = figure("bird-base", 100.0);
    // Not along the sheet, of which lines on lines would be left.
    for (azimuth, elevation) in [(-60.0, 10.0), (120.0, 10.0), (0.0, 75.0), (0.0, -75.0)] {
        let picture = Picture { camera: Camera { azimuth, elevation, ..Camera::default() }, ..small() };
        let name = format!("bird-base-from-{azimuth}-{elevation}");
        check(&name, &renderer.draw(&picture, &figure).unwrap(), &Processor.draw(&picture, &figure).unwrap());
    }
}

#[test]
fn soft_shading_looks_as_on_the_processor() {
    let Some(renderer) = renderer() else { return };
    for (name, percent) in [("kresling", 90.0), ("miura", 80.0), ("square-twist", 80.0), ("crane", 90.0)] {
        let flat = figure(name, percent);
        let mut soft = flat.clone();
        soft.shade();
        for projection in [Projection::Orthographic, Projection::Perspective(60.0)] {
            let picture = Picture { camera: Camera { projection, ..Camera::default() }, ..small() };
            let far = if projection == Projection::Orthographic { "far" } else { "near" };
            let on_gpu = renderer.draw(&picture, &soft).unwrap();
            check(&format!("soft-{name}-{far}"), &on_gpu, &Processor.draw(&picture, &soft).unwrap());
            let differs = !differ(&on_gpu, &renderer.draw(&picture, &flat).unwrap()).within(&TOLERANCE);
            assert!(differs, "{name}: softness is seen");
        }
    }
}

#[test]
fn layers_lie_before_what_hangs_on_them_from_everywhere() {
    let Some(renderer) = renderer() else { return };
    for (name, percent) in [("crane", 100.0), ("crane", 99.0), ("miura", 100.0)] {
        let figure = figure(name, percent);
        for (azimuth, elevation) in [(-60.0, 35.0), (30.0, 10.0), (150.0, -40.0)] {
            let picture = Picture { camera: Camera { azimuth, elevation, ..Camera::default() }, ..small() };
            let name = format!("{name}-{percent}-from-{azimuth}-{elevation}");
            check(&name, &renderer.draw(&picture, &figure).unwrap(), &Processor.draw(&picture, &figure).unwrap());
        }
    }
}

#[test]
fn every_style_looks_as_on_the_processor() {
    let Some(renderer) = renderer() else { return };
    let figure = figure("miura", 60.0);
    let perspective = Camera { projection: Projection::Perspective(50.0), roll: 10.0, ..Camera::isometric() };
    for name in Theme::NAMES {
        let theme = Theme::named(name).unwrap();
        let caption = name.to_owned();
        let picture = Picture { theme, camera: perspective, edges: LineSet::ALL, caption, ..small() };
        check(
            &format!("theme-{name}"),
            &renderer.draw(&picture, &figure).unwrap(),
            &Processor.draw(&picture, &figure).unwrap(),
        );
    }
    let wide = Picture { line_width: 5.0, edges: "MB".parse().unwrap(), ..small() };
    check("wide", &renderer.draw(&wide, &figure).unwrap(), &Processor.draw(&wide, &figure).unwrap());
}

#[test]
fn maps_look_as_on_the_processor() {
    let Some(renderer) = renderer() else { return };
    let (pattern, model, state) = folded("hypar", 80.0);
    for (quantity, name) in [(Quantity::Strain, "strain"), (Quantity::FaceStrain, "face-strain")] {
        let map = Map::new(quantity, &model, &state, ColourMap::Viridis, None);
        let figure = Figure::new(&pattern, &model, &state.positions).with_map(map);
        for projection in [Projection::Orthographic, Projection::Perspective(60.0)] {
            let picture = Picture { camera: Camera { projection, ..Camera::default() }, ..small() };
            let far = if projection == Projection::Orthographic { "far" } else { "near" };
            let name = format!("hypar-{name}-{far}");
            check(&name, &renderer.draw(&picture, &figure).unwrap(), &Processor.draw(&picture, &figure).unwrap());
        }
    }
}

#[test]
fn nothing_is_behind_a_sheet_without_a_background() {
    let Some(renderer) = renderer() else { return };
    let theme = Theme { background: None, ..Theme::paper() };
    let picture = Picture { theme, ..small() };
    let figure = figure("miura", 60.0);
    let (on_gpu, by_processor) =
        (renderer.draw(&picture, &figure).unwrap(), Processor.draw(&picture, &figure).unwrap());
    check("transparent", &on_gpu, &by_processor);
    assert_eq!(on_gpu.pixel(0, 0), [0; 4]);
    // At the rim the colour is the line's, not darkened or lightened by what is not there.
    let rims = |image: &Image| {
        let lines = picture.theme.lines.map(|style| style.colour);
        let thin = image.pixels.chunks(4).filter(|p| (1..128).contains(&p[3]));
        let of_a_line = |p: &&[u8]| lines.iter().any(|c| p.iter().zip([c.0, c.1, c.2]).all(|(p, c)| p.abs_diff(c) < 2));
        (thin.clone().filter(of_a_line).count(), thin.count())
    };
    let ((is, thin), (should_be, _)) = (rims(&on_gpu), rims(&by_processor));
    assert!(thin > 100 && is * 10 > thin * 6 && is.abs_diff(should_be) < should_be / 10, "{is} {should_be} of {thin}");
    let cover = |image: &Image| image.pixels.iter().skip(3).step_by(4).map(|a| f64::from(*a) / 255.0).sum::<f64>();
    assert!((cover(&on_gpu) / cover(&by_processor) - 1.0).abs() < 1e-3);
}

#[test]
fn fewer_samples_are_what_they_are_on_the_processor() {
    let Some(renderer) = renderer() else { return };
    let figure = figure("miura", 60.0);
    for samples in [1, 4, 8] {
        let picture = Picture { samples, ..small() };
        let name = format!("samples-{samples}");
        check(&name, &renderer.draw(&picture, &figure).unwrap(), &Processor.draw(&picture, &figure).unwrap());
    }
    let colours = |samples| {
        let image = renderer.draw(&Picture { samples, ..small() }, &figure).unwrap();
        image.pixels.chunks(4).map(<[u8]>::to_vec).collect::<std::collections::BTreeSet<_>>().len()
    };
    // Without edges between colours there are only those of the folds and lines.
    assert!(colours(1) < 60 && colours(4) > 100, "{} {}", colours(1), colours(4));
}

#[test]
fn a_wrong_picture_fails() {
    let Some(renderer) = renderer() else { return };
    let figure = figure("miura", 60.0);
    let should_be = Processor.draw(&small(), &figure).unwrap();
    let mut missing = figure.clone();
    let line = missing.lines.iter().position(|line| line.kind == LineKind::Mountain).unwrap();
    missing.lines.remove(line);
    let mut turned = figure.clone();
    turned.triangles[0].swap(0, 1);
    let mut dented = figure.clone();
    dented.positions[8][2] += 0.03;
    for (what, wrong) in [("a line is missing", missing), ("a triangle shows its back", turned), ("dented", dented)] {
        let difference = differ(&renderer.draw(&small(), &wrong).unwrap(), &should_be);
        assert!(!difference.within(&TOLERANCE), "{what}, and it is not seen: {difference:?}");
    }
}
