//! The five numbers of the paper's section 3, and one of ours.

use crate::error::Error;

/// Stiffness of the sheet. All numbers hold for a sheet scaled to radius 1 with nodes of mass 1 (see [`super::Normalisation`]).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Material {
    /// Axial rigidity EA of the beams, a force; a beam of rest length l0 has stiffness EA / l0 (paper 2.2).
    /// Higher: less strain, smaller time steps, slower convergence. Default 20. Greater than 0.
    pub ea: f64,
    /// Stiffness of mountain and valley creases (paper 2.3): a moment per radian and per unit of length, that is a force per
    /// radian.
    /// Higher: creases come nearer to their target angles, at the price of strain. Default 0.7. At least 0; 0 leaves them out.
    pub k_fold: f64,
    /// Stiffness of facet creases: a moment per radian and per unit of length, that is a force per radian. Higher: flatter
    /// facets. Default 0.7. At least 0; 0 leaves them out.
    pub k_facet: f64,
    /// Stiffness of the corner angles of triangles (paper 2.4), a moment per radian. Not scaled with length: on fine meshes
    /// (edges under 0.02 of the radius) it overtakes the beams. Higher: less shear. Default 0.2. At least 0; 0 leaves them out.
    pub k_face: f64,
    /// Damping ratio zeta of the beams (paper 2.5); only [`crate::solve::Dynamics`] has damping. Higher: vibration
    /// of single beams dies sooner, slow global motion hardly. Default 0.45. At least 0.
    pub zeta: f64,
    /// How strongly a triangle resists losing the last fifth of its area, as a share of [`Model::stiffest_crease`](super::Model::stiffest_crease);
    /// nothing acts on triangles that have more. The paper has no such springs, and a sheet whose creases cannot have their
    /// angles together may squeeze a triangle to a line, where forces have no rest. Higher: the triangles that it keeps open
    /// keep more of their area. Default 0.03. At least 0; 0 leaves them out.
    pub collapse: f64,
}

impl Default for Material {
    fn default() -> Self {
        Self { ea: 20.0, k_fold: 0.7, k_facet: 0.7, k_face: 0.2, zeta: 0.45, collapse: 0.03 }
    }
}

impl Material {
    /// The paper's: the default without springs against collapse.
    #[must_use]
    pub fn paper() -> Self {
        Self { collapse: 0.0, ..Self::default() }
    }

    /// Whether every number can be simulated.
    ///
    /// # Errors
    /// [`Error::Invalid`] naming the first number that is not finite or out of range.
    pub fn check(&self) -> Result<(), Error> {
        let at_least_zero = [
            ("k_fold", self.k_fold),
            ("k_facet", self.k_facet),
            ("k_face", self.k_face),
            ("zeta", self.zeta),
            ("collapse", self.collapse),
        ];
        if !(self.ea.is_finite() && self.ea > 0.0) {
            return Err(Error::invalid("material ea", self.ea.to_string(), "a number greater than 0"));
        }
        match at_least_zero.iter().find(|(_, x)| !(x.is_finite() && *x >= 0.0)) {
            Some((name, x)) => Err(Error::invalid(format!("material {name}"), x.to_string(), "a number of at least 0")),
            None => Ok(()),
        }
    }
}
