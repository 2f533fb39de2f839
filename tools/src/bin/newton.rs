//! What the reference solver costs, on each generated pattern and on a large sheet:
//! `cargo run --release -p origami-tools --bin newton [-- EA]`, where EA is the beams' rigidity, 20 by default.
//!
//! From where `relax` ends, and by itself in increments from the sheet at rest: factorisations, time, and how far the one
//! lies from `relax` and the other from the first, in radii.
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

use origami::scene::Scene;
use std::time::Instant;

use origami::generate::{catalog, miura};
use origami::measure::align;
use origami::{CreasePattern, Error, Material, Model, Newton, Relax, Solver, State};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let ea = std::env::args().nth(1).map_or(Ok(Material::default().ea), |text| text.parse())?;
    let material = Material { ea, ..Material::default() };
    let generated = catalog::names().iter().map(|name| Ok(((*name).to_owned(), catalog::generate(name, &[])?)));
    let mut patterns: Vec<(String, CreasePattern)> = generated.collect::<Result<_, Error>>()?;
    patterns.push(("miura 30 by 30".to_owned(), miura(30, 30)?));

    println!(
        "| pattern | % | relax: steps, ms | newton: factorisations, ms | residual | from relax | modes < 0, = 0 \
         | increments: factorisations, ms | from newton | energy over newton's |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (name, pattern) in &patterns {
        let model = Model::new(pattern, &material)?;
        for percent in [60.0, 100.0] {
            let clock = Instant::now();
            let near = Relax::default().fold_from_rest(&model, percent)?;
            let relax_ms = ms(clock);
            let clock = Instant::now();
            let exact = Newton::default().refine(&model, &near.state)?;
            let newton_ms = ms(clock);
            let clock = Instant::now();
            let alone = Newton::default().climb(&model, &State::at_rest(&model), &Scene::percent(percent))?;
            let alone_ms = ms(clock);
            let from_relax = align(&near.state.positions, &exact.state.positions).max;
            let from_newton = align(&alone.state.positions, &exact.state.positions).max;
            let higher = alone.state.energy(&model).total() - exact.state.energy(&model).total();
            let (negative, neutral) = exact.stability.map_or((0, 0), |s| (s.negative, s.neutral));
            println!(
                "| {name} | {percent} | {}, {relax_ms:.1} | {}, {newton_ms:.1} | {:.0e} | {from_relax:.0e} | {negative}, \
                 {neutral} | {}, {alone_ms:.1} | {from_newton:.0e} | {higher:.0e} |",
                near.steps, exact.factorisations, exact.residual, alone.factorisations,
            );
        }
    }
    Ok(())
}

fn ms(clock: Instant) -> f64 {
    1e3 * clock.elapsed().as_secs_f64()
}
