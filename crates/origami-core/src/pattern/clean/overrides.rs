//! Keys of our own: stiffness of single edges, fixed vertices.

use serde_json::Value;

use super::letters::same_length;
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;
use crate::pattern::keys::FIXED;

/// One number of at least `least`, or none, for each edge.
pub(super) fn edge_numbers(
    frame: &Frame,
    key: &'static str,
    edges: usize,
    least: f64,
) -> Result<Vec<Option<f64>>, Error> {
    let Some(value) = frame.extra.get(key) else { return Ok(vec![None; edges]) };
    let entries = array(key, value)?;
    same_length(key, entries.len(), edges)?;
    let number = |(index, entry): (usize, &Value)| match entry {
        Value::Null => Ok(None),
        _ => match entry.as_f64().filter(|number| number.is_finite() && *number >= least) {
            Some(number) => Ok(Some(number)),
            None if least == 0.0 => Err(wrong(key, index, entry, "a number that is not negative, or null")),
            None => Err(wrong(key, index, entry, "a number, or null")),
        },
    };
    entries.iter().enumerate().map(number).collect()
}

/// Whether each vertex is fixed, in every direction: those that are held in some alone are for structural analysis.
pub(super) fn fixed(frame: &Frame, vertices: usize) -> Result<Vec<bool>, Error> {
    let Some(value) = frame.extra.get(FIXED) else { return Ok(vec![false; vertices]) };
    let entries = array(FIXED, value)?;
    if entries.len() != vertices {
        let problem = format!("has {} entries where vertices_coords has {vertices}", entries.len());
        return Err(Error::new(ErrorCode::WrongLength, Place::key(FIXED), problem, "one entry for each vertex"));
    }
    let flag = |(index, entry): (usize, &Value)| match entry {
        Value::Bool(flag) => Ok(*flag),
        Value::Number(number) if number.as_f64() == Some(0.0) => Ok(false),
        Value::Number(number) if number.as_f64() == Some(1.0) => Ok(true),
        Value::String(letters) if letters.chars().all(|letter| "xyz".contains(letter)) => {
            Ok("xyz".chars().all(|axis| letters.contains(axis)))
        }
        Value::Array(axes) if axes.len() == 3 && axes.iter().all(Value::is_boolean) => {
            Ok(axes.iter().all(|held| *held == Value::Bool(true)))
        }
        _ => Err(wrong(FIXED, index, entry, "true or false (or 1 or 0), or axes such as \"xz\"")),
    };
    entries.iter().enumerate().map(flag).collect()
}

fn array<'a>(key: &'static str, value: &'a Value) -> Result<&'a Vec<Value>, Error> {
    value.as_array().ok_or_else(|| Error::new(ErrorCode::WrongType, Place::key(key), "is not an array", "an array"))
}

fn wrong(key: &'static str, index: usize, entry: &Value, expected: &str) -> Error {
    let shown: String = entry.to_string().chars().take(24).collect();
    Error::new(ErrorCode::WrongValue, Place::entry(key, index), format!("is {shown}"), expected)
}
