//! What one task looks at, and how it is shared out.

use super::super::groups::{Group, Places};
use super::super::soon::Brief;

/// Some pairs of one kind, and when each is due.
pub(super) struct Those<'a> {
    pub(super) pairs: &'a [Brief],
    pub(super) due: &'a mut [f64],
    /// How many are before these.
    pub(super) from: usize,
}

impl<'a> Those<'a> {
    fn split(self, share: [usize; 2]) -> [Self; 2] {
        let at = cut(self.pairs.len(), share);
        let ((pairs, others), (due, other_due)) = (self.pairs.split_at(at), self.due.split_at_mut(at));
        [Self { pairs, due, from: self.from }, Self { pairs: others, due: other_due, from: self.from + at }]
    }
}

/// What one task looks at: some pairs of points, some of edges, and some groups.
pub(super) struct Part<'a> {
    pub(super) points: Those<'a>,
    pub(super) edges: Those<'a>,
    pub(super) groups: &'a mut [Group],
    pub(super) group_due: &'a mut [f64],
    pub(super) places: &'a [Places],
}

impl<'a> Part<'a> {
    /// Such a share of it, and the rest.
    pub(super) fn split(self, share: [usize; 2]) -> [Self; 2] {
        let ([points, other_points], [edges, other_edges]) = (self.points.split(share), self.edges.split(share));
        let at = cut(self.groups.len(), share);
        let (groups, other_groups) = self.groups.split_at_mut(at);
        let ((group_due, other_due), (places, other_places)) =
            (self.group_due.split_at_mut(at), self.places.split_at(at));
        [
            Self { points, edges, groups, group_due, places },
            Self {
                points: other_points,
                edges: other_edges,
                groups: other_groups,
                group_due: other_due,
                places: other_places,
            },
        ]
    }
}

/// Where so many things are cut so that the first part is such a share of them.
fn cut(count: usize, [part, all]: [usize; 2]) -> usize {
    count * part / all
}
