//! The points of a path as a table and as a plot.

use std::fmt::Write;

use origami::Model;
use origami::analysis::job::Setup;
use origami::analysis::{Event, Point, Trace};
use origami::study::{Axis, Mark, Plot, Scale, Series};

/// CSV (RFC 4180) with a line of keys; numbers read back as the same bits. Reactions are those of moved supports, by vertex of
/// the file and axis.
pub(super) fn csv(setup: &Setup, model: &Model, trace: &Trace) -> String {
    let structure = &setup.structure;
    let mut text = String::from("step,event,load_factor");
    // Writing to a string cannot fail.
    for (vertex, dof) in &setup.monitors {
        let _ = write!(text, ",u_{vertex}_{}", dof.axis.name());
    }
    for (dof, _) in &structure.supports.moved {
        let vertex = model.mesh.vertex_of_node[dof.node.index()];
        let _ = write!(text, ",reaction_{}_{}", vertex.0, dof.axis.name());
    }
    text.push_str(",energy_bars,energy_creases,energy_facets,energy_corners,energy_total,work,negative");
    text.push_str(",nearest_eigenvalue,residual,arc\r\n");
    for (step, point) in trace.points.iter().enumerate() {
        let _ = write!(text, "{step},{},{}", point.event.name(), point.load_factor);
        for (_, dof) in &setup.monitors {
            let _ = write!(text, ",{}", point.displacement(&structure.nodes, *dof));
        }
        for (dof, _) in &structure.supports.moved {
            let own = point.reactions.iter().find(|(held, _)| held == dof).map_or(0.0, |(_, force)| *force);
            let _ = write!(text, ",{own}");
        }
        let Point { energies, work, negative, nearest_eigenvalue, residual, arc, .. } = point;
        let _ = write!(text, ",{},{},{},{}", energies.bars, energies.creases, energies.facets, energies.corners);
        let _ = write!(text, ",{},{work},{negative},{nearest_eigenvalue},{residual:e},{arc}\r\n", energies.total());
    }
    text
}

/// Load factor over the first displacement that is shown: whole where stable, dashed where not.
pub(super) fn svg(setup: &Setup, trace: &Trace, input: &str) -> Result<String, String> {
    let at = |point: &Point| {
        let displacement = setup.monitors.first().map(|(_, dof)| point.displacement(&setup.structure.nodes, *dof));
        (displacement.unwrap_or(point.arc), point.load_factor)
    };
    let mut series: Vec<Series> = Vec::new();
    for (i, point) in trace.points.iter().enumerate() {
        let stable = point.negative == 0;
        let (label, mark) = if stable { ("stable", Mark::Line) } else { ("unstable", Mark::Dashed) };
        match series.last_mut().filter(|last| last.mark == mark) {
            Some(last) => last.points.push(at(point)),
            None => {
                // Joined to the piece before it.
                let before = i.checked_sub(1).map(|i| at(&trace.points[i]));
                let points = before.into_iter().chain([at(point)]).collect();
                series.push(Series { label: label.to_owned(), mark, points });
            }
        }
    }
    let marked = |label: &str, is: fn(&Event) -> bool| {
        let points: Vec<(f64, f64)> = trace.points.iter().filter(|point| is(&point.event)).map(at).collect();
        (!points.is_empty()).then(|| Series { label: label.to_owned(), mark: Mark::Points, points })
    };
    series.extend(marked("limit point", |event| matches!(event, Event::LimitPoint { .. })));
    series.extend(marked("bifurcation", |event| matches!(event, Event::Bifurcation { .. })));
    series.extend(marked("without load", |event| *event == Event::ZeroLoad));
    let displacement = match setup.monitors.first() {
        Some((vertex, dof)) => format!("displacement of vertex {vertex} along {} ({})", dof.axis.name(), setup.length),
        None => format!("length of the path ({})", setup.length),
    };
    let axis = |label: String| Axis { label, scale: Scale::Linear };
    let plot = Plot {
        title: format!("Path of {input}"),
        note: format!("bars {}, lengths in {}, forces in {}", setup.bar_law().name(), setup.length, setup.force),
        x: axis(displacement),
        y: axis("load factor".to_owned()),
        series,
    };
    plot.svg().map_err(|error| error.to_string())
}
