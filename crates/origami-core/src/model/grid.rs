//! Materials by the list.

use super::Material;

/// Values of each number of a [`Material`]; every combination of them is a material. Each list has the default alone
/// unless told otherwise.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct MaterialGrid {
    /// Values of [`Material::ea`].
    pub ea: Vec<f64>,
    /// Values of [`Material::k_fold`].
    pub k_fold: Vec<f64>,
    /// Values of [`Material::k_facet`].
    pub k_facet: Vec<f64>,
    /// Values of [`Material::k_face`].
    pub k_face: Vec<f64>,
    /// Values of [`Material::zeta`].
    pub zeta: Vec<f64>,
}

impl Default for MaterialGrid {
    fn default() -> Self {
        let Material { ea, k_fold, k_facet, k_face, zeta, .. } = Material::default();
        let [ea, k_fold, k_facet, k_face, zeta] = [ea, k_fold, k_facet, k_face, zeta].map(|x| vec![x]);
        Self { ea, k_fold, k_facet, k_face, zeta }
    }
}

impl MaterialGrid {
    /// How many combinations there are; `None` where that is more than a `usize` holds.
    #[must_use]
    pub fn count(&self) -> Option<usize> {
        let lists = [&self.ea, &self.k_fold, &self.k_facet, &self.k_face, &self.zeta];
        lists.iter().try_fold(1_usize, |count, list| count.checked_mul(list.len()))
    }

    /// All combinations, in the order of the fields: `ea` varies slowest, `zeta` fastest.
    #[must_use]
    pub fn materials(&self) -> Vec<Material> {
        let each = |materials: Vec<Material>, list: &[f64], set: fn(&mut Material, f64)| -> Vec<Material> {
            let varied = |material: Material| {
                list.iter().map(move |x| {
                    let mut material = material;
                    set(&mut material, *x);
                    material
                })
            };
            materials.into_iter().flat_map(varied).collect()
        };
        let materials = vec![Material::default()];
        let materials = each(materials, &self.ea, |m, x| m.ea = x);
        let materials = each(materials, &self.k_fold, |m, x| m.k_fold = x);
        let materials = each(materials, &self.k_facet, |m, x| m.k_facet = x);
        let materials = each(materials, &self.k_face, |m, x| m.k_face = x);
        each(materials, &self.zeta, |m, x| m.zeta = x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_field_varies_fastest() {
        let grid = MaterialGrid {
            ea: vec![10.0, 20.0],
            k_face: vec![0.0, 0.1, 0.2],
            zeta: vec![0.3, 0.4],
            ..MaterialGrid::default()
        };
        let materials = grid.materials();
        assert_eq!(grid.count(), Some(12));
        let seen: Vec<_> = materials.iter().map(|m| (m.ea, m.k_face, m.zeta)).collect();
        assert_eq!(seen[..4], [(10.0, 0.0, 0.3), (10.0, 0.0, 0.4), (10.0, 0.1, 0.3), (10.0, 0.1, 0.4)]);
        assert!(seen.is_sorted() && seen.len() == 12 && seen.windows(2).all(|pair| pair[0] != pair[1]));
        assert!(materials.iter().all(|m| (m.k_fold, m.k_facet) == (0.7, 0.7)), "what is not varied is the default");
    }

    #[test]
    fn by_itself_it_is_the_default_and_an_empty_list_leaves_none() {
        assert_eq!(MaterialGrid::default().materials(), [Material::default()]);
        let grid = MaterialGrid { k_fold: Vec::new(), ..MaterialGrid::default() };
        assert_eq!((grid.count(), grid.materials()), (Some(0), Vec::new()));
    }

    #[test]
    fn more_than_can_be_counted_is_none() {
        let many = vec![1.0; 1 << 16];
        let grid = MaterialGrid {
            ea: many.clone(),
            k_fold: many.clone(),
            k_facet: many.clone(),
            k_face: many,
            zeta: vec![1.0],
        };
        assert_eq!(grid.count(), None);
    }
}
