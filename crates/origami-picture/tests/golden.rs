//! Pictures as they should be, in `tests/golden`. `ORIGAMI_UPDATE_GOLDEN=1 cargo test -p origami-picture --test golden`
//! draws them again: look at them before they are kept.

mod support;

use origami_core::generate::catalog;
use origami_core::{CreasePattern, Material, Model, Relax, Solver, State};
use origami_picture::{
    Camera, ColourMap, Figure, Image, LineKind, LineSet, Map, Picture, Processor, Projection, Quantity, Renderer,
    Theme, contact_sheet,
};
use support::{TOLERANCE, check, compare};

fn folded(name: &str, percent: f64) -> (CreasePattern, Model, State) {
    let pattern = catalog::generate(name, &[]).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let state = Relax::default().fold_from_rest(&model, percent).expect("a state").state;
    (pattern, model, state)
}

fn figure(name: &str, percent: f64) -> Figure {
    let (pattern, model, state) = folded(name, percent);
    Figure::new(&pattern, &model, &state.positions)
}

fn small() -> Picture {
    Picture { width: 200, height: 160, ..Picture::default() }
}

fn from(azimuth: f64, elevation: f64) -> Picture {
    Picture { camera: Camera { azimuth, elevation, ..Camera::default() }, ..small() }
}

#[test]
fn folded_sheets() {
    for (name, percent) in [("miura", 60.0), ("crane", 90.0), ("kresling", 80.0), ("curved-pleat", 80.0)] {
        check(&format!("{name}-{percent}"), &Processor.draw(&small(), &figure(name, percent)).unwrap());
    }
}

/// Layers at one place: what is on top hides all below it, lines too.
#[test]
fn flat_layers() {
    let bird_base = figure("bird-base", 100.0);
    check("bird-base-100", &Processor.draw(&from(-60.0, 10.0), &bird_base).unwrap());
    check("bird-base-100-behind", &Processor.draw(&from(120.0, 10.0), &bird_base).unwrap());
    let twist = figure("square-twist", 100.0);
    check("square-twist-100", &Processor.draw(&from(-60.0, 60.0), &twist).unwrap());
    check("square-twist-100-below", &Processor.draw(&from(-60.0, -60.0), &twist).unwrap());
    // Wings hang on a stack of layers, and nothing of it comes before them.
    check("crane-100", &Processor.draw(&small(), &figure("crane", 100.0)).unwrap());
    // Two triangles make the topmost panel, and no crease below comes out between them.
    let miura = figure("miura", 100.0);
    check("miura-100", &Processor.draw(&Picture { camera: miura.camera(), ..small() }, &miura).unwrap());
}

/// Valleys and what lies under a flap are darker.
#[test]
fn soft_shading() {
    for (name, percent) in [("miura", 80.0), ("square-twist", 80.0), ("kresling", 90.0)] {
        let mut figure = figure(name, percent);
        figure.shade();
        check(&format!("{name}-{percent}-soft"), &Processor.draw(&small(), &figure).unwrap());
    }
}

#[test]
fn maps() {
    let (pattern, model, state) = folded("hypar", 80.0);
    for (quantity, colours, name) in [
        (Quantity::Strain, ColourMap::Viridis, "strain"),
        (Quantity::FaceStrain, ColourMap::Hue, "face-strain"),
        (Quantity::AngleError, ColourMap::Cividis, "angle-error"),
        (Quantity::EnergyDensity, ColourMap::Inferno, "energy"),
    ] {
        let map = Map::new(quantity, &model, &state, colours, None);
        let figure = Figure::new(&pattern, &model, &state.positions).with_map(map);
        check(&format!("hypar-80-{name}"), &Processor.draw(&small(), &figure).unwrap());
    }
}

#[test]
fn styles() {
    let miura = figure("miura", 60.0);
    let perspective = Camera { projection: Projection::Perspective(50.0), roll: 10.0, ..Camera::isometric() };
    let themes = Theme::NAMES.map(|name| {
        let theme = Theme::named(name).unwrap();
        Picture {
            theme,
            camera: perspective,
            edges: LineSet::ALL,
            caption: name.into(),
            width: 140,
            height: 120,
            ..small()
        }
    });
    let images: Vec<Image> = themes.iter().map(|picture| Processor.draw(picture, &miura).unwrap()).collect();
    check("themes", &contact_sheet(&images, 2, None).unwrap());
    let transparent = Theme { background: None, ..Theme::paper() };
    check("transparent", &Processor.draw(&Picture { theme: transparent, ..small() }, &miura).unwrap());
}

#[test]
fn patterns() {
    let pattern = Figure::of_pattern(&catalog::generate("crane", &[]).unwrap()).unwrap();
    check("pattern", &Processor.draw(&Picture { height: 200, ..small() }.for_pattern(), &pattern).unwrap());
    let mono = Picture { theme: Theme::mono(), height: 200, ..small() };
    check("pattern-mono", &Processor.draw(&mono.for_pattern(), &pattern).unwrap());
}

#[test]
fn a_wrong_picture_fails() {
    let figure = figure("miura", 60.0);
    let picture = small();
    let right = Processor.draw(&picture, &figure).unwrap();
    assert!(compare(&right, &right).0.within(&support::Difference { mean: 0.0, block: 0.0 }));
    let mut missing = figure.clone();
    let line = missing.lines.iter().position(|line| line.kind == LineKind::Mountain).unwrap();
    missing.lines.remove(line);
    let mut turned = figure.clone();
    turned.triangles[0].swap(0, 1);
    let mut dented = figure.clone();
    dented.positions[8][2] += 0.03;
    let darker = Picture { theme: Theme { shading: 1.25, ..Theme::paper() }, ..picture.clone() };
    for (what, wrong) in [
        ("a line is missing", Processor.draw(&picture, &missing)),
        ("a triangle shows its back", Processor.draw(&picture, &turned)),
        ("a node is dented", Processor.draw(&picture, &dented)),
        ("shades are deeper", Processor.draw(&darker, &figure)),
    ] {
        let difference = compare(&wrong.unwrap(), &right).0;
        assert!(!difference.within(&TOLERANCE), "{what}, and it is not seen: {difference:?}");
    }
}

#[test]
fn a_camera_that_moves_by_a_thousandth_of_a_degree_passes() {
    let figure = figure("miura", 60.0);
    let [one, two] = [-60.0, -60.001].map(|azimuth| Processor.draw(&from(azimuth, 35.0), &figure).unwrap());
    assert!(compare(&one, &two).0.within(&TOLERANCE));
}
