//! What tells one pattern from another.

use std::fmt::{self, Write};

use origami::CreasePattern;

/// Sixteen digits that depend on all that was read of the pattern.
pub(super) fn of(pattern: &CreasePattern) -> String {
    let mut hash = Fnv(0xcbf2_9ce4_8422_2325);
    // Hashing cannot fail.
    let _ = write!(hash, "{pattern:?}");
    format!("{:016x}", hash.0)
}

/// FNV-1a, which is the same on every machine; nobody has a reason to look for another pattern with the same hash.
struct Fnv(u64);

impl Write for Fnv {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_others_and_patterns_differ() {
        // Test vectors of the authors of FNV.
        for (text, hash) in
            [("", 0xcbf2_9ce4_8422_2325_u64), ("a", 0xaf63_dc4c_8601_ec8c), ("foobar", 0x8594_4171_f739_67e8)]
        {
            let mut fnv = Fnv(0xcbf2_9ce4_8422_2325);
            fnv.write_str(text).expect("hashed");
            assert_eq!(fnv.0, hash, "{text}");
        }
        let pattern = |columns| origami::generate::catalog::generate("miura", &[("columns".to_owned(), columns)]);
        let [a, b, again] = [4.0, 5.0, 4.0].map(|columns| of(&pattern(columns).expect("a pattern")));
        assert!(a != b && a == again);
    }
}
