//! The facts for a person.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::Value;

use super::check;
use super::facts::{Facts, File, ModelFacts, Pattern};
use crate::numbers::{self, count, grouped, short};
use crate::text::{brief, plain};

/// One line a fact, those of one kind under a heading.
pub(super) fn of(facts: &Facts) -> String {
    let mut text = format!("{}\n", plain(&facts.input));
    // Writing to a string cannot fail.
    let _ = facts.file.iter().try_for_each(|part| file(&mut text, part));
    let _ = facts.pattern.iter().try_for_each(|part| pattern(&mut text, part));
    let _ = facts.flat.iter().try_for_each(|part| part.tell(&mut text));
    let _ = facts.model.iter().try_for_each(|part| model(&mut text, part));
    let _ = facts.check.iter().try_for_each(|frames| check::tell(&mut text, frames));
    for warning in &facts.spoken_warnings {
        let _ = writeln!(text, "  warning     {}", plain(&warning.to_string()));
    }
    text
}

fn file(text: &mut String, file: &File) -> std::fmt::Result {
    let spec = file.spec.as_ref().map_or_else(|| "version not given".to_owned(), shown);
    let format = match file.format.strip_prefix("FOLD") {
        Some(packed) => format!("FOLD{}{spec}{packed}", if file.spec.is_some() { " " } else { ", " }),
        None => plain(&file.format).into_owned(),
    };
    write!(text, "  file        {format}, {}", count(file.frames, "frame", "frames"))?;
    if file.frames > 1 {
        write!(text, ", the pattern is frame {}", file.frame)?;
    }
    writeln!(text)?;
    for (name, value) in [("title", &file.title), ("creator", &file.creator)] {
        if let Some(value) = value {
            writeln!(text, "  {name:<11} {}", shown(value))?;
        }
    }
    let number =
        |n: Option<usize>, one: &str, many: &str| n.map_or_else(|| format!("no {many}"), |n| count(n, one, many));
    write!(text, "  as written  {}", count(file.vertices, "vertex", "vertices"))?;
    write!(text, ", {}", number(file.edges, "edge", "edges"))?;
    if let Some(letters) = &file.letters {
        write!(text, "{}", bracketed(letters))?;
    }
    writeln!(text, ", {}", number(file.faces, "face", "faces"))
}

fn pattern(text: &mut String, pattern: &Pattern) -> std::fmt::Result {
    let vertices = count(pattern.vertices, "vertex", "vertices");
    let edges = count(pattern.edges, "edge", "edges");
    let faces = count(pattern.faces, "face", "faces");
    let shape = if pattern.flat { "flat" } else { "in space" };
    writeln!(text, "  as read     {vertices}, {edges}{}, {faces}", bracketed(&pattern.letters))?;
    write!(text, "  sheet       {shape}, longest side {}", numbers::plain(pattern.size))?;
    if pattern.fixed > 0 {
        write!(text, ", {} fixed", count(pattern.fixed, "vertex", "vertices"))?;
    }
    let paper = pattern.paper;
    write!(text, "\n  paper       {}, area {}", count(paper.pieces, "piece", "pieces"), short(paper.area))?;
    if paper.lost > 0.0 {
        write!(text, "; {} more lies between lines and is no paper", short(paper.lost))?;
    }
    if !pattern.joins.is_empty() {
        write!(text, "; {} joined", count(pattern.joins.len(), "near miss", "near misses"))?;
    }
    writeln!(text)
}

fn model(text: &mut String, model: &ModelFacts) -> std::fmt::Result {
    let scene = &model.scene;
    writeln!(
        text,
        "  model       {}, {}, {}, {}",
        count(scene.vertices, "vertex", "vertices"),
        count(scene.beams, "beam", "beams"),
        count(scene.creases, "crease", "creases"),
        count(scene.triangles, "triangle", "triangles")
    )?;
    for built in &scene.built {
        writeln!(text, "  built       {} {}", grouped(built.count as u64), built.what)?;
    }
    for left_out in &scene.left_out {
        let number = if left_out.count > 0 { format!("{} ", grouped(left_out.count as u64)) } else { String::new() };
        writeln!(text, "  left out    {number}{}: {}", left_out.what, left_out.why)?;
    }
    let steps = model.time_step;
    writeln!(text, "  time step   paper {}, safe {}", short(steps.paper), short(steps.safe))
}

fn bracketed(letters: &BTreeMap<impl std::fmt::Display, usize>) -> String {
    if letters.is_empty() {
        return String::new();
    }
    let counts: Vec<String> =
        letters.iter().map(|(letter, count)| format!("{} {count}", brief(&letter.to_string()))).collect();
    format!(" ({})", counts.join(", "))
}

/// Text without its quotation marks, as much as a line holds.
fn shown(value: &Value) -> String {
    value.as_str().map_or_else(|| brief(&value.to_string()), brief)
}
