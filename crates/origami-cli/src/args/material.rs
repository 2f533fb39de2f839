//! The five numbers of the material.

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
}

impl MaterialArgs {
    /// The material asked for.
    pub(crate) fn material(&self) -> Material {
        let zeta = self.zeta.unwrap_or(Material::default().zeta);
        Material { ea: self.ea, k_fold: self.k_fold, k_facet: self.k_facet, k_face: self.k_face, zeta }
    }

    /// Its numbers with their options.
    pub(crate) fn named(&self) -> [(&'static str, f64); 5] {
        let Material { ea, k_fold, k_facet, k_face, zeta } = self.material();
        [("--ea", ea), ("--k-fold", k_fold), ("--k-facet", k_facet), ("--k-face", k_face), ("--zeta", zeta)]
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
