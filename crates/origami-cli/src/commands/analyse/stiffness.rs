//! `origami analyse stiffness`.

use origami::analysis::{Dof, Moduli};
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
    /// The answer to the load, where the sheet is held.
    #[serde(flatten)]
    answer: Option<Answer>,
    /// Where the job has a cell: forces per length.
    #[serde(skip_serializing_if = "Option::is_none")]
    moduli: Option<Moduli>,
}

#[derive(Serialize)]
struct Answer {
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

/// Writes the answer to the first bit of load, and moduli.
pub(super) fn run(args: &StiffnessArgs) -> Result<Exit, Failure> {
    let subject = Subject::read(&args.subject, "stiffness.json")?;
    let structure = &subject.setup.structure;
    let moduli = subject.setup.cell.map(|cell| structure.moduli(cell)).transpose();
    let moduli = moduli.map_err(|refused| subject.refused(&refused))?;
    // A cell alone needs no supports.
    let is_held = !(structure.supports.fixed.is_empty() && structure.supports.moved.is_empty());
    let answer = (is_held || moduli.is_none()).then(|| answer(&subject)).transpose()?;
    let mut told = Vec::new();
    told.extend(answer.as_ref().map(|answer| format!("compliance {}", plain(answer.compliance))));
    told.extend(moduli.as_ref().map(|moduli| {
        let [[x, y], [xy, yx]] = [moduli.young, moduli.poisson].map(|pair| pair.map(plain));
        format!("Young's moduli {x} and {y}, Poisson's ratios {xy} and {yx}, shear modulus {}", plain(moduli.shear))
    }));
    let report = Report {
        origami: env!("CARGO_PKG_VERSION"),
        input: &subject.name,
        units: Units::of(&subject),
        laws: Laws::of(&subject),
        answer,
        moduli,
    };
    subject.write_json("stiffness.json", &report)?;
    subject.say(&format!("{}: {}", subject.output.join("stiffness.json").display(), told.join(", ")))?;
    Ok(Exit::Done)
}

fn answer(subject: &Subject) -> Result<Answer, String> {
    let (model, structure) = (&subject.model, &subject.setup.structure);
    let first = structure.first_order(&structure.as_drawn(), 0.0).map_err(|refused| subject.refused(&refused))?;
    let nodes = model.mesh.node_of_vertex.iter().take(subject.pattern.vertices_in_file);
    let reaction = |(dof, force): &(Dof, f64)| Reaction {
        vertex: model.mesh.vertex_of_node[dof.node.index()].0,
        axis: dof.axis.name(),
        force: *force,
    };
    Ok(Answer {
        compliance: first.compliance,
        displacements: nodes.map(|node| node.map(|n| first.displacements[n.index()].to_array())).collect(),
        reactions: first.reactions.iter().map(reaction).collect(),
    })
}
