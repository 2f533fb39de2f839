//! Colour maps.

use crate::colour::Rgb;

/// A way from numbers between 0 and 1 to colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColourMap {
    /// Even to the eye, in grey too: S. van der Walt and N. Smith's (2015).
    #[default]
    Viridis,
    /// The same to those who confuse colours: J. Nuñez, C. Anderton and R. Renslow's (2018).
    Cividis,
    /// From black over red to yellow, even to the eye.
    Inferno,
    /// From blue over green to red by hue alone, as Origami Simulator has it; not even to the eye.
    Hue,
}

impl ColourMap {
    /// All, in the order of their names.
    pub const ALL: [Self; 4] = [Self::Viridis, Self::Cividis, Self::Inferno, Self::Hue];
    /// What to call them, in the order of [`ColourMap::ALL`].
    pub const NAMES: [&str; 4] = ["viridis", "cividis", "inferno", "hue"];

    /// The map of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let index = Self::NAMES.iter().position(|known| *known == name)?;
        Self::ALL.get(index).copied()
    }

    /// The colour of a share; below 0, above 1 and what is no number take the colours at the ends.
    #[must_use]
    pub fn colour(self, share: f64) -> Rgb {
        let share = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) };
        let gradient = match self {
            Self::Viridis => colorous::VIRIDIS,
            Self::Cividis => colorous::CIVIDIS,
            Self::Inferno => colorous::INFERNO,
            Self::Hue => return hue(240.0 * (1.0 - share)),
        };
        let colour = gradient.eval_continuous(share);
        Rgb(colour.r, colour.g, colour.b)
    }

    /// 256 steps of the map, as linear light: what a renderer looks colours up in.
    #[must_use]
    pub fn table(self) -> Vec<[f32; 3]> {
        (0..256).map(|i| self.colour(f64::from(i) / 255.0).linear()).collect()
    }
}

/// The pure colour of a hue in degrees, 0 to 240 (HSL with full saturation and half lightness).
fn hue(degrees: f64) -> Rgb {
    let channel = |centre: f64| {
        let apart = (degrees - centre).abs();
        let apart = apart.min(360.0 - apart);
        ((2.0 - apart / 60.0).clamp(0.0, 1.0) * 255.0).round() as u8
    };
    Rgb(channel(0.0), channel(120.0), channel(240.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hue_runs_from_blue_over_green_to_red() {
        let at = |share| ColourMap::Hue.colour(share);
        assert_eq!([at(0.0), at(0.5), at(1.0)], [Rgb(0, 0, 255), Rgb(0, 255, 0), Rgb(255, 0, 0)]);
        assert_eq!([at(0.25), at(0.75)], [Rgb(0, 255, 255), Rgb(255, 255, 0)]);
        assert_eq!([at(-3.0), at(f64::NAN), at(7.0)], [at(0.0), at(0.0), at(1.0)]);
    }

    #[test]
    fn even_maps_grow_lighter_all_the_way() {
        let lightness = |[r, g, b]: [f32; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
        for map in [ColourMap::Viridis, ColourMap::Cividis, ColourMap::Inferno] {
            let steps: Vec<f32> = map.table().into_iter().map(lightness).collect();
            assert!(steps.windows(8).all(|w| w[7] > w[0]), "{map:?}");
        }
        let hue: Vec<f32> = ColourMap::Hue.table().into_iter().map(lightness).collect();
        assert!(!hue.windows(8).all(|w| w[7] > w[0]), "the hue map does not");
    }
}
