//! Cuts a cloud of points into compact parts of equal size.

use glam::DVec3;

/// The indices of the points in `count` parts, each in ascending order: again and again halved across their longest extent.
pub(super) fn parts(points: &[DVec3], count: usize) -> Vec<Vec<u32>> {
    let mut parts = Vec::with_capacity(count);
    let mut all: Vec<u32> = (0..).take(points.len()).collect();
    cut(points, &mut all, count.clamp(1, points.len().max(1)), &mut parts);
    parts
}

fn cut(points: &[DVec3], own: &mut [u32], count: usize, parts: &mut Vec<Vec<u32>>) {
    if count < 2 {
        own.sort_unstable();
        parts.push(own.to_vec());
        return;
    }
    let at = |i: &u32| points[*i as usize];
    let (low, high) =
        own.iter().map(at).fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    let extent = (high - low).to_array();
    let longest = (0..3).max_by(|a, b| extent[*a].total_cmp(&extent[*b])).unwrap_or(0);
    let left = count / 2;
    let middle = own.len() * left / count;
    // Equal places are told apart by their index, so that the parts depend on nothing else.
    own.select_nth_unstable_by(middle, |a, b| at(a)[longest].total_cmp(&at(b)[longest]).then(a.cmp(b)));
    let (one, two) = own.split_at_mut(middle);
    cut(points, one, left, parts);
    cut(points, two, count - left, parts);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(columns: u32, rows: u32) -> Vec<DVec3> {
        (0..columns * rows).map(|i| DVec3::new(f64::from(i % columns), f64::from(i / columns), 0.0)).collect()
    }

    #[test]
    fn every_point_is_in_one_part_and_all_are_of_one_size() {
        let points = grid(37, 11);
        for count in [1, 2, 3, 7, 10, 407] {
            let parts = parts(&points, count);
            assert_eq!(parts.len(), count);
            let mut all = parts.concat();
            all.sort_unstable();
            assert!(all.iter().copied().eq(0..407), "{count}");
            let sizes = parts.iter().map(Vec::len);
            assert!(sizes.clone().max() <= sizes.min().map(|least| least + 2), "{count}");
        }
        assert_eq!(parts(&points[..3], 5).len(), 3, "no part is empty");
    }

    #[test]
    fn parts_are_compact() {
        let points = grid(64, 64);
        for part in parts(&points, 64) {
            let places = part.iter().map(|i| points[*i as usize]);
            let (low, high) = places.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
            assert_eq!((high - low).to_array(), [7.0, 7.0, 0.0], "eight by eight");
        }
    }
}
