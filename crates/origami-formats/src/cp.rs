//! CP, as Oripa, Orihime, Oriedita and CP Editor write it: a line a crease, `type x1 y1 x2 y2`.

use glam::DVec2;
use origami_core::error::{Error, ErrorCode, Place};
use origami_core::fold::Document;

use crate::lines::Lines;

/// Reads a CP file.
///
/// # Errors
/// [`Error::Invalid`] with the line that is not five numbers or whose type is not 0 to 4.
pub fn read(bytes: &[u8]) -> Result<Document, Error> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = Lines::default();
    for (line, text) in (1..).zip(text.lines()) {
        let place = Place::Line { line, column: None };
        let words: Vec<&str> = text.split_whitespace().collect();
        let numbers: Option<Vec<f64>> = words.iter().map(|word| word.parse().ok()).collect();
        let (Some(&letter), Some(&[_, x1, y1, x2, y2])) = (words.first(), numbers.as_deref()) else {
            if words.is_empty() {
                continue;
            }
            return Err(Error::new(ErrorCode::WrongType, place, "is not a line of CP", "type x1 y1 x2 y2"));
        };
        let letter = match letter {
            "1" => "B",
            "2" => "M",
            "3" => "V",
            _ => "F",
        };
        lines.push([DVec2::new(x1, y1), DVec2::new(x2, y2)], letter, None, format!("line {line}"));
    }
    Ok(lines.into_document())
}
