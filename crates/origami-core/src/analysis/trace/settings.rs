//! How a path is followed, and where it ends.

use crate::analysis::{Dof, Refused, Structure};

/// What grows from one point of a path to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Control {
    /// The length of the path itself: load and displacements may both turn back. The default.
    #[default]
    Arc,
    /// The load factor: the path ends where it turns back.
    Load,
    /// The displacement of one free degree of freedom: the path ends where that turns back.
    Displacement(Dof),
}

/// Where a path ends: exactly there.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Until {
    /// Where the load factor passes this value.
    LoadFactor(f64),
    /// Where the displacement of a free degree of freedom, from where it is drawn, passes this value, in the structure's
    /// unit of length.
    Displacement(Dof, f64),
}

/// How a path is followed.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Path {
    /// What grows. Default [`Control::Arc`].
    pub control: Control,
    /// Where it ends, whichever comes first. Default: where the load factor passes 1.
    pub until: Vec<Until>,
    /// Points after which it ends in any case, those of events included. Default 500.
    pub steps: usize,
    /// Whether it sets out with a falling load factor. Default: a rising one. With [`Control::Displacement`] it sets out
    /// towards the value of `until`, whatever this says.
    pub backwards: bool,
    /// How far the node that moves farthest goes in the first step, in [sizes](Structure::size) of the structure. Larger:
    /// fewer factorisations before the first that fails. Default 0.01.
    pub step: f64,
    /// How far it may go in any step, in sizes. Smaller: more points, and a smaller danger that a step leads to another
    /// branch. Default 0.05.
    pub longest: f64,
    /// How far the last iteration of a point may move a node, in sizes. Smaller: sharper, until rounding ends it. Default
    /// 1e-10.
    pub tolerance: f64,
}

impl Default for Path {
    fn default() -> Self {
        Self {
            control: Control::Arc,
            until: vec![Until::LoadFactor(1.0)],
            steps: 500,
            backwards: false,
            step: 0.01,
            longest: 0.05,
            tolerance: 1e-10,
        }
    }
}

impl Path {
    /// Along the arc, with a number of steps and no other end.
    #[must_use]
    pub fn steps(steps: usize) -> Self {
        Self { until: Vec::new(), steps, ..Self::default() }
    }

    /// The same with one more end.
    #[must_use]
    pub fn until(mut self, until: Until) -> Self {
        self.until.push(until);
        self
    }

    pub(super) fn check(&self, structure: &Structure) -> Result<(), Refused> {
        for (name, x) in [("step", self.step), ("longest", self.longest), ("tolerance", self.tolerance)] {
            if !(x.is_finite() && x > 0.0) {
                return Err(Refused::at(format!("path.{name}"), x.to_string(), "a number above 0"));
            }
        }
        let node = |place: String, dof: &Dof| {
            let free = dof.node.index() < structure.nodes.len() && {
                let mut held = structure.supports.fixed.iter().chain(structure.supports.moved.iter().map(|(d, _)| d));
                held.all(|held| held != dof)
            };
            let problem = format!("node {} along {}", dof.node.0, dof.axis.name());
            if free { Ok(()) } else { Err(Refused::at(place, problem, "a free degree of freedom")) }
        };
        if let Control::Displacement(dof) = &self.control {
            node("path.control".to_owned(), dof)?;
            if !self.until.iter().any(|until| matches!(until, Until::Displacement(own, _) if own == dof)) {
                let expected = "a value of the displacement that is controlled";
                return Err(Refused::at("path.until", format!("{:?}", self.until), expected));
            }
        }
        for (i, until) in self.until.iter().enumerate() {
            let value = match until {
                Until::LoadFactor(value) => value,
                Until::Displacement(dof, value) => {
                    node(format!("path.until[{i}]"), dof)?;
                    value
                }
            };
            if !value.is_finite() {
                return Err(Refused::at(format!("path.until[{i}]"), value.to_string(), "a finite number"));
            }
        }
        Ok(())
    }
}
