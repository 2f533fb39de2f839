//! Inverse design: numbers of a structure for which equilibria are as wanted.

mod goal;
mod minimise;
mod variable;

pub use goal::{Goal, Judgement};
pub use minimise::{Effort, Progress};
pub use variable::{Members, Variable};

use glam::DVec3;

use super::structure::Structure;
use super::{Configuration, Gradient, Refused};
use minimise::minimise;
use variable::Variables;

/// A step after which a node is farther than this from where it was, in sizes, may have led to another state: it is shortened.
const FARTHEST: f64 = 0.1;

/// A state that is followed while a design changes, from equilibrium to equilibrium.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Watched {
    /// Where it is sought in the beginning.
    pub start: Configuration,
    /// The load factor at which it is in equilibrium.
    pub load_factor: f64,
}

/// A structure whose equilibria are as they are wanted, or as near as was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Designed {
    /// The structure with its new numbers.
    pub structure: Structure,
    /// Its equilibria, one for each that was watched.
    pub states: Vec<Configuration>,
    /// The values of the variables, in their order.
    pub values: Vec<f64>,
    /// What was to be small.
    pub value: f64,
    /// How often the equilibria were sought.
    pub evaluations: u32,
    /// How the value fell, from the start on.
    pub history: Vec<Progress>,
}

/// The equilibria of a structure, each sought from where it was.
fn settle(structure: &Structure, watched: &[Watched], from: &[Configuration]) -> Result<Vec<Configuration>, Refused> {
    watched.iter().zip(from).map(|(own, from)| structure.equilibrium(from, own.load_factor)).collect()
}

/// A design with certain values.
struct Evaluated {
    states: Vec<Configuration>,
    value: f64,
    slopes: Vec<f64>,
}

type Judge<'a> = dyn FnMut(&Structure, &[Configuration]) -> Judgement + 'a;

impl Variables<'_> {
    fn evaluate(
        &self,
        watched: &[Watched],
        from: &[Configuration],
        values: &[f64],
        judge: &mut Judge<'_>,
    ) -> Result<Evaluated, Refused> {
        let structure = self.structure(values);
        let states = settle(&structure, watched, from)?;
        let judged = judge(&structure, &states);
        let mut gradient = Gradient::zero(&structure);
        for (i, (own, at)) in watched.iter().zip(&states).enumerate() {
            judged.add_gradient(i, &structure, (at, own.load_factor), &mut gradient)?;
        }
        let slopes = self.slopes(&structure, values, &gradient, &judged.drawn)?;
        Ok(Evaluated { states, value: judged.value, slopes })
    }
}

impl Structure {
    /// Changes `variables` so that what `judge` says of the equilibria becomes small: a [goal](Goal), or whatever depends smoothly
    /// on them. Each variable begins with the mean of its members' numbers.
    ///
    /// # Errors
    /// [`Refused`] where a variable names no member, the structure is wrong, or an equilibrium near its start is not found or
    /// is singular: a limit point or a bifurcation, where it does not depend smoothly on anything.
    pub fn design(
        &self,
        watched: &[Watched],
        variables: &[Variable],
        effort: &Effort,
        judge: &mut dyn FnMut(&Self, &[Configuration]) -> Judgement,
    ) -> Result<Designed, Refused> {
        let (variables, values) = Variables::new(self, variables)?;
        let size = self.size();
        for Watched { start, load_factor } in watched {
            // Newton's method may leave a limit point by more than rounding: it is looked at as it is given.
            if self.tangent(start, *load_factor)?.inertia().neutral > 0 {
                return Err(Refused::Singular { at: format!("load factor {load_factor}") });
            }
        }
        let starts: Vec<Configuration> = watched.iter().map(|own| own.start.clone()).collect();
        let mut states = settle(self, watched, &starts)?;
        // Of a step that is taken back nothing is kept: it may lie in another valley.
        let mut least = f64::INFINITY;
        let mut refused = None;
        let mut evaluate = |values: &[f64]| {
            let found = variables.evaluate(watched, &states, values, judge).and_then(|found| {
                let apart = found.states.iter().zip(&states);
                let apart = apart.flat_map(|(new, old)| new.positions.iter().zip(&old.positions));
                match apart.map(|(p, q)| p.distance(*q)).fold(0.0, f64::max) > FARTHEST * size {
                    true => Err(Refused::NotFound { at: "a step of the design".to_owned(), iterations: 1 }),
                    false => Ok(found),
                }
            });
            match found {
                Ok(found) => {
                    if found.value <= least {
                        (least, states) = (found.value, found.states);
                    }
                    Some((found.value, found.slopes))
                }
                Err(why) => {
                    refused = Some(why);
                    None
                }
            }
        };
        let found = minimise(values, &variables.bounds(), effort, &mut evaluate);
        let Some(found) = found else {
            let nowhere = Refused::NotFound { at: "the start".to_owned(), iterations: 0 };
            return Err(refused.unwrap_or(nowhere));
        };
        let structure = variables.structure(&found.at);
        let states = settle(&structure, watched, &states)?;
        Ok(Designed {
            structure,
            states,
            values: found.at,
            value: found.value,
            evaluations: found.evaluations,
            history: found.history,
        })
    }

    /// The same structure drawn with its nodes elsewhere: rest lengths and rest angles change by as much as lengths and angles of
    /// the drawing do, stiffnesses of hinges in proportion to their lengths; rigidities, loads and masses stay.
    #[must_use]
    pub fn redrawn(&self, nodes: Vec<DVec3>) -> Self {
        let mut new = Self { nodes, ..self.clone() };
        let length =
            |nodes: &[DVec3], ends: [crate::ids::NodeId; 2]| nodes[ends[0].index()].distance(nodes[ends[1].index()]);
        for bar in &mut new.bars {
            bar.rest_length += length(&new.nodes, bar.nodes) - length(&self.nodes, bar.nodes);
        }
        let before = self.as_drawn().fold_angles;
        let after = self.fold_angles(&new.nodes, &before);
        for ((hinge, before), after) in new.hinges.iter_mut().zip(before).zip(after) {
            hinge.rest_angle += after - before;
            let ends = [hinge.nodes[2], hinge.nodes[3]];
            hinge.stiffness *= length(&new.nodes, ends) / length(&self.nodes, ends);
        }
        new
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Axis, HingeLaw};
    use crate::generate::catalog;
    use crate::ids::NodeId;
    use crate::model::{Material, Model};
    use crate::scene::Axes;

    /// A sheet with bumps, without stress where it is drawn.
    fn sheet() -> Structure {
        let pattern = catalog::generate("miura", &[]).expect("a pattern");
        let material = Material { k_fold: 0.5, k_facet: 1.0, ..Material::default() };
        let mut structure = Structure::of(&Model::new(&pattern, &material).expect("a model"));
        structure.corners.clear();
        let bump = |(i, p): (usize, &DVec3)| *p + DVec3::Z * 0.2 * (1.0 + 7.0 * i as f64).sin();
        structure = structure.redrawn(structure.nodes.iter().enumerate().map(bump).collect());
        structure.hinges.iter_mut().enumerate().for_each(|(i, hinge)| {
            hinge.law = [HingeLaw::Linear, HingeLaw::Stiffened { between: [-0.1, 0.1] }][i % 2];
        });
        [0, 3, 7].map(NodeId).iter().for_each(|node| structure.hold(*node, Axes::ALL));
        structure.loads.points = vec![(NodeId(12), DVec3::new(0.3, -0.2, -0.5)), (NodeId(5), DVec3::Z)];
        structure
    }

    #[test]
    fn slopes_are_those_of_differences_for_every_goal_and_every_variable() {
        let structure = sheet();
        let drawn = structure.as_drawn();
        let watched = [0.04, 0.1].map(|load_factor| Watched { start: drawn.clone(), load_factor });
        let all = [
            Members::RestAngles(vec![2, 5]),
            Members::HingeStiffnesses(vec![1, 4]),
            Members::RestLengths(vec![3]),
            Members::Rigidities(vec![0, 7]),
            Members::Moved { nodes: vec![NodeId(4), NodeId(3)], along: DVec3::new(0.2, 0.1, 0.5) },
            Members::Turned {
                nodes: vec![NodeId(7), NodeId(4), NodeId(9)],
                about: DVec3::new(0.1, 0.0, 0.2),
                axis: DVec3::new(0.6, 0.0, 0.8),
            },
        ];
        let all = all.map(|members| Variable { members, bounds: [-1e3, 1e3] });
        let (variables, mut values) = Variables::new(&structure, &all).expect("variables");
        values[4] = 0.02;
        values[5] = -0.02;
        let place = |n: u32| (NodeId(n), structure.nodes[n as usize] + DVec3::new(0.1, -0.2, 0.3));
        let goals = [
            Goal::Shape(vec![place(10), place(12)]),
            Goal::Height { of: vec![NodeId(5), NodeId(12)], above: vec![NodeId(8)], axis: Axis::Z, wanted: 0.7 },
            Goal::FoldAngle { hinge: 6, wanted: 1.0 },
            Goal::Compliance,
            Goal::Barrier { wanted: 0.5 },
        ];
        for goal in goals {
            let mut judge =
                |own: &Structure, states: &[Configuration]| Goal::judge_all(&[(2.0, goal.clone())], own, states, 0.04);
            let starts = [drawn.clone(), drawn.clone()];
            let found = variables.evaluate(&watched, &starts, &values, &mut judge).expect("equilibria");
            let states = found.states.clone();
            let mut value = |k: usize, h: f64| {
                let mut moved = values.clone();
                moved[k] += h;
                variables.evaluate(&watched, &states, &moved, &mut judge).expect("equilibria").value
            };
            let largest = found.slopes.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
            assert!(largest > 0.0);
            for (k, slope) in found.slopes.iter().enumerate() {
                let mut difference = |h: f64| (value(k, h) - value(k, -h)) / (2.0 * h);
                let h = [1e-3, 1e-3, 1e-4, 1e-2, 1e-3, 1e-3][k];
                let wanted = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
                assert!((slope - wanted).abs() < 1e-6 * largest, "{goal:?} {k}: {slope} is not {wanted} of {largest}");
            }
        }
    }

    #[test]
    fn goals_are_measured_as_they_are_named() {
        let structure = sheet();
        let drawn = structure.as_drawn();
        let states = [drawn.clone(), structure.equilibrium(&drawn, 0.1).expect("an equilibrium")];
        let near = |goal: &Goal, wanted: f64| {
            let got = goal.measure(&structure, &states, 0.5);
            assert!((got - wanted).abs() < 1e-12, "{goal:?}: {got} is not {wanted}");
        };
        let off = |n: u32, by: f64| (NodeId(n), structure.nodes[n as usize] + DVec3::X * by);
        near(&Goal::Shape(vec![off(1, 3.0), off(2, 4.0)]), 12.5_f64.sqrt());
        let height = drawn.positions[5].z - drawn.positions[8].z;
        near(&Goal::Height { of: vec![NodeId(5)], above: vec![NodeId(8)], axis: Axis::Z, wanted: 9.0 }, height);
        near(&Goal::FoldAngle { hinge: 3, wanted: 9.0 }, drawn.fold_angles[3]);
        near(&Goal::Compliance, 0.0);
        let [first, second] = states.each_ref().map(|at| structure.energies(at).total());
        near(&Goal::Barrier { wanted: 9.0 }, second - first);
    }
}
