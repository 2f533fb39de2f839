//! Motions to the flat-folded state, found backwards from there: for which patterns there is one, and what it is like.

use std::num::NonZeroUsize;
use std::time::Instant;

use origami_core::contact::Crossings;
use origami_core::generate::catalog;
use origami_core::solve::{Backwards, Failed, Motion, NotBackwards, unwatched};
use origami_core::{CreasePattern, Material, Model, Relax};

use crate::options::Deadline;
use crate::table::{Cell, Column, Table, column};
use crate::{Options, Part, Study, StudyError, Watch};

/// Vertices of the largest generated pattern: those of more take minutes.
const MOST_VERTICES: usize = 60;
/// Stages under contact.
const STAGES: u32 = 6;

const COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("vertices", "vertices", "of the sheet"),
    column("triangles", "triangles", "of the sheet"),
    column("found", "found", "whether there is a motion, or what is in the way of one"),
    column("crossings", "crossings", "of all its states, by the exact test"),
    column("states", "states", "of the motion"),
    column("off_deg", "off (degrees)", "the farthest crease from flat in the last state but one"),
    column("last_move", "last move (radii)", "the farthest that a vertex goes from there to the flat state"),
    column("evaluations", "evaluations", "of all attempts"),
    column("seconds", "seconds", "on one thread"),
];

/// Runs the study on [`Options::patterns`], or on those of up to 60 vertices that the generators make; patterns without a flat-folded state are left
/// out, and those that there is no time for are named.
///
/// # Errors
/// Where a pattern makes no model.
pub fn study(options: &Options, watch: &mut dyn Watch) -> Result<Study, StudyError> {
    let deadline = Deadline::after(options.time_limit);
    let mut patterns: Vec<(String, CreasePattern)> = options.patterns.clone();
    if patterns.is_empty() {
        for name in catalog::names() {
            let pattern = catalog::generate(name, &[])?;
            if pattern.vertices.len() <= MOST_VERTICES {
                patterns.push(((*name).to_owned(), pattern));
            }
        }
    }
    watch.begins(patterns.len());
    let (mut table, mut left_out, mut found) = (Table::new(COLUMNS), Vec::new(), 0);
    // One after the other: their time is measured.
    for (name, pattern) in &patterns {
        let model = Model::new(pattern, &Material::default())?;
        if deadline.passed() {
            left_out.push(name.as_str());
        } else if let Some(row) = row(name, &model, &mut found) {
            table.push(row);
        }
        watch.ran(name);
    }
    let counts =
        format!("A motion was found for {found} of {} patterns that have a flat-folded state.", table.rows.len());
    let mut parts = vec![Part::Text(ABOUT.into()), Part::Text(counts)];
    if !left_out.is_empty() {
        parts.push(Part::Text(format!("There was no time for {}.", left_out.join(", "))));
    }
    let shown = COLUMNS.iter().map(|column| column.key).collect();
    parts.push(Part::Table { file: "backwards-patterns".into(), table, shown });
    Ok(Study { name: "backwards", title: "Folding backwards: motions found from the flat-folded state".into(), parts })
}

const ABOUT: &str = "The flat-folded state is constructed, an order of its layers is found, and the sheet is opened from there \
    under contact. The motion is that played forwards; its last state is exactly flat. *Crossings* are edges that go through \
    triangles in any of its states.";

/// What came of a pattern; `None` where it has no flat-folded state.
fn row(name: &str, model: &Model, found: &mut usize) -> Option<Vec<Cell>> {
    let relax = Relax { threads: NonZeroUsize::new(1), ..Relax::default() };
    let began = Instant::now();
    let motion = Backwards { relax, ..Backwards::default() }.fold(model, STAGES, &mut unwatched);
    let seconds = began.elapsed().as_secs_f64();
    let (told, motion) = match motion {
        Ok(motion) => ("yes".to_owned(), Some(motion)),
        Err(NotBackwards::Failed(Failed::Refused { .. })) => return None,
        Err(why) => (why.to_string(), None),
    };
    *found += usize::from(motion.is_some());
    let motion = motion.as_ref();
    let crossings = |motion: &Motion| -> usize {
        let of = |state: &origami_core::State| Crossings::of(&model.mesh, &state.positions).all.len();
        motion.states.iter().map(|folded| of(&folded.state)).sum()
    };
    Some(vec![
        name.into(),
        model.node_count().into(),
        model.mesh.triangles.len().into(),
        told.as_str().into(),
        motion.map(crossings).into(),
        motion.map(|motion| motion.states.len()).into(),
        motion.map(|motion| motion.off.to_degrees()).into(),
        motion.and_then(last_move).into(),
        motion.map(|motion| motion.evaluations).into(),
        seconds.into(),
    ])
}

/// How far the farthest vertex goes from the last state but one to the flat one.
fn last_move(motion: &Motion) -> Option<f64> {
    let [.., before, flat] = &motion.states[..] else { return None };
    let moves = before.state.positions.iter().zip(&flat.state.positions).map(|(from, to)| from.distance(*to));
    Some(moves.fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_is_found_for_a_twist_and_none_sought_for_what_is_not_flat() {
        let named = |name: &str| (name.to_owned(), catalog::generate(name, &[]).expect(name));
        let patterns = vec![named("square-twist"), named("hypar")];
        let study = study(&Options { patterns, ..Options::default() }, &mut ()).expect("they make models");
        let mut tables =
            study.parts.iter().filter_map(|part| if let Part::Table { table, .. } = part { Some(table) } else { None });
        let rows = &tables.next().expect("a table").rows;
        let column = |key: &str| COLUMNS.iter().position(|column| column.key == key).expect(key);
        assert_eq!(rows.len(), 1);
        assert_eq!((&rows[0][column("found")], &rows[0][column("crossings")]), (&"yes".into(), &Cell::Count(0)));
    }
}
