//! What answers.

use std::sync::Arc;

use origami_core::generate::catalog::{self, generate};
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::Scene;
use origami_core::solve::{Failed, Report, State};
use origami_core::{CreasePattern, Error};

use crate::computer::{Computer, Mover};
use crate::message::{CatalogEntry, CatalogParameter, Drawing, MapWish, Own, Reply, Request, Wishes};
use crate::packet::Packet;
use crate::sheet::{Sheet, carried};
use crate::undo::{Mark, Undo};
use crate::{export, numbers, saved};

/// Of the way to 100 %, so many per cent go by between two pictures at most: what folds in an instant is seen to fold.
const PERCENT_A_FRAME: f64 = 1.0;
/// Steps after which it is looked how far the way has gone.
const FEW_STEPS: u64 = 8;
/// Steps that one request may ask for.
const MOST_STEPS: u64 = 100_000;

/// One sheet and one page that looks at it.
pub struct Session {
    computer: Box<dyn Computer>,
    open: Option<Open>,
    undo: Undo,
    /// The map of a picture that was asked for and not taken yet.
    wanted: Option<MapWish>,
    frames: u64,
}

/// A sheet that is open.
struct Open {
    sheet: Sheet,
    wishes: Wishes,
    mover: Box<dyn Mover>,
    running: bool,
    /// Steps to take whether or not it runs.
    owed: u64,
    /// Whether something has changed since the last picture.
    changed: bool,
    pace: Pace,
    /// Whether something was asked that no step has seen yet: the solver's word is of before.
    asked: bool,
    failed: Option<String>,
}

/// How much of a ramp may go by between two pictures.
#[derive(Clone, Copy)]
struct Pace {
    share: f64,
    shown: f64,
}

impl Pace {
    /// For a way of so many per cent.
    fn of(percent: f64) -> Self {
        Self { share: (PERCENT_A_FRAME / percent.abs().max(1e-9)).min(1.0), shown: 0.0 }
    }
}

/// Why a request was refused.
struct Refused {
    code: String,
    text: String,
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        Self { code: error.code().name().to_owned(), text: error.to_string() }
    }
}

impl From<Failed> for Refused {
    fn from(failed: Failed) -> Self {
        Self { code: "solver".to_owned(), text: failed.to_string() }
    }
}

impl Refused {
    fn request(text: &str) -> Self {
        Self { code: "request".to_owned(), text: text.to_owned() }
    }

    fn reading(name: &str, error: &Error) -> Self {
        Self { code: error.code().name().to_owned(), text: format!("{name}: {error}") }
    }
}

impl Session {
    /// One without a sheet.
    #[must_use]
    pub fn new(computer: Box<dyn Computer>) -> Self {
        Self { computer, open: None, undo: Undo::default(), wanted: None, frames: 0 }
    }

    /// Does what is asked; `body` is what came with it.
    pub fn answer(&mut self, request: Request, body: &[u8]) -> Vec<Packet> {
        match self.answered(request, body) {
            Ok(packets) => packets,
            Err(Refused { code, text }) => vec![Packet::new(&Reply::Error { code, text }, Vec::new())],
        }
    }

    /// What a page is told of a message that cannot be understood.
    #[must_use]
    pub fn refusal(text: &str) -> Packet {
        let Refused { code, text } = Refused::request(text);
        Packet::new(&Reply::Error { code, text }, Vec::new())
    }

    /// Whether [`Session::advance`] would do something: the sheet moves, and does not wait for a picture to be taken.
    #[must_use]
    pub fn has_work(&self) -> bool {
        self.open.as_ref().is_some_and(Open::has_work)
    }

    /// Moves the sheet by so many steps at most. More: fewer pictures in a second, and later answers.
    pub fn advance(&mut self, steps: u64) {
        let Some(open) = &mut self.open else { return };
        if !open.has_work() {
            return;
        }
        open.changed = true;
        let moved = open.advance(steps);
        if let Err(failed) = moved {
            let state = failed.last_state().clone();
            let text = format!("{failed}; a softer material or smaller steps of the hand may hold");
            // It stands where it last made sense, and waits for other wishes.
            let again = open.start(self.computer.as_ref(), state, true);
            open.failed = Some(again.err().map_or(text, |error| error.text));
            (open.running, open.owed) = (false, 0);
        }
    }

    /// The picture that was asked for, where there is something new to see.
    pub fn take_frame(&mut self) -> Option<Packet> {
        let map = self.wanted?;
        // What was just asked is seen once the sheet has taken a step towards it.
        let open = self.open.as_mut().filter(|open| open.changed && !(open.asked && open.has_work()))?;
        let (report, state) = (open.report(), open.mover.state());
        let Ok(state) = state else { return None };
        self.wanted = None;
        self.frames += 1;
        open.changed = false;
        open.pace.shown = report.ramp;
        let wanted = open.sheet.targets(&open.wishes).of(&open.sheet.model).unwrap_or_default();
        let (mut head, values) = numbers::head(&open.sheet.model, &state, &wanted, report, map);
        head.frame = self.frames;
        head.percent = open.wishes.percent;
        head.running = open.running && !report.settled;
        head.failed.clone_from(&open.failed);
        Some(Packet::new(&Reply::Frame(Box::new(head)), numbers::body(&state, &values)))
    }

    fn answered(&mut self, request: Request, body: &[u8]) -> Result<Vec<Packet>, Refused> {
        match request {
            Request::Catalog => return Ok(vec![catalog()]),
            Request::Open { name } => {
                let wishes = self.kept();
                let sheet = Sheet::read(&name, body, &wishes.material);
                return self.opened(sheet.map_err(|error| Refused::reading(&name, &error))?, wishes, None);
            }
            Request::Generate { name, parameters } => {
                let wishes = self.kept();
                let sheet = Sheet::generate(&name, &parameters, &wishes.material)?;
                return self.opened(sheet, wishes, None);
            }
            Request::Restore => {
                let restored = saved::read(body)?;
                let state = Some((restored.positions, restored.fold_angles));
                return self.opened(restored.sheet, restored.wishes, state);
            }
            Request::Frame { map } => {
                let old = self.wanted.replace(map);
                if let Some(open) = &mut self.open {
                    // Another map of the same sheet is something new.
                    open.changed |= old.is_some_and(|old| old != map);
                }
                return Ok(Vec::new());
            }
            _ => {}
        }
        let Self { computer, open, undo, .. } = self;
        let Some(open) = open else { return Err(Refused::request("no pattern is open")) };
        let computer = computer.as_ref();
        match request {
            Request::Fold { percent } => open.fold(percent)?,
            Request::Crease { edges, own } => open.crease(computer, &edges, own)?,
            Request::Grab { node } => open.grab(node)?,
            Request::Drag { node, to } => open.drag(node, to)?,
            Request::Release { node } => open.release(node)?,
            Request::Material(material) => open.change(computer, Wishes { material, ..open.wishes.clone() })?,
            Request::Solver(solver) => open.change(computer, Wishes { solver, ..open.wishes.clone() })?,
            Request::Run { on } => (open.running, open.changed) = (on, true),
            Request::Step { count } => {
                (open.running, open.owed) = (false, count.min(MOST_STEPS));
                open.changed = true;
            }
            Request::Reset => {
                undo.mark(open.mark()?);
                let wishes = Wishes { material: open.wishes.material, solver: open.wishes.solver, ..Wishes::default() };
                open.go_to(computer, wishes, None)?;
                return Ok(vec![wishes_of(open, undo)]);
            }
            Request::Mark => {
                undo.mark(open.mark()?);
                let (can_undo, can_redo) = undo.can();
                return Ok(vec![Packet::new(&Reply::Marked { can_undo, can_redo }, Vec::new())]);
            }
            Request::Undo | Request::Redo => {
                let now = open.mark()?;
                let mark = if request == Request::Undo { undo.back(now) } else { undo.forward(now) };
                if let Some(Mark { wishes, state }) = mark {
                    open.go_to(computer, wishes, Some(state))?;
                }
                return Ok(vec![wishes_of(open, undo)]);
            }
            Request::Export { format } => {
                let (report, state) = (open.report(), open.mover.state()?);
                let bytes = export::file(format, &open.sheet, &state, open.wishes.percent, report)?;
                let name = format!("{}-folded.{}", stem(&open.sheet.named.name), format.extension());
                return Ok(vec![Packet::new(&Reply::File { name, media: format.media() }, bytes)]);
            }
            Request::Save => {
                let state = open.mover.state()?;
                let bytes = saved::write(&open.sheet, &open.wishes, &state.positions, &state.fold_angles)?;
                let name = format!("{}.origami-session.json", stem(&open.sheet.named.name));
                return Ok(vec![Packet::new(&Reply::File { name, media: "application/json" }, bytes)]);
            }
            Request::Catalog | Request::Open { .. } | Request::Generate { .. } | Request::Restore => {}
            Request::Frame { .. } => {}
        }
        Ok(Vec::new())
    }

    /// What another pattern keeps of the wishes.
    fn kept(&self) -> Wishes {
        let kept = self.open.as_ref().map(|open| (open.wishes.material, open.wishes.solver));
        let (material, solver) = kept.unwrap_or_default();
        Wishes { material, solver, ..Wishes::default() }
    }

    /// Opens a sheet, at rest or as it was saved.
    fn opened(
        &mut self,
        mut sheet: Sheet,
        wishes: Wishes,
        at: Option<(Vec<DVec3>, Vec<f64>)>,
    ) -> Result<Vec<Packet>, Refused> {
        sheet.check(&wishes)?;
        sheet.model = Arc::new(sheet.model_for(&wishes.creases, &wishes.material)?);
        let start = match at {
            None => State::at_rest(&sheet.model),
            Some((positions, fold_angles)) => {
                let mut state = State::at(&sheet.model, positions);
                if fold_angles.len() == state.fold_angles.len() {
                    state.targets.clone_from(&fold_angles);
                    state.fold_angles = fold_angles;
                }
                state
            }
        };
        let mover = mover(self.computer.as_ref(), &sheet, &wishes, start, false)?;
        let (head, body) = sheet.opened(&wishes, self.computer.name());
        self.undo = Undo::default();
        self.open = Some(Open {
            sheet,
            wishes,
            mover,
            running: true,
            owed: 0,
            changed: true,
            pace: Pace::of(100.0),
            asked: true,
            failed: None,
        });
        Ok(vec![Packet::new(&Reply::Opened(Box::new(head)), body)])
    }
}

impl Open {
    fn has_work(&self) -> bool {
        let report = self.report();
        let waits = report.ramp < 1.0 && report.ramp - self.pace.shown >= self.pace.share;
        self.owed > 0 || (self.running && !report.settled && !waits)
    }

    /// Takes so many steps at most. While targets rise it goes by few, so as not to pass what shall be seen.
    fn advance(&mut self, mut steps: u64) -> Result<(), Failed> {
        while steps > 0 && self.has_work() {
            let many = if self.owed > 0 { self.owed.min(steps) } else { steps };
            let few = if self.mover.report().ramp < 1.0 { many.min(FEW_STEPS) } else { many };
            self.mover.advance(few, self.owed == 0)?;
            self.asked = false;
            self.owed = self.owed.saturating_sub(few);
            steps -= few;
        }
        Ok(())
    }

    /// How far it has come.
    fn report(&self) -> Report {
        let report = self.mover.report();
        Report { settled: report.settled && !self.asked, ..report }
    }

    fn mark(&mut self) -> Result<Mark, Refused> {
        Ok(Mark { wishes: self.wishes.clone(), state: self.mover.state()? })
    }

    /// Begins anew from a state of the model of now. Where `stays`, the state is asked to stay as it is for the moment.
    fn start(&mut self, computer: &dyn Computer, state: State, stays: bool) -> Result<(), Refused> {
        self.mover = mover(computer, &self.sheet, &self.wishes, state, stays)?;
        self.changed = true;
        Ok(())
    }

    /// Takes other wishes from where the sheet is.
    fn change(&mut self, computer: &dyn Computer, wishes: Wishes) -> Result<(), Refused> {
        self.sheet.check(&wishes)?;
        let state = self.mover.state()?;
        self.go_to(computer, wishes, Some(state))
    }

    /// Takes wishes and a state of the model of now; without one the sheet is at rest.
    fn go_to(&mut self, computer: &dyn Computer, wishes: Wishes, state: Option<State>) -> Result<(), Refused> {
        let same = wishes.material == self.wishes.material && springs(&wishes) == springs(&self.wishes);
        let model = if same {
            Arc::clone(&self.sheet.model)
        } else {
            Arc::new(self.sheet.model_for(&wishes.creases, &wishes.material)?)
        };
        let state = match state {
            None => State::at_rest(&model),
            // A mark may be of a model with other springs.
            Some(state) if state.fold_angles.len() != self.sheet.model.creases.len() => {
                if state.fold_angles.len() == model.creases.len() { state } else { State::at(&model, state.positions) }
            }
            Some(state) => carried(&self.sheet.model, &state, &model),
        };
        let old = std::mem::replace(&mut self.sheet.model, model);
        match mover(computer, &self.sheet, &wishes, state, false) {
            Ok(mover) => self.mover = mover,
            Err(refused) => {
                self.sheet.model = old;
                return Err(refused);
            }
        }
        self.wishes = wishes;
        self.moved(100.0);
        Ok(())
    }

    /// Something was changed by a hand: the sheet goes a way of so many per cent.
    fn moved(&mut self, percent: f64) {
        self.pace = Pace::of(percent);
        (self.changed, self.asked) = (true, true);
        if self.failed.take().is_some() {
            self.running = true;
        }
    }

    fn fold(&mut self, percent: f64) -> Result<(), Refused> {
        let wishes = Wishes { percent, ..self.wishes.clone() };
        self.sheet.check(&wishes)?;
        self.mover.set_targets(self.sheet.targets(&wishes))?;
        let way = percent - self.wishes.percent;
        self.wishes = wishes;
        self.moved(way);
        Ok(())
    }

    fn crease(&mut self, computer: &dyn Computer, edges: &[u32], own: Option<Own>) -> Result<(), Refused> {
        let mut wishes = self.wishes.clone();
        for edge in edges {
            match own {
                Some(own) => wishes.creases.insert(*edge, own),
                None => wishes.creases.remove(edge),
            };
        }
        self.sheet.check(&wishes)?;
        if springs(&wishes) == springs(&self.wishes) {
            self.mover.set_targets(self.sheet.targets(&wishes))?;
            self.wishes = wishes;
            self.moved(10.0);
            return Ok(());
        }
        self.change(computer, wishes)
    }

    fn grab(&mut self, node: u32) -> Result<(), Refused> {
        self.check_node(node)?;
        let position = self.position(node)?;
        self.mover.hold(NodeId(node))?;
        self.wishes.pins.insert(node, position.to_array());
        self.moved(1.0);
        Ok(())
    }

    fn drag(&mut self, node: u32, to: [f64; 3]) -> Result<(), Refused> {
        self.check_node(node)?;
        if !self.wishes.pins.contains_key(&node) {
            return Err(Refused::request(&format!("node {node} is not held; expected it to be grabbed before")));
        }
        self.mover.place(NodeId(node), DVec3::from_array(to))?;
        self.wishes.pins.insert(node, to);
        self.moved(1.0);
        Ok(())
    }

    fn release(&mut self, node: u32) -> Result<(), Refused> {
        self.check_node(node)?;
        if self.wishes.pins.remove(&node).is_some() {
            self.mover.release(NodeId(node))?;
            self.moved(1.0);
        }
        Ok(())
    }

    fn position(&mut self, node: u32) -> Result<DVec3, Refused> {
        let state = self.mover.state()?;
        Ok(state.positions.get(NodeId(node).index()).copied().unwrap_or_default())
    }

    fn check_node(&self, node: u32) -> Result<(), Refused> {
        let nodes = self.sheet.model.node_count();
        if NodeId(node).index() < nodes {
            return Ok(());
        }
        Err(Refused::request(&format!(
            "node {node} is no node of the sheet; expected 0 to {}",
            nodes.saturating_sub(1)
        )))
    }
}

/// What makes springs other than the pattern's: which creases are free, and which have an angle of their own.
fn springs(wishes: &Wishes) -> Vec<(u32, bool)> {
    wishes.creases.iter().map(|(edge, own)| (*edge, *own == Own::Free)).collect()
}

/// A mover from `start`; where it `stays` nothing else is asked of it than what it was asked there.
fn mover(
    computer: &dyn Computer,
    sheet: &Sheet,
    wishes: &Wishes,
    start: State,
    stays: bool,
) -> Result<Box<dyn Mover>, Refused> {
    let targets = sheet.targets(wishes);
    let still = Scene::new(origami_core::Targets::angles(start.targets.clone()));
    let mut mover = computer.mover(&wishes.solver, Arc::clone(&sheet.model), &still, start)?;
    if !stays {
        mover.set_targets(targets)?;
    }
    for (node, position) in &wishes.pins {
        mover.hold(NodeId(*node))?;
        mover.place(NodeId(*node), DVec3::from_array(*position))?;
    }
    Ok(mover)
}

fn wishes_of(open: &Open, undo: &Undo) -> Packet {
    let (can_undo, can_redo) = undo.can();
    Packet::new(&Reply::Wishes { wishes: open.wishes.clone(), can_undo, can_redo }, Vec::new())
}

fn catalog() -> Packet {
    let entries = catalog::entries().iter().map(|entry| CatalogEntry {
        name: entry.name,
        summary: entry.summary,
        parameters: entry
            .parameters
            .iter()
            .map(|parameter| CatalogParameter {
                name: parameter.name,
                default: parameter.default,
                meaning: parameter.meaning,
            })
            .collect(),
        picture: generate(entry.name, &[]).map(|pattern| drawing(&pattern)).unwrap_or_default(),
    });
    Packet::new(&Reply::Catalog { entries: entries.collect() }, Vec::new())
}

fn drawing(pattern: &CreasePattern) -> Drawing {
    Drawing {
        points: pattern.vertices.iter().flat_map(|vertex| [vertex.x, vertex.y]).collect(),
        ends: pattern.edges.iter().flat_map(|edge| edge.vertices.map(|vertex| vertex.0)).collect(),
        letters: pattern.edges.iter().map(|edge| edge.assignment.letter()).collect(),
    }
}

/// A file's name without its extensions.
fn stem(name: &str) -> &str {
    let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let name = name.strip_suffix(".gz").unwrap_or(name);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

impl std::fmt::Debug for Session {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("frames", &self.frames).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests;
