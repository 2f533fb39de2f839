//! Why there is no motion.

use super::super::Failed;
use crate::contact::Crossings;
use crate::layers::NoOrder;
use crate::scene::Refusal;

/// Why there is no motion.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NotBackwards {
    /// A solver has no result; of the flat-folded state too.
    #[error(transparent)]
    Failed(#[from] Failed),
    /// The layers of the flat-folded state have no order.
    #[error("{}", match .0 {
        NoOrder::Contradiction => "no order of the layers lets the sheet lie flat without paper going through paper",
        _ => "no order of the layers was found in the time that it may take",
    })]
    Order(NoOrder),
    /// It was broken off.
    #[error("stopped before a motion was found")]
    Stopped,
    /// The flat-folded state could not be embedded.
    #[error("the flat state could not be embedded: {} left, {}", count(.crossings), faces(.crossings))]
    Embedded {
        /// Those of the best attempt.
        crossings: Crossings,
    },
    /// It was embedded, and the sheet did not open from there.
    #[error(
        "the layers of the flat state were moved apart, but then the sheet was caught on itself before it lay open: a crease stayed \
         {:.1} degrees from its angle in the open sheet, expected less than 0.1", .off.to_degrees()
    )]
    Closed {
        /// The farthest that a crease is from its angle in the open sheet, in radians.
        off: f64,
    },
}

fn count(crossings: &Crossings) -> String {
    match crossings.all.len() {
        1 => "1 crossing".to_owned(),
        n => format!("{n} crossings"),
    }
}

fn faces(crossings: &Crossings) -> String {
    const NAMED: usize = 3;
    let named: Vec<String> = crossings.faces.iter().take(NAMED).map(|[a, b]| format!("{} and {}", a.0, b.0)).collect();
    let more = crossings.faces.len().saturating_sub(NAMED);
    let more = if more > 0 { format!(" and {more} more pairs") } else { String::new() };
    format!("faces {}{more}", named.join(", "))
}

/// Whether layers are no longer apart, which another attempt may mend.
pub(super) fn is_crossed(refusal: &Refusal) -> bool {
    matches!(refusal, Refusal::Crossed { .. } | Refusal::Closed { .. })
}

/// Which of two attempts came farther.
pub(super) fn nearer(before: Option<NotBackwards>, now: NotBackwards) -> NotBackwards {
    match (before, now) {
        (Some(NotBackwards::Closed { off }), NotBackwards::Closed { off: own }) => {
            NotBackwards::Closed { off: off.min(own) }
        }
        (Some(closed @ NotBackwards::Closed { .. }), _) => closed,
        (Some(NotBackwards::Embedded { crossings }), NotBackwards::Embedded { crossings: own })
            if crossings.all.len() < own.all.len() =>
        {
            NotBackwards::Embedded { crossings }
        }
        (Some(before), NotBackwards::Failed(_)) => before,
        (_, now) => now,
    }
}
