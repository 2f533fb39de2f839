//! `Plan`: a sweep as a list of sheets, any of which can be folded by itself, in whatever process.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use origami::model::{Inventory, Material, MaterialGrid, Model};
use origami::solve::{Folded, Point, Relax, Stop as Ended, Sweep};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::backend::Computer;
use crate::errors::{OrRaise, refused};
use crate::pattern::Pattern;
use crate::settings::Method;
use crate::source::Read;
use crate::table::{Row, line};
use crate::watch::Watch;

/// Nodes of all models that are held at once: some hundred megabytes.
const NODES_AT_ONCE: usize = 1 << 18;

/// What varies between the sheets of a sweep, with all that it takes to fold them.
#[pyclass(frozen, module = "origami_sim._native")]
pub(crate) struct Plan {
    pattern: Py<Pattern>,
    solver: Py<PyAny>,
    asked: Asked,
    read: Arc<Read>,
    method: Method,
    sweep: Sweep,
    count: usize,
    scenes: Vec<(Needs, usize)>,
    place: Option<usize>,
}

/// The lists as they were given: percents, perturbations, seeds, ea, k_fold, k_facet, k_face, zeta.
type Asked = (Vec<f64>, Option<Vec<f64>>, u64, Vec<f64>, Vec<f64>, Vec<f64>, Vec<f64>, Vec<f64>);

/// Set from another thread, it ends the batches that look at it.
#[pyclass(frozen, module = "origami_sim._native")]
pub(crate) struct Stop(Arc<AtomicBool>);

#[pymethods]
impl Stop {
    #[new]
    fn new() -> Self {
        Self(Arc::default())
    }

    /// From now on.
    fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

#[pymethods]
impl Plan {
    #[new]
    #[pyo3(signature = (pattern, solver, asked, place=None))]
    fn new(
        py: Python<'_>,
        pattern: Bound<'_, Pattern>,
        solver: Bound<'_, PyAny>,
        asked: Asked,
        place: Option<usize>,
    ) -> PyResult<Self> {
        let method = Method::of(&solver)?;
        let (percents, perturbations, seeds, ea, k_fold, k_facet, k_face, zeta) = asked.clone();
        let own = if matches!(method, Method::Dynamics(_)) { 0.0 } else { Relax::default().perturbation };
        let perturbations = perturbations.unwrap_or_else(|| vec![own]);
        check("percent", &percents, f64::is_finite, "finite percentages")?;
        check("perturbation", &perturbations, |x| (0.0..=1.0).contains(&x), "shares from 0 to 1")?;
        let grid = MaterialGrid { ea, k_fold, k_facet, k_face, zeta };
        let numbers = [grid.count(), Some(percents.len()), Some(perturbations.len()), usize::try_from(seeds).ok()];
        let count = numbers.into_iter().try_fold(1_usize, |product, n| product.checked_mul(n?));
        let count = count.filter(|count| (1..=MOST).contains(count)).ok_or_else(|| {
            refused("sweep", "the lists combine to no sheet, or too many", &format!("1 to {MOST} sheets"))
        })?;
        let mut materials = grid.materials();
        if matches!(method, Method::Dynamics(_)) {
            // The paper's motion has the paper's springs.
            materials.iter_mut().for_each(|material| material.collapse = Material::paper().collapse);
        }
        let sweep = Sweep { percents, materials, perturbations, seeds };
        sweep.materials.iter().try_for_each(Material::check).or_raise()?;
        let read = Arc::clone(&pattern.get().read);
        let method = method.unperturbed();
        let scenes = py.detach(|| scenes(&read, &method, &sweep.materials)).or_raise()?;
        Ok(Self {
            pattern: pattern.unbind(),
            solver: solver.unbind(),
            asked,
            read,
            method,
            sweep,
            count,
            scenes,
            place,
        })
    }

    fn __len__(&self) -> usize {
        self.count
    }

    /// The rows of `count` sheets from `first` on, as lines of `sweep.csv`. Raises `KeyboardInterrupt` where `stop` was set.
    #[pyo3(signature = (first, count, stop=None))]
    fn rows(
        &self,
        py: Python<'_>,
        first: usize,
        count: usize,
        stop: Option<&Bound<'_, Stop>>,
    ) -> PyResult<Vec<String>> {
        let stop = stop.map(|stop| Arc::clone(&stop.get().0));
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let pool = pool.map_err(|error| refused("threads", &error.to_string(), "a system that has one more"))?;
        // A pool of its own: one thread for one batch, and none of a pool that a forked process has lost.
        let rows = py.detach(|| pool.install(|| self.fold(first, count, &mut Watch::until(stop))));
        rows.or_raise()?.ok_or_else(|| PyKeyboardInterrupt::new_err("the sweep was stopped"))
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let py = this.py();
        let plan = this.get();
        let parts = (plan.pattern.clone_ref(py), plan.solver.clone_ref(py), plan.asked.clone(), plan.place);
        (py.get_type::<Self>(), parts).into_pyobject(py)
    }
}

/// The most sheets of one sweep.
const MOST: usize = 100_000_000;

impl Plan {
    /// Folds some of the sheets, one after the other; `None` where it was stopped.
    fn fold(&self, first: usize, count: usize, watch: &mut Watch) -> Result<Option<Vec<String>>, origami::Error> {
        let points: Vec<Point> = self.sweep.points().skip(first).take(count).collect();
        let computer = Computer::processor(&self.method);
        let materials = (NODES_AT_ONCE / self.read.pattern.vertices.len().max(1)).max(1);
        let mut lines = Vec::with_capacity(points.len());
        for part in points.chunk_by(|one, other| one.material / materials == other.material / materials) {
            let (Some(least), Some(most)) = (part.first(), part.last()) else { continue };
            let models = Model::of_each(&self.read.pattern, &self.sweep.materials[least.material..=most.material])?;
            for point in part {
                let model = &models[point.material - least.material];
                let instance = point.instance(model);
                let folded = computer.solver().fold(model, &instance.start, &instance.scene, &mut |p| watch.observe(p));
                if watch.is_stopped() || folded.as_ref().is_ok_and(|folded: &Folded| folded.stop == Ended::Cancelled) {
                    return Ok(None);
                }
                let index = self.place.unwrap_or(0) * self.count + first + lines.len();
                let row = Row { index, scene: self.scene(&model.material), place: self.place, point, model };
                lines.push(line(&row, folded));
            }
        }
        Ok(Some(lines))
    }

    /// The number of what is built for a material, in the order in which the materials of the sweep have it.
    fn scene(&self, material: &Material) -> usize {
        let needs = needs(material);
        self.scenes.iter().find(|(known, _)| *known == needs).map_or(0, |(_, scene)| *scene)
    }
}

/// Which of a material's springs there are: what is built depends on nothing else of it.
type Needs = [bool; 6];

fn needs(material: &Material) -> Needs {
    let Material { ea, k_fold, k_facet, k_face, zeta, collapse } = *material;
    [ea, k_fold, k_facet, k_face, zeta, collapse].map(|stiffness| stiffness != 0.0)
}

/// The number of each way in which materials differ in what is built for them.
fn scenes(read: &Read, method: &Method, materials: &[Material]) -> Result<Vec<(Needs, usize)>, origami::Error> {
    let mut scenes: Vec<(Needs, usize)> = Vec::new();
    let mut inventories: Vec<Inventory> = Vec::new();
    for material in materials {
        let needs = needs(material);
        if scenes.iter().any(|(known, _)| *known == needs) {
            continue;
        }
        let inventory = method.solver().inventory(&Model::new(&read.pattern, material)?);
        let seen = inventories.iter().position(|other| *other == inventory);
        scenes.push((needs, seen.unwrap_or(inventories.len())));
        if seen.is_none() {
            inventories.push(inventory);
        }
    }
    Ok(scenes)
}

fn check(name: &'static str, numbers: &[f64], holds: impl Fn(f64) -> bool, expected: &str) -> PyResult<()> {
    match numbers.iter().position(|x| !holds(*x)) {
        Some(i) => Err(refused(format!("{name}[{i}]"), &numbers[i].to_string(), expected)),
        None => Ok(()),
    }
}
