//! Effective moduli of a sheet that repeats itself in its plane: what a large piece answers to being stretched and sheared, from
//! the energy of one cell under strains that are uniform but for a part that repeats itself as the sheet does.

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use glam::{DMat3, DVec3};

use super::Refused;
use super::equations::Equations;
use super::structure::Structure;

/// How far a node may be from where another one repeats itself, in sizes.
const NEAR: f64 = 1e-6;
/// A cell of more nodes is not solved: its matrix is dense.
const MOST: usize = 1000;

/// What a sheet answers to small strains in the plane of x and y, per width: forces per length, as a modulus times a thickness.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Moduli {
    /// Young's modulus when it is stretched along x, and along y.
    pub young: [f64; 2],
    /// Poisson's ratio: how much it becomes narrower along y when stretched along x, and the other way round.
    pub poisson: [f64; 2],
    /// Shear modulus.
    pub shear: f64,
    /// Stress by strain, for `[xx, yy, xy]` with the shear strain of an engineer, twice that of a tensor.
    pub stiffness: [[f64; 3]; 3],
}

impl Structure {
    /// The moduli of the sheet as drawn, in which all repeats itself by each of two vectors in the plane of x and y. The structure
    /// must be a piece of it that has a copy of every member away from its border: two cells each way as a rule. Supports and
    /// loads do not matter.
    ///
    /// # Errors
    /// [`Refused`] where the vectors span no cell, nothing repeats itself by them, the piece is too small or the cell too large,
    /// or where it has a mechanism.
    pub fn moduli(&self, cell: [DVec3; 2]) -> Result<Moduli, Refused> {
        self.check()?;
        let area = cell[0].cross(cell[1]).z.abs();
        let size = self.size();
        let in_plane = cell.iter().all(|v| v.is_finite() && v.z.abs() <= NEAR * size);
        if !(in_plane && area > NEAR * size * size) {
            return Err(Refused::at(
                "cell",
                format!("{} and {}", cell[0], cell[1]),
                "two vectors in the plane of x and y",
            ));
        }
        let class = self.classes(cell);
        let count = class.iter().copied().max().map_or(0, |last| last + 1);
        if count > MOST {
            return Err(Refused::at("cell", format!("{count} nodes"), format!("at most {MOST}")));
        }
        let one = self.each_once(&class)?;
        let equations = Equations::new(&one)?;
        let drawn = one.as_drawn();
        let mut matrix = Mat::<f64>::zeros(3 * count, 3 * count);
        one.blocks(equations.size, &drawn, &mut |i, j, block: DMat3| {
            let mut add = |i: usize, j: usize, block: DMat3| {
                for (column, entries) in block.to_cols_array_2d().into_iter().enumerate() {
                    for (row, x) in entries.into_iter().enumerate() {
                        matrix[(3 * class[i] + row, 3 * class[j] + column)] += x;
                    }
                }
            };
            add(i, j, block);
            if i != j {
                add(j, i, block.transpose());
            }
        });
        // The sheet as a whole stays where it is.
        let free = 3 * count - 3;
        let free_matrix = matrix.submatrix(3, 3, free, free);
        let Ok(factors) = free_matrix.llt(Side::Lower) else { return Err(Refused::Mechanisms { count: 1 }) };
        let strains: [fn(DVec3) -> DVec3; 3] =
            [|p| DVec3::new(p.x, 0.0, 0.0), |p| DVec3::new(0.0, p.y, 0.0), |p| DVec3::new(0.5 * p.y, 0.5 * p.x, 0.0)];
        let uniform = strains.map(|strain| one.nodes.iter().map(|p| strain(*p)).collect::<Vec<DVec3>>());
        let forces = uniform.each_ref().map(|moves| equations.stiffness_times(&drawn, moves));
        let mut right = Mat::<f64>::zeros(3 * count, 3);
        for (k, forces) in forces.iter().enumerate() {
            for (node, force) in forces.iter().enumerate() {
                (0..3).for_each(|axis| right[(3 * class[node] + axis, k)] += force[axis]);
            }
        }
        let right = right.submatrix(3, 0, free, 3);
        let moves = factors.solve(right);
        let energy = |k: usize, l: usize| {
            let as_given: f64 = uniform[k].iter().zip(&forces[l]).map(|(u, f)| u.dot(*f)).sum();
            let relaxed: f64 = (0..free).map(|i| moves[(i, k)] * right[(i, l)]).sum();
            (as_given - relaxed) / area
        };
        let stiffness: [[f64; 3]; 3] = std::array::from_fn(|k| std::array::from_fn(|l| energy(k, l)));
        let compliance = DMat3::from_cols_array_2d(&stiffness).inverse();
        let s = |i: usize, j: usize| compliance.col(j)[i];
        Ok(Moduli {
            young: [1.0 / s(0, 0), 1.0 / s(1, 1)],
            poisson: [-s(0, 1) / s(0, 0), -s(0, 1) / s(1, 1)],
            shear: 1.0 / s(2, 2),
            stiffness,
        })
    }

    /// For each node the number of those that repeat each other.
    fn classes(&self, [a, b]: [DVec3; 2]) -> Vec<usize> {
        let near = NEAR * self.size();
        let mut order: Vec<usize> = (0..self.nodes.len()).collect();
        order.sort_by(|i, j| self.nodes[*i].x.total_cmp(&self.nodes[*j].x));
        let at = |place: DVec3| {
            let first = order.partition_point(|i| self.nodes[*i].x < place.x - near);
            let close = order[first..].iter().take_while(|i| self.nodes[**i].x <= place.x + near);
            close.copied().find(|i| self.nodes[*i].distance(place) <= near)
        };
        let mut class: Vec<Option<usize>> = vec![None; self.nodes.len()];
        let mut count = 0;
        for start in 0..self.nodes.len() {
            let mut waiting = if class[start].is_none() { vec![start] } else { Vec::new() };
            if !waiting.is_empty() {
                class[start] = Some(count);
                count += 1;
            }
            while let Some(node) = waiting.pop() {
                for step in [a, -a, b, -b, a + b, -a - b, a - b, b - a] {
                    if let Some(other) = at(self.nodes[node] + step)
                        && class[other].is_none()
                    {
                        class[other] = class[node];
                        waiting.push(other);
                    }
                }
            }
        }
        class.into_iter().flatten().collect()
    }

    /// The structure with one copy of each member: of bars the stiffest, as those at the border lack the triangle beyond.
    fn each_once(&self, class: &[usize]) -> Result<Self, Refused> {
        let near = NEAR * self.size();
        let same = |these: &[crate::ids::NodeId], those: &[crate::ids::NodeId]| {
            let [from, to] = [these[0], those[0]].map(|n| self.nodes[n.index()]);
            these.iter().zip(those).all(|(a, b)| {
                let apart = (self.nodes[a.index()] - from).distance(self.nodes[b.index()] - to);
                class[a.index()] == class[b.index()] && apart <= near
            })
        };
        let mut one = Self { nodes: self.nodes.clone(), ..Self::default() };
        for bar in &self.bars {
            let [a, b] = bar.nodes;
            match one.bars.iter_mut().find(|own| same(&own.nodes, &[a, b]) || same(&own.nodes, &[b, a])) {
                Some(own) => own.rigidity = own.rigidity.max(bar.rigidity),
                None => one.bars.push(*bar),
            }
        }
        for hinge in &self.hinges {
            let [a, b, c, d] = hinge.nodes;
            if !one.hinges.iter().any(|own| same(&own.nodes, &[a, b, c, d]) || same(&own.nodes, &[b, a, d, c])) {
                one.hinges.push(*hinge);
            }
        }
        for corners in &self.corners {
            let [a, b, c] = corners.angles.nodes;
            let turns = [[a, b, c], [b, c, a], [c, a, b]];
            if !one.corners.iter().any(|own| turns.iter().any(|turn| same(&own.angles.nodes, turn))) {
                one.corners.push(*corners);
            }
        }
        let is_line = |bar: &super::Bar| {
            let [a, b] = bar.nodes;
            one.hinges.iter().any(|hinge| {
                let line = &hinge.nodes[2..];
                same(line, &[a, b]) || same(line, &[b, a])
            })
        };
        if let Some(i) = one.bars.iter().position(|bar| !is_line(bar)) {
            let [a, b] = one.bars[i].nodes.map(|n| n.0);
            let problem = format!("the bar between nodes {a} and {b} lies at the border in all of its copies");
            return Err(Refused::at("cell", problem, "a larger piece of the sheet, two cells each way"));
        }
        Ok(one)
    }
}
