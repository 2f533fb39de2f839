//! Letters from what drawings have in their place: names of layers, groups and materials.

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
    // A letter alone, with a number behind it or not.
    let alone = || words.first().filter(|_| words.len() == 1);
    by_word.or_else(|| {
        WORDS
            .iter()
            .map(|(letter, _)| *letter)
            .find(|letter| alone().is_some_and(|word| word.eq_ignore_ascii_case(letter)))
    })
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
            ("V.001", Some("V")),
            ("group b", None),
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
}
