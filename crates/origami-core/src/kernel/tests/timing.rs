//! What the passes take, by set of instructions and by number of threads.

use std::io::Write as _;
use std::time::Instant;

use super::{Case, Compute, Isa, Kernel, Material, Model};
use crate::kernel::parallelism::Parallelism;

#[test]
#[ignore = "measures"]
fn timing() {
    for panels in [9_usize, 31, 99, 315] {
        let pattern = crate::generate::miura(panels, panels).expect("valid");
        let model = Model::new(&pattern, &Material::default()).expect("valid");
        let nodes = model.node_count();
        let scene = Case::new(model, 1, 1e-4);
        let repeat = (30_000 / nodes).max(1);
        time::<f64>(&scene, repeat);
        time::<f32>(&scene, repeat);
    }
}

fn time<R: Compute>(scene: &Case, repeat: usize) {
    let nodes = scene.positions.len();
    for isa in Isa::all() {
        if matches!(isa, Isa::PortableFused | Isa::Counting) {
            continue;
        }
        let mut kernel = scene.kernel::<R>(isa);
        let mut each = [f64::INFINITY; 3];
        for _ in 0..60 {
            let mut of = |pass_index: usize, pass: &mut dyn FnMut(&mut Kernel<R>)| {
                let start = Instant::now();
                for _ in 0..repeat {
                    pass(&mut kernel);
                }
                each[pass_index] = each[pass_index].min(start.elapsed().as_secs_f64() * 1e9 / (nodes * repeat) as f64);
            };
            of(0, &mut |k| {
                k.springs(true);
            });
            of(1, &mut |k| {
                k.euler(0.0);
            });
            of(2, &mut |k| {
                k.springs(true);
                k.euler(1e-9);
            });
        }
        let name = format!("{isa:?}");
        let line = format!(
            "{nodes:>7} {} {:>9} springs {:5.1} integrate {:5.1} all {:5.1}",
            size_of::<R>() * 8,
            &name[..name.len().min(8)],
            each[0],
            each[1],
            each[2]
        );
        writeln!(std::io::stderr(), "{line}").expect("standard error");
    }
}

#[test]
#[ignore = "measures"]
fn timing_of_threads() {
    for panels in [15_usize, 22, 31, 54, 99, 172, 315] {
        let pattern = crate::generate::miura(panels, panels).expect("valid");
        let scene = Case::new(Model::new(&pattern, &Material::default()).expect("valid"), 1, 1e-4);
        time_threads::<f64>(&scene, "f64");
        time_threads::<f32>(&scene, "mixed");
    }
}

/// On one thread, always shared out among two, and as the clock decides.
fn time_threads<R: Compute>(scene: &Case, what: &str) {
    let nodes = scene.positions.len();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("a pool");
    let mut kernels = [1, 2, 2].map(|threads| scene.shared::<R>(Isa::best(), threads));
    kernels[1].parallelism = Parallelism::steady(2);
    let rounds = std::env::var("ROUNDS").ok().and_then(|rounds| rounds.parse().ok()).unwrap_or(2);
    let (mut best, mut all) = ([f64::INFINITY; 3], [0.0; 3]);
    for _ in 0..rounds {
        for (i, kernel) in kernels.iter_mut().enumerate() {
            if i == 2 {
                kernel.parallelism = Parallelism::new(2);
            }
            let (start, mut steps) = (Instant::now(), 0);
            pool.install(|| {
                while start.elapsed().as_millis() < 600 {
                    kernel.springs(true);
                    kernel.euler(1e-9);
                    steps += 1;
                }
            });
            let each = start.elapsed().as_secs_f64() * 1e9 / (nodes * steps) as f64;
            best[i] = best[i].min(each);
            all[i] += each / f64::from(rounds);
        }
    }
    let line = format!("{nodes:>7} {what:>6} alone, two, as fits: best {best:5.1?} mean {all:5.1?}");
    writeln!(std::io::stderr(), "{line}").expect("standard error");
}
