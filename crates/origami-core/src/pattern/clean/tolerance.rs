//! How near ends and lines must come to be joined: found from the file itself.
//!
//! Distances between what is not yet joined are of two kinds. Near misses are tiny, and mostly a loose end takes part: a
//! crease that stops short of the border, a line that overshoots it, lines with ends of their own that a program wrote
//! with few digits. Distances on purpose are as long as lines are. Where the two kinds lie far apart, the tolerance lies
//! between them; where they do not, nothing is joined but what was off by rounding.

use glam::DVec2;

use super::near::Near;
use crate::csr::Csr;

/// Points and lines nearer than this, in sizes of the pattern, touch. Files with six digits are off by as much.
pub(super) const TOUCH: f64 = 2e-6;
/// A near miss of a loose end, or one of less than the last digit written, is so many times nearer than what is on purpose;
/// other programs join what is nearer than 1/300 of the shortest line.
const LIKELY: f64 = 8.0;
/// Any other near miss is so many times nearer.
const CLEAR: f64 = 100.0;
/// Loose ends farther away than this, in sizes, are loose on purpose.
const FAR: f64 = 5e-3;
/// As [`FAR`] for vertices of two lines and more.
const FIRM: f64 = 1e-4;
/// As [`FAR`] for vertices that already lie on a line.
const HELD: f64 = 2e-5;
/// Coarser digits than this, in sizes, are a grid on purpose.
const COARSE: f64 = 1e-3;
/// Only distances below this share of the shortest line are looked at.
const LOOK: f64 = 0.75;

/// The least distance of what is separate on purpose is above the tolerance, that of near misses below.
pub(super) struct Lines<'a> {
    /// Vertices, of which those that touch are one.
    pub(super) points: &'a [DVec2],
    /// Different lines with a length.
    pub(super) lines: &'a [[u32; 2]],
    /// [`TOUCH`] times the size.
    pub(super) touch: f64,
    /// The last digit written; 0 where that is not known.
    pub(super) digit: f64,
}

/// A vertex and what it comes near to.
#[derive(Clone, Copy)]
struct Miss {
    distance: f64,
    vertex: u32,
    /// The end that it is near to; none for the inside of a line.
    end: Option<u32>,
}

/// How firmly a vertex is part of the drawing.
#[derive(Clone, Copy, PartialEq)]
enum Hold {
    /// The end of one line, on no other.
    Loose,
    /// The end of several lines, on no other.
    Firm,
    /// On a line that does not end there.
    Held,
}

impl Lines<'_> {
    /// The distance within which to join; `touch` where nothing speaks for more.
    pub(super) fn tolerance(&self) -> f64 {
        let length = |ends: &[u32; 2]| self.points[ends[0] as usize].distance(self.points[ends[1] as usize]);
        let shortest = self.lines.iter().map(length).fold(f64::INFINITY, f64::min);
        let size = self.touch / TOUCH;
        let look = (LOOK * shortest).min(LIKELY * FAR * size);
        if look < LIKELY * self.touch {
            return self.touch;
        }
        let mut misses = self.misses(look);
        let holds = self.holds(&misses);
        misses.retain(|miss| miss.distance > self.touch);
        misses.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let digit = if self.digit <= COARSE * size { 2f64.sqrt() * self.digit } else { 0.0 };
        let (mut ratio, mut tolerance) = (LIKELY, self.touch);
        for (index, miss) in misses.iter().enumerate() {
            let hold = |vertex: u32| holds[vertex as usize];
            let pair = [Some(hold(miss.vertex)), miss.end.map(hold)];
            let has = |kind: Hold| pair.contains(&Some(kind));
            let (least, limit) = if has(Hold::Loose) {
                (LIKELY, FAR * size)
            } else if miss.distance <= digit {
                (LIKELY, f64::INFINITY)
            } else if has(Hold::Held) {
                (CLEAR, HELD * size)
            } else {
                (CLEAR, FIRM * size)
            };
            if miss.distance > limit {
                break;
            }
            ratio = f64::max(ratio, least);
            let next = misses.get(index + 1).map_or(look, |next| next.distance);
            if next >= ratio * miss.distance {
                tolerance = (miss.distance * next).sqrt().min(LIKELY * miss.distance);
            }
        }
        tolerance
    }

    /// All pairs of a vertex and a line, or an end of it, that lie nearer to each other than `look`.
    fn misses(&self, look: f64) -> Vec<Miss> {
        let near = Near::new(self.points, self.lines, look);
        let mut misses = Vec::new();
        for line in 0..self.lines.len() {
            near.apart(line, |other| {
                // Both see each other: each looks for its own ends only.
                self.ends_at(line, other, look, &mut misses);
            });
            near.beside(line, |other| self.ends_at(line, other, look, &mut misses));
        }
        misses
    }

    fn ends_at(&self, line: usize, other: usize, look: f64, misses: &mut Vec<Miss>) {
        let ends = self.lines[other];
        let [a, b] = ends.map(|v| self.points[v as usize]);
        for vertex in self.lines[line] {
            if ends.contains(&vertex) {
                continue;
            }
            let point = self.points[vertex as usize];
            let at = (point - a).dot(b - a) / a.distance_squared(b);
            let distance = (a + at * (b - a)).distance(point);
            if at > 0.0 && at < 1.0 && distance <= look {
                misses.push(Miss { distance, vertex, end: None });
            }
            for (end, place) in ends.into_iter().zip([a, b]) {
                let distance = place.distance(point);
                if distance <= look {
                    misses.push(Miss { distance, vertex, end: Some(end) });
                }
            }
        }
    }

    fn holds(&self, misses: &[Miss]) -> Vec<Hold> {
        let ends = self.lines.iter().flat_map(|ends| ends.map(|v| (v as usize, ())));
        let degree = Csr::from_entries(self.points.len(), ends);
        let hold = |vertex| if degree.row(vertex).len() == 1 { Hold::Loose } else { Hold::Firm };
        let mut holds: Vec<Hold> = (0..self.points.len()).map(hold).collect();
        for miss in misses.iter().filter(|miss| miss.end.is_none() && miss.distance <= self.touch) {
            holds[miss.vertex as usize] = Hold::Held;
        }
        holds
    }
}

/// The last decimal digit with which these numbers were written: 0.01 where all of them have two decimals at most, 0 where
/// they have more than nine.
pub(super) fn last_digit(numbers: impl Iterator<Item = f64> + Clone) -> f64 {
    // Exact: of all doubles, the quotient of two whole ones is the nearest to the decimal.
    let fits = |power: f64, x: f64| (x * power).abs() < 9e15 && (x * power).round() / power == x;
    let power = (0..=9).map(|digits| 10f64.powi(digits)).find(|&power| numbers.clone().all(|x| fits(power, x)));
    power.map_or(0.0, f64::recip)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tolerance(points: &[[f64; 2]], lines: &[[u32; 2]]) -> f64 {
        let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
        let digit = last_digit(points.iter().flat_map(|p| [p.x, p.y]));
        Lines { points: &points, lines, touch: TOUCH, digit }.tolerance()
    }

    const FRAME: [[u32; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];
    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    #[test]
    fn lies_between_near_misses_and_what_is_on_purpose() {
        let with =
            |more: &[[f64; 2]], lines: &[[u32; 2]]| tolerance(&[&SQUARE, more].concat(), &[&FRAME, lines].concat());
        let (third, root) = (1.0 / 3.0, 0.5f64.sqrt());
        assert_eq!(with(&[], &[]), TOUCH);
        // A crease short of the border by a little, by more, and by so much that it is meant to be.
        for (gap, joined) in [(1e-5, true), (1e-4, true), (4e-3, true), (2e-2, false)] {
            let t = with(&[[third, 0.0], [root, 1.0 - gap]], &[[4, 5]]);
            assert_eq!(t > gap, joined, "{gap}: {t}");
            assert!(t < 0.1);
        }
        // Two creases side by side, both on the border, are no near miss, whatever their distance.
        for apart in [1e-4, 1e-3] {
            let t = with(&[[third, 0.0], [root, 1.0], [third + apart, 0.0], [root + apart, 1.0]], &[[4, 5], [6, 7]]);
            assert!(t < apart, "{apart}: {t}");
        }
        // Nor are short lines.
        let t = with(&[[third, third], [third + 1e-4, third], [root, root]], &[[4, 5], [5, 6]]);
        assert!(t < 1e-4);
    }

    #[test]
    fn digits() {
        let of = |numbers: &[f64]| last_digit(numbers.iter().copied());
        assert_eq!(of(&[0.0, 12.0, -3.0]), 1.0);
        assert_eq!(of(&[0.25, 1e3]), 0.01);
        assert_eq!(of(&[0.1 + 0.2]), 0.0);
        assert_eq!(of(&[123.456789]), 1e-6);
    }
}
