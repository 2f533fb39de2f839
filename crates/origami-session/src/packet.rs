//! How a message travels: a head as JSON, and numbers behind it that JSON would make slow and long.

use std::fmt;

use serde::Serialize;
use serde::de::DeserializeOwned;

/// A head and what belongs to it: the bytes of a file, or numbers of four bytes each, the least significant first.
///
/// As bytes it is the length of the head in four bytes, the head padded with blanks to a multiple of four, and the body: so
/// that the numbers lie where a page can see them without a copy.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Packet {
    /// JSON.
    pub head: String,
    /// What belongs to it.
    pub body: Vec<u8>,
}

/// Why bytes are no [`Packet`], or its head no message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Malformed(String);

impl fmt::Display for Malformed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Malformed {}

impl Packet {
    /// A message with its body.
    pub(crate) fn new(head: &impl Serialize, body: Vec<u8>) -> Self {
        // Types of ours, whose keys are texts: nothing in them can fail to be written.
        Self { head: serde_json::to_string(head).unwrap_or_default(), body }
    }

    /// As bytes.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let padded = self.head.len().next_multiple_of(4);
        let mut bytes = Vec::with_capacity(4 + padded + self.body.len());
        bytes.extend(u32::try_from(padded).unwrap_or(u32::MAX).to_le_bytes());
        bytes.extend(self.head.as_bytes());
        bytes.resize(4 + padded, b' ');
        bytes.extend(&self.body);
        bytes
    }

    /// From bytes.
    ///
    /// # Errors
    /// [`Malformed`] where the length does not fit the bytes, or the head is not text.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Malformed> {
        let short = || Malformed(format!("a packet of {} bytes is shorter than its head says", bytes.len()));
        let (length, rest) = bytes.split_first_chunk::<4>().ok_or_else(short)?;
        let length = usize::try_from(u32::from_le_bytes(*length)).map_err(|_| short())?;
        let (head, body) = rest.split_at_checked(length).ok_or_else(short)?;
        let head = std::str::from_utf8(head).map_err(|_| Malformed("the head of a packet is not UTF-8".to_owned()))?;
        Ok(Self { head: head.to_owned(), body: body.to_vec() })
    }

    /// The message in the head.
    ///
    /// # Errors
    /// [`Malformed`], with what was found and what was expected.
    pub fn message<T: DeserializeOwned>(&self) -> Result<T, Malformed> {
        serde_json::from_str(&self.head).map_err(|error| Malformed(format!("not a message: {error}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_begin_at_a_multiple_of_four() {
        for head in ["{}", "{ }", "{  }", "{   }"] {
            let packet = Packet { head: head.to_owned(), body: vec![1, 2, 3, 4] };
            let bytes = packet.to_bytes();
            assert_eq!((bytes.len() - 4) % 4, 0, "{head}");
            let back = Packet::from_bytes(&bytes).expect("as written");
            assert_eq!((back.head.trim_end(), &back.body), (head, &packet.body));
        }
    }

    #[test]
    fn what_is_cut_off_is_refused() {
        let bytes = Packet { head: "{\"do\":\"undo\"}".to_owned(), body: Vec::new() }.to_bytes();
        for length in 0..bytes.len() {
            assert!(Packet::from_bytes(&bytes[..length]).is_err(), "{length}");
        }
        assert!(Packet::from_bytes(&[255; 8]).is_err());
    }
}
