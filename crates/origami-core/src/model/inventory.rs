//! What a scene's model holds and what it does without (the reader is told both).

/// A group of elements that was built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Built {
    /// The group, such as `beams`.
    pub what: &'static str,
    /// How many elements it has.
    pub count: usize,
}

/// A group that this scene does not need, or cannot have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// The group, such as `corner angles`.
    pub what: &'static str,
    /// How many elements it would have had; 0 where that is not a number of elements.
    pub count: usize,
    /// Why.
    pub why: &'static str,
}

/// The lists of both.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inventory {
    /// In the order in which forces are summed.
    pub built: Vec<Built>,
    /// In the same order.
    pub left_out: Vec<LeftOut>,
}

impl Inventory {
    pub(crate) fn built(&mut self, what: &'static str, count: usize) {
        if count > 0 {
            self.built.push(Built { what, count });
        }
    }

    pub(crate) fn left_out(&mut self, what: &'static str, count: usize, why: &'static str) {
        if count > 0 {
            self.left_out.push(LeftOut { what, count, why });
        }
    }

    /// Something that has no number of elements while it is not there.
    pub(crate) fn without(&mut self, what: &'static str, why: &'static str) {
        self.left_out.push(LeftOut { what, count: 0, why });
    }
}
