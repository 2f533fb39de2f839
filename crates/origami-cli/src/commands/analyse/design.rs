//! `origami design`.

use origami::analysis::job::{DesignSetup, keys_of};
use origami::analysis::{Configuration, Designed, Goal, Progress, Structure, Watched};
use serde::Serialize;
use serde_json::Value;

use super::report::{Laws, Units};
use super::subject::Subject;
use crate::args::DesignArgs;
use crate::exit::{Exit, Failure};
use crate::numbers::{count, plain};

/// Own key: what is stored in a frame.
const ENERGY: &str = "origami:energy";
/// A goal that is missed by this share of what is wanted, or of half the diagonal of the sheet's box, is reached ...
const REACHED: f64 = 1e-3;
/// ... and a shape whose vertices are as far from their places.
const IN_SHAPE: f64 = 1e-2;

#[derive(Serialize)]
struct Report<'a> {
    origami: &'static str,
    input: &'a str,
    units: Units<'a>,
    laws: Laws,
    goals: Vec<GoalEntry>,
    /// Half the sum of squares, weighted, of how far goals are from being reached, compliances as they are: at first and at last.
    value: [f64; 2],
    evaluations: u32,
    variables: Vec<VariableEntry<'a>>,
    history: &'a [Progress],
}

/// Heights in the job's lengths, angles in degrees, compliances and barriers in its energies; of shapes the root of the mean
/// squared distance.
#[derive(Serialize)]
struct GoalEntry {
    goal: &'static str,
    wanted: Option<f64>,
    before: f64,
    after: f64,
    reached: bool,
}

#[derive(Serialize)]
struct VariableEntry<'a> {
    of: &'a str,
    value: f64,
    bounds: [f64; 2],
}

/// Designs, and writes what came of it.
pub(in crate::commands) fn run(args: &DesignArgs) -> Result<Exit, Failure> {
    let subject = Subject::read(&args.subject, "design.json")?;
    let structure = &subject.setup.structure;
    let design = subject.job.design_setup(&subject.setup, &subject.pattern, &subject.model);
    let design = design.map_err(|error| subject.in_job(&error))?;
    let watched = design.watched(&subject.setup).map_err(|refused| subject.refused(&refused))?;
    let mut judge =
        |own: &Structure, states: &[Configuration]| Goal::judge_all(&design.goals, own, states, design.load_factor);
    let designed = structure.design(&watched, &design.variables, &design.effort, &mut judge);
    let designed = designed.map_err(|refused| subject.refused(&refused))?;
    let goals = goals(structure, &design, &watched, &designed);
    let reached = goals.iter().all(|goal| goal.reached);
    write_sheet(&subject, &designed)?;
    let variable = |((own, (name, scale)), value)| -> VariableEntry<'_> {
        let own: &origami::analysis::Variable = own;
        let (name, scale): (&String, &f64) = (name, scale);
        VariableEntry { of: name, value: value * scale, bounds: own.bounds.map(|x| x * scale) }
    };
    let all = design.variables.iter().zip(design.names.iter().map(|(name, scale)| (name, scale)));
    let report = Report {
        origami: env!("CARGO_PKG_VERSION"),
        input: &subject.name,
        units: Units::of(&subject),
        laws: Laws::of(&subject),
        value: [designed.history.first().map_or(designed.value, |first| first.value), designed.value],
        evaluations: designed.evaluations,
        variables: all.zip(designed.values.iter().copied()).map(variable).collect(),
        history: &designed.history,
        goals,
    };
    subject.write_json("design.json", &report)?;
    let change = |goal: &GoalEntry| format!("{} from {} to {}", goal.goal, plain(goal.before), plain(goal.after));
    let changes: Vec<String> = report.goals.iter().map(change).collect();
    subject.say(&format!(
        "{} and design.fold beside it: {} by {}, {}",
        subject.output.join("design.json").display(),
        changes.join(", "),
        count(design.variables.len(), "variable", "variables"),
        count(designed.evaluations as usize, "evaluation", "evaluations"),
    ))?;
    Ok(if reached { Exit::Done } else { Exit::NotConverged })
}

fn goals(structure: &Structure, design: &DesignSetup, watched: &[Watched], designed: &Designed) -> Vec<GoalEntry> {
    let starts: Vec<Configuration> = watched.iter().map(|own| own.start.clone()).collect();
    let entry = |(_, goal): &(f64, Goal)| {
        let (name, wanted, scale, size) = match goal {
            Goal::Height { wanted, .. } => ("height", Some(*wanted), 1.0, structure.size()),
            Goal::FoldAngle { wanted, .. } => ("fold angle", Some(*wanted), 1_f64.to_degrees(), 1.0),
            Goal::Compliance => ("compliance", None, 1.0, 0.0),
            Goal::Barrier { wanted } => ("barrier", Some(*wanted), 1.0, wanted.abs()),
            _ => ("distance", Some(0.0), 1.0, structure.size() * IN_SHAPE / REACHED),
        };
        let measure = |structure, states: &[Configuration]| goal.measure(structure, states, design.load_factor) * scale;
        let after = measure(&designed.structure, &designed.states);
        let wanted = wanted.map(|wanted| wanted * scale);
        let reached = wanted.is_none_or(|wanted| (after - wanted).abs() <= REACHED * size * scale);
        GoalEntry { goal: name, wanted, before: measure(structure, &starts), after, reached }
    };
    design.goals.iter().map(entry).collect()
}

/// Writes the sheet as it is to be made, with its states as frames.
fn write_sheet(subject: &Subject, designed: &Designed) -> Result<(), Failure> {
    let Subject { model, setup, pattern, .. } = subject;
    let mut drawn = pattern.clone();
    if designed.structure.nodes != setup.structure.nodes {
        let positions: Vec<_> = designed.structure.nodes.iter().map(|p| *p / setup.radius).collect();
        drawn.vertices = model.file_positions(pattern, &positions);
    }
    let states = designed.states.iter().map(|at| {
        let energy = designed.structure.energies(at).total();
        (at, ENERGY, Value::from(energy))
    });
    let keys = keys_of(&setup.structure, &designed.structure, pattern, model);
    subject.write_sheet("design.fold", &drawn, keys, states)
}
