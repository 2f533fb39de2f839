//! Draws the shipped patterns: `look FOLDER [SIZE]`.
use origami_core::{Material, Model, Relax, generate::catalog};
use origami_picture::{Camera, ColourMap, Picture, Quantity, Scene};
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let folder = args.next().ok_or("look FOLDER [SIZE]")?;
    let size: u32 = args.next().map_or(Ok(800), |s| s.parse())?;
    for (name, percent) in [
        ("bird-base", 100.0),
        ("bird-base", 80.0),
        ("miura", 60.0),
        ("crane", 90.0),
        ("kresling", 80.0),
        ("curved-pleat", 80.0),
        ("hypar", 80.0),
        ("square-twist", 100.0),
        ("waterbomb", 60.0),
    ] {
        let pattern = catalog::generate(name, &[])?;
        let model = Model::new(&pattern, &Material::default())?;
        let folded = Relax::default().fold_from_rest(&model, percent)?;
        let scene = Scene::new(&pattern, &model, &folded.state.positions);
        let camera = if name == "bird-base" {
            Camera { azimuth: -60.0, elevation: 10.0, ..Camera::default() }
        } else {
            Camera::default()
        };
        let start = std::time::Instant::now();
        let image = Picture { width: size, height: size * 4 / 5, camera, ..Picture::default() }.draw(&scene)?;
        println!("{name} {:?}", start.elapsed());
        image.write_png(std::fs::File::create(format!("{folder}/{name}-{percent}-{size}.png"))?)?;
    }
    for (name, percent, quantity, colours) in [
        ("hypar", 80.0, Quantity::Strain, ColourMap::Viridis),
        ("hypar", 80.0, Quantity::Strain, ColourMap::Hue),
        ("curved-pleat", 80.0, Quantity::EnergyDensity, ColourMap::Inferno),
        ("crane", 90.0, Quantity::AngleError, ColourMap::Cividis),
    ] {
        let pattern = catalog::generate(name, &[])?;
        let model = Model::new(&pattern, &Material::default())?;
        let folded = Relax::default().fold_from_rest(&model, percent)?;
        let map = origami_picture::Map::new(quantity, &model, &folded.state, colours, None);
        let scene = Scene::new(&pattern, &model, &folded.state.positions).with_map(map);
        let image = Picture {
            width: size,
            height: size * 4 / 5,
            caption: format!("{name}, {percent} %"),
            ..Picture::default()
        }
        .draw(&scene)?;
        image.write_png(std::fs::File::create(format!("{folder}/map-{name}-{quantity:?}-{colours:?}-{size}.png"))?)?;
    }
    Ok(())
}
