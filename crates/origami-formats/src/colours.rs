//! Colours that stand for letters: the field's six, those near them, and a table of one's own.

use std::fmt;
use std::str::FromStr;

use origami_core::error::Error;
use svgtypes::Color;

/// What a line can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Letter {
    Boundary,
    Mountain,
    Valley,
    Cut,
    Flat,
    Unassigned,
}

impl Letter {
    /// FOLD's.
    pub(crate) fn letter(self) -> &'static str {
        match self {
            Self::Boundary => "B",
            Self::Mountain => "M",
            Self::Valley => "V",
            Self::Cut => "C",
            Self::Flat => "F",
            Self::Unassigned => "U",
        }
    }

    pub(crate) fn meaning(self) -> &'static str {
        match self {
            Self::Boundary => "a border",
            Self::Mountain => "a mountain",
            Self::Valley => "a valley",
            Self::Cut => "a cut",
            Self::Flat => "a flat line",
            Self::Unassigned => "a free line",
        }
    }

    fn of(text: &str) -> Option<Self> {
        [Self::Boundary, Self::Mountain, Self::Valley, Self::Cut, Self::Flat, Self::Unassigned]
            .into_iter()
            .find(|letter| letter.letter().eq_ignore_ascii_case(text))
    }
}

/// The six colours, by hue in degrees, and what they stand for.
const HUES: [(f64, &str, Letter); 6] = [
    (0.0, "red", Letter::Mountain),
    (60.0, "yellow", Letter::Flat),
    (120.0, "green", Letter::Cut),
    (240.0, "blue", Letter::Valley),
    (300.0, "magenta", Letter::Unassigned),
    (360.0, "red", Letter::Mountain),
];
/// Hues that are farther than this from all of them stand for nothing: those around cyan.
const NEAR: f64 = 30.0;
/// Colours with less than this between their channels, as a share of the greatest, are grey.
const GREY: f64 = 0.35;
/// Colours without a channel above this are black.
const DARK: u8 = 0x40;

/// Which colours stand for which letters. What the table does not name follows the field's rule: black (and nearly black) is
/// the border, red mountains, blue valleys, green cuts, yellow flat lines, magenta lines that nothing drives; other hues
/// go with the nearest of the six within 30 degrees. Greys and cyan stand for nothing.
///
/// Parsed from a list such as `#e3170d=M,rgb(0,0,255)=V,grey=none`: CSS colours, letters of FOLD, and `none` for what is
/// left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Colours {
    table: Vec<([u8; 3], Option<Letter>)>,
}

impl Colours {
    /// The letter of a colour, `Some(None)` where the table says that it is left out. If it is only near one of the six, that
    /// one's name. `None`: it stands for nothing.
    pub(crate) fn letter(&self, colour: [u8; 3]) -> Option<(Option<Letter>, Option<&'static str>)> {
        if let Some((_, letter)) = self.table.iter().find(|(own, _)| *own == colour) {
            return Some((*letter, None));
        }
        let [red, green, blue] = colour.map(f64::from);
        let (most, least) = (red.max(green).max(blue), red.min(green).min(blue));
        if colour.iter().all(|channel| *channel <= DARK) && most - least <= 0.5 * f64::from(DARK) {
            return Some((Some(Letter::Boundary), (most > 0.0).then_some("black")));
        }
        if most - least < GREY * most {
            return None;
        }
        let part = |a: f64, b: f64, from: f64| from + 60.0 * (a - b) / (most - least);
        let hue = if most == red {
            part(green, blue, 0.0).rem_euclid(360.0)
        } else if most == green {
            part(blue, red, 120.0)
        } else {
            part(red, green, 240.0)
        };
        let (_, name, letter) = HUES.into_iter().find(|(own, ..)| (hue - own).abs() < NEAR)?;
        // The six themselves have channels of nothing and all.
        let pure = colour.iter().all(|channel| matches!(channel, 0 | 255));
        Some((Some(letter), (!pure).then_some(name)))
    }

    /// Whether the table has this colour.
    pub(crate) fn names(&self, colour: [u8; 3]) -> bool {
        self.table.iter().any(|(own, _)| *own == colour)
    }
}

/// A colour as it is written, such as `#ed1c24`.
pub(crate) fn name_of([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

impl FromStr for Colours {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let wrong = |entry: &str| {
            let expected = "a list such as #e3170d=M,blue=V,grey=none: a CSS colour, and B, M, V, C, F, U or none";
            Error::invalid("colours", format!("cannot be read: {entry:?}"), expected)
        };
        let mut table = Vec::new();
        for entry in entries(text).filter(|entry| !entry.is_empty()) {
            let (colour, letter) = entry.split_once('=').ok_or_else(|| wrong(entry))?;
            let colour: Color = colour.trim().parse().map_err(|_| wrong(entry))?;
            let letter = match letter.trim() {
                "none" => None,
                letter => Some(Letter::of(letter).ok_or_else(|| wrong(entry))?),
            };
            table.push(([colour.red, colour.green, colour.blue], letter));
        }
        Ok(Self { table })
    }
}

/// The parts between commas that are not in parentheses.
fn entries(text: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_usize;
    text.split(move |c| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && matches!(c, ',' | ';')
    })
    .map(str::trim)
}

impl fmt::Display for Colours {
    /// As it is parsed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (colour, letter)) in self.table.iter().enumerate() {
            let letter = letter.map_or("none", Letter::letter);
            write!(f, "{}{}={letter}", if index == 0 { "" } else { "," }, name_of(*colour))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn letter(colours: &Colours, colour: &str) -> Option<&'static str> {
        let Color { red, green, blue, .. } = colour.parse().unwrap();
        colours.letter([red, green, blue]).map(|(letter, _)| letter.map_or("none", Letter::letter))
    }

    #[test]
    fn the_six_and_what_programs_write_in_their_place() {
        let rule = Colours::default();
        // Pure ones; then the red, green, blue, yellow and magenta of printing inks as a drawing program converts them.
        for (colour, expected) in [
            ("black", Some("B")),
            ("red", Some("M")),
            ("blue", Some("V")),
            ("lime", Some("C")),
            ("yellow", Some("F")),
            ("magenta", Some("U")),
            ("#231f20", Some("B")),
            ("#ed1c24", Some("M")),
            ("#00a651", Some("C")),
            ("#2e3192", Some("V")),
            ("#fff200", Some("F")),
            ("#ec008c", Some("U")),
            ("navy", Some("V")),
            ("green", Some("C")),
            ("maroon", Some("M")),
            ("cyan", None),
            ("grey", None),
            ("white", None),
            ("#777788", None),
        ] {
            assert_eq!(letter(&rule, colour), expected, "{colour}");
        }
    }

    #[test]
    fn what_is_only_near_says_so() {
        let rule = Colours::default();
        assert_eq!(rule.letter([255, 0, 0]).unwrap().1, None);
        assert_eq!(rule.letter([237, 28, 36]).unwrap().1, Some("red"));
        assert_eq!(rule.letter([0, 0, 0]).unwrap().1, None);
        assert_eq!(rule.letter([0x23, 0x1f, 0x20]).unwrap().1, Some("black"));
    }

    #[test]
    fn a_table_comes_first_and_is_written_as_it_is_read() {
        let table: Colours = " #f00 = v, rgb(1, 2, 3)=C ; gray=none".parse().unwrap();
        assert_eq!(table.to_string(), "#ff0000=V,#010203=C,#808080=none");
        assert_eq!(table, table.to_string().parse().unwrap());
        assert_eq!(letter(&table, "red"), Some("V"));
        assert_eq!(letter(&table, "#010203"), Some("C"));
        assert_eq!(letter(&table, "grey"), Some("none"));
        assert_eq!(letter(&table, "blue"), Some("V"), "the rule for the rest");
        for wrong in ["red", "red=X", "rod=M", "=M", "red=M=V", "rgb(1,2=M"] {
            let message = wrong.parse::<Colours>().unwrap_err().to_string();
            assert!(message.starts_with("colours: cannot be read: "), "{message}");
        }
    }
}
