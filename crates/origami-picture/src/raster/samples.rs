//! Where in a pixel it is looked: the standard patterns of multisampling hardware, so that pictures compare.

use origami_core::Error;

/// Offsets from the pixel's upper left corner.
pub(super) type Pattern = &'static [[f64; 2]];

/// The pattern of so many samples.
pub(super) fn pattern(samples: u32) -> Result<Pattern, Error> {
    Ok(match samples {
        1 => &ONE,
        4 => &FOUR,
        8 => &EIGHT,
        16 => &SIXTEEN,
        other => return Err(Error::invalid("samples", other.to_string(), "1, 4, 8 or 16")),
    })
}

const fn sixteenths<const N: usize>(offsets: [[i8; 2]; N]) -> [[f64; 2]; N] {
    let mut pattern = [[0.0; 2]; N];
    let mut i = 0;
    while i < N {
        pattern[i] = [0.5 + offsets[i][0] as f64 / 16.0, 0.5 + offsets[i][1] as f64 / 16.0];
        i += 1;
    }
    pattern
}

static ONE: [[f64; 2]; 1] = sixteenths([[0, 0]]);
static FOUR: [[f64; 2]; 4] = sixteenths([[-2, -6], [6, -2], [-6, 2], [2, 6]]);
static EIGHT: [[f64; 2]; 8] = sixteenths([[1, -3], [-1, 3], [5, 1], [-3, -5], [-5, 5], [-7, -1], [3, 7], [7, -7]]);
static SIXTEEN: [[f64; 2]; 16] = sixteenths([
    [1, 1],
    [-1, -3],
    [-3, 2],
    [4, -1],
    [-5, -2],
    [2, 5],
    [5, 3],
    [3, -5],
    [-2, 6],
    [0, -7],
    [-4, -6],
    [-6, 4],
    [-8, 0],
    [7, -4],
    [6, 7],
    [-7, -8],
]);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_spread_evenly() {
        for count in [1, 4, 8, 16] {
            let pattern = pattern(count).unwrap();
            assert_eq!(pattern.len(), count as usize);
            for axis in 0..2 {
                // One in each row and each column of a grid with as many.
                let mut cells: Vec<usize> = pattern.iter().map(|p| (p[axis] * f64::from(count)) as usize).collect();
                cells.sort_unstable();
                assert_eq!(cells, (0..count as usize).collect::<Vec<_>>());
            }
        }
        assert!(pattern(3).is_err());
    }
}
