//! Vibrations about a state: `K shape = eigenvalue M shape` with the tangent K and the masses M of the nodes.

use glam::DVec3;

use super::eigen::{Patience, nearest_to_zero};
use super::equations::Equations;
use super::structure::{HingeKind, Structure};
use super::tangent::{NEUTRAL, Tangent};
use super::{Configuration, Energies, Refused};

/// The first shift that makes a tangent positive definite, as a share of its largest eigenvalue, and by how much one that was
/// too small is raised.
const SHIFT: f64 = 1e-9;
const RAISE: f64 = 8.0;

/// A vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// The square of its angular frequency, a force per length and mass; negative where the state is unstable.
    pub eigenvalue: f64,
    /// How the nodes move, the farthest by 1.
    pub shape: Vec<DVec3>,
    /// The energy that it stores, to second order, when it moves as `shape`: where a state bears loads parts may be negative.
    pub stores: Energies,
    /// What it mostly deforms.
    pub kind: ModeKind,
}

/// What a vibration mostly deforms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ModeKind {
    /// Nothing: a rigid motion or a mechanism.
    Free,
    /// Creases: the sheet folds.
    Creases,
    /// Facets, which bend.
    Facets,
    /// Bars and corners: it is stretched or sheared.
    Bars,
}

impl Structure {
    /// The `count` lowest vibrations about `at`, an equilibrium under `load_factor` times the loads, in order. Nodes have the
    /// [masses](Structure::masses), or 1 each.
    ///
    /// # Errors
    /// [`Refused`] where the structure is wrong or too large.
    pub fn modes(&self, at: &Configuration, load_factor: f64, count: usize) -> Result<Vec<Mode>, Refused> {
        self.check_configuration(at)?;
        let mut tangent = Tangent::new(self)?;
        tangent.set(at, load_factor);
        let of_node = |i: usize| self.masses.get(i).copied().unwrap_or(1.0);
        let masses: Vec<DVec3> = (0..self.nodes.len()).map(|i| DVec3::splat(of_node(i))).collect();
        let masses = tangent.equations.rows.gather(&masses);
        let roots: Vec<f64> = masses.iter().map(|m| m.sqrt()).collect();
        let scaled = |x: &[f64], by: fn(f64, f64) -> f64| -> Vec<f64> {
            x.iter().zip(&roots).map(|(x, root)| by(*x, *root)).collect()
        };
        let Tangent { equations, matrix, factor, .. } = &mut tangent;
        let largest = matrix.largest_diagonal() / masses.iter().copied().fold(f64::INFINITY, f64::min);
        let mut shift = SHIFT * largest;
        while factor.factorise(matrix.shifted(shift, &masses)) != Some(0) {
            shift *= RAISE;
            if !shift.is_finite() {
                return Err(Refused::Singular { at: format!("load factor {load_factor}") });
            }
        }
        // With x = sqrt(M) shape the masses are 1.
        let times = |x: &[f64]| -> Vec<f64> {
            let product = scaled(&matrix.times(&scaled(x, |x, root| x / root)), |x, root| x / root);
            product.iter().zip(x).map(|(p, x)| p + shift * x).collect()
        };
        let solve = |right: &[f64]| {
            let mut x = scaled(right, |x, root| x * root);
            factor.solve(&mut x);
            scaled(&x, |x, root| x * root)
        };
        let patience = Patience { tolerance: 1e-12, nothing: 1e-15 * largest, rounds: 500 };
        let mut pairs = nearest_to_zero(masses.len(), count, patience, &mut Vec::new(), times, solve);
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mode = |(value, x): (f64, Vec<f64>)| {
            let mut shape = equations.rows.scatter(&scaled(&x, |x, root| x / root));
            let farthest = shape.iter().map(|s| s.length()).fold(f64::MIN_POSITIVE, f64::max);
            shape.iter_mut().for_each(|s| *s /= farthest);
            let eigenvalue = value - shift;
            let stores = self.stored_by(at, &shape);
            let kind = match stores {
                _ if eigenvalue.abs() <= NEUTRAL * largest => ModeKind::Free,
                Energies { bars, creases, facets, corners } => {
                    let parts = [
                        (ModeKind::Creases, creases.abs()),
                        (ModeKind::Facets, facets.abs()),
                        (ModeKind::Bars, bars.abs() + corners.abs()),
                    ];
                    parts.into_iter().fold(parts[0], |a, b| if b.1 > a.1 { b } else { a }).0
                }
            };
            Mode { eigenvalue, shape, stores, kind }
        };
        Ok(pairs.into_iter().map(mode).collect())
    }

    /// Half of `shape . K shape`, by what it is stored in.
    fn stored_by(&self, at: &Configuration, shape: &[DVec3]) -> Energies {
        let energy = |part: &Self, fold_angles: Vec<f64>| {
            let at = Configuration { positions: at.positions.clone(), fold_angles };
            Equations::new(part).map_or(f64::NAN, |equations| {
                let pull = equations.stiffness_times(&at, shape);
                0.5 * pull.iter().zip(shape).map(|(p, s)| p.dot(*s)).sum::<f64>()
            })
        };
        let bare = Self { nodes: self.nodes.clone(), ..Self::default() };
        let hinges = |kind: HingeKind| {
            let own = self.hinges.iter().zip(&at.fold_angles).filter(|(hinge, _)| hinge.kind == kind);
            let (hinges, angles): (Vec<_>, Vec<f64>) = own.unzip();
            energy(&Self { hinges: hinges.into_iter().copied().collect(), ..bare.clone() }, angles)
        };
        Energies {
            bars: energy(&Self { bars: self.bars.clone(), ..bare.clone() }, Vec::new()),
            creases: hinges(HingeKind::Crease),
            facets: hinges(HingeKind::Facet),
            corners: energy(&Self { corners: self.corners.clone(), ..bare.clone() }, Vec::new()),
        }
    }
}
