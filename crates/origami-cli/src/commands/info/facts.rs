//! What can be said of a file without folding it. docs/REPORT.md documents the keys.

use std::borrow::Cow;
use std::collections::BTreeMap;

use origami::fold::{Document, Frame};
use origami::model::{Material, Model};
use origami::pattern::{self, CreasePattern, JoinedTo};
use origami::solve::{Integrator, time_step};
use origami::{Error, Warning};
use serde::Serialize;
use serde_json::Value;

use super::check::{self, CheckedFrame};
use super::flat::FlatFacts;
use crate::args::InfoArgs;
use crate::files::{Input, Opened};
use crate::report::{Note, PaperFacts, SceneFacts};
use crate::settings::scene_warnings;

/// All of it; parts that could not be reached are absent.
#[derive(Debug, Default, Serialize)]
pub(super) struct Facts {
    pub(super) input: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) file: Option<File>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) pattern: Option<Pattern>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) flat: Option<FlatFacts>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) model: Option<ModelFacts>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) check: Option<Vec<CheckedFrame>>,
    pub(super) warnings: Vec<Note>,
    #[serde(skip)]
    pub(super) spoken_warnings: Vec<Warning>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) error: Option<String>,
}

/// As written in the file.
#[derive(Debug, Serialize)]
pub(super) struct File {
    pub(super) format: String,
    pub(super) spec: Option<Value>,
    pub(super) creator: Option<Value>,
    pub(super) title: Option<Value>,
    pub(super) frames: usize,
    pub(super) frame: usize,
    pub(super) vertices: usize,
    pub(super) edges: Option<usize>,
    pub(super) faces: Option<usize>,
    pub(super) letters: Option<BTreeMap<Cow<'static, str>, usize>>,
}

/// What it was read as.
#[derive(Debug, Serialize)]
pub(super) struct Pattern {
    pub(super) vertices: usize,
    pub(super) edges: usize,
    pub(super) letters: BTreeMap<&'static str, usize>,
    pub(super) faces: usize,
    pub(super) flat: bool,
    pub(super) size: f64,
    pub(super) fixed: usize,
    pub(super) paper: PaperFacts,
    pub(super) joins: Vec<Join>,
}

/// A near miss that was joined.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Join {
    vertex: u32,
    with: With,
    distance: f64,
    border: bool,
}

/// What it was joined to.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
enum With {
    Vertex(u32),
    Edge(u32),
    Other,
}

impl From<&pattern::Join> for Join {
    fn from(join: &pattern::Join) -> Self {
        let with = match join.with {
            JoinedTo::Vertex(vertex) => With::Vertex(vertex.0),
            JoinedTo::Edge(edge) => With::Edge(edge.0),
            _ => With::Other,
        };
        Self { vertex: join.vertex.0, with, distance: join.distance, border: join.border }
    }
}

/// What a model of it would hold.
#[derive(Debug, Serialize)]
pub(super) struct ModelFacts {
    #[serde(flatten)]
    pub(super) scene: SceneFacts,
    pub(super) time_step: TimeSteps,
}

/// In units of the model's time.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct TimeSteps {
    pub(super) paper: f64,
    pub(super) safe: f64,
}

impl Facts {
    pub(super) fn gather(input: &Input, args: &InfoArgs, material: &Material) -> Self {
        let mut facts = Self { input: input.to_string(), ..Self::default() };
        if let Err(error) = facts.look(input, args, material) {
            facts.error = Some(input.describe(&error));
        }
        facts.warnings = facts.spoken_warnings.iter().map(Note::from).collect();
        facts
    }

    fn look(&mut self, input: &Input, args: &InfoArgs, material: &Material) -> Result<(), Error> {
        let Opened { document, format } = input.open()?;
        self.spoken_warnings.extend_from_slice(&document.warnings);
        let index = args.frame.map_or_else(|| document.pattern_frame(), Ok)?;
        let frame = document.frame(index)?;
        self.file = Some(File::of(&document, format, index, &frame));
        let reading = pattern::Reading::joining(document.join);
        let pattern = CreasePattern::from_frame_with(&frame, &reading)?;
        self.spoken_warnings.extend_from_slice(&pattern.warnings);
        self.pattern = Some(Pattern::of(&pattern));
        self.flat = Some(FlatFacts::of(&pattern));
        let model = Model::new(&pattern, material)?;
        self.spoken_warnings.extend(scene_warnings(&pattern, &model, &[100.0], None));
        let steps = TimeSteps {
            paper: time_step::paper(&model),
            safe: time_step::safe(&model, &model.rest, Integrator::Euler),
        };
        self.model =
            Some(ModelFacts { scene: SceneFacts::new(&pattern, &model, &model.inventory, &[]), time_step: steps });
        self.check = args.check.then(|| check::frames(&document, index, &model));
        Ok(())
    }
}

impl File {
    fn of(document: &Document, format: String, index: usize, frame: &Frame) -> Self {
        let letters = frame.edges_assignment.as_ref().map(|letters| {
            let mut counts = BTreeMap::new();
            letters.iter().for_each(|letter| *counts.entry(letter.clone()).or_default() += 1);
            counts
        });
        let title = frame.extra.get("frame_title").or_else(|| document.metadata.get("file_title"));
        Self {
            format,
            spec: document.spec.clone(),
            creator: document.metadata.get("file_creator").cloned(),
            title: title.cloned(),
            frames: document.frame_count(),
            frame: index,
            vertices: frame.vertices_coords.as_ref().map_or(0, Vec::len),
            edges: frame.edges_vertices.as_ref().map(Vec::len),
            faces: frame.faces_vertices.as_ref().map(Vec::len),
            letters,
        }
    }
}

impl Pattern {
    fn of(pattern: &CreasePattern) -> Self {
        let mut letters = BTreeMap::new();
        for edge in pattern.edges.iter().filter(|edge| edge.alias_of.is_none()) {
            *letters.entry(edge.assignment.letter()).or_default() += 1;
        }
        Self {
            vertices: pattern.alias_of.iter().filter(|alias| alias.is_none()).count(),
            edges: letters.values().sum(),
            letters,
            faces: pattern.faces.len(),
            flat: pattern.is_flat(),
            size: pattern.size(),
            fixed: pattern.fixed.len(),
            paper: PaperFacts::of(pattern),
            joins: pattern.joins.iter().map(Join::from).collect(),
        }
    }
}
