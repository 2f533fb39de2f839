//! Patterns, a contact sheet, animations: `look2 FOLDER`.
use origami_core::solve::{fold_path, frame_percents};
use origami_core::{Material, Model, Relax, generate::catalog};
use origami_picture::*;
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("folder")?;
    let cell = Picture { width: 480, height: 400, ..Picture::default() };
    let mut images = Vec::new();
    let pattern = catalog::generate("crane", &[])?;
    let model = Model::new(&pattern, &Material::default())?;
    let mut p = cell.clone().for_pattern();
    p.caption = "pattern".into();
    images.push(p.draw(&Scene::of_pattern(&pattern)?)?);
    let percents = frame_percents(100.0, 5);
    let path = fold_path(&model, &Relax::default(), &percents[1..], &mut |_, _| {})?;
    for f in &path {
        let scene = Scene::new(&pattern, &model, &f.state.positions);
        images.push(Picture { caption: format!("{} %", f.percent), ..cell.clone() }.draw(&scene)?);
    }
    contact_sheet(&images, 3, Some(Rgb::WHITE))?.write_png(std::fs::File::create(format!("{folder}/sheet.png"))?)?;
    let mut p = Picture { theme: Theme::mono(), ..Picture::default() }.for_pattern();
    p.width = 800;
    p.height = 800;
    p.draw(&Scene::of_pattern(&pattern)?)?.write_png(std::fs::File::create(format!("{folder}/pattern-mono.png"))?)?;
    std::fs::write(
        format!("{folder}/pattern.svg"),
        pattern::svg(&pattern, &Theme::mono().for_pattern(), LineSet::ALL, 800.0),
    )?;
    let mono = Picture { theme: Theme::mono(), ..Picture::default() };
    mono.draw(&Scene::new(&pattern, &model, &path[3].state.positions))?
        .write_png(std::fs::File::create(format!("{folder}/mono.png"))?)?;
    let dark = Picture {
        theme: Theme::dark(),
        camera: Camera { projection: Projection::Perspective(45.0), ..Camera::default() },
        ..Picture::default()
    };
    let miura = catalog::generate("miura", &[])?;
    let m = Model::new(&miura, &Material::default())?;
    let f = Relax::default().fold_from_rest(&m, 70.0)?;
    dark.draw(&Scene::new(&miura, &m, &f.state.positions))?
        .write_png(std::fs::File::create(format!("{folder}/dark.png"))?)?;
    Ok(())
}
