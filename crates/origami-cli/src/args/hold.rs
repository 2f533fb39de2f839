//! What keeps its place when results are turned.

use origami::ids::FaceId;
use origami::measure::attitude::Hold;

/// `sheet`, `none` or the number of a face.
pub(super) fn hold(text: &str) -> Result<Hold, String> {
    match text.trim() {
        "sheet" => Ok(Hold::Sheet),
        "none" => Ok(Hold::Nothing),
        face => face.parse().map(|face| Hold::Face(FaceId(face))).map_err(|_| expected()),
    }
}

fn expected() -> String {
    "expected `sheet`, `none` or the number of a face, from 0".to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_numbers_are_read() {
        assert_eq!(hold("sheet"), Ok(Hold::Sheet));
        assert_eq!(hold("none"), Ok(Hold::Nothing));
        assert_eq!(hold("12"), Ok(Hold::Face(FaceId(12))));
        for wrong in ["", "-1", "1.5", "face", "4294967296"] {
            assert_eq!(hold(wrong), Err(expected()), "{wrong}");
        }
    }
}
