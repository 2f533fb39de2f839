//! Whether layers lie as the flat-folded sheet must have them.

use origami_core::contact::Contact;
use origami_core::layers::Agreement;
use origami_core::solve::Reflect;
use origami_core::{Model, Relax, Scene, Solver};

use super::asked::Asked;
use super::found::Found;
use super::watched::{solver, watched};
use crate::table::{Cell, Column, Table, column};

/// A state farther from its angles is not folded flat, in degrees.
const FOLDED: f64 = 5.0;
/// By how much a file may miss its own flat-folded state, in radii.
const CLOSED: f64 = 1e-3;

const COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("end", "end", "of the fold to 100 % under contact"),
    column("off_deg", "off (degrees)", "the largest difference of an angle from its target"),
    column("pairs", "pairs", "of triangles that lie upon each other in the flat-folded sheet"),
    column("forced", "forced", "those whose order follows from creases and the conditions of flat folding alone"),
    column("told", "told", "those of the forced ones that the fold has apart and parallel"),
    column("differ", "differ", "those of them that lie the other way round"),
    column("faces", "which", "the faces of the first three of those"),
];

/// Of patterns that have a flat-folded state.
pub(super) fn study<'p>(patterns: impl Iterator<Item = (&'p str, Model)>) -> Found {
    let mut table = Table::new(COLUMNS);
    let (mut unique, mut whole) = (0, 0);
    for (name, model) in patterns {
        let Ok(flat) = (Reflect { tolerance: CLOSED }).fold_from_rest(&model, 100.0) else { continue };
        let solver = solver(Relax::default().perturbation, Contact::default());
        let Ok(came) = watched(&model, &solver, &[Scene::percent(100.0)]) else { continue };
        let state = &came.folded.state;
        let exact = (flat.state.positions.as_slice(), flat.state.fold_angles.as_slice());
        let Ok(agreement) = Agreement::of(&model, exact, (&state.positions, &state.fold_angles)) else { continue };
        let Agreement { pairs, forced, told, ref differ, .. } = agreement;
        let face = |t: &origami_core::ids::TriangleId| model.mesh.face_of_triangle[t.index()].0;
        let which = differ.iter().take(3).map(|[a, b]| format!("{} and {}", face(a), face(b)));
        let which: Vec<String> = which.collect();
        table.push(vec![
            name.into(),
            came.stop().into(),
            came.off.into(),
            pairs.into(),
            forced.into(),
            told.into(),
            differ.len().into(),
            if which.is_empty() { Cell::Missing } else { which.join(", ").into() },
        ]);
        if came.stop() == "converged" && came.off < FOLDED && pairs == forced {
            unique += 1;
            whole += usize::from(agreement.is_whole());
        }
    }
    let what = "layers where the order is unique and the fold within 5 degrees: patterns that agree in all pairs";
    let asked = vec![Asked::that(what, unique.to_string(), whole.to_string(), whole == unique)];
    Found::one("The order of the layers", ABOUT, ("contact-layers", table), asked)
}

const ABOUT: &str = "The flat-folded state is constructed by reflecting the faces. A pair of triangles that lie upon each other there is \
    *forced* if its order follows without a choice; the fold under contact is asked for the order of each of these. A fold may \
    look finished and have other layers: where they differ it says so.";
