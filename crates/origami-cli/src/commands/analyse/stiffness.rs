//! `origami analyse stiffness`.

use origami::analysis::Dof;
use serde::Serialize;

use super::report::{Laws, Units};
use super::subject::Subject;
use crate::args::StiffnessArgs;
use crate::exit::{Exit, Failure};
use crate::numbers::plain;

#[derive(Serialize)]
struct Report<'a> {
    origami: &'static str,
    input: &'a str,
    units: Units<'a>,
    laws: Laws,
    /// Work of the load on its displacements, for a load factor of 1.
    compliance: f64,
    /// By vertex of the file; null for one that is no part of the sheet.
    displacements: Vec<Option<[f64; 3]>>,
    reactions: Vec<Reaction>,
}

#[derive(Serialize)]
struct Reaction {
    vertex: u32,
    axis: &'static str,
    force: f64,
}

/// Writes the answer to the first bit of load.
pub(super) fn run(args: &StiffnessArgs) -> Result<Exit, Failure> {
    let subject = Subject::read(&args.subject, "stiffness.json")?;
    let (model, structure) = (&subject.model, &subject.setup.structure);
    let first = structure.first_order(&structure.as_drawn(), 0.0).map_err(|refused| subject.refused(&refused))?;
    let nodes = model.mesh.node_of_vertex.iter().take(subject.pattern.vertices_in_file);
    let reaction = |(dof, force): &(Dof, f64)| Reaction {
        vertex: model.mesh.vertex_of_node[dof.node.index()].0,
        axis: dof.axis.name(),
        force: *force,
    };
    let report = Report {
        origami: env!("CARGO_PKG_VERSION"),
        input: &subject.name,
        units: Units::of(&subject),
        laws: Laws::of(&subject),
        compliance: first.compliance,
        displacements: nodes.map(|node| node.map(|n| first.displacements[n.index()].to_array())).collect(),
        reactions: first.reactions.iter().map(reaction).collect(),
    };
    subject.write_json("stiffness.json", &report)?;
    subject.say(&format!(
        "{}: compliance {}",
        subject.output.join("stiffness.json").display(),
        plain(first.compliance)
    ))?;
    Ok(Exit::Done)
}
