//! What was opened: the pattern as the file has it, and the model of what is asked of it.

use std::collections::BTreeMap;
use std::sync::Arc;

use origami_core::export::{Template, crease_pattern_document};
use origami_core::fold::Document;
use origami_core::generate::catalog;
use origami_core::ids::{EdgeId, NodeId};
use origami_core::measure::scene_warnings;
use origami_core::pattern::Assignment;
use origami_core::scene::Targets;
use origami_core::solve::State;
use origami_core::{CreasePattern, Error, Material, Model};

use crate::message::{Note, Opened, Own, Wishes};
use crate::places::note;
use crate::reading::Reading;
use crate::sequence::Order;

/// What a pattern is called.
pub(crate) struct Named {
    /// The file's name, or the generator's.
    pub(crate) name: String,
    /// What it was read from.
    pub(crate) format: String,
    /// The title in the file.
    pub(crate) title: Option<String>,
}

impl Named {
    /// The file's name without its extensions.
    pub(crate) fn stem(&self) -> &str {
        let name = self.name.rsplit(['/', '\\']).next().unwrap_or(&self.name);
        let name = name.strip_suffix(".gz").unwrap_or(name);
        name.rsplit_once('.').map_or(name, |(stem, _)| stem)
    }
}

/// A pattern and the sheet made of it.
pub(crate) struct Sheet {
    pub(crate) named: Named,
    /// As read.
    pub(crate) pattern: CreasePattern,
    /// What its exports keep of the file.
    pub(crate) template: Template,
    /// The sequence in the file, or why it is none.
    pub(crate) order: Result<Option<Order>, Error>,
    /// The model of the pattern with the wishes of now.
    pub(crate) model: Arc<Model>,
}

impl Sheet {
    /// The pattern in the bytes of a file.
    pub(crate) fn read(name: &str, bytes: &[u8], reading: &Reading, material: &Material) -> Result<Self, Error> {
        let (document, format) = reading.document(name, bytes)?;
        Self::of_document(name, format, &document, material)
    }

    /// The pattern in a document.
    pub(crate) fn of_document(
        name: &str,
        format: String,
        document: &Document,
        material: &Material,
    ) -> Result<Self, Error> {
        let frame = document.pattern_frame()?;
        let pattern = CreasePattern::from_document(document, frame)?;
        let template = Template::new(document, frame, &pattern)?;
        let title = ["frame_title", "file_title"].iter().find_map(|key| {
            let of_frame = document.key_frame.extra.get(*key).or_else(|| document.metadata.get(*key));
            of_frame.and_then(|value| value.as_str()).filter(|title| !title.trim().is_empty()).map(str::to_owned)
        });
        let model = Arc::new(Model::new(&pattern, material)?);
        let named = Named { name: name.to_owned(), format, title };
        let order = document.frame(frame).and_then(|frame| Order::of(frame, &pattern, &model));
        Ok(Self { named, pattern, template, order, model })
    }

    /// What a generator makes.
    pub(crate) fn generate(name: &str, parameters: &[(String, f64)], material: &Material) -> Result<Self, Error> {
        let pattern = catalog::generate(name, parameters)?;
        let document = crease_pattern_document(&pattern, name);
        Self::of_document(&format!("{name}.fold"), "generated".to_owned(), &document, material)
    }

    /// The pattern unfolded, as a document.
    pub(crate) fn document(&self) -> Document {
        self.template.crease_pattern(&self.pattern)
    }

    /// Whether all that the wishes name is there.
    pub(crate) fn check(&self, wishes: &Wishes) -> Result<(), Error> {
        let edges = self.pattern.edges.len();
        for (edge, own) in &wishes.creases {
            let inner = EdgeId(*edge);
            if inner.index() >= edges || self.pattern.edges[inner.index()].assignment == Assignment::Boundary {
                let expected = format!("a crease, an edge from 0 to {}", edges.saturating_sub(1));
                return Err(Error::invalid(format!("edge {edge}"), "is no crease of the pattern", expected));
            }
            if let Own::Angle(angle) = own
                && !(angle.is_finite() && angle.abs() <= 360.0)
            {
                return Err(Error::invalid(
                    format!("edge {edge}"),
                    format!("an angle of {angle}"),
                    "-360 to 360 degrees",
                ));
            }
        }
        let nodes = self.model.node_count();
        if let Some(node) = wishes.pins.keys().find(|node| NodeId(**node).index() >= nodes) {
            let expected = format!("0 to {}", nodes.saturating_sub(1));
            return Err(Error::invalid(format!("node {node}"), "is no node of the sheet", expected));
        }
        if !wishes.percent.is_finite() {
            return Err(Error::invalid("percent", format!("is {}", wishes.percent), "a finite number"));
        }
        let tolerance = wishes.solver.tolerance;
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::invalid("tolerance", format!("is {tolerance}"), "a number above 0"));
        }
        wishes.material.check()
    }

    /// The model with creases freed, or given springs by an angle of their own.
    pub(crate) fn model_for(&self, creases: &BTreeMap<u32, Own>, material: &Material) -> Result<Model, Error> {
        let mut pattern = self.pattern.clone();
        for (edge, own) in creases {
            let Some(edge) = pattern.edges.get_mut(EdgeId(*edge).index()) else { continue };
            match own {
                Own::Free => edge.fold_angle = None,
                Own::Angle(angle) => {
                    edge.fold_angle = Some(angle.to_radians());
                    if matches!(edge.assignment, Assignment::Unassigned | Assignment::Flat | Assignment::Join) {
                        edge.assignment = if *angle < 0.0 { Assignment::Mountain } else { Assignment::Valley };
                    }
                }
            }
        }
        Model::new(&pattern, material)
    }

    /// What is asked of each crease of the model of now.
    pub(crate) fn targets(&self, wishes: &Wishes) -> Targets {
        let model = &self.model;
        let own = wishes.creases.iter().filter_map(|(edge, own)| match own {
            Own::Angle(angle) => model.crease_of(EdgeId(*edge)).map(|crease| (crease, angle.to_radians())),
            Own::Free => None,
        });
        let mut own = own.peekable();
        if own.peek().is_none() {
            return Targets::percent(wishes.percent);
        }
        let mut angles = model.targets(wishes.percent);
        own.for_each(|(crease, angle)| angles[crease.index()] = angle);
        Targets::angles(angles).labelled(model, wishes.percent)
    }

    /// What a page needs to know, and the numbers behind it.
    pub(crate) fn opened(&self, wishes: &Wishes, computer: String) -> (Opened, Vec<u8>) {
        let (mut opened, body) = described(&self.named, &self.pattern, &self.model, wishes, computer);
        match &self.order {
            Ok(order) => opened.steps = order.as_ref().map(Order::names).unwrap_or_default(),
            // A pattern can be folded whatever its sequence says.
            Err(error) => {
                let (code, text) = (error.code().name(), format!("its steps cannot be folded: {error}"));
                opened.warnings.push(Note { code, text, nodes: Vec::new(), edges: Vec::new() });
            }
        }
        (opened, body)
    }
}

/// What a page needs to know of a pattern, and the numbers behind it.
pub(crate) fn described(
    named: &Named,
    pattern: &CreasePattern,
    model: &Model,
    wishes: &Wishes,
    computer: String,
) -> (Opened, Vec<u8>) {
    let mesh = &model.mesh;
    let mut warnings: Vec<Note> = pattern.warnings.iter().map(|warning| note(warning, pattern, model)).collect();
    for mut warning in scene_warnings(model, &[100.0]) {
        pattern.name_sources(&mut warning);
        warnings.push(note(&warning, pattern, model));
    }
    let mut body = Vec::new();
    for position in &model.rest {
        position.as_vec3().to_array().iter().for_each(|x| body.extend(x.to_le_bytes()));
    }
    for node in mesh.triangles.iter().flatten() {
        body.extend(node.0.to_le_bytes());
    }
    for edge in &pattern.edges {
        // An edge that is no part of the sheet is drawn as nothing: from a node to itself.
        let ends = edge.vertices.map(|vertex| model.node(vertex).map_or(0, |node| node.0));
        let ends = if edge.vertices.iter().all(|vertex| model.node(*vertex).is_some()) { ends } else { [0, 0] };
        ends.iter().for_each(|node| body.extend(node.to_le_bytes()));
    }
    for edge in &pattern.edges {
        let angle = edge.fold_angle.map_or(f64::NAN, f64::to_degrees);
        #[expect(clippy::cast_possible_truncation, reason = "for a person to read")]
        body.extend((angle as f32).to_le_bytes());
    }
    mesh.face_of_triangle.iter().for_each(|face| body.extend(face.0.to_le_bytes()));
    let opened = Opened {
        name: named.name.clone(),
        format: named.format.clone(),
        title: named.title.clone(),
        nodes: model.node_count(),
        triangles: mesh.triangles.len(),
        edges: pattern.edges.len(),
        creases: model.creases.len(),
        letters: pattern.edges.iter().map(|edge| edge.assignment.letter()).collect(),
        flat: pattern.is_flat(),
        computer,
        steps: Vec::new(),
        warnings,
        wishes: wishes.clone(),
    };
    (opened, body)
}

/// A state of one model as a state of another of the same sheet: creases keep their angles and what is asked of them, and
/// those that only now have springs begin as they are.
pub(crate) fn carried(from: &Model, state: &State, to: &Model) -> State {
    let mut carried = State::at(to, state.positions.clone());
    carried.velocities.clone_from(&state.velocities);
    let mut old = from.creases.iter().zip(state.fold_angles.iter().zip(&state.targets)).peekable();
    // Creases lie in the order of their sides in both.
    for (i, crease) in to.creases.iter().enumerate() {
        while old.next_if(|(known, _)| known.side < crease.side).is_some() {}
        if let Some((_, (angle, target))) = old.next_if(|(known, _)| known.side == crease.side) {
            (carried.fold_angles[i], carried.targets[i]) = (*angle, *target);
        }
    }
    carried
}
