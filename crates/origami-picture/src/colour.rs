//! Colours as people write them (sRGB) and as light adds up (linear).

use std::fmt;
use std::str::FromStr;

use origami_core::Error;

/// A colour in sRGB, 8 bits a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rgb(pub u8, pub u8, pub u8);

impl Rgb {
    /// White.
    pub const WHITE: Self = Self(255, 255, 255);
    /// Black.
    pub const BLACK: Self = Self(0, 0, 0);

    /// Its light by channel, 0 to 1.
    #[must_use]
    pub fn linear(self) -> [f32; 3] {
        [self.0, self.1, self.2].map(|c| to_linear(f32::from(c) / 255.0))
    }

    /// The colour of this much light by channel; what is beyond 0 to 1 is cut off.
    #[must_use]
    pub fn from_linear(light: [f32; 3]) -> Self {
        let [r, g, b] = light.map(|c| (to_srgb(c.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8);
        Self(r, g, b)
    }

    /// Part of the way to another colour, 0 to 1, as seen (not as light).
    #[must_use]
    pub fn towards(self, other: Self, share: f32) -> Self {
        let mix = |a: u8, b: u8| (f32::from(a) + (f32::from(b) - f32::from(a)) * share.clamp(0.0, 1.0) + 0.5) as u8;
        Self(mix(self.0, other.0), mix(self.1, other.1), mix(self.2, other.2))
    }

    /// Whether black can be read on it better than white.
    #[must_use]
    pub fn is_light(self) -> bool {
        let [r, g, b] = self.linear();
        0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18
    }
}

/// As CSS writes it: `#rrggbb`.
impl fmt::Display for Rgb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

/// From `#rrggbb`, `#rgb` (the `#` may be missing), `white` or `black`.
impl FromStr for Rgb {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let wrong = || Error::invalid("colour", format!("{text:?}"), "six hexadecimal digits, such as #c62828");
        match text {
            "white" => return Ok(Self::WHITE),
            "black" => return Ok(Self::BLACK),
            _ => {}
        }
        let digits: Option<Vec<u8>> = { text.strip_prefix('#').unwrap_or(text).chars() }
            .map(|c| c.to_digit(16).and_then(|digit| u8::try_from(digit).ok()))
            .collect();
        match digits.ok_or_else(wrong)?[..] {
            [r, g, b] => Ok(Self(r * 17, g * 17, b * 17)),
            [a, b, c, d, e, f] => Ok(Self(a * 16 + b, c * 16 + d, e * 16 + f)),
            _ => Err(wrong()),
        }
    }
}

/// IEC 61966-2-1, from a channel's value to its light; both 0 to 1.
#[must_use]
pub fn to_linear(value: f32) -> f32 {
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// IEC 61966-2-1, from light to a channel's value; both 0 to 1.
#[must_use]
pub fn to_srgb(light: f32) -> f32 {
    if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_values_survive_the_way_to_light_and_back() {
        for c in 0..=255 {
            let colour = Rgb(c, 255 - c, c / 2);
            assert_eq!(Rgb::from_linear(colour.linear()), colour);
        }
        // Half the light is far more than half the value.
        assert_eq!(Rgb::from_linear([0.5; 3]), Rgb(188, 188, 188));
    }

    #[test]
    fn colours_are_read_as_written() {
        let read = |text: &str| text.parse::<Rgb>();
        assert_eq!(read("#c62828").unwrap(), Rgb(198, 40, 40));
        assert_eq!(read("0af").unwrap(), Rgb(0, 170, 255));
        assert_eq!(Rgb(1, 2, 254).to_string().parse::<Rgb>().unwrap(), Rgb(1, 2, 254));
        for wrong in ["", "#", "#12345", "red-ish", "#ééé", "1234567"] {
            assert!(read(wrong).unwrap_err().to_string().starts_with("colour: "), "{wrong}");
        }
    }
}
