//! Files that went wrong on their way: bytes turned, numbers replaced, lines swapped, ends cut off.

/// Numbers by xorshift64*: the same seed, the same files.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// From 0 to `end`, without the end; 0 if that is 0.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let drawn = self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11;
        (drawn % (end.max(1) as u64)) as usize
    }
}

/// What has been wrong in files, or may be.
const WORDS: [&str; 36] = [
    "0",
    "-0",
    "1",
    "-1",
    "1e300",
    "-1e308",
    "1e-300",
    "1e999",
    "NaN",
    "inf",
    "0.333333333333333",
    "4294967295",
    "-2147483649",
    "1e6",
    "0.00001",
    "null",
    "true",
    "\"M\"",
    "\"\"",
    "[]",
    "{}",
    "[[",
    "}",
    ",",
    "B",
    "V",
    "transform=\"scale(0)\"",
    "transform=\"matrix(1 0 0 0 0 0)\"",
    "stroke=\"#ff0000\"",
    "d=\"M0 0C1 1 2 2 3e9 3A0 0 0 0 0 1 1Z\"",
    "<g>",
    "</g>",
    "<use href=\"#a\"/>",
    "\n2 0 0 1 1\n",
    "\u{202e}",
    "\u{1b}[31m",
];

/// `bytes` with a change or some: half of all files have one, one in sixteen has five or more. Now and then a part of `other`
/// gets in.
pub(crate) fn mutated(bytes: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    loop {
        mutate(&mut bytes, other, random);
        if random.below(2) == 0 {
            break;
        }
    }
    bytes
}

fn mutate(bytes: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let at = random.below(bytes.len());
    let up_to = 1 << random.below(10);
    let length = 1 + random.below(up_to);
    let end = (at + length).min(bytes.len());
    match random.below(10) {
        0 if !bytes.is_empty() => bytes[at] ^= 1 << random.below(8),
        1 => drop(bytes.drain(at..end)),
        2 => {
            let part = bytes[at..end].to_vec();
            let to = random.below(bytes.len());
            drop(bytes.splice(to..to, part));
        }
        3 => drop(bytes.splice(at..at, WORDS[random.below(WORDS.len())].bytes())),
        4..=6 => replace_number(bytes, at, random),
        7 => swap_lines(bytes, random),
        8 => {
            let from = random.below(other.len());
            let part = &other[from..(from + length).min(other.len())];
            drop(bytes.splice(at..end, part.iter().copied()));
        }
        _ if random.below(8) == 0 => bytes.truncate(at),
        _ => {}
    }
}

/// Replaces the number that follows `at`: by another word, or by one that is nearly the same.
fn replace_number(bytes: &mut Vec<u8>, at: usize, random: &mut Random) {
    let digit = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
    let Some(from) = bytes[at..].iter().position(digit).map(|offset| at + offset) else { return };
    let to = bytes[from..].iter().position(|byte| !digit(byte)).map_or(bytes.len(), |offset| from + offset);
    let written = String::from_utf8_lossy(&bytes[from..to]).parse::<f64>();
    let new = match (written, random.below(3)) {
        (Ok(number), 0 | 1) => {
            let off = [1e-9, 1e-6, 1e-4, 1e-2, -1e-5, 1.0][random.below(6)];
            (number * (1.0 + off)).to_string()
        }
        _ => WORDS[random.below(WORDS.len())].to_owned(),
    };
    drop(bytes.splice(from..to, new.bytes()));
}

fn swap_lines(bytes: &mut Vec<u8>, random: &mut Random) {
    let mut lines: Vec<Vec<u8>> = bytes.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
    let (a, b) = (random.below(lines.len()), random.below(lines.len()));
    lines.swap(a, b);
    *bytes = lines.join(&b'\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seed_gives_the_same_files_and_another_gives_others() {
        let file = b"1 0 0 1 0\n2 0 0 1 1\n";
        let all = |seed| {
            let mut random = Random::new(seed);
            (0..50).map(|_| mutated(file, b"<svg/>", &mut random)).collect::<Vec<_>>()
        };
        assert_eq!(all(1), all(1));
        assert_ne!(all(1), all(2));
        assert!(all(1).iter().filter(|bytes| *bytes != file).count() > 40);
    }
}
