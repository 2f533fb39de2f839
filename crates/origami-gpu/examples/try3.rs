use origami_core::measure::align;
use origami_core::solve::*;
use origami_core::*;
fn main() {
    let gpu = origami_gpu::Gpu::open(&origami_gpu::AdapterChoice::from_env()).unwrap();
    let a: Vec<String> = std::env::args().collect();
    let doc = fold::Document::read(&a[1]).unwrap();
    let percent: f64 = a[2].parse().unwrap();
    let pattern = CreasePattern::from_document(&doc, doc.pattern_frame().unwrap()).unwrap();
    for (name, m) in [("default", Material::default()), ("k_face 0", Material { k_face: 0.0, ..Material::default() })] {
        let model = Model::new(&pattern, &m).unwrap();
        let start = State::at_rest(&model);
        for max in [5000, 20000] {
            let r = Relax { max_steps: max, retry: false, ..Relax::default() };
            let cpu = r.fold(&model, &start, percent, &mut |_| {}).unwrap();
            let f = gpu.with(r).fold(&model, &start, percent, &mut |_| {}).unwrap();
            println!(
                "{name} {max}: pos {:.2e} {:?} {:?} steps {} {} dist {:.2e} {:.2e} res {:.2e} {:.2e} step {} energy {:.9} {:.9}",
                align(&f.state.positions, &cpu.state.positions).max,
                f.stop,
                cpu.stop,
                f.steps,
                cpu.steps,
                f.distance,
                cpu.distance,
                f.residual,
                cpu.residual,
                f.time_step,
                f.state.energy(&model).total(),
                cpu.state.energy(&model).total()
            );
            // go on from the GPU state on CPU
            let on = Relax { ramp: Some(0), perturbation: 0.0, ..Relax::default() }
                .fold(&model, &f.state, percent, &mut |_| {})
                .unwrap();
            println!(
                "   cpu goes on: {} steps, moved {:.2e}, from cpu {:.2e} energy {:.9}",
                on.steps,
                align(&on.state.positions, &f.state.positions).max,
                align(&on.state.positions, &cpu.state.positions).max,
                on.state.energy(&model).total()
            );
            let minheight = model
                .mesh
                .triangles
                .iter()
                .map(|t| {
                    let p = t.map(|n| model.rest[n.index()]);
                    let a = (p[1] - p[0]).cross(p[2] - p[0]).length();
                    a / (p[1] - p[0]).length().max((p[2] - p[1]).length()).max((p[0] - p[2]).length())
                })
                .fold(9.0, f64::min);
            println!(
                "   least height {minheight:.2e} largest angle {:.1}",
                f.state.fold_angles.iter().fold(0.0f64, |a, b| a.max(b.abs())).to_degrees()
            );
        }
    }
}
