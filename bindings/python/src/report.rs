//! What was built, done and measured, by the keys of `docs/REPORT.md`, which the command line has too.

use origami::Warning;
use origami::error::WarningCode;
use origami::measure::{Strain, Summary, angle_error, crushed, folded_warnings, scene_warnings};
use origami::solve::{Folded, Stop};
use serde_json::{Map, Value, json};

use crate::model::Sheet;
use crate::notes::notes;
use crate::run::Run;

/// The report of one sheet.
pub(crate) fn report(sheet: &Sheet, folded: &Folded, run: &Run) -> Value {
    let model = &sheet.model;
    let pattern = sheet.pattern();
    let paper = pattern.paper();
    let built: Vec<Value> = run.built.iter().map(|(what, count)| json!({"what": what, "count": count})).collect();
    let left_out = run.left_out.iter();
    let left_out: Vec<Value> =
        left_out.map(|(what, count, why)| json!({"what": what, "count": count, "why": why})).collect();
    let mut report = json!({
        "input": sheet.input,
        "solver": run.solver,
        "from": run.from,
        "backend": if run.adapter.is_some() { "gpu" } else { "cpu" },
        // Nothing is chosen here.
        "backend_by": "asked",
        "adapter": run.adapter,
        "vertices": model.node_count(),
        "beams": model.beams.len(),
        "creases": model.creases.len(),
        "faces": pattern.faces.len(),
        "paper": {"pieces": paper.pieces, "area": paper.area, "lost": paper.lost},
        "triangles": model.mesh.triangles.len(),
        "built": built,
        "left_out": left_out,
        "warnings": notes(&warnings(sheet, folded)),
        "precision": run.precision,
        "tolerance": run.tolerance,
        "attitude": run.attitude(pattern),
    });
    if let Value::Object(report) = &mut report {
        report.extend(measured(sheet, folded));
        let [read, understood] = sheet.read.seconds;
        let build = understood + sheet.seconds;
        report.insert("outputs".into(), json!([]));
        report.insert(
            "seconds".into(),
            json!({"read": read, "build": build, "solve": run.seconds, "write": 0.0, "draw": 0.0}),
        );
    }
    report
}

/// How the state was reached and what it is like.
pub(crate) fn measured(sheet: &Sheet, folded: &Folded) -> Map<String, Value> {
    let strain = Strain::of(&sheet.model, &folded.state.positions);
    let energy = folded.state.energy(&sheet.model);
    let angles = angle_error(&folded.state);
    let tangled = folded.state.tangled_creases();
    let measured = json!({
        "percent": folded.percent(),
        "time_step": folded.time_step,
        "steps": folded.steps,
        "converged": folded.converged(),
        "stop": ending(folded.stop),
        "attempts": folded.attempts,
        "saddles": folded.saddles,
        "factorisations": folded.factorisations,
        "residual": folded.residual,
        "distance": folded.distance,
        "strain": statistics(strain.beams),
        "nodes_strain": statistics(strain.nodes),
        "energy": {
            "beams": energy.beams,
            "creases": energy.creases,
            "corner_angles": energy.corner_angles,
            "areas": energy.areas,
            "total": energy.total(),
        },
        "angle_error_deg": {"mean": angles.mean, "max": angles.max},
        "tangled": tangled > 0,
        "tangled_creases": tangled,
    });
    if let Value::Object(measured) = measured { measured } else { Map::new() }
}

pub(crate) fn statistics(summary: Summary) -> Value {
    json!({"mean": summary.mean, "rms": summary.rms, "max": summary.max})
}

/// Why a solver stopped.
pub(crate) fn ending(stop: Stop) -> &'static str {
    match stop {
        Stop::Converged => "converged",
        Stop::StepsDone => "steps_done",
        Stop::Crushed => "crushed",
        Stop::Cancelled => "cancelled",
        Stop::Blocked => "blocked",
        _ => "step_limit",
    }
}

/// What was odd in the file, what is dangerous in the scene, and what went wrong.
pub(crate) fn warnings(sheet: &Sheet, folded: &Folded) -> Vec<Warning> {
    let (pattern, model) = (sheet.pattern(), &*sheet.model);
    let percents: Vec<f64> = folded.percent().into_iter().collect();
    let mut of_scene = scene_warnings(model, &percents);
    of_scene.iter_mut().for_each(|warning| pattern.name_sources(warning));
    let mut at_the_end = folded_warnings(pattern, model, folded);
    let limited = matches!(folded.stop, Stop::StepLimit | Stop::Crushed);
    if limited && !at_the_end.iter().any(|warning| warning.code == WarningCode::CrushedTriangle) {
        at_the_end.extend(crushed(model, &folded.state.positions));
    }
    pattern.warnings.iter().cloned().chain(of_scene).chain(at_the_end).collect()
}
