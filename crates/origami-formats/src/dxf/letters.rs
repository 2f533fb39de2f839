//! Letters from colours by number.

/// FOLD's letter for an index colour. Reds are mountains and blues valleys, as ORIPA reads them; green is a cut,
/// yellow and cyan (Oriedita's auxiliary lines) are flat, magenta is free, and black, white and greys are the border.
pub(super) fn of_index(colour: i64) -> Option<&'static str> {
    Some(match colour.abs() {
        1 | 10..=39 | 240..=249 => "M",
        5 | 140..=199 => "V",
        3 | 60..=129 => "C",
        2 | 4 | 40..=59 | 130..=139 => "F",
        6 | 200..=239 => "U",
        7..=9 | 250..=255 => "B",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::of_index;

    #[test]
    fn what_oripa_and_oriedita_write_is_understood() {
        // Red, blue, cyan and grey; by layer and by block say nothing.
        let letters = [1, 5, 4, 250, 7, 3, 256, 0].map(of_index);
        let expected = [Some("M"), Some("V"), Some("F"), Some("B"), Some("B"), Some("C"), None, None];
        assert_eq!(letters, expected);
    }
}
