//! What a bar and a hinge answer to being stretched and turned. The first derivative of an energy is a force or a moment,
//! the second a stiffness.

mod bar;
mod hinge;

pub use bar::BarLaw;
pub use hinge::HingeLaw;

/// An energy with its derivatives by a length or by an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Energy.
    pub energy: f64,
    /// Its first derivative: the tension of a bar, the moment of a hinge.
    pub slope: f64,
    /// Its second derivative.
    pub curvature: f64,
}
