//! How much a step does, and how fast it could be at best.

use std::hint::black_box;
use std::io::Write as _;
use std::time::Instant;

use super::counting::{Counts, count};
use super::{Case, Compute, Isa, Kernel, Material, Model};
use crate::kernel::isa::Pass;
use crate::kernel::lane::{GatherScatter, Num};
use crate::kernel::real::Quad64;

fn miura(panels: usize, material: &Material) -> Case {
    let pattern = crate::generate::miura(panels, panels).expect("valid");
    Case::new(Model::new(&pattern, material).expect("valid"), 1, 1e-4)
}

fn step<R: Compute>(kernel: &mut Kernel<R>, damped: bool) {
    kernel.springs(damped);
    kernel.euler(1e-9);
}

fn counts<R: Compute>(scene: &Case, damped: bool) -> Counts {
    let mut kernel = scene.kernel::<R>(Isa::Counting);
    count(|| step(&mut kernel, damped))
}

#[test]
fn what_a_scene_does_not_have_costs_nothing() {
    let all = counts::<f64>(&miura(9, &Material::default()), true);
    assert!(all.flops > 0 && all.divisions > 0 && all.choices > 0);
    let less = |what: &str, material: Material, damped| {
        let counts = counts::<f64>(&miura(9, &material), damped);
        assert!(counts.flops < all.flops, "{what}: {} of {}", counts.flops, all.flops);
        counts
    };
    less("corner angles", Material { k_face: 0.0, ..Material::default() }, true);
    less("creases within faces", Material { k_facet: 0.0, ..Material::default() }, true);
    less("damping", Material { zeta: 0.0, ..Material::default() }, true);
    // A relaxation has none, whatever the material says.
    assert_eq!(
        less("damping", Material::default(), false),
        less("damping", Material { zeta: 0.0, ..Material::default() }, true)
    );
}

#[test]
fn counts_grow_with_the_sheet() {
    let of = |panels: usize| counts::<f64>(&miura(panels, &Material::default()), true).flops as f64;
    // Twice as many panels a side are four times as many elements.
    assert!((of(32) / of(16) - 4.0).abs() < 0.2, "{}", of(32) / of(16));
}

/// Bytes that a step reads and writes: each list once for each pass over it, a node that several blocks share once for each. What
/// a block works with itself ([`Scratch`](crate::kernel::scratch::Scratch)) is not counted: it never leaves the fastest memory.
fn bytes<R: Compute>(kernel: &Kernel<R>) -> usize {
    fn of<T>(list: &[T]) -> usize {
        size_of_val(list)
    }
    let layout = &kernel.layout;
    let acted_on: usize = layout.blocks.iter().map(|block| block.acted_on).sum();
    let copied = layout.block_nodes.len() * (size_of::<u32>() + size_of::<Quad64>()) + acted_on * size_of::<R::Quad>();
    let creases = of(&layout.hinges) + of(&layout.stiffness) + of(&kernel.targets) + 2 * of(&kernel.angles);
    let triangles =
        of(&layout.corners) + of(&layout.creases) + of(&layout.beams) + of(&layout.damping) + of(&layout.angles);
    let sums = of(&layout.counts) + of(&layout.summands);
    let slots = 2 * acted_on * size_of::<R::Quad>() + of(layout.slots.starts()) + of(layout.slots.items());
    copied + creases + triangles + sums + slots + 2 * of(&kernel.positions) + 2 * of(&kernel.velocities)
}

#[test]
fn a_step_moves_no_more_bytes_than_it_did() {
    // 10 000 nodes, for each node and step.
    let scene = miura(99, &Material::default());
    let each = |bytes: usize| bytes as f64 / scene.positions.len() as f64;
    let (exact, mixed) =
        (each(bytes(&scene.kernel::<f64>(Isa::best()))), each(bytes(&scene.kernel::<f32>(Isa::best()))));
    assert!((400.0..680.0).contains(&exact) && (250.0..420.0).contains(&mixed), "{exact} and {mixed}");
}

/// Several chains of products and sums, or of divisions, of which none waits for another.
struct Chains<R> {
    times: usize,
    divide: bool,
    start: R,
}

const CHAINS: usize = 12;

impl<R: Compute> Pass<R> for Chains<R> {
    type Output = R;

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) -> R {
        let mut chains = [Num::of(lane, self.start); CHAINS];
        let (a, b) = (Num::splat(lane, 0.999), Num::splat(lane, 1e-3));
        for _ in 0..self.times {
            for chain in &mut chains {
                *chain = if self.divide { b / *chain } else { chain.mul_add(a, b) };
            }
        }
        let mut sum = chains[0];
        for chain in &chains[1..] {
            sum = sum + *chain;
        }
        let mut each = [R::default(); 16];
        sum.store(&mut each);
        each[0]
    }
}

/// Reads a list from its beginning to its end.
struct Reads<'a>(&'a [Quad64]);

impl Pass<f64> for Reads<'_> {
    type Output = f64;

    #[inline(always)]
    fn run<L: GatherScatter<Real = f64>>(self, lane: L) -> f64 {
        let numbers: &[f64] = bytemuck::cast_slice(self.0);
        let mut sums = [Num::splat(lane, 0.0); 4];
        for chunk in numbers.chunks_exact(4 * L::WIDTH) {
            for (i, sum) in sums.iter_mut().enumerate() {
                *sum = *sum + Num::load(lane, &chunk[i * L::WIDTH..]);
            }
        }
        let mut each = [0.0; 8];
        (sums[0] + sums[1] + sums[2] + sums[3]).store(&mut each);
        each[0]
    }
}

fn least(repeat: usize, mut work: impl FnMut()) -> f64 {
    let once = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..repeat).map(once).fold(f64::INFINITY, f64::min)
}

/// Products with sums, and divisions, each per nanosecond.
fn rates<R: Compute>() -> [f64; 2] {
    let isa = Isa::best();
    [false, true].map(|divide| {
        let times = 100_000;
        let start = black_box(R::of(1.0));
        let seconds = least(20, || {
            black_box(R::run(isa, Chains { times, divide, start }));
        });
        (times * CHAINS * R::width(isa)) as f64 / (1e9 * seconds)
    })
}

#[test]
#[ignore = "measures"]
fn floors() {
    let table = [floor::<f64>("f64"), floor::<f32>("mixed")].concat();
    writeln!(std::io::stderr(), "{table}").expect("standard error");
}

fn floor<R: Compute>(name: &str) -> String {
    use std::fmt::Write as _;
    let [products, divisions] = rates::<R>();
    let mut table = String::new();
    for panels in [31, 99, 315, 999] {
        let scene = miura(panels, &Material::default());
        let nodes = scene.positions.len();
        let each = |count: u64| count as f64 / nodes as f64;
        let counts = counts::<R>(&scene, true);
        let mut kernel = scene.kernel::<R>(Isa::best());
        let bytes = bytes(&kernel);
        let repeat = (100_000 / nodes).max(1);
        let steps = least(30, || (0..repeat).for_each(|_| step(&mut kernel, true)));
        let measured = steps * 1e9 / (nodes * repeat) as f64;
        let list = vec![Quad64::default(); bytes / size_of::<Quad64>()];
        let reading = least(30, || {
            for _ in 0..repeat {
                black_box(f64::run(Isa::best(), Reads(black_box(&list))));
            }
        });
        let floors = [
            0.5 * each(counts.flops) / products,
            each(counts.divisions) / divisions,
            reading * 1e9 / (nodes * repeat) as f64,
        ];
        let highest = floors.into_iter().fold(0.0, f64::max);
        let [by_products, by_divisions, by_reading] = floors;
        writeln!(
            table,
            "| {nodes} | {name} | {:.0} | {:.0} | {:.0} | {:.0} | {by_products:.1} | {by_divisions:.1} | {by_reading:.1} | {measured:.1} | {:.1} |",
            each(counts.flops),
            each(counts.divisions),
            each(counts.choices),
            bytes as f64 / nodes as f64,
            measured / highest,
        )
        .expect("a string");
    }
    table
}
