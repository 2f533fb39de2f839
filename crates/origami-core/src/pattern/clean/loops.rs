//! The regions between the lines of a planar graph, traced along half-edges.
//!
//! Half-edge `2 e` runs along edge `e` from its first end to its second, half-edge `2 e + 1` back; each has the region
//! on its left.

use std::cell::Cell;

use glam::DVec2;

use super::boxes::{Bounds, BoxTree};
use super::draft::Draft;
use super::rings::{NONE, Rings};

/// The unbounded region.
pub(super) const OUTSIDE: u32 = 0;

/// The regions of the plane.
#[derive(Debug)]
pub(super) struct Regions {
    /// The closed walks around each region, as half-edges with the region on the left: counterclockwise around it,
    /// then clockwise around each island in it.
    pub(super) loops: Vec<Vec<Vec<u32>>>,
    /// The region on the left of each half-edge; none for aliases.
    pub(super) left_of: Vec<u32>,
}

/// Finds the regions between the live edges of a flat draft, which meet at their ends only.
pub(super) fn regions(draft: &Draft) -> Regions {
    let points: Vec<_> = draft.points.iter().map(|p| p.truncate()).collect();
    let graph = HalfEdges::new(draft, &points);
    let (loops, loop_of) = graph.trace();
    let contours = graph.contours(&points, &loop_of);
    let mut region_of: Vec<u32> = vec![NONE; loops.len()];
    let mut is_contour = vec![false; loops.len()];
    contours.iter().for_each(|contour| is_contour[contour.around as usize] = true);
    let mut count = OUTSIDE;
    for (region, _) in region_of.iter_mut().zip(&is_contour).filter(|(_, contour)| !**contour) {
        count += 1;
        *region = count;
    }
    // From the left to the right: whatever lies to the left of an island is already known.
    if let [single] = contours.as_slice() {
        region_of[single.around as usize] = OUTSIDE;
    } else {
        let tree = BoxTree::new(&graph.bounds);
        for contour in &contours {
            let seen = graph.to_the_left(&points, &tree, contour);
            region_of[contour.around as usize] = seen.map_or(OUTSIDE, |half| region_of[loop_of[half] as usize]);
        }
    }
    let left_of = loop_of.iter().map(|&l| region_of.get(l as usize).copied().unwrap_or(NONE)).collect();
    let mut grouped: Vec<Vec<Vec<u32>>> = vec![Vec::new(); count as usize + 1];
    let (inner, outer): (Vec<_>, Vec<_>) = loops.into_iter().enumerate().partition(|(index, _)| !is_contour[*index]);
    for (index, walk) in inner.into_iter().chain(outer) {
        grouped[region_of[index] as usize].push(walk);
    }
    Regions { loops: grouped, left_of }
}

/// A connected part of the graph.
struct Contour {
    component: u32,
    /// Its leftmost vertex; of several the lowest.
    leftmost: u32,
    /// The loop around it.
    around: u32,
}

struct HalfEdges {
    rings: Rings,
    /// The component of each vertex.
    component: Vec<u32>,
    bounds: Vec<Bounds>,
}

impl HalfEdges {
    fn new(draft: &Draft, points: &[DVec2]) -> Self {
        let live = draft.edges.iter().map(|edge| edge.alias.is_none().then_some(edge.ends));
        let nowhere = Bounds { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };
        let of = |[a, b]: [u32; 2]| Bounds::of(points[a as usize], points[b as usize]);
        let bounds = live.clone().map(|ends| ends.map_or(nowhere, of)).collect();
        let rings = Rings::new(points, live);
        let mut graph = Self { rings, component: Vec::new(), bounds };
        graph.component = graph.components();
        graph
    }

    /// The half-edge that follows around the region on the left: the next one clockwise after turning back.
    fn next(&self, half: u32) -> u32 {
        let back = half ^ 1;
        let around = self.rings.at(self.rings.origin[back as usize] as usize).len();
        self.rings.turned(back, around - 1)
    }

    /// All closed walks, and the walk that each half-edge is on.
    fn trace(&self) -> (Vec<Vec<u32>>, Vec<u32>) {
        let mut loops = Vec::new();
        let mut loop_of = vec![NONE; self.rings.origin.len()];
        for start in 0..self.rings.origin.len() as u32 {
            if self.rings.origin[start as usize] == NONE || loop_of[start as usize] != NONE {
                continue;
            }
            let mut walk = Vec::new();
            let mut half = start;
            while loop_of[half as usize] == NONE {
                loop_of[half as usize] = loops.len() as u32;
                walk.push(half);
                half = self.next(half);
            }
            loops.push(walk);
        }
        (loops, loop_of)
    }

    fn components(&self) -> Vec<u32> {
        let vertices = self.rings.vertices();
        let mut component = vec![NONE; vertices];
        let mut stack = Vec::new();
        for seed in 0..vertices {
            if component[seed] != NONE || self.rings.at(seed).is_empty() {
                continue;
            }
            component[seed] = seed as u32;
            stack.push(seed);
            while let Some(vertex) = stack.pop() {
                for &half in self.rings.at(vertex) {
                    let to = self.rings.origin[(half ^ 1) as usize] as usize;
                    if component[to] == NONE {
                        component[to] = seed as u32;
                        stack.push(to);
                    }
                }
            }
        }
        component
    }

    /// The outer walk of each component, from left to right.
    fn contours(&self, points: &[DVec2], loop_of: &[u32]) -> Vec<Contour> {
        let place = |v: u32| (points[v as usize].x, points[v as usize].y);
        let mut leftmost: Vec<u32> = vec![NONE; points.len()];
        for (vertex, &component) in self.component.iter().enumerate().filter(|(_, component)| **component != NONE) {
            let best = &mut leftmost[component as usize];
            if *best == NONE || place(vertex as u32) < place(*best) {
                *best = vertex as u32;
            }
        }
        let mut contours: Vec<_> = leftmost
            .iter()
            .enumerate()
            .filter_map(|(component, &leftmost)| {
                // All directions there lie in (-pi/2, pi/2]: what is left of the last one is outside.
                let last = self.rings.at((leftmost != NONE).then_some(leftmost)? as usize).last()?;
                Some(Contour { component: component as u32, leftmost, around: loop_of[*last as usize] })
            })
            .collect();
        contours.sort_by(|a, b| points[a.leftmost as usize].x.total_cmp(&points[b.leftmost as usize].x));
        contours
    }

    /// The half-edge of another component that is seen from the leftmost vertex, looking left: its left side is here.
    fn to_the_left(&self, points: &[DVec2], tree: &BoxTree, contour: &Contour) -> Option<usize> {
        let eye = points[contour.leftmost as usize];
        let strip = Bounds { low: DVec2::new(f64::NEG_INFINITY, eye.y), high: eye };
        let mut seen: Option<(f64, f64, usize)> = None;
        // What is seen hides all farther to the left.
        let nearest = Cell::new(f64::NEG_INFINITY);
        tree.visit(
            |bounds| bounds.overlaps(&strip) && bounds.high.x >= nearest.get(),
            |edge| {
                let from = self.rings.origin[2 * edge];
                if from == NONE || self.component[from as usize] == contour.component {
                    return;
                }
                let ends = [from, self.rings.origin[2 * edge + 1]].map(|v| points[v as usize]);
                // Of a line, the lower end counts and the upper one does not: each vertex is passed exactly once.
                let (up, [low, high]) = if ends[0].y <= ends[1].y { (true, ends) } else { (false, [ends[1], ends[0]]) };
                if !(low.y <= eye.y && eye.y < high.y) {
                    return;
                }
                let slope = (high.x - low.x) / (high.y - low.y);
                let x = low.x + (eye.y - low.y) * slope;
                // At one lower end, the line that leans farther to the right is in front.
                if x < eye.x && seen.is_none_or(|(best, lean, _)| (x, slope) > (best, lean)) {
                    // Right of a line upwards is left of the half-edge downwards.
                    seen = Some((x, slope, 2 * edge + usize::from(up)));
                    nearest.set(x);
                }
            },
        );
        seen.map(|(.., half)| half)
    }
}
