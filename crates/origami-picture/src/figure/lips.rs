//! Which edges of the rim are the lips of an opened cut.

use origami_core::glam::DVec3;

/// Edges of the rim (`None`: not on it) that lie where another one lies, exactly: an opened cut has left them.
pub(crate) fn find(on_rim: &[Option<[DVec3; 2]>]) -> Vec<bool> {
    let bits = |ends: [DVec3; 2]| {
        // Adding 0 makes one zero of both.
        let mut ends = ends.map(|p| (p + 0.0).to_array().map(f64::to_bits));
        ends.sort_unstable();
        ends
    };
    let mut ends_by_bits: Vec<_> =
        { on_rim.iter().enumerate() }.filter_map(|(i, ends)| Some((bits((*ends)?), i))).collect();
    ends_by_bits.sort_unstable();
    let mut lips = vec![false; on_rim.len()];
    for pair in ends_by_bits.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        lips[pair[0].1] = true;
        lips[pair[1].1] = true;
    }
    lips
}
