//! Inverse design as a job asks for it: goals, and what may be changed.

use std::ops::ControlFlow;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::edges::{Edges, Kind, Member};
use super::pick::{Pick, node_of};
use super::{Job, Setup};
use crate::analysis::{Axis, Effort, Ended, Goal, Members, Path, Refused, Start, Structure, Until, Variable, Watched};
use crate::error::{Error, ErrorCode, Place};
use crate::ids::NodeId;
use crate::model::Model;
use crate::pattern::CreasePattern;

/// What is to be reached, and what may be changed to that end.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct DesignJob {
    /// Which state is designed: its number among those without load on the job's path, from 0. Default: the first where a
    /// barrier is asked for, else that at `load_factor`.
    pub state: Option<usize>,
    /// The load factor of the state, which is sought along a path from the sheet as drawn. Default 0.
    pub load_factor: f64,
    /// What is to be reached: one or more, whose values are added up.
    pub goals: Vec<GoalJob>,
    /// What may be changed: one or more.
    pub variables: Vec<VariableJob>,
    /// As [`Effort::evaluations`].
    pub evaluations: u32,
    /// As [`Effort::enough`].
    pub enough: f64,
}

impl Default for DesignJob {
    fn default() -> Self {
        let Effort { evaluations, enough, .. } = Effort::default();
        Self { state: None, load_factor: 0.0, goals: Vec::new(), variables: Vec::new(), evaluations, enough }
    }
}

/// One of the goals, with its weight.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct GoalJob {
    /// Vertices and the places where they are wanted, in the file's unit of length.
    pub shape: Option<Vec<(u32, [f64; 3])>>,
    /// A height.
    pub height: Option<HeightJob>,
    /// A fold angle.
    pub fold_angle: Option<FoldAngleJob>,
    /// `true`: as small a compliance as can be, the work of the loads at `load_factor`.
    pub compliance: bool,
    /// The barrier between the state and the next one, an energy.
    pub barrier: Option<f64>,
    /// What it counts beside other goals. Larger: it is nearer to being reached where not all can be. Above 0. Default 1.
    pub weight: f64,
}

impl Default for GoalJob {
    fn default() -> Self {
        Self { shape: None, height: None, fold_angle: None, compliance: false, barrier: None, weight: 1.0 }
    }
}

/// How high some vertices are above others.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct HeightJob {
    /// The upper ones: of several the mean.
    pub of: Pick,
    /// The lower ones.
    pub above: Pick,
    /// Along which axis. Default z.
    #[serde(default = "upwards")]
    pub axis: Axis,
    /// How high, in the job's unit of length.
    pub wanted: f64,
}

fn upwards() -> Axis {
    Axis::Z
}

/// The fold angle of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct FoldAngleJob {
    /// Its number in the file.
    pub edge: u32,
    /// In degrees, valleys positive.
    pub wanted: f64,
}

/// Something that may be changed: one of the six.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct VariableJob {
    /// Fold angles at which edges are at rest, in degrees.
    pub rest_angles: Option<Edges>,
    /// Stiffnesses of hinges, a moment per radian and length.
    pub stiffnesses: Option<Edges>,
    /// Rest lengths of edges.
    pub rest_lengths: Option<Edges>,
    /// Axial rigidities of edges, a force.
    pub rigidities: Option<Edges>,
    /// Vertices that are drawn farther `along` a vector, by a length.
    #[serde(rename = "move")]
    pub moved: Option<Pick>,
    /// The direction of a move; its length does not matter.
    pub along: Option<[f64; 3]>,
    /// Vertices that are drawn turned about an axis, in degrees.
    pub turn: Option<Pick>,
    /// A point on the axis of a turn, in the file's unit of length. Default the origin.
    pub about: Option<[f64; 3]>,
    /// The direction of the axis. Default z.
    pub axis: Option<[f64; 3]>,
    /// Whether all edges have the same value, not each its own. Default false.
    pub together: bool,
    /// The least and the largest value, in the units named above.
    pub bounds: [f64; 2],
}

/// A design in terms of a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignSetup {
    /// What may be changed.
    pub variables: Vec<Variable>,
    /// Of each variable what it is, such as `rest angle of edge 12`, and what a value is to be multiplied by to be in the job's
    /// units.
    pub names: Vec<(String, f64)>,
    /// What is to be reached, with weights.
    pub goals: Vec<(f64, Goal)>,
    /// How long it is tried.
    pub effort: Effort,
    /// The load factor of the states.
    pub load_factor: f64,
    state: Option<usize>,
}

impl Job {
    /// The design that the job asks for, of a structure that it made.
    ///
    /// # Errors
    /// [`Error::Invalid`] that names the key of what is missing, out of range, or of no vertex or edge of the sheet.
    pub fn design_setup(&self, setup: &Setup, pattern: &CreasePattern, model: &Model) -> Result<DesignSetup, Error> {
        let Some(job) = &self.design else {
            return Err(missing("design", "`goals`, and `variables` that may be changed"));
        };
        for (key, empty) in [("design.goals", job.goals.is_empty()), ("design.variables", job.variables.is_empty())] {
            if empty {
                return Err(missing(key, "one or more"));
            }
        }
        let sheet = Sheet { structure: &setup.structure, radius: setup.radius, pattern, model };
        let mut goals = Vec::new();
        for (i, goal) in job.goals.iter().enumerate() {
            let place = format!("design.goals[{i}]");
            if !(goal.weight.is_finite() && goal.weight > 0.0) {
                return Err(wrong(format!("{place}.weight"), format!("is {}", goal.weight), "a number above 0"));
            }
            goals.push((goal.weight, sheet.goal(&place, goal)?));
        }
        let (mut variables, mut names) = (Vec::new(), Vec::new());
        for (i, variable) in job.variables.iter().enumerate() {
            let place = format!("design.variables[{i}]");
            let in_order = variable.bounds[0] <= variable.bounds[1];
            if !(in_order && variable.bounds.iter().all(|x| x.is_finite())) {
                let [low, high] = variable.bounds;
                return Err(wrong(format!("{place}.bounds"), format!("is [{low}, {high}]"), "two numbers in order"));
            }
            for (own, name, scale) in sheet.variables(&place, variable)? {
                variables.push(own);
                names.push((name, scale));
            }
        }
        let is_barrier = goals.iter().any(|(_, goal)| matches!(goal, Goal::Barrier { .. }));
        if job.load_factor != 0.0 && (job.state.is_some() || is_barrier) {
            let problem = format!("is {}", job.load_factor);
            return Err(wrong("design.load_factor", problem, "0 for a `state` without load, or for a `barrier`"));
        }
        let effort = Effort { evaluations: job.evaluations, enough: job.enough, ..Effort::default() };
        Ok(DesignSetup { variables, names, goals, effort, load_factor: job.load_factor, state: job.state })
    }
}

impl DesignSetup {
    /// The equilibria that the design is of: sought along the path of `setup`, whose structure it is of.
    ///
    /// # Errors
    /// [`Refused`] where there are none.
    pub fn watched(&self, setup: &Setup) -> Result<Vec<Watched>, Refused> {
        let structure = &setup.structure;
        let is_barrier = self.goals.iter().any(|(_, goal)| matches!(goal, Goal::Barrier { .. }));
        if self.state.is_none() && !is_barrier {
            if self.load_factor == 0.0 {
                return Ok(vec![Watched { start: structure.as_drawn(), load_factor: 0.0 }]);
            }
            let until = vec![Until::LoadFactor(self.load_factor)];
            let path = Path { until, backwards: self.load_factor < 0.0, ..setup.path.clone() };
            let trace = structure.trace(&Start::default(), &path, &mut |_| ControlFlow::Continue(()))?;
            let end = trace.points.last().filter(|_| trace.ended == Ended::Reached);
            return match end {
                Some(end) => Ok(vec![Watched { start: end.configuration.clone(), load_factor: self.load_factor }]),
                None => {
                    let problem = format!("{} is not reached", self.load_factor);
                    Err(Refused::at("design.load_factor", problem, "one that the path of the job comes to"))
                }
            };
        }
        let trace = structure.trace(&Start::default(), &setup.path, &mut |_| ControlFlow::Continue(()))?;
        let states = trace.equilibria();
        let first = self.state.unwrap_or(0);
        let count = if is_barrier { 2 } else { 1 };
        let Some(own) = states.get(first..first + count) else {
            let problem = format!("state {first} of {} without load on the path", states.len());
            return Err(Refused::at("design.state", problem, "one of them, and for a barrier the one after it"));
        };
        if is_barrier && (own[0].index, own[1].index) != (0, 1) {
            let problem =
                format!("states {first} and {} have indices {} and {}", first + 1, own[0].index, own[1].index);
            return Err(Refused::at("design.state", problem, "0 and 1 for a barrier: a stable state and a saddle"));
        }
        let watched = |state: &crate::analysis::Equilibrium| Watched {
            start: trace.points[state.point].configuration.clone(),
            load_factor: 0.0,
        };
        Ok(own.iter().map(watched).collect())
    }
}

/// What goals and variables are of.
struct Sheet<'a> {
    structure: &'a Structure,
    radius: f64,
    pattern: &'a CreasePattern,
    model: &'a Model,
}

impl Sheet<'_> {
    fn nodes(&self, place: &str, pick: &Pick) -> Result<Vec<NodeId>, Error> {
        pick.nodes(place, self.pattern, self.model)
    }

    /// A place of the file in the structure's coordinates.
    fn place(&self, p: [f64; 3]) -> DVec3 {
        self.model.normalisation.to_model(DVec3::from_array(p)) * self.radius
    }

    fn goal(&self, place: &str, job: &GoalJob) -> Result<Goal, Error> {
        match (&job.shape, &job.height, job.fold_angle, job.compliance, job.barrier) {
            (Some(shape), None, None, false, None) => {
                let node = |(i, (vertex, at)): (usize, &(u32, [f64; 3]))| {
                    let node = node_of(&format!("{place}.shape[{i}]"), *vertex, self.pattern, self.model)?;
                    Ok((node, self.place(*at)))
                };
                if shape.is_empty() {
                    return Err(wrong(format!("{place}.shape"), "is empty", "one or more vertices with places"));
                }
                Ok(Goal::Shape(shape.iter().enumerate().map(node).collect::<Result<_, Error>>()?))
            }
            (None, Some(HeightJob { of, above, axis, wanted }), None, false, None) => {
                let of = self.nodes(&format!("{place}.height.of"), of)?;
                let above = self.nodes(&format!("{place}.height.above"), above)?;
                Ok(Goal::Height { of, above, axis: *axis, wanted: *wanted })
            }
            (None, None, Some(FoldAngleJob { edge, wanted }), false, None) => {
                let place = format!("{place}.fold_angle.edge");
                let member = Edges::List(vec![edge]).members(&place, Kind::Hinges, self.pattern, self.model)?;
                Ok(Goal::FoldAngle { hinge: member[0].index, wanted: wanted.to_radians() })
            }
            (None, None, None, true, None) => {
                if self.structure.loads.points.is_empty() {
                    let expected = "forces in `loads` or `vertices_origami:load`";
                    return Err(wrong(format!("{place}.compliance"), "is of no load", expected));
                }
                Ok(Goal::Compliance)
            }
            (None, None, None, false, Some(wanted)) => Ok(Goal::Barrier { wanted }),
            _ => {
                let expected = "`shape`, `height`, `fold_angle`, `compliance` or `barrier`, one of them";
                Err(wrong(place, "has no goal, or several", expected))
            }
        }
    }

    /// The variables of an entry, with their names and the factors to the job's units.
    fn variables(&self, place: &str, job: &VariableJob) -> Result<Vec<(Variable, String, f64)>, Error> {
        let edges = [
            (&job.rest_angles, "rest_angles", "rest angle", Kind::Hinges),
            (&job.stiffnesses, "stiffnesses", "stiffness", Kind::Hinges),
            (&job.rest_lengths, "rest_lengths", "rest length", Kind::Bars),
            (&job.rigidities, "rigidities", "rigidity", Kind::Bars),
        ];
        let mut asked =
            edges.into_iter().filter_map(|(edges, key, name, kind)| edges.as_ref().map(|e| (e, key, name, kind)));
        let first = asked.next();
        match (first, asked.next(), &job.moved, &job.turn) {
            (Some((edges, key, name, kind)), None, None, None) => {
                let place = format!("{place}.{key}");
                let members = edges.members(&place, kind, self.pattern, self.model)?;
                self.of_edges(&place, job, (key, name), &members)
            }
            (None, None, Some(pick), None) => {
                let nodes = self.nodes(&format!("{place}.move"), pick)?;
                let along = direction(format!("{place}.along"), job.along)?;
                let name = format!("move of {} vertices", nodes.len());
                Ok(vec![(Variable { members: Members::Moved { nodes, along }, bounds: job.bounds }, name, 1.0)])
            }
            (None, None, None, Some(pick)) => {
                let nodes = self.nodes(&format!("{place}.turn"), pick)?;
                let axis = direction(format!("{place}.axis"), job.axis.or(Some([0.0, 0.0, 1.0])))?;
                let about = self.place(job.about.unwrap_or_default());
                let name = format!("turn of {} vertices", nodes.len());
                let members = Members::Turned { nodes, about, axis };
                let bounds = job.bounds.map(f64::to_radians);
                Ok(vec![(Variable { members, bounds }, name, 1_f64.to_degrees())])
            }
            _ => {
                let expected =
                    "`rest_angles`, `stiffnesses`, `rest_lengths`, `rigidities`, `move` or `turn`, one of them";
                Err(wrong(place, "changes nothing, or several things", expected))
            }
        }
    }

    fn of_edges(
        &self,
        place: &str,
        job: &VariableJob,
        (key, name): (&str, &str),
        members: &[Member],
    ) -> Result<Vec<(Variable, String, f64)>, Error> {
        // How many of the job's units a unit of the structure's number is.
        let scale = |member: &Member| match key {
            "rest_angles" => 1_f64.to_degrees(),
            "stiffnesses" => {
                let ends = self.structure.hinges[member.index].nodes;
                let [a, b] = [ends[2], ends[3]].map(|n| self.structure.nodes[n.index()]);
                1.0 / a.distance(b)
            }
            _ => 1.0,
        };
        let made = |all: Vec<usize>| match key {
            "rest_angles" => Members::RestAngles(all),
            "stiffnesses" => Members::HingeStiffnesses(all),
            "rest_lengths" => Members::RestLengths(all),
            _ => Members::Rigidities(all),
        };
        let variable =
            |all: Vec<usize>, scale: f64| Variable { members: made(all), bounds: job.bounds.map(|x| x / scale) };
        if !job.together {
            let each = |member: &Member| {
                let scale = scale(member);
                (variable(vec![member.index], scale), format!("{name} of edge {}", member.edge), scale)
            };
            return Ok(members.iter().map(each).collect());
        }
        let own = scale(&members[0]);
        if let Some(other) = members.iter().find(|member| (scale(member) / own - 1.0).abs() > 1e-9) {
            let problem = format!("edges {} and {} differ in length", members[0].edge, other.edge);
            return Err(wrong(place, problem, "edges of one length, or no `together`"));
        }
        let all = members.iter().map(|member| member.index).collect();
        Ok(vec![(variable(all, own), format!("{name} of {} edges", members.len()), own)])
    }
}

fn direction(place: String, vector: Option<[f64; 3]>) -> Result<DVec3, Error> {
    let direction = vector.map(DVec3::from_array).and_then(DVec3::try_normalize);
    direction.ok_or_else(|| wrong(place, "is no direction", "a vector other than 0, [x, y, z]"))
}

fn missing(key: &'static str, expected: &str) -> Error {
    Error::new(ErrorCode::MissingKey, Place::key(key), "is missing", expected)
}

fn wrong(place: impl Into<String>, problem: impl Into<String>, expected: &str) -> Error {
    Error::new(ErrorCode::WrongValue, Place::key(place.into()), problem.into(), expected)
}
