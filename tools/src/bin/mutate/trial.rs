//! One file through all of the program: read, cleaned, built, folded a little, written, and read again.

use origami::export;
use origami::fold::Document;
use origami::formats::{self, write};
use origami::glam::DVec3;
use origami::{CreasePattern, Material, Model, Relax, Solver};

/// How far a file came.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Reached {
    /// It was refused by its reader.
    Refused,
    /// It is lines, of which no pattern was made.
    Read,
    /// A pattern, of which no model was made.
    Cleaned,
    /// A model, which did not fold: it diverged or was refused.
    Built,
    /// It folded, as far as it was let.
    Folded,
}

/// Larger patterns are not folded: the readers are what is tried.
const NODES: usize = 3000;
/// Force evaluations of a fold.
const STEPS: u64 = 200;

/// Puts `bytes` through. An error is what must not be.
pub(crate) fn run(bytes: &[u8]) -> Result<Reached, String> {
    let document = match formats::read(bytes, None, &formats::Options::default()) {
        Ok(document) => document,
        Err(error) => return placed(&error).map(|()| Reached::Refused),
    };
    let frame = match document.pattern_frame() {
        Ok(frame) => frame,
        Err(error) => return placed(&error).map(|()| Reached::Read),
    };
    let pattern = match CreasePattern::from_document(&document, frame) {
        Ok(pattern) => pattern,
        Err(error) => return placed(&error).map(|()| Reached::Read),
    };
    finite("a vertex of the pattern", &pattern.vertices)?;
    let model = match Model::new(&pattern, &Material::default()) {
        Ok(model) => model,
        Err(error) => return placed(&error).map(|()| Reached::Cleaned),
    };
    finite("a node at rest", &model.rest)?;
    if model.node_count() > NODES {
        return Ok(Reached::Built);
    }
    let relax = Relax { max_steps: STEPS, retry: false, ..Relax::default() };
    let Ok(folded) = relax.fold_from_rest(&model, 60.0) else { return Ok(Reached::Built) };
    finite("a node of the folded sheet", &folded.state.positions)?;
    written(&document, frame, &pattern, &model, &folded)?;
    Ok(Reached::Folded)
}

/// All that is written of a folded sheet; FOLD is read again.
fn written(
    document: &Document,
    frame: usize,
    pattern: &CreasePattern,
    model: &Model,
    folded: &origami::Folded,
) -> Result<(), String> {
    let pose = export::Pose::of(model, pattern, folded);
    let form = export::folded_form(document, frame, pattern, &pose).map_err(|error| error.to_string())?;
    let mut text = Vec::new();
    form.write_to(&mut text).map_err(|error| error.to_string())?;
    let again = Document::from_slice(&text).map_err(|error| format!("what was written is not read: {error}"))?;
    if again.key_frame.edges_vertices != form.key_frame.edges_vertices {
        return Err("what was written reads back as something else".into());
    }
    if pattern.vertices.iter().all(|place| place.z == 0.0) {
        read_again(pattern)?;
    }
    let mut bytes = Vec::new();
    export::write_obj(&mut bytes, pattern, &pose.positions).map_err(|error| error.to_string())?;
    let text = String::from_utf8(bytes).map_err(|error| error.to_string())?;
    match text.split_whitespace().find(|word| ["nan", "inf", "-inf"].contains(&word.to_ascii_lowercase().as_str())) {
        Some(word) => Err(format!("{word} in an OBJ file")),
        None => Ok(()),
    }
}

/// The pattern as CP, SVG and DXF: each is read again, with as many lines.
fn read_again(pattern: &CreasePattern) -> Result<(), String> {
    let mut options = write::Options::default();
    options.joined = Some(false);
    let lines = write::strokes(pattern, None).map_err(|error| error.to_string())?.len();
    let (mut cp, mut svg, mut dxf) = (Vec::new(), Vec::new(), Vec::new());
    let written = [
        ("CP", write::cp(pattern, &options, &mut cp), &cp),
        ("SVG", write::svg(pattern, &options, &mut svg), &svg),
        ("DXF", write::dxf(pattern, &options, &mut dxf), &dxf),
    ];
    for (name, done, bytes) in written {
        done.map_err(|error| format!("{name}: {error}"))?;
        let read = formats::read(bytes, None, &formats::Options::default());
        let read = read.map_err(|error| format!("the {name} that was written is not read: {error}"))?;
        let found = read.key_frame.edges_vertices.map_or(0, |edges| edges.len());
        if found != lines {
            return Err(format!("{lines} lines were written as {name}, and {found} are read"));
        }
    }
    Ok(())
}

/// Errors are for people: none without text, none that a terminal would obey.
fn placed(error: &origami::Error) -> Result<(), String> {
    let text = error.to_string();
    match text.is_empty() || text.chars().any(|c| c.is_control() && c != '\n') {
        true => Err(format!("an error that should not be printed: {text:?}")),
        false => Ok(()),
    }
}

fn finite(what: &str, places: &[DVec3]) -> Result<(), String> {
    match places.iter().position(|place| !place.is_finite()) {
        Some(index) => Err(format!("{what} is not finite: {index}")),
        None => Ok(()),
    }
}
