//! A grid of instances: every percentage with every material, perturbation and seed.

use super::{Instance, Relax, State};
use crate::model::{Material, Model};
use crate::scene::Scene;

/// What varies between the sheets of an ensemble. Every combination is one of its points.
///
/// ```
/// use origami_core::generate::BirdBase;
/// use origami_core::model::MaterialGrid;
/// use origami_core::solve::Sweep;
/// use origami_core::{Model, Relax, Solver};
///
/// let pattern = BirdBase::default().pattern()?;
/// let materials = MaterialGrid { k_fold: vec![0.1, 0.7, 7.0], ..MaterialGrid::default() }.materials();
/// let sweep = Sweep { percents: vec![30.0, 60.0, 90.0], materials, ..Sweep::default() };
/// let models = Model::of_each(&pattern, &sweep.materials)?;
/// // The instances bring their perturbation with them.
/// let solver = Relax { perturbation: 0.0, ..Relax::default() };
/// let folded = solver.fold_all(&sweep.instances(&models), &|_, _| std::ops::ControlFlow::Continue(()));
/// for (point, folded) in sweep.points().zip(folded) {
///     assert!(folded?.converged(), "{} % of {:?}", point.percent, sweep.materials[point.material]);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// Percentages of the pattern's fold angles. Default: 100.
    pub percents: Vec<f64>,
    /// Materials; [`crate::model::MaterialGrid`] makes them from lists. Default: the default one.
    pub materials: Vec<Material>,
    /// How far each node is moved at the start, as a share of its shortest beam. Default: that of [`Relax`].
    pub perturbations: Vec<f64>,
    /// How many seeds each perturbation is taken with: 0, 1 and so on. Default 1.
    pub seeds: u64,
}

impl Default for Sweep {
    fn default() -> Self {
        Self {
            percents: vec![100.0],
            materials: vec![Material::default()],
            perturbations: vec![Relax::default().perturbation],
            seeds: 1,
        }
    }
}

/// One combination of what varies in a [`Sweep`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Its place in [`Sweep::materials`].
    pub material: usize,
    /// How far each node is moved at the start, as a share of its shortest beam.
    pub perturbation: f64,
    /// The directions in which they are moved.
    pub seed: u64,
    /// Percentage of the pattern's fold angles.
    pub percent: f64,
}

impl Sweep {
    /// All combinations: the material varies slowest, then the perturbation, then the seed, and the percentage fastest.
    pub fn points(&self) -> impl Iterator<Item = Point> + '_ {
        let of_seed = |material, perturbation, seed| {
            self.percents.iter().map(move |&percent| Point { material, perturbation, seed, percent })
        };
        let of_perturbation =
            move |material, perturbation| (0..self.seeds).flat_map(move |seed| of_seed(material, perturbation, seed));
        let of_material =
            move |material| self.perturbations.iter().flat_map(move |&share| of_perturbation(material, share));
        (0..self.materials.len()).flat_map(of_material)
    }

    /// One instance for each of [`Sweep::points`], in that order. `models` are those of [`Sweep::materials`], as
    /// [`Model::of_each`] makes them. Each instance holds a whole state: of a great many take some points at a time.
    ///
    /// # Panics
    /// If there are fewer models than materials.
    #[must_use]
    pub fn instances<'m>(&self, models: &'m [Model]) -> Vec<Instance<'m>> {
        self.points().map(|point| point.instance(&models[point.material])).collect()
    }
}

impl Point {
    /// The sheet to be folded, of `model`, which is of this point's material. Where nothing is to be folded nothing is
    /// moved: a flat sheet at 0 % stays flat.
    ///
    /// It begins as [`Relax`] does with the same perturbation, so that a `Relax` without one of its own arrives at the
    /// same bits.
    #[must_use]
    pub fn instance<'m>(&self, model: &'m Model) -> Instance<'m> {
        let at_rest = State::at_rest(model);
        let still = model.targets(self.percent) == at_rest.targets;
        let start = if still { at_rest } else { State::perturbed(model, self.perturbation, self.seed) };
        Instance { model, start, scene: Scene::percent(self.percent) }
    }
}
