//! Files that are compressed by gzip, of any format.

use std::io::Read;

use flate2::read::MultiGzDecoder;
use origami_core::error::{Error, ErrorCode, Place};

/// How a gzip file begins.
const MAGIC: [u8; 2] = [0x1f, 0x8b];

/// Whether these are the bytes of a gzip file.
pub(crate) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&MAGIC)
}

/// What is compressed in `bytes`, all parts of it, up to `most` bytes.
///
/// # Errors
/// That it is damaged, and that there is more: a small file can hold any amount.
pub(crate) fn unpacked(bytes: &[u8], most: u64) -> Result<Vec<u8>, Error> {
    let mut unpacked = Vec::new();
    let place = || Place::key("gzip");
    let read = MultiGzDecoder::new(bytes).take(most.saturating_add(1)).read_to_end(&mut unpacked);
    if unpacked.len() as u64 > most {
        let problem = format!("more than {most} bytes come out");
        return Err(Error::new(ErrorCode::InputTooLarge, place(), problem, "a crease pattern"));
    }
    match read {
        Ok(_) => Ok(unpacked),
        Err(error) => {
            let problem = format!("is damaged or cut off after {} bytes: {error}", unpacked.len());
            Err(Error::new(ErrorCode::Damaged, place(), problem, "a whole file"))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use flate2::Compression;
    use flate2::write::GzEncoder;

    use super::*;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn all_parts_come_out() {
        let two = [packed(b"abc"), packed(b"def")].concat();
        assert!(is_gzip(&two));
        assert_eq!(unpacked(&two, 6).expect("gzip"), b"abcdef");
    }

    #[test]
    fn bombs_and_damage_are_refused() {
        let bomb = packed(&vec![b' '; 10_000_000]);
        assert!(bomb.len() < 20_000, "it is small");
        assert_eq!(unpacked(&bomb, 1_000_000).expect_err("a bomb").code(), ErrorCode::InputTooLarge);
        let whole = packed(b"a crease pattern, somewhat longer");
        for length in 2..whole.len() {
            assert_eq!(unpacked(&whole[..length], 1000).expect_err("cut off").code(), ErrorCode::Damaged, "{length}");
        }
    }
}
