//! Groups, measured and pushing.

use glam::DVec3;

use super::super::groups::{Group, Places};
use super::super::lanes::{WIDTH, push};
use super::super::soon::Brief;
use super::{All, Task, first_due};

impl Task {
    /// The first groups that may push, as many as lie side by side; what they lose is kept. The result is how many were looked at.
    #[inline(always)]
    pub(super) fn groups(
        &mut self,
        all: &All<'_>,
        (groups, due, places): (&mut [Group], &mut [f64], &[Places]),
    ) -> usize {
        let Self { given, measured, push: pushes, lost, .. } = self;
        let (own, count, seen) = first_due(due, all.bound);
        if count == 0 {
            return seen;
        }
        // How far along its edge the nearest point of the second thing is.
        let mut alongs = [0.0; WIDTH];
        let mut lose = |number: u32| {
            let pair = &all.pairs[number as usize];
            let brief = Brief { nodes: pair.nodes, eased: pair.eased, number, width: 0 };
            lost[usize::from(pair.split == 2)].push(brief, f64::NEG_INFINITY);
        };
        for (i, at) in own[..count].iter().enumerate() {
            let group = &mut groups[*at];
            let stars = group.corners.map(|corner| &all.stars[corner.index()]);
            let arms = group.corners.map(|corner| &all.arms[corner.index()]);
            let (apart, along) = group.apart(all.positions);
            group.look((apart, along), (stars, arms), all.path, (&places[*at], &mut lose));
            alongs[i] = along;
            let distance = apart.length();
            let normal = if distance > 0.0 { apart / distance } else { DVec3::ZERO };
            (measured.normal[0][i], measured.normal[1][i], measured.normal[2][i]) = (normal.x, normal.y, normal.z);
            measured.gap[i] = distance;
            given.width[i] = all.contact.gap;
        }
        push(false, all.contact.stiffness, given, measured, pushes);
        for (i, at) in own[..count].iter().enumerate() {
            let group = &groups[*at];
            let gap = self.measured.gap[i];
            due[*at] = if group.is_empty() { f64::INFINITY } else { gap.min(all.farthest) + all.twice_the_way };
            if gap < all.contact.gap {
                self.pushing += group.count() as usize;
                self.add_group(i, group, alongs[i]);
            }
        }
        seen
    }

    /// Adds what a group does that is at `i` of a block.
    #[inline(always)]
    fn add_group(&mut self, i: usize, group: &Group, along: f64) {
        let count = f64::from(group.count());
        let nodes = [(group.corners[0], 1.0), (group.corners[1], along - 1.0), (group.end, -along)];
        let [one, other, end] = nodes;
        let (all, weights) = ([one.0, other.0, end.0, end.0], [one.1, other.1, end.1, 0.0]);
        let stiffness = self.less_stiff(i, (&all, weights), count * self.push.stiffness[i]);
        let Self { push, felt, .. } = self;
        let [x, y, z] = [0, 1, 2].map(|axis| count * push.force[axis][i]);
        for (node, weight) in nodes {
            let own = &mut felt[node.index()];
            let size = f64::abs(weight) * stiffness;
            *own = [own[0] + weight * x, own[1] + weight * y, own[2] + weight * z, own[3] + size];
        }
    }
}
