//! The numbers of the material.

use clap::Args;
use origami::model::Material;

use super::values::{at_least_zero, positive};

/// Options that make a [`Material`].
#[derive(Args, Clone, Copy)]
#[command(next_help_heading = "Material (all numbers hold for a sheet scaled to radius 1)")]
pub(crate) struct MaterialArgs {
    /// Axial rigidity of the paper; higher: less strain, slower
    #[arg(long, value_name = "X", value_parser = positive, default_value_t = Material::default().ea)]
    ea: f64,
    /// Stiffness of mountain and valley creases; higher: nearer to their angles, more strain
    #[arg(long, value_name = "X", value_parser = at_least_zero, default_value_t = Material::default().k_fold)]
    k_fold: f64,
    /// Stiffness of flat creases inside faces; higher: flatter faces
    #[arg(long, value_name = "X", value_parser = at_least_zero, default_value_t = Material::default().k_facet)]
    k_facet: f64,
    /// Stiffness of the corner angles of triangles; higher: less shear
    #[arg(long, value_name = "X", value_parser = at_least_zero, default_value_t = Material::default().k_face)]
    k_face: f64,
    /// Damping ratio, for `--solver dynamics` only [default: 0.45]
    #[arg(long, value_name = "X", value_parser = at_least_zero)]
    pub(crate) zeta: Option<f64>,
    /// How strongly triangles resist losing the last fifth of their area, as a share of the stiffest crease; higher: they keep
    /// more of it; 0: not at all [default: 0.03; 0 for `--solver dynamics`, as in the paper]
    #[arg(long, value_name = "X", value_parser = at_least_zero)]
    collapse: Option<f64>,
}

impl MaterialArgs {
    /// The material asked for; what the arguments leave open is as in `others`.
    pub(crate) fn material(&self, others: Material) -> Material {
        let (zeta, collapse) = (self.zeta.unwrap_or(others.zeta), self.collapse.unwrap_or(others.collapse));
        Material { ea: self.ea, k_fold: self.k_fold, k_facet: self.k_facet, k_face: self.k_face, zeta, collapse }
    }

    /// Its numbers with their options.
    pub(crate) fn named(&self) -> [(&'static str, f64); 6] {
        let Material { ea, k_fold, k_facet, k_face, zeta, collapse } = self.material(Material::default());
        let paper = [("--ea", ea), ("--k-fold", k_fold), ("--k-facet", k_facet), ("--k-face", k_face)];
        let [ea, k_fold, k_facet, k_face] = paper;
        [ea, k_fold, k_facet, k_face, ("--zeta", zeta), ("--collapse", collapse)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_text_tells_the_default_of_zeta() {
        let definition = MaterialArgs::augment_args(clap::Command::new("test"));
        let help = definition.get_arguments().find(|a| a.get_id() == "zeta").and_then(|a| a.get_help());
        let default = format!("[default: {}]", Material::default().zeta);
        assert!(help.expect("zeta has a help text").to_string().ends_with(&default));
    }
}
