//! Settings of materials and solvers: dataclasses of `origami_sim.settings`, read by their attributes.

use std::num::NonZeroUsize;

use origami::model::{Material, Softening};
#[cfg(feature = "newton")]
use origami::solve::Newton;
use origami::solve::{Dynamics, Integrator, Precision, Relax, Solver, TimeStep};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{OrRaise, refused};

/// What folds.
pub(crate) enum Method {
    Relax(Relax),
    Dynamics(Dynamics),
    #[cfg(feature = "newton")]
    Newton(Newton),
}

impl Method {
    /// That of a `Relax`, `Dynamics` or `Newton`.
    pub(crate) fn of(settings: &Bound<'_, PyAny>) -> PyResult<Self> {
        let name: String = settings.getattr("name").and_then(|name| name.extract()).unwrap_or_default();
        match name.as_str() {
            "relax" => relax(settings).map(Self::Relax),
            "dynamics" => dynamics(settings).map(Self::Dynamics),
            #[cfg(feature = "newton")]
            "newton" => newton(settings).map(Self::Newton),
            #[cfg(not(feature = "newton"))]
            "newton" => Err(refused("solver", "this build has no feature `newton`", "Relax or Dynamics")),
            _ => Err(refused("solver", &settings.get_type().to_string(), "a Relax, Dynamics or Newton")),
        }
    }

    pub(crate) fn solver(&self) -> &dyn Solver {
        match self {
            Self::Relax(relax) => relax,
            Self::Dynamics(dynamics) => dynamics,
            #[cfg(feature = "newton")]
            Self::Newton(newton) => newton,
        }
    }

    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Relax(_) => "relax",
            Self::Dynamics(_) => "dynamics",
            #[cfg(feature = "newton")]
            Self::Newton(_) => "newton",
        }
    }

    /// The numbers that it computes in, as reports call them.
    pub(crate) fn precision(&self) -> &'static str {
        match self {
            Self::Relax(relax) => relax.precision.name(),
            Self::Dynamics(dynamics) => dynamics.precision.name(),
            #[cfg(feature = "newton")]
            Self::Newton(_) => Precision::F64.name(),
        }
    }

    /// The distance from the equilibrium that it stops at, in radii.
    pub(crate) fn tolerance(&self) -> f64 {
        match self {
            Self::Relax(relax) => relax.tolerance,
            Self::Dynamics(dynamics) => dynamics.tolerance,
            #[cfg(feature = "newton")]
            Self::Newton(newton) => newton.relax.as_ref().map_or(Relax::default().tolerance, |relax| relax.tolerance),
        }
    }

    /// The same without a perturbation of its own: the instances of a sweep bring theirs.
    pub(crate) fn unperturbed(mut self) -> Self {
        match &mut self {
            Self::Relax(relax) => relax.perturbation = 0.0,
            Self::Dynamics(_) => {}
            #[cfg(feature = "newton")]
            Self::Newton(newton) => {
                newton.perturbation = 0.0;
                newton.relax.iter_mut().for_each(|relax| relax.perturbation = 0.0);
            }
        }
        self
    }
}

/// The material of a `Material`.
pub(crate) fn material(settings: &Bound<'_, PyAny>) -> PyResult<Material> {
    let number = |name| setting(settings, name);
    let material = Material {
        ea: number("ea")?,
        k_fold: number("k_fold")?,
        k_facet: number("k_facet")?,
        k_face: number("k_face")?,
        zeta: number("zeta")?,
        collapse: number("collapse")?,
    };
    material.check().or_raise()?;
    Ok(material)
}

fn relax(settings: &Bound<'_, PyAny>) -> PyResult<Relax> {
    Ok(Relax {
        tolerance: positive(settings, "tolerance")?,
        ramp: setting(settings, "ramp")?,
        max_steps: setting(settings, "max_steps")?,
        steps: setting(settings, "steps")?,
        retry: setting(settings, "retry")?,
        softening: softening(&settings.getattr("softening")?)?,
        perturbation: share(settings, "perturbation")?,
        saddle_search: at_least_zero(settings, "saddle_search")?,
        near: at_least_zero(settings, "near")?,
        hand_over: setting(settings, "hand_over")?,
        precision: precision(settings)?,
        threads: threads(settings)?,
    })
}

/// That of a `Softening`, or none.
fn softening(settings: &Bound<'_, PyAny>) -> PyResult<Option<Softening>> {
    if settings.is_none() {
        return Ok(None);
    }
    let softening = Softening {
        beams: positive(settings, "beams")?,
        corner_angles: at_least_zero(settings, "corner_angles")?,
        wrong_side: at_least_zero(settings, "wrong_side")?,
    };
    Ok(Some(softening))
}

fn dynamics(settings: &Bound<'_, PyAny>) -> PyResult<Dynamics> {
    let integrator = match setting::<String>(settings, "integrator")?.as_str() {
        "euler" => Integrator::Euler,
        "verlet" => Integrator::Verlet,
        other => return Err(refused("integrator", other, "`euler` or `verlet`")),
    };
    let word: Option<String> = settings.getattr("time_step")?.extract().ok();
    let time_step = match word.as_deref() {
        Some("paper") => TimeStep::Paper,
        Some("safe") => TimeStep::Safe,
        Some(other) => return Err(refused("time_step", other, "`paper`, `safe` or a number greater than 0")),
        None => TimeStep::Fixed(positive(settings, "time_step")?),
    };
    Ok(Dynamics {
        time_step,
        integrator,
        ramp: setting(settings, "ramp")?,
        tolerance: positive(settings, "tolerance")?,
        max_steps: setting(settings, "max_steps")?,
        steps: setting(settings, "steps")?,
        precision: precision(settings)?,
        threads: threads(settings)?,
    })
}

#[cfg(feature = "newton")]
fn newton(settings: &Bound<'_, PyAny>) -> PyResult<Newton> {
    let before = settings.getattr("relax")?;
    Ok(Newton {
        residual: positive(settings, "residual")?,
        relax: if before.is_none() { None } else { Some(relax(&before)?) },
        increments: setting(settings, "increments")?,
        perturbation: share(settings, "perturbation")?,
        max_factorisations: setting(settings, "max_factorisations")?,
        max_steps: setting::<Option<u64>>(settings, "max_steps")?.unwrap_or(u64::MAX),
    })
}

fn precision(settings: &Bound<'_, PyAny>) -> PyResult<Precision> {
    match setting::<String>(settings, "precision")?.as_str() {
        "f64" => Ok(Precision::F64),
        "mixed" => Ok(Precision::Mixed),
        other => Err(refused("precision", other, "`f64` or `mixed`")),
    }
}

fn threads(settings: &Bound<'_, PyAny>) -> PyResult<Option<NonZeroUsize>> {
    let threads: Option<usize> = setting(settings, "threads")?;
    threads.map(|n| NonZeroUsize::new(n).ok_or_else(|| refused("threads", "0", "at least 1, or None"))).transpose()
}

fn positive(settings: &Bound<'_, PyAny>, name: &'static str) -> PyResult<f64> {
    checked(settings, name, |x| x > 0.0, "a finite number greater than 0")
}

fn at_least_zero(settings: &Bound<'_, PyAny>, name: &'static str) -> PyResult<f64> {
    checked(settings, name, |x| x >= 0.0, "a finite number of at least 0")
}

fn share(settings: &Bound<'_, PyAny>, name: &'static str) -> PyResult<f64> {
    checked(settings, name, |x| (0.0..=1.0).contains(&x), "a number from 0 to 1")
}

fn checked(
    settings: &Bound<'_, PyAny>,
    name: &'static str,
    holds: impl Fn(f64) -> bool,
    expected: &str,
) -> PyResult<f64> {
    let number: f64 = setting(settings, name)?;
    if number.is_finite() && holds(number) { Ok(number) } else { Err(refused(name, &number.to_string(), expected)) }
}

/// A setting of the type that it is to have; `None`, too large or negative ones are named.
fn setting<T: for<'a, 'py> FromPyObject<'a, 'py>>(settings: &Bound<'_, PyAny>, name: &'static str) -> PyResult<T> {
    let value = settings.getattr(name)?;
    value.extract().map_err(|_| refused(name, &value.to_string(), &format!("a value of type {}", kind::<T>())))
}

/// A Rust type as a person calls it.
fn kind<T>() -> &'static str {
    let name = std::any::type_name::<T>();
    match name {
        _ if name.contains("String") => "str",
        _ if name.contains("bool") => "bool",
        _ if name.contains("f64") => "float",
        _ if name.contains("Option") => "int of at least 0, or None",
        _ => "int of at least 0",
    }
}

/// The library's own defaults, by class and setting, which those of the dataclasses are compared with.
#[pyfunction]
pub(crate) fn defaults(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    all.set_item("Material", pythonize::pythonize(py, &Material::default())?)?;
    all.set_item("Relax", pythonize::pythonize(py, &Relax::default())?)?;
    all.set_item("Dynamics", pythonize::pythonize(py, &Dynamics::default())?)?;
    #[cfg(feature = "newton")]
    all.set_item("Newton", pythonize::pythonize(py, &Newton::default())?)?;
    Ok(all)
}
