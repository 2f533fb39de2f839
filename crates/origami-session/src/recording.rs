//! A folding of which every settled state is kept, so that a page can go back and forth in it.

use std::collections::VecDeque;
use std::sync::Arc;

use origami_core::contact::Contact;
use origami_core::scene::{Scene, Targets};
use origami_core::sequence::Stage;
use origami_core::solve::{
    ContactRelax, Failed, Folded, Precision, Relax, Report, Solver, State, Steps, Stop, Touch, Touching, unwatched,
};
use origami_core::{CreasePattern, Model};

use crate::computer::relax;
use crate::export;
use crate::film::film;
use crate::message::{Crossed, ExportFormat, Recorded, Way, Wishes};
use crate::numbers::report;
use crate::packet::Packet;
use crate::refused::Refused;
use crate::sheet::Sheet;

/// Parts of a way that may be asked for.
const MOST_PARTS: u32 = 1000;
/// Places of nodes that all states may have together: some hundred megabytes.
const MOST_PLACES: usize = 1 << 22;

/// States on a way, and the one that is looked at.
pub(crate) struct Recording {
    model: Arc<Model>,
    relax: Relax,
    contact: Option<Contact>,
    ahead: Ahead,
    kept: Vec<Kept>,
    /// How many there will be.
    of: usize,
    /// The number of the state that is shown.
    at: f64,
    /// Whether that is the last there is, until another is asked for.
    follows: bool,
    changed: bool,
    ended: Option<String>,
}

/// A state.
struct Kept {
    label: String,
    folded: Folded,
    crossed: Crossed,
}

/// What is still to be folded.
enum Ahead {
    /// To these targets in turn, from a state; each with what it is called.
    Targets { scenes: VecDeque<(String, Scene)>, from: State },
    /// These stages, each in so many parts.
    Stages { stages: VecDeque<Stage>, steps: Box<Steps<Arc<Model>>>, done: usize, parts: u32 },
}

impl Recording {
    /// One that begins with the sheet at rest.
    pub(crate) fn new(
        sheet: &Sheet,
        wishes: &Wishes,
        (way, contact, parts): (Way, bool, u32),
    ) -> Result<Self, Refused> {
        if !(1..=MOST_PARTS).contains(&parts) {
            return Err(Refused::request(&format!("{parts} parts; expected 1 to {MOST_PARTS}")));
        }
        let contact = contact.then(Contact::default);
        let settings = |model: &Model, rest: &State| {
            let relax = relax(&wishes.solver, model, rest);
            if contact.is_some() { Relax { precision: Precision::F64, ..relax } } else { relax }
        };
        let (model, relax, ahead, count) = match way {
            Way::Percent(percent) => {
                let model = Arc::clone(&sheet.model);
                let part = |i: u32| {
                    let percent = percent * f64::from(i) / f64::from(parts);
                    let wishes = Wishes { percent, ..wishes.clone() };
                    sheet.check(&wishes)?;
                    Ok::<_, Refused>((format!("{} %", rounded(percent)), Scene::new(sheet.targets(&wishes))))
                };
                let scenes = (1..=parts).map(part).collect::<Result<_, _>>()?;
                let from = State::at_rest(&model);
                (Arc::clone(&model), settings(&model, &from), Ahead::Targets { scenes, from }, parts as usize)
            }
            Way::Steps => {
                let Ok(Some(order)) = &sheet.order else {
                    return Err(Refused::request("the file has no steps; expected one with `origami:sequence`"));
                };
                // Steps are the file's: no crease has a wish of its own there.
                let model = Arc::new(Model::new(&sheet.pattern, &wishes.material)?);
                let stages: VecDeque<Stage> = order.stages(&sheet.pattern, &model)?.into();
                let count = stages.len() * parts as usize;
                let rest = State::at_rest(&model);
                let relax = settings(&model, &rest);
                let steps = Steps::new(Arc::clone(&model), &relax, &rest);
                let steps = Box::new(contact.map_or(steps.clone(), |contact| steps.with_contact(contact)));
                (model, relax, Ahead::Stages { stages, steps, done: 0, parts }, count)
            }
        };
        let nodes = model.node_count().max(1);
        if count > MOST_PLACES / nodes {
            let most = MOST_PLACES / nodes;
            return Err(Refused::request(&format!("{count} states of {nodes} vertices; expected at most {most}")));
        }
        let mut recording = Self {
            model,
            relax,
            contact,
            ahead,
            kept: Vec::new(),
            of: count + 1,
            at: 0.0,
            follows: true,
            changed: true,
            ended: None,
        };
        let rest = at_rest(&recording.model);
        recording.keep(if sheet.pattern.is_flat() { "flat" } else { "as in the file" }.to_owned(), rest);
        Ok(recording)
    }

    /// Whether there is more to fold.
    pub(crate) fn has_work(&self) -> bool {
        self.ended.is_none() && self.kept.len() < self.of
    }

    /// Folds on to the next state that is kept, or through the next step.
    pub(crate) fn advance(&mut self) {
        let states = match self.next() {
            Ok(states) => states,
            Err(failed) => {
                self.ended = Some(failed.to_string());
                self.changed = true;
                return;
            }
        };
        for (label, folded, touch) in states {
            let blocked = (folded.stop == Stop::Blocked).then(|| blocked(&self.model, &label, touch.as_ref()));
            self.keep(label, folded);
            if blocked.is_some() {
                self.ended = blocked;
                break;
            }
        }
    }

    fn next(&mut self) -> Result<Vec<(String, Folded, Option<Touch>)>, Failed> {
        match &mut self.ahead {
            Ahead::Targets { scenes, from } => {
                let Some((label, scene)) = scenes.pop_front() else { return Ok(Vec::new()) };
                let relax = self.relax.clone();
                let (folded, touch) = match self.contact {
                    None => (relax.fold(&self.model, from, &scene, &mut unwatched)?, None),
                    Some(contact) => {
                        let solver = ContactRelax { relax, contact };
                        let (folded, touch) = solver.fold_touching(&self.model, from, &scene, &mut unwatched)?;
                        (folded, Some(touch))
                    }
                };
                if from.targets != folded.state.targets {
                    // The sheet is off every symmetry from its first move on.
                    self.relax.perturbation = 0.0;
                }
                from.clone_from(&folded.state);
                Ok(vec![(label, folded, touch)])
            }
            Ahead::Stages { stages, steps, done, parts } => {
                let Some(stage) = stages.pop_front() else { return Ok(Vec::new()) };
                let before = steps.states().len();
                steps.fold(&stage, (*done, *parts), &mut unwatched)?;
                *done += 1;
                let reached = steps.states()[before..].iter();
                Ok(reached.map(|reached| (stage.name.clone(), reached.folded.clone(), reached.touch.clone())).collect())
            }
        }
    }

    fn keep(&mut self, label: String, folded: Folded) {
        let crossed = Crossed::of(&self.model, &folded.state.positions);
        self.kept.push(Kept { label, folded, crossed });
        self.changed = true;
        if self.follows {
            self.at = self.last();
        }
    }

    #[expect(clippy::cast_precision_loss, reason = "some thousands")]
    fn last(&self) -> f64 {
        (self.kept.len() - 1) as f64
    }

    /// Shows another state.
    pub(crate) fn show(&mut self, at: f64) -> Result<(), Refused> {
        if !at.is_finite() {
            return Err(Refused::request("no state has that number"));
        }
        self.at = at.clamp(0.0, self.last());
        (self.follows, self.changed) = (false, true);
        Ok(())
    }

    /// The same state in another way.
    pub(crate) fn see_again(&mut self) {
        self.changed = true;
    }

    /// A file of the kept state that is nearest to what is shown.
    pub(crate) fn file(&self, format: ExportFormat, sheet: &Sheet) -> Result<Vec<u8>, Refused> {
        let Kept { folded, label, .. } = &self.kept[self.index(self.at.round())];
        let step = matches!(self.ahead, Ahead::Stages { .. }).then_some(label.as_str());
        let shown = (&*self.model, &folded.state, folded.percent(), step);
        Ok(export::file(format, sheet, shown, report(folded))?)
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the last")]
    fn index(&self, at: f64) -> usize {
        (at as usize).min(self.kept.len() - 1)
    }

    /// What is shown, where that is new: a state, how it is, and which. Between two states vertices go straight.
    pub(crate) fn new_to_see(&mut self) -> Option<Seen<'_>> {
        if !std::mem::take(&mut self.changed) {
            return None;
        }
        let (low, share) = (self.index(self.at.floor()), self.at.fract());
        let kept = &self.kept[self.index(self.at.round())];
        let mut state = kept.folded.state.clone();
        if share > 0.0 {
            let (a, b) = (&self.kept[low].folded.state.positions, &self.kept[low + 1].folded.state.positions);
            state.positions = a.iter().zip(b).map(|(a, b)| a.lerp(*b, share)).collect();
        }
        let recorded = Recorded {
            at: self.at,
            states: self.kept.len(),
            of: self.of,
            label: kept.label.clone(),
            ended: self.ended.clone(),
        };
        let crossed = (share == 0.0).then(|| kept.crossed.clone());
        Some(Seen {
            model: &self.model,
            state,
            report: report(&kept.folded),
            percent: kept.folded.percent(),
            crossed,
            recorded,
        })
    }

    /// All of it as a page of its own.
    pub(crate) fn film(&self, name: &str, title: Option<String>, pattern: &CreasePattern) -> Result<Packet, Refused> {
        if self.has_work() {
            return Err(Refused::request("the film is not at its end; expected all states to be there"));
        }
        let labels: Vec<String> = self.kept.iter().map(|kept| kept.label.clone()).collect();
        let states: Vec<Folded> = self.kept.iter().map(|kept| kept.folded.clone()).collect();
        Ok(film((name, title), pattern, &self.model, &states, &labels))
    }
}

/// A picture of a recording.
pub(crate) struct Seen<'a> {
    pub(crate) model: &'a Model,
    pub(crate) state: State,
    pub(crate) report: Report,
    pub(crate) percent: Option<f64>,
    pub(crate) crossed: Option<Crossed>,
    pub(crate) recorded: Recorded,
}

/// The sheet before anything was asked of it.
fn at_rest(model: &Model) -> Folded {
    Folded {
        state: State::at_rest(model),
        targets: Targets::percent(0.0),
        stop: Stop::Converged,
        steps: 0,
        time_step: 0.0,
        residual: 0.0,
        distance: 0.0,
        attempts: 1,
        saddles: 0,
        factorisations: 0,
        reactions: Vec::new(),
    }
}

/// What is told of a sheet that contact holds up.
fn blocked(model: &Model, label: &str, touch: Option<&Touch>) -> String {
    let mut text = format!("Held up at {label}: paper lies in the way of paper");
    let Some(touch) = touch else { return text };
    if let Some(pressing) = touch.pressing.first() {
        let [one, other] = pressing.faces;
        text += &format!("; faces {} and {} press on each other the hardest", one.0, other.0);
    }
    if let Some((crease, off)) = touch.farthest {
        let edge = model.mesh.sides[model.creases[crease.index()].side.index()]
            .edge
            .map(|edge| format!(", edge {},", edge.0))
            .unwrap_or_default();
        text += &format!("; a crease{edge} is {:.0}° off", off.to_degrees());
    }
    text + "."
}

/// To a tenth, as short as it is read.
fn rounded(percent: f64) -> f64 {
    (10.0 * percent).round() / 10.0
}
