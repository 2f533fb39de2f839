//! From bytes to text: UTF-8, UTF-16 with its mark, and Latin-1 where the file declares it.

use std::borrow::Cow;

use origami_core::error::{Error, ErrorCode, Place};

/// The text of an XML file, without a byte-order mark.
pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, Error> {
    let wide = |of: fn([u8; 2]) -> u16| {
        let units = bytes[2..].chunks_exact(2).map(|pair| of([pair[0], pair[1]]));
        char::decode_utf16(units).collect::<Result<String, _>>().map(Cow::Owned).ok()
    };
    let text = match bytes {
        [0xFF, 0xFE, ..] => wide(u16::from_le_bytes),
        [0xFE, 0xFF, ..] => wide(u16::from_be_bytes),
        _ => str::from_utf8(bytes).ok().map(Cow::Borrowed).or_else(|| latin(bytes)),
    };
    let text = text.ok_or_else(|| {
        let place = Place::Line { line: 1, column: None };
        Error::new(ErrorCode::NotUtf8, place, "is not text in its encoding", "XML in UTF-8, UTF-16 or declared Latin-1")
    })?;
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => Cow::Owned(rest.to_owned()),
        None => text,
    })
}

/// Latin-1, if the declaration in the first line says so.
fn latin(bytes: &[u8]) -> Option<Cow<'_, str>> {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]).to_ascii_lowercase();
    let declared = head.split("?>").next().is_some_and(|declaration| {
        declaration.starts_with("<?xml")
            && ["iso-8859-1", "latin1", "windows-1252"].iter().any(|e| declaration.contains(e))
    });
    declared.then(|| Cow::Owned(bytes.iter().copied().map(char::from).collect()))
}
