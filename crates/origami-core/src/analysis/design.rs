//! Inverse design: numbers of a structure for which an equilibrium is as wanted.

use glam::DVec3;

use super::minimise::{Effort, minimise};
use super::structure::Structure;
use super::{Configuration, Gradient, Refused};

/// A step after which a node is farther than this from where it was, in sizes, may have led to another state: it is shortened.
const FARTHEST: f64 = 0.1;

/// Numbers of a structure that a design may change: all members named take the same value.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Which numbers.
    pub members: Members,
    /// The least value and the largest.
    pub bounds: [f64; 2],
}

/// Numbers that are changed together, by the indices of hinges or bars.
#[derive(Clone, Debug, PartialEq)]
pub enum Members {
    /// Rest angles of hinges, in radians.
    RestAngles(Vec<usize>),
    /// Stiffnesses of whole hinges.
    HingeStiffnesses(Vec<usize>),
    /// Rest lengths of bars.
    RestLengths(Vec<usize>),
    /// Rigidities of bars.
    Rigidities(Vec<usize>),
}

impl Members {
    fn indices(&self) -> &[usize] {
        let (Self::RestAngles(all) | Self::HingeStiffnesses(all) | Self::RestLengths(all) | Self::Rigidities(all)) =
            self;
        all
    }

    fn number<'s>(&self, structure: &'s mut Structure, i: usize) -> Option<&'s mut f64> {
        match self {
            Self::RestAngles(_) => structure.hinges.get_mut(i).map(|hinge| &mut hinge.rest_angle),
            Self::HingeStiffnesses(_) => structure.hinges.get_mut(i).map(|hinge| &mut hinge.stiffness),
            Self::RestLengths(_) => structure.bars.get_mut(i).map(|bar| &mut bar.rest_length),
            Self::Rigidities(_) => structure.bars.get_mut(i).map(|bar| &mut bar.rigidity),
        }
    }

    fn slope(&self, gradient: &Gradient) -> f64 {
        let all = match self {
            Self::RestAngles(_) => &gradient.rest_angles,
            Self::HingeStiffnesses(_) => &gradient.hinge_stiffnesses,
            Self::RestLengths(_) => &gradient.rest_lengths,
            Self::Rigidities(_) => &gradient.rigidities,
        };
        self.indices().iter().map(|i| all[*i]).sum()
    }
}

/// A structure whose equilibrium is as it is wanted, or as near as was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Designed {
    /// The structure with its new numbers.
    pub structure: Structure,
    /// Its equilibrium.
    pub at: Configuration,
    /// The values of the variables, in their order.
    pub values: Vec<f64>,
    /// What was to be small.
    pub value: f64,
    /// Equilibria that were sought.
    pub evaluations: u32,
}

impl Structure {
    /// Changes `variables` so that `objective` becomes small at the equilibrium under `load_factor` times the loads that lies
    /// near `start`, from equilibrium to equilibrium. `objective` gives its value, and its derivative by the nodes'
    /// positions. Each variable begins with the mean of its members' values.
    ///
    /// # Errors
    /// [`Refused`] where a variable names no member, the structure is wrong, or has no regular equilibrium near `start`.
    pub fn design(
        &self,
        start: &Configuration,
        load_factor: f64,
        variables: &[Variable],
        effort: &Effort,
        objective: &mut dyn FnMut(&Configuration) -> (f64, Vec<DVec3>),
    ) -> Result<Designed, Refused> {
        let mut structure = self.clone();
        let mut values = Vec::new();
        for (k, Variable { members, bounds }) in variables.iter().enumerate() {
            let place = format!("variables[{k}]");
            let mut sum = 0.0;
            for i in members.indices() {
                let number = members.number(&mut structure, *i).map(|own| *own);
                sum += number.ok_or_else(|| {
                    Refused::at(format!("{place}.members"), format!("member {i}"), "a hinge or bar of the structure")
                })?;
            }
            let in_order = bounds[0] <= bounds[1];
            if members.indices().is_empty() || !in_order {
                let problem = format!("{} members between {} and {}", members.indices().len(), bounds[0], bounds[1]);
                return Err(Refused::at(place, problem, "one or more, and bounds in order"));
            }
            values.push(sum / members.indices().len() as f64);
        }
        let set = |structure: &mut Structure, values: &[f64]| {
            for (Variable { members, .. }, value) in variables.iter().zip(values) {
                for i in members.indices() {
                    if let Some(own) = members.number(structure, *i) {
                        *own = *value;
                    }
                }
            }
        };
        let size = self.size();
        let mut at = self.equilibrium(start, load_factor)?;
        let mut refused = None;
        let bounds: Vec<[f64; 2]> = variables.iter().map(|variable| variable.bounds).collect();
        let mut evaluate = |values: &[f64]| {
            set(&mut structure, values);
            let found = structure.equilibrium(&at, load_factor).and_then(|found| {
                let (value, by_positions) = objective(&found);
                let moves = found.positions.iter().zip(&at.positions).map(|(p, q)| p.distance(*q));
                if moves.fold(0.0, f64::max) > FARTHEST * size {
                    return Err(Refused::NotFound { at: "a step of the design".to_owned(), iterations: 1 });
                }
                let gradient = structure.gradient(&found, load_factor, &by_positions)?;
                Ok((found, value, gradient))
            });
            match found {
                Ok((found, value, gradient)) => {
                    at = found;
                    Some((value, variables.iter().map(|variable| variable.members.slope(&gradient)).collect()))
                }
                Err(why) => {
                    refused = Some(why);
                    None
                }
            }
        };
        let found = minimise(values, &bounds, effort, &mut evaluate);
        let Some(found) = found else {
            let nowhere = Refused::NotFound { at: "the start".to_owned(), iterations: 0 };
            return Err(refused.unwrap_or(nowhere));
        };
        set(&mut structure, &found.at);
        let at = structure.equilibrium(&at, load_factor)?;
        Ok(Designed { structure, at, values: found.at, value: found.value, evaluations: found.evaluations })
    }
}
