//! Accordions of thick paper: how high they come out, however their panels are cut into triangles.

use origami_core::contact::Contact;
use origami_core::fold::Document;
use origami_core::glam::DVec3;
use origami_core::ids::VertexId;
use origami_core::{CreasePattern, Material, Model, Relax, Scene, State};
use serde_json::json;

use super::asked::Asked;
use super::found::Found;
use super::watched::{Watched, solver, watched};
use crate::StudyError;
use crate::table::{Cell, Column, Table, column};

/// How many panels, and how thick paper is, in radii.
const PANELS: [usize; 4] = [4, 8, 12, 16];
const QUICK_PANELS: [usize; 1] = [8];
const THICKNESSES: [f64; 2] = [0.002, 0.004];

/// An accordion of so many panels of 1 x 1.5, mountains and valleys in turn. Its creases are slanted by a ten thousandth, so
/// that all diagonals by which panels are cut are parallel, or those of neighbours mirrored.
fn accordion(panels: usize, mirrored: bool) -> Result<Model, StudyError> {
    let slant = |line: usize| match (mirrored, line % 2) {
        (false, _) => 1e-4,
        (true, 0) => 1e-4 * line as f64,
        (true, _) => -1e-4 * line as f64,
    };
    let vertices: Vec<[f64; 2]> =
        (0..=panels).flat_map(|line| [[line as f64, 0.0], [line as f64 + slant(line), 1.5]]).collect();
    let fold = |line: usize| if line.is_multiple_of(2) { "V" } else { "M" };
    let mut edges: Vec<[usize; 2]> = (0..=panels).map(|line| [2 * line, 2 * line + 1]).collect();
    let mut letters: Vec<&str> = (0..=panels).map(|line| if line % panels == 0 { "B" } else { fold(line) }).collect();
    edges.extend((0..panels).flat_map(|k| [[2 * k, 2 * k + 2], [2 * k + 3, 2 * k + 1]]));
    letters.extend((0..2 * panels).map(|_| "B"));
    let faces: Vec<[usize; 4]> = (0..panels).map(|k| [2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1]).collect();
    let text = json!({
        "vertices_coords": vertices, "edges_vertices": edges, "edges_assignment": letters, "faces_vertices": faces,
    });
    let pattern = CreasePattern::from_document(&Document::from_slice(text.to_string().as_bytes())?, 0)?;
    Ok(Model::new(&pattern, &Material::default())?)
}

/// How far apart the centroids of the first and the last panel are along the stack, in radii.
fn height(model: &Model, state: &State, panels: usize) -> Option<f64> {
    let at = |vertex: usize| model.node(VertexId::new(vertex)).map(|node| state.positions[node.index()]);
    let centroid = |panel: usize| {
        let corners: Option<Vec<DVec3>> = (2 * panel..2 * panel + 4).map(at).collect();
        Some(corners?.into_iter().sum::<DVec3>() / 4.0)
    };
    // The stack is along the normal of its panels.
    let normal = (at(2)? - at(0)?).cross(at(1)? - at(0)?).normalize();
    Some((centroid(panels - 1)? - centroid(0)?).dot(normal).abs())
}

const COLUMNS: &[Column] = &[
    column("panels", "panels", "of the accordion, n"),
    column("thickness", "T (radii)", "the thickness of its paper"),
    column(
        "parallel",
        "height, parallel cuts",
        "between the centroids of the first and the last panel, over (n - 1) T",
    ),
    column("mirrored", "mirrored cuts", "the same of panels that are cut along mirrored diagonals"),
    column("evaluations", "evaluations", "of both"),
    column("crossings", "crossings", "of both, at every tenth evaluation and at the end"),
    column("end", "end", "of both"),
];

pub(super) fn study(quick: bool) -> Result<Found, StudyError> {
    let panels: &[usize] = if quick { &QUICK_PANELS } else { &PANELS };
    let mut table = Table::new(COLUMNS);
    let (mut off, mut apart, mut crossed) = (0.0_f64, 0.0_f64, 0);
    for &panels in panels {
        for thickness in THICKNESSES {
            let mut both = Vec::new();
            for mirrored in [false, true] {
                let model = accordion(panels, mirrored)?;
                let solver = solver(Relax::default().perturbation, Contact::thick(thickness));
                let came = watched(&model, &solver, &[Scene::percent(100.0)]).ok();
                let height = came.as_ref().and_then(|came| height(&model, &came.folded.state, panels));
                both.push((came, height.map_or(f64::NAN, |height| height / ((panels - 1) as f64 * thickness))));
            }
            let heights: Vec<f64> = both.iter().map(|(_, height)| *height).collect();
            // What is no number is as bad as can be.
            off = heights.iter().fold(off, |off, height| worse(off, (height - 1.0).abs()));
            apart = worse(apart, (heights[0] - heights[1]).abs());
            let crossings: usize = both.iter().filter_map(|(came, _)| Some(came.as_ref()?.crossings)).sum();
            crossed += crossings;
            let ends: Vec<&str> = both.iter().map(|(came, _)| came.as_ref().map_or("no end", Watched::stop)).collect();
            table.push(vec![
                panels.into(),
                thickness.into(),
                heights[0].into(),
                heights[1].into(),
                both.iter().filter_map(|(came, _)| Some(came.as_ref()?.evaluations)).sum::<u64>().into(),
                crossings.into(),
                if ends[0] == ends[1] { Cell::from(ends[0]) } else { ends.join(", ").into() },
            ]);
        }
    }
    let asked = vec![
        Asked::at_most("accordions: height, off (n - 1) T (%)", 5.0, 100.0 * off),
        Asked::at_most("accordions: cuts, apart (%)", 1.0, 100.0 * apart),
        Asked::that("accordions: crossings", "none", crossed.to_string(), crossed == 0),
    ];
    Ok(Found::one("Accordions of thick paper", ABOUT, ("contact-accordions", table), asked))
}

fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

const ABOUT: &str = "Panels of 1 x 1.5 with a thickness, folded to 100 % and cut into triangles in two ways.";
