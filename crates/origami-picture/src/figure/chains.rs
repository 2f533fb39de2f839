//! Dashes that run on: lines of one kind that continue each other are measured as one.

use origami_core::glam::DVec3;

use super::Line;

/// Two lines continue each other where the turn is less than this, in cosine: 40 degrees, for curved creases.
const STRAIGHT: f64 = 0.766;

/// Sets [`Line::along`] by lengths at `rest`.
pub(crate) fn measure(lines: &mut [Line], rest: &[DVec3]) {
    let next = partners(lines, rest);
    let mut done = vec![false; lines.len()];
    // Open chains from one of their ends, then closed ones from anywhere.
    for only_ends in [true, false] {
        for start in 0..lines.len() {
            let Some(end) = (0..2).find(|&end| !only_ends || next[start][end].is_none()) else { continue };
            let (mut line, mut end, mut length) = (start, end, 0.0);
            while !std::mem::replace(&mut done[line], true) {
                let [a, b] = lines[line].nodes.map(|n| rest[n as usize]);
                lines[line].along[end] = length as f32;
                length += a.distance(b);
                lines[line].along[1 - end] = length as f32;
                let Some(after) = next[line][1 - end] else { break };
                let joint = lines[line].nodes[1 - end];
                end = usize::from(lines[after].nodes[0] != joint);
                line = after;
            }
        }
    }
}

/// The line that continues each one at each of its ends: the straightest of its kind that has found no better one.
fn partners(lines: &[Line], rest: &[DVec3]) -> Vec<[Option<usize>; 2]> {
    let mut ends: Vec<(u32, u8, usize, usize)> = Vec::with_capacity(2 * lines.len());
    for (i, line) in lines.iter().enumerate() {
        ends.extend((0..2).map(|end| (line.nodes[end], line.kind as u8, i, end)));
    }
    ends.sort_unstable();
    let mut next = vec![[None; 2]; lines.len()];
    for joint in ends.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        // A hub of many lines has no straight ways through it that anyone could follow.
        if joint.len() > 64 {
            continue;
        }
        let away = |&(_, _, line, end): &(u32, u8, usize, usize)| {
            let [from, to] = [end, 1 - end].map(|e| rest[lines[line].nodes[e] as usize]);
            (to - from).normalize_or_zero()
        };
        let mut pairs = Vec::new();
        for (i, a) in joint.iter().enumerate() {
            pairs.extend(joint[..i].iter().map(|b| (-away(a).dot(away(b)), (a.2, a.3), (b.2, b.3))));
        }
        pairs.sort_by(|a, b| b.0.total_cmp(&a.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        for (straight, a, b) in pairs {
            if straight > STRAIGHT && next[a.0][a.1].is_none() && next[b.0][b.1].is_none() {
                next[a.0][a.1] = Some(b.0);
                next[b.0][b.1] = Some(a.0);
            }
        }
    }
    next
}

#[cfg(test)]
mod tests {
    use super::super::LineKind;
    use super::*;

    fn line(a: u32, b: u32) -> Line {
        Line { nodes: [a, b], along: [0.0; 2], kind: LineKind::Valley, triangles: [None; 2] }
    }

    #[test]
    fn a_chain_is_measured_through_its_joints_and_past_a_branch() {
        let rest = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.1], [1.0, 1.0]].map(|[x, y]: [f64; 2]| DVec3::new(x, y, 0.0));
        let mut lines = [line(2, 1), line(0, 1), line(1, 3)];
        measure(&mut lines, &rest);
        let whole = 1.0 + 1.01_f32.sqrt();
        assert!((lines[0].along[1] - lines[1].along[1]).abs() < 1e-6, "they meet at node 1");
        let ends = [lines[0].along[0], lines[1].along[0]];
        assert!((ends[0] - ends[1]).abs() > whole - 1e-5, "{ends:?}");
        assert_eq!(lines[2].along, [0.0, 1.0], "the branch counts by itself");
    }

    #[test]
    fn a_ring_ends_where_it_began() {
        let rest: Vec<DVec3> = (0..12)
            .map(|i| (f64::from(i) * std::f64::consts::TAU / 12.0).sin_cos())
            .map(|(y, x)| DVec3::new(x, y, 0.0))
            .collect();
        let mut lines: Vec<Line> = (0..12).map(|i| line(i, (i + 1) % 12)).collect();
        measure(&mut lines, &rest);
        let length = lines.iter().flat_map(|l| l.along).fold(0.0, f32::max);
        assert!((length - 12.0 * rest[0].distance(rest[1]) as f32).abs() < 1e-5);
    }
}
