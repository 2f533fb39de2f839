use origami_core::measure::align;
use origami_core::solve::*;
use origami_core::*;
use std::time::Instant;
fn main() {
    let gpu = origami_gpu::Gpu::open(&origami_gpu::AdapterChoice::from_env()).unwrap();
    for path in std::env::args().skip(1) {
        let doc = fold::Document::read(&path).unwrap();
        let pattern = CreasePattern::from_document(&doc, doc.pattern_frame().unwrap()).unwrap();
        let model = Model::new(&pattern, &Material::default()).unwrap();
        let start = State::at_rest(&model);
        for dispatch in [origami_gpu::Dispatch::Passes, origami_gpu::Dispatch::Workgroup] {
            for (name, integrator, ts) in [
                ("euler", Integrator::Euler, TimeStep::Paper),
                ("verlet", Integrator::Verlet, TimeStep::Paper),
                ("safe", Integrator::Euler, TimeStep::Safe),
            ] {
                let d = Dynamics { steps: Some(300), integrator, time_step: ts, ..Dynamics::default() };
                let t = Instant::now();
                let Ok(cpu) = d.fold(&model, &start, 60.0, &mut |_| {}) else {
                    println!(
                        "{path} {name}: cpu diverges, gpu {}",
                        gpu.with(d).fold(&model, &start, 60.0, &mut |_| {}).is_err()
                    );
                    continue;
                };
                let tc = t.elapsed();
                let t = Instant::now();
                match gpu.with(d).dispatch(dispatch).fold(&model, &start, 60.0, &mut |_| {}) {
                    Ok(f) => println!(
                        "{path} {dispatch:?} {name}: pos {:.2e} vel {:.2e} dist {:.2e} {:.2e} steps {} {:?} {:?}",
                        align(&f.state.positions, &cpu.state.positions).max,
                        f.state
                            .velocities
                            .iter()
                            .zip(&cpu.state.velocities)
                            .map(|(a, b)| a.distance(*b))
                            .fold(0.0, f64::max),
                        f.distance,
                        cpu.distance,
                        f.steps,
                        tc,
                        t.elapsed()
                    ),
                    Err(e) => println!("{path} {name} {e}"),
                }
            }
            for percent in [60.0, 100.0] {
                let r = Relax::default();
                let t = Instant::now();
                let cpu = r.fold(&model, &start, percent, &mut |_| {}).unwrap();
                let tc = t.elapsed();
                let t = Instant::now();
                match gpu.with(r).dispatch(dispatch).fold(&model, &start, percent, &mut |_| {}) {
                    Ok(f) => println!(
                        "{path} {dispatch:?} relax {percent}: pos {:.2e} {:?} {:?} steps {} {} dist {:.2e} {:.2e} att {} {} energy {:.6} {:.6}  {:?} {:?}",
                        align(&f.state.positions, &cpu.state.positions).max,
                        f.stop,
                        cpu.stop,
                        f.steps,
                        cpu.steps,
                        f.distance,
                        cpu.distance,
                        f.attempts,
                        cpu.attempts,
                        f.state.energy(&model).total(),
                        cpu.state.energy(&model).total(),
                        tc,
                        t.elapsed()
                    ),
                    Err(e) => println!("{path} relax {e}"),
                }
            }
        }
    }
}
