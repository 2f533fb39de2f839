//! How [`super::Dynamics`] steps through time.

/// How [`super::Dynamics`] steps through time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Integrator {
    /// `v += dt a(x, v)`, then `x += dt v`: what the paper calls explicit Euler is the semi-implicit one. First order.
    Euler,
    /// Velocity Verlet, with the damping at a velocity extrapolated to the same instant. Second order.
    Verlet,
}
