//! What is wrong with a structure, said before any work.

use glam::DVec3;

use super::{Configuration, Dof, Refused, Structure};
use crate::ids::NodeId;

impl Structure {
    /// Whether all members, supports and loads are on nodes that there are, with numbers that mean something.
    ///
    /// # Errors
    /// The first thing that is wrong, by name and index.
    pub fn check(&self) -> Result<(), Refused> {
        if let Some(i) = self.nodes.iter().position(|p| !p.is_finite()) {
            return Err(Refused::at(format!("nodes[{i}]"), self.nodes[i].to_string(), "finite coordinates"));
        }
        for (i, bar) in self.bars.iter().enumerate() {
            self.nodes_exist("bars", i, &bar.nodes)?;
            above_zero(format!("bars[{i}].rest_length"), bar.rest_length)?;
            above_zero(format!("bars[{i}].rigidity"), bar.rigidity)?;
        }
        for (i, hinge) in self.hinges.iter().enumerate() {
            self.nodes_exist("hinges", i, &hinge.nodes)?;
            finite(format!("hinges[{i}].rest_angle"), hinge.rest_angle)?;
            at_least_zero(format!("hinges[{i}].stiffness"), hinge.stiffness)?;
            if let Some((number, expected)) = hinge.law.problem() {
                return Err(Refused::at(format!("hinges[{i}].law"), number, expected));
            }
        }
        for (i, corners) in self.corners.iter().enumerate() {
            self.nodes_exist("corners", i, &corners.angles.nodes)?;
            at_least_zero(format!("corners[{i}].stiffness"), corners.stiffness)?;
        }
        for (i, (node, force)) in self.loads.points.iter().enumerate() {
            self.node_exists("loads.points", i, *node)?;
            if !force.is_finite() {
                return Err(Refused::at(format!("loads.points[{i}]"), force.to_string(), "finite numbers"));
            }
        }
        for (i, (nodes, pressure)) in self.loads.pressures.iter().enumerate() {
            self.nodes_exist("loads.pressures", i, nodes)?;
            finite(format!("loads.pressures[{i}]"), *pressure)?;
        }
        if !self.masses.is_empty() && self.masses.len() != self.nodes.len() {
            let expected = format!("one for each of the {} nodes, or none", self.nodes.len());
            return Err(Refused::at("masses", format!("{} masses", self.masses.len()), expected));
        }
        for (i, mass) in self.masses.iter().enumerate() {
            above_zero(format!("masses[{i}]"), *mass)?;
        }
        self.check_supports()
    }

    /// Whether a configuration has a position for each node and an angle for each hinge.
    pub(super) fn check_configuration(&self, at: &Configuration) -> Result<(), Refused> {
        let (positions, angles) = (at.positions.len(), at.fold_angles.len());
        if (positions, angles) == (self.nodes.len(), self.hinges.len()) {
            return Ok(());
        }
        let expected = format!("one for each of {} nodes and {} hinges", self.nodes.len(), self.hinges.len());
        Err(Refused::at("configuration", format!("{positions} positions and {angles} angles"), expected))
    }

    fn check_supports(&self) -> Result<(), Refused> {
        for (i, dof) in self.supports.fixed.iter().enumerate() {
            self.node_exists("supports.fixed", i, dof.node)?;
        }
        for (i, (dof, way)) in self.supports.moved.iter().enumerate() {
            self.node_exists("supports.moved", i, dof.node)?;
            finite(format!("supports.moved[{i}]"), *way)?;
        }
        let fixed = self.supports.fixed.iter().map(|dof| (*dof, 0.0));
        let mut all: Vec<(Dof, f64)> = fixed.chain(self.supports.moved.iter().copied()).collect();
        all.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        match all.windows(2).find(|pair| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1) {
            Some(pair) => Err(Refused::Contradiction { dof: pair[0].0, one: pair[0].1, other: pair[1].1 }),
            None => Ok(()),
        }
    }

    fn node_exists(&self, what: &str, index: usize, node: NodeId) -> Result<(), Refused> {
        if node.index() < self.nodes.len() {
            return Ok(());
        }
        let expected = format!("one of the {} nodes", self.nodes.len());
        Err(Refused::at(format!("{what}[{index}]"), format!("node {}", node.0), expected))
    }

    fn nodes_exist(&self, what: &str, index: usize, nodes: &[NodeId]) -> Result<(), Refused> {
        nodes.iter().try_for_each(|node| self.node_exists(what, index, *node))?;
        let twice = (1..nodes.len()).find(|i| nodes[..*i].contains(&nodes[*i]));
        let problem = |i: usize| format!("node {} twice", nodes[i].0);
        twice.map_or(Ok(()), |i| Err(Refused::at(format!("{what}[{index}]"), problem(i), "different nodes")))
    }

    /// How many degrees of freedom neither are held nor moved.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        super::rows::Rows::new(self).len()
    }

    /// How many independent rigid motions the supports leave free: 6 of each part that nothing holds.
    #[must_use]
    pub fn free_rigid_motions(&self) -> usize {
        let parts = self.parts();
        let mut held: Vec<Vec<Dof>> = vec![Vec::new(); self.nodes.len()];
        let moved = self.supports.moved.iter().map(|(dof, _)| dof);
        for dof in self.supports.fixed.iter().chain(moved) {
            held[dof.node.index()].push(*dof);
        }
        let free = |part: &Vec<usize>| {
            let count = part.len() as f64;
            let centre = part.iter().map(|n| self.nodes[*n]).sum::<DVec3>() / count;
            let arms = part.iter().map(|n| (self.nodes[*n] - centre).length());
            let size = arms.fold(0.0, f64::max).max(f64::MIN_POSITIVE);
            let motion = |dof: &Dof| {
                let (axis, arm) = (dof.axis.index(), (self.nodes[dof.node.index()] - centre) / size);
                let turn = |about: DVec3| about.cross(arm)[axis];
                let shift = |i: usize| f64::from(u8::from(i == axis));
                [shift(0), shift(1), shift(2), turn(DVec3::X), turn(DVec3::Y), turn(DVec3::Z)]
            };
            let all = part.iter().flat_map(|n| super::Axis::ALL.map(|axis| Dof::new(NodeId::new(*n), axis)));
            let possible = rank(all.map(|dof| motion(&dof)).collect());
            possible - rank(part.iter().flat_map(|n| &held[*n]).map(motion).collect())
        };
        parts.iter().map(free).sum()
    }

    /// The nodes of each part that hangs together.
    fn parts(&self) -> Vec<Vec<usize>> {
        let mut root: Vec<usize> = (0..self.nodes.len()).collect();
        let mut join = |nodes: &[NodeId]| {
            for pair in nodes.windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|n| find(&mut root, n.index()));
                root[a.max(b)] = a.min(b);
            }
        };
        self.bars.iter().for_each(|bar| join(&bar.nodes));
        self.hinges.iter().for_each(|hinge| join(&hinge.nodes));
        self.corners.iter().for_each(|corners| join(&corners.angles.nodes));
        let mut parts = vec![Vec::new(); self.nodes.len()];
        for node in 0..self.nodes.len() {
            parts[find(&mut root, node)].push(node);
        }
        parts.retain(|part| !part.is_empty());
        parts
    }
}

/// The rank of rows of lengths around 1: what is left of each after those before it.
fn rank(rows: Vec<[f64; 6]>) -> usize {
    const NOTHING: f64 = 1e-9;
    let mut basis: Vec<[f64; 6]> = Vec::new();
    for mut row in rows {
        // Twice: once leaves rounding.
        for unit in basis.iter().chain(&basis) {
            let along: f64 = unit.iter().zip(&row).map(|(a, b)| a * b).sum();
            row.iter_mut().zip(unit).for_each(|(x, u)| *x -= along * u);
        }
        let length = row.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length > NOTHING {
            basis.push(row.map(|x| x / length));
        }
    }
    basis.len()
}

fn find(root: &mut [usize], node: usize) -> usize {
    let mut node = node;
    while root[node] != node {
        root[node] = root[root[node]];
        node = root[node];
    }
    node
}

fn above_zero(place: String, x: f64) -> Result<(), Refused> {
    let fine = x.is_finite() && x > 0.0;
    if fine { Ok(()) } else { Err(Refused::at(place, x.to_string(), "a number above 0")) }
}

fn at_least_zero(place: String, x: f64) -> Result<(), Refused> {
    let fine = x.is_finite() && x >= 0.0;
    if fine { Ok(()) } else { Err(Refused::at(place, x.to_string(), "a number of at least 0")) }
}

fn finite(place: String, x: f64) -> Result<(), Refused> {
    if x.is_finite() { Ok(()) } else { Err(Refused::at(place, x.to_string(), "a finite number")) }
}
