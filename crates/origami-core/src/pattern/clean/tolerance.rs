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
/// A near miss is so many times nearer than the next distance on purpose. Other programs join what is nearer than 1/300 of
/// the shortest line, or than a length of their own.
const LIKELY: f64 = 5.0;
/// And so many times nearer than the next of a loose end, of which it is not clear what it is.
const UNCLEAR: f64 = 1.5;
/// Loose ends farther away than this, in sizes, are loose on purpose.
const LOOSE: f64 = 5e-3;
/// Vertices farther from the inside of a line than this are so on purpose: pleats are not as narrow.
const BESIDE: f64 = 1e-3;
/// As [`BESIDE`] for two vertices of several lines.
const FIRM: f64 = 1e-4;
/// As [`FIRM`] where both already lie on lines: side by side on a border, say.
const HELD: f64 = 5e-5;
/// Where other misses are evident, any that is not longer than so many of them is one too.
const ALIKE: f64 = 3.0;
/// The tolerance is at most so many times the farthest near miss.
const FARTHER: f64 = 8.0;
/// So many misses for each line, and so many more, are looked at.
const MOST_EACH: usize = 48;
const MOST: usize = 20_000;
/// Where there are more, only those of so many times less.
const LOOK_LESS: f64 = 8.0;
/// All but one in so many lines are longer than near misses.
const SHORT: usize = 50;
/// Coarser digits than this, in sizes, are a grid on purpose.
const COARSE: f64 = 1e-3;
/// Only distances below this share of the shortest line are looked at.
const LOOK: f64 = 0.75;

/// The lines of a pattern, as far as they are joined by rounding alone.
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

/// Two things that are near each other.
#[derive(Clone, Copy)]
struct Miss {
    distance: f64,
    kind: Kind,
}

#[derive(Clone, Copy)]
enum Kind {
    /// A vertex and the inside of a line.
    Beside(u32),
    /// Two vertices.
    Ends(u32, u32),
    /// The ends of one line.
    Line,
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
        let size = self.touch / TOUCH;
        let lengths: Vec<f64> = self.lines.iter().map(|line| self.length(*line)).collect();
        let look = (LOOK * shortest(&lengths)).min(LIKELY * LOOSE * size);
        let Some((look, mut misses)) = self.misses_within(look) else { return self.touch };
        let holds = self.holds(&misses);
        let hold = |vertex: u32| holds[vertex as usize];
        misses.retain(|miss| miss.distance > self.touch);
        let short = lengths.into_iter().filter(|&length| length <= look);
        misses.extend(short.map(|distance| Miss { distance, kind: Kind::Line }));
        misses.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let is_loose = |miss: &Miss| match miss.kind {
            Kind::Beside(vertex) => hold(vertex) == Hold::Loose,
            Kind::Ends(one, two) => [hold(one), hold(two)].contains(&Hold::Loose),
            Kind::Line => false,
        };
        // The next distance on purpose, from each miss on.
        let mut next_firm = vec![look; misses.len() + 1];
        for (index, miss) in misses.iter().enumerate().rev() {
            next_firm[index] = if is_loose(miss) { next_firm[index + 1] } else { miss.distance };
        }
        let digit = if self.digit <= COARSE * size { 2f64.sqrt() * self.digit } else { 0.0 };
        let (mut evident, mut loose, mut tolerance) = (0.0, 0.0, self.touch);
        for (index, miss) in misses.iter().enumerate() {
            let limit = match miss.kind {
                _ if is_loose(miss) => LOOSE * size,
                // Short lines are drawn on purpose, but where ends miss each other by as much.
                Kind::Line => ALIKE * loose,
                Kind::Beside(_) => f64::max(BESIDE * size, ALIKE * evident).max(digit),
                Kind::Ends(one, two) => {
                    let limit = if [hold(one), hold(two)] == [Hold::Held; 2] { HELD } else { FIRM };
                    f64::max(limit * size, ALIKE * evident).max(digit)
                }
            };
            if miss.distance > limit {
                break;
            }
            if is_loose(miss) {
                (evident, loose) = (miss.distance, miss.distance);
            } else if matches!(miss.kind, Kind::Beside(vertex) if hold(vertex) == Hold::Firm) {
                evident = miss.distance;
            }
            let next = misses.get(index + 1).map_or(look, |next| next.distance);
            if next >= UNCLEAR * miss.distance && next_firm[index + 1] >= LIKELY * miss.distance {
                tolerance = (miss.distance * next).sqrt().min(FARTHER * miss.distance);
            }
        }
        tolerance
    }

    fn length(&self, line: [u32; 2]) -> f64 {
        let [a, b] = line.map(|v| self.points[v as usize]);
        a.distance(b)
    }

    /// All misses shorter than `look`, or than less where there are too many of those; `None` where that leaves nothing to
    /// look for.
    fn misses_within(&self, mut look: f64) -> Option<(f64, Vec<Miss>)> {
        while look >= LIKELY * self.touch {
            if let Some(misses) = self.misses(look) {
                return Some((look, misses));
            }
            look /= LOOK_LESS;
        }
        None
    }

    /// All pairs of a vertex and a line, or an end of it, that lie nearer to each other than `look`; `None` where there
    /// are too many for misses, as in a sheet of narrow pleats.
    fn misses(&self, look: f64) -> Option<Vec<Miss>> {
        let near = Near::new(self.points, self.lines, look);
        let most = MOST_EACH * self.lines.len() + MOST;
        let mut misses = Vec::new();
        for line in near.order() {
            // Both see each other: each looks for its own ends only.
            near.apart(line, |other| self.ends_at(line, other, look, &mut misses));
            near.beside(line, |other| self.ends_at(line, other, look, &mut misses));
            if misses.len() > most {
                return None;
            }
        }
        Some(misses)
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
                misses.push(Miss { distance, kind: Kind::Beside(vertex) });
            }
            for (end, place) in ends.into_iter().zip([a, b]) {
                let distance = place.distance(point);
                if distance <= look {
                    misses.push(Miss { distance, kind: Kind::Ends(vertex, end) });
                }
            }
        }
    }

    fn holds(&self, misses: &[Miss]) -> Vec<Hold> {
        let ends = self.lines.iter().flat_map(|ends| ends.map(|v| (v as usize, ())));
        let degree = Csr::from_entries(self.points.len(), ends);
        let hold = |vertex| if degree.row(vertex).len() == 1 { Hold::Loose } else { Hold::Firm };
        let mut holds: Vec<Hold> = (0..self.points.len()).map(hold).collect();
        for miss in misses.iter().filter(|miss| miss.distance <= self.touch) {
            if let Kind::Beside(vertex) = miss.kind {
                holds[vertex as usize] = Hold::Held;
            }
        }
        holds
    }
}

/// The length of the shortest lines, a few left out that may be near misses themselves.
fn shortest(lengths: &[f64]) -> f64 {
    let mut lengths = lengths.to_vec();
    let few = lengths.len() / SHORT;
    if few >= lengths.len() {
        return f64::INFINITY;
    }
    let (_, shortest, _) = lengths.select_nth_unstable_by(few, f64::total_cmp);
    *shortest
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
            assert!(t < 0.1 && (t > gap) == joined, "{gap}: {t}");
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
