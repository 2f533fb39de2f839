//! Letters from what drawings have in their place: names of layers, groups and materials, and colours.

/// FOLD's letter for a name such as `Mountain folds`, `ValleyLine`, `cut` or `B`; `None` for a name that says nothing.
///
/// The words of the name count, whatever stands between them and in lower or upper case. `CutLine` is the border, as in what
/// ORIPA and Oriedita write.
pub(crate) fn of_name(name: &str) -> Option<&'static str> {
    const WORDS: [(&str, &[&str]); 7] = [
        ("M", &["mountain", "mountains", "mtn", "ridge"]),
        ("V", &["valley", "valleys", "vally"]),
        ("B", &["cutline", "border", "borders", "boundary", "boundaries", "contour", "outline", "paper"]),
        ("C", &["cut", "cuts", "slit", "slits"]),
        ("F", &["flat", "facet", "facets", "aux", "auxiliary", "auxiliaryline", "unfolded", "join", "triangulation"]),
        ("U", &["unassigned", "undriven", "free", "hinge", "hinges", "crease", "creases", "score"]),
        ("J", &[]),
    ];
    let words = words(name);
    let whole = name.trim().to_lowercase();
    let is = |word: &str| whole == word || words.iter().any(|own| own == word);
    let by_word = WORDS.iter().find(|(_, known)| known.iter().any(|word| is(word))).map(|(letter, _)| *letter);
    by_word.or_else(|| WORDS.iter().map(|(letter, _)| *letter).find(|letter| whole == letter.to_lowercase()))
}

/// The words of a name: `MountainLine`, `mountain_line` and `MOUNTAIN 1` have the word `mountain`.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut lower = false;
    for c in name.chars() {
        if !c.is_alphabetic() || (lower && c.is_uppercase()) {
            words.push(String::new());
        }
        lower = c.is_lowercase();
        if c.is_alphabetic() {
            words.last_mut().expect("there is one").extend(c.to_lowercase());
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// FOLD's letter for a colour, each part from 0 to 1: by the reference program's rule, black is the border, red a mountain,
/// blue a valley, green a cut, yellow (and cyan, Oriedita's) flat, magenta undriven. `None` for what is nearly white.
pub(crate) fn of_colour([red, green, blue]: [f64; 3]) -> Option<&'static str> {
    let [most, least] = [red.max(green).max(blue), red.min(green).min(blue)];
    let spread = most - least;
    if !spread.is_finite() || spread <= 0.25 * most {
        return (most <= 0.7).then_some("B");
    }
    let sixth = if most == red {
        ((green - blue) / spread).rem_euclid(6.0)
    } else if most == green {
        (blue - red) / spread + 2.0
    } else {
        (red - green) / spread + 4.0
    };
    Some(match 60.0 * sixth {
        hue if hue < 35.0 => "M",
        hue if hue < 75.0 => "F",
        hue if hue < 165.0 => "C",
        hue if hue < 195.0 => "F",
        hue if hue < 265.0 => "V",
        hue if hue < 330.0 => "U",
        _ => "M",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_letters_by_their_words() {
        for (name, letter) in [
            ("MountainLine", Some("M")),
            ("valley_folds.001", Some("V")),
            ("CutLine", Some("B")),
            ("AuxiliaryLine", Some("F")),
            ("CUT", Some("C")),
            ("m", Some("M")),
            ("J", Some("J")),
            ("Paper border", Some("B")),
            ("noname", None),
            ("0", None),
            ("Cutter", None),
            ("", None),
        ] {
            assert_eq!(of_name(name), letter, "{name}");
        }
    }

    #[test]
    fn colours_say_letters_by_their_hue() {
        let hex = |rgb: u32| [16, 8, 0].map(|shift| f64::from(rgb >> shift & 255) / 255.0);
        for (rgb, letter) in [
            (0x000000, Some("B")),
            (0x808080, Some("B")),
            (0xff0000, Some("M")),
            (0xed1c24, Some("M")),
            (0x0000ff, Some("V")),
            (0x2e3192, Some("V")),
            (0x00ff00, Some("C")),
            (0xffff00, Some("F")),
            (0x00ffff, Some("F")),
            (0xff00ff, Some("U")),
            (0xffffff, None),
            (0xe0e0e0, None),
        ] {
            assert_eq!(of_colour(hex(rgb)), letter, "{rgb:06x}");
        }
    }
}
