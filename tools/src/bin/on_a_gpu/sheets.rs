//! The sheets that are measured, the solvers, and what computes them.

use std::error::Error;
use std::num::NonZeroUsize;

use origami::generate::{catalog, miura};
use origami::gpu::{Dispatch, Gpu, GpuMethod};
use origami::solve::Precision;
use origami::{Dynamics, Material, Model, Relax, Solver};

/// What every sheet is folded to, in percent.
pub(crate) const PERCENT: f64 = 60.0;

/// Steps that no run comes to the end of: it is broken off.
pub(crate) const ENDLESS: u64 = 1_000_000_000;

/// A generator of the catalogue, and those of its numbers that are not the defaults.
pub(crate) type Named = (&'static str, &'static [(&'static str, f64)]);

/// Every pattern of the catalogue, the most telling first, and four that are larger.
pub(crate) const PATTERNS: [Named; 20] = [
    ("miura", &[]),
    ("bird-base", &[]),
    ("crane", &[]),
    ("waterbomb", &[]),
    ("kresling", &[]),
    ("curved-pleat", &[]),
    ("hypar", &[]),
    ("yoshimura", &[]),
    ("square-twist", &[]),
    ("fan", &[]),
    ("strip", &[]),
    ("degree-4", &[]),
    ("waterbomb-vertex", &[]),
    ("single-crease", &[]),
    ("kresling-ring", &[]),
    ("yoshimura-ring", &[]),
    ("miura", &[("columns", 30.0), ("rows", 30.0)]),
    ("waterbomb", &[("columns", 12.0), ("rows", 12.0)]),
    ("yoshimura", &[("columns", 16.0), ("rows", 16.0)]),
    ("miura", &[("columns", 99.0), ("rows", 99.0)]),
];

/// A sheet of the catalogue in the default material.
///
/// # Errors
/// If the catalogue has none such.
pub(crate) fn model((name, numbers): Named) -> Result<Model, Box<dyn Error>> {
    let numbers: Vec<(String, f64)> = numbers.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    Ok(Model::new(&catalog::generate(name, &numbers)?, &Material::default())?)
}

/// A Miura sheet of so many panels along both sides.
///
/// # Errors
/// If there is none of that size.
pub(crate) fn square(panels: usize) -> Result<Model, Box<dyn Error>> {
    Ok(Model::new(&miura(panels, panels)?, &Material::default())?)
}

/// Dynamics of so many steps.
pub(crate) fn dynamics(steps: u64) -> Dynamics {
    Dynamics { steps: Some(steps), ..Dynamics::default() }
}

/// A relaxation of so many evaluations, of which none is on a ramp.
pub(crate) fn relax(steps: u64) -> Relax {
    Relax { steps: Some(steps), ramp: Some(0), ..Relax::default() }
}

/// One workgroup is one of a GPU's many processors: beyond so many vertices nobody would give it a whole sheet.
const MOST_IN_ONE_WORKGROUP: usize = 4_096;

/// The ways that the library lists and `model` can go, each with what a row calls it.
pub(crate) fn ways<S: GpuMethod + Clone>(gpu: &Gpu, method: &S, model: &Model) -> Vec<(String, Dispatch)> {
    let sensible = |way: Dispatch| way != Dispatch::Workgroup || model.node_count() <= MOST_IN_ONE_WORKGROUP;
    let can = |way: &&Dispatch| sensible(**way) && gpu.with(method.clone()).dispatch(**way).way(model) == **way;
    Dispatch::WAYS.iter().filter(can).map(|way| (format!("GPU, {way}"), *way)).collect()
}

/// What a row calls the paper's passes.
pub(crate) const PAPER: &str = "GPU, the paper's passes in plain f32";

/// Numbers and threads of the processor.
#[derive(Clone, Copy)]
pub(crate) struct Processor {
    pub(crate) precision: Precision,
    /// Or as many as there are.
    pub(crate) one_thread: bool,
}

impl Processor {
    pub(crate) const ALL: [Self; 4] = [
        Self { precision: Precision::F64, one_thread: true },
        Self { precision: Precision::F64, one_thread: false },
        Self { precision: Precision::Mixed, one_thread: true },
        Self { precision: Precision::Mixed, one_thread: false },
    ];

    /// What a row calls it.
    pub(crate) fn name(self) -> String {
        let numbers = if self.precision == Precision::F64 { "f64" } else { "mixed" };
        let threads = if self.one_thread { "one thread" } else { "all threads" };
        format!("CPU, {numbers}, {threads}")
    }

    pub(crate) fn threads(self) -> Option<NonZeroUsize> {
        self.one_thread.then_some(NonZeroUsize::MIN)
    }

    pub(crate) fn relax(self, relax: Relax) -> Relax {
        Relax { precision: self.precision, threads: self.threads(), ..relax }
    }

    pub(crate) fn dynamics(self, dynamics: Dynamics) -> Dynamics {
        Dynamics { precision: self.precision, threads: self.threads(), ..dynamics }
    }
}

/// The solver of a way.
pub(crate) fn on<S: GpuMethod + 'static>(gpu: &Gpu, method: S, way: Dispatch) -> Box<dyn Solver> {
    Box::new(gpu.with(method).dispatch(way))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_generator_is_there_and_every_sheet_can_be_built() {
        let names: Vec<&str> = PATTERNS.iter().map(|(name, _)| *name).collect();
        assert!(catalog::names().iter().all(|name| names.contains(name)));
        let sizes = PATTERNS.map(|named| model(named).expect("a model").node_count());
        assert!(sizes.iter().max() >= Some(&10_000) && sizes.iter().min() <= Some(&5));
    }
}
