//! What the benches of the GPU share: the adapter, the scenes, and how the time of a step is taken.
#![expect(dead_code, reason = "each bench uses what it needs")]

use origami::scene::Scene;
use origami::solve::unwatched;
use std::ops::ControlFlow;
use std::sync::{Mutex, OnceLock};
use std::time::{Duration, Instant};

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, SamplingMode, Throughput};
use origami::generate::miura;
use origami::gpu::{AdapterChoice, AdapterKind, Gpu};
use origami::solve::{Instance, Progress, Session};
use origami::{CreasePattern, Dynamics, Material, Model, Solver, State};

/// Submissions that are under way while a run waits for an earlier one: its last looks come at once.
const UNDER_WAY: usize = 2;

/// An opened adapter.
pub(crate) struct Place {
    pub(crate) gpu: Gpu,
    /// A software adapter says nothing about GPUs, and is spared the large sheets.
    pub(crate) hardware: bool,
}

impl Place {
    /// The adapter that `ORIGAMI_ADAPTER` names or else the best there is, opened once; one printed line where there is none.
    pub(crate) fn open() -> Option<&'static Self> {
        static OPENED: OnceLock<Option<Place>> = OnceLock::new();
        let open = || match Gpu::open(&AdapterChoice::from_env()) {
            Ok(gpu) => {
                let hardware = gpu.adapter().kind != AdapterKind::Software;
                eprintln!("adapter: {}, {}, driver {}", gpu.adapter(), gpu.adapter().kind, gpu.adapter().driver);
                Some(Self { gpu, hardware })
            }
            Err(error) => {
                eprintln!("benches of the GPU are skipped: {error}");
                None
            }
        };
        OPENED.get_or_init(open).as_ref()
    }

    /// A group of benches, named after the adapter.
    pub(crate) fn group<'c>(&self, c: &'c mut Criterion, name: &str) -> BenchmarkGroup<'c, WallTime> {
        let mut group = c.benchmark_group(format!("{name} on {}, {}", self.gpu.adapter(), self.gpu.adapter().kind));
        group.sample_size(10).sampling_mode(SamplingMode::Flat);
        group.warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_secs(2));
        group
    }

    /// Those of the sizes that this adapter is asked for; one printed line where some are left out.
    pub(crate) fn sizes(&self, bench: &str, panels: &[usize], most_on_software: usize) -> Vec<usize> {
        let nodes = |panels: usize| (panels + 1) * (panels + 1);
        let fits = |panels: &usize| self.hardware || nodes(*panels) <= most_on_software;
        if !panels.iter().all(fits) {
            eprintln!("{bench}: sheets of more than {most_on_software} nodes are left to hardware adapters");
        }
        panels.iter().copied().filter(fits).collect()
    }
}

/// A Miura sheet of so many panels along both sides.
pub(crate) fn sheet(panels: usize, material: &Material) -> Model {
    model(&miura(panels, panels).expect("valid"), material)
}

pub(crate) fn model(pattern: &CreasePattern, material: &Material) -> Model {
    Model::new(pattern, material).expect("a valid pattern")
}

/// The patterns of `examples/patterns` that stand for real ones.
pub(crate) fn patterns() -> Vec<(&'static str, Model)> {
    let names = ["bird-base", "crane", "kresling", "waterbomb", "curved-pleat", "hypar"];
    let read = |name: &'static str| {
        let file = format!("{}/examples/patterns/{name}.fold", env!("CARGO_MANIFEST_DIR"));
        (name, model(&CreasePattern::read(file).expect("it is there"), &Material::default()))
    };
    names.map(read).into()
}

/// 200 steps after the jump from flat: before that creases turn so fast that angles cost more.
pub(crate) fn on_the_way(model: &Model) -> State {
    let to_start = Dynamics { steps: Some(200), ..Dynamics::default() };
    to_start.fold(model, &State::at_rest(model), &Scene::percent(60.0), &mut unwatched).expect("it holds").state
}

/// Steps enough for the time of one to be taken, and no more of a large sheet than must be. `speed`: nodes times steps
/// that take about a second.
pub(crate) fn steps(nodes: usize, speed: usize) -> u64 {
    (speed / nodes).clamp(600, 20_000).next_multiple_of(100) as u64
}

/// Nodes times steps a second, roughly: for the choice of a number of steps only.
pub(crate) const CPU: usize = 6_000_000;
pub(crate) const SOFTWARE: usize = 600_000;
pub(crate) const HARDWARE: usize = 1_000_000_000;

/// Takes the time between the looks at a run: from the first to the last before which the queue was full. What comes
/// before the first step and after the last is not in it.
#[derive(Default)]
pub(crate) struct Looks {
    at: Vec<(u64, Instant)>,
}

impl Looks {
    pub(crate) fn look(&mut self, progress: Progress) -> ControlFlow<()> {
        self.at.push((progress.step, Instant::now()));
        ControlFlow::Continue(())
    }

    /// The time of one step.
    pub(crate) fn per_step(&self) -> Duration {
        let last = self.at.len().saturating_sub(1 + UNDER_WAY);
        let ((first, start), (last, end)) = (self.at[0], self.at[last]);
        assert!(last > first, "too few looks");
        end.duration_since(start).div_f64((last - first) as f64)
    }
}

/// Benches the time of one step of what `run` runs.
pub(crate) fn bench_steps(
    group: &mut BenchmarkGroup<'_, WallTime>,
    id: BenchmarkId,
    nodes: usize,
    mut run: impl FnMut(&mut Looks),
) {
    group.throughput(Throughput::Elements(nodes as u64));
    group.bench_function(id, |b| {
        b.iter_custom(|iterations| {
            let one = |_| {
                let mut looks = Looks::default();
                run(&mut looks);
                looks.per_step()
            };
            (0..iterations).map(one).sum()
        });
    });
}

/// Benches the time of one step of a session.
pub(crate) fn bench_session(
    group: &mut BenchmarkGroup<'_, WallTime>,
    id: BenchmarkId,
    nodes: usize,
    mut session: Box<dyn Session + '_>,
    start: &State,
) {
    bench_steps(group, id, nodes, |looks| {
        session.fold(start, &Scene::percent(60.0), &mut |progress| looks.look(progress)).expect("it holds");
    });
}

/// Benches the time of one step of all instances together.
pub(crate) fn bench_ensemble(
    group: &mut BenchmarkGroup<'_, WallTime>,
    id: BenchmarkId,
    solver: &dyn Solver,
    instances: &[Instance<'_>],
) {
    let nodes = instances.iter().map(|i| i.model.node_count()).sum();
    bench_steps(group, id, nodes, |looks| {
        let looks = Mutex::new(looks);
        let results = solver.fold_all(instances, &|i, progress| {
            if i == 0
                && let Ok(mut looks) = looks.lock()
            {
                return looks.look(progress);
            }
            ControlFlow::Continue(())
        });
        assert!(results.iter().all(Result::is_ok), "all hold");
    });
}
