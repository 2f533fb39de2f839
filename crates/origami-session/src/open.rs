//! A sheet that is open: what is asked of it, and how it is moved there.

use std::sync::Arc;

use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::Scene;
use origami_core::solve::{Failed, Report, State};

use crate::computer::{Computer, Mover};
use crate::message::{Own, Wishes};
use crate::refused::Refused;
use crate::sheet::{Sheet, carried};
use crate::undo::Mark;

/// Of the way to 100 %, so many per cent go by between two pictures at most: what folds in an instant is seen to fold.
const PERCENT_A_FRAME: f64 = 1.0;
/// Steps after which it is looked how far the way has gone.
const FEW_STEPS: u64 = 8;

/// A sheet that is open.
pub(crate) struct Open {
    pub(crate) sheet: Sheet,
    pub(crate) wishes: Wishes,
    mover: Box<dyn Mover>,
    pub(crate) running: bool,
    /// Steps to take whether or not it runs.
    pub(crate) owed: u64,
    /// Whether something has changed since the last picture.
    pub(crate) changed: bool,
    pace: Pace,
    /// Whether something was asked that no step has seen yet: the solver's word is of before.
    asked: bool,
    pub(crate) failed: Option<String>,
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

impl Open {
    /// A sheet in a state, of which nothing has been seen yet.
    pub(crate) fn new(
        computer: &dyn Computer,
        mut sheet: Sheet,
        wishes: Wishes,
        at: Option<(Vec<DVec3>, Vec<f64>)>,
    ) -> Result<Self, Refused> {
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
        let mover = mover(computer, &sheet, &wishes, start, false)?;
        let pace = Pace::of(100.0);
        Ok(Self { sheet, wishes, mover, running: true, owed: 0, changed: true, pace, asked: true, failed: None })
    }

    pub(crate) fn has_work(&self) -> bool {
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

    /// Takes so many steps at most; a sheet that leaves all bounds stands where it last made sense, and waits for other wishes.
    pub(crate) fn advance_or_stop(&mut self, computer: &dyn Computer, steps: u64) {
        self.changed = true;
        let Err(failed) = self.advance(steps) else { return };
        let text = format!("{failed}; a softer material or smaller steps of the hand may hold");
        let again = self.start(computer, failed.last_state().clone(), true);
        self.failed = Some(again.err().map_or(text, |error| error.text));
        (self.running, self.owed) = (false, 0);
    }

    /// The sheet, where it is something new to see: what was just asked is seen once a step was taken towards it.
    pub(crate) fn new_to_see(&mut self) -> Option<(State, Report)> {
        if !self.changed || (self.asked && self.has_work()) {
            return None;
        }
        let (report, state) = (self.report(), self.mover.state().ok()?);
        self.changed = false;
        self.pace.shown = report.ramp;
        Some((state, report))
    }

    /// The sheet as it is.
    pub(crate) fn state(&mut self) -> Result<State, Failed> {
        self.mover.state()
    }

    /// How far it has come.
    pub(crate) fn report(&self) -> Report {
        let report = self.mover.report();
        Report { settled: report.settled && !self.asked, ..report }
    }

    pub(crate) fn mark(&mut self) -> Result<Mark, Refused> {
        Ok(Mark { wishes: self.wishes.clone(), state: self.mover.state()? })
    }

    /// Begins anew from a state of the model of now. Where `stays`, the state is asked to stay as it is for the moment.
    fn start(&mut self, computer: &dyn Computer, state: State, stays: bool) -> Result<(), Refused> {
        self.mover = mover(computer, &self.sheet, &self.wishes, state, stays)?;
        self.changed = true;
        Ok(())
    }

    /// Takes other wishes from where the sheet is.
    pub(crate) fn change(&mut self, computer: &dyn Computer, wishes: Wishes) -> Result<(), Refused> {
        self.sheet.check(&wishes)?;
        let state = self.mover.state()?;
        self.go_to(computer, wishes, Some(state))
    }

    /// Takes wishes and a state of the model of now; without one the sheet is at rest.
    pub(crate) fn go_to(
        &mut self,
        computer: &dyn Computer,
        wishes: Wishes,
        state: Option<State>,
    ) -> Result<(), Refused> {
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

    pub(crate) fn fold(&mut self, percent: f64) -> Result<(), Refused> {
        let wishes = Wishes { percent, ..self.wishes.clone() };
        self.sheet.check(&wishes)?;
        self.mover.set_targets(self.sheet.targets(&wishes))?;
        let way = percent - self.wishes.percent;
        self.wishes = wishes;
        self.moved(way);
        Ok(())
    }

    pub(crate) fn crease(&mut self, computer: &dyn Computer, edges: &[u32], own: Option<Own>) -> Result<(), Refused> {
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

    pub(crate) fn grab(&mut self, node: u32) -> Result<(), Refused> {
        self.check_node(node)?;
        let position = self.position(node)?;
        self.mover.hold(NodeId(node))?;
        self.wishes.pins.insert(node, position.to_array());
        self.moved(1.0);
        Ok(())
    }

    pub(crate) fn drag(&mut self, node: u32, to: [f64; 3]) -> Result<(), Refused> {
        self.check_node(node)?;
        if !self.wishes.pins.contains_key(&node) {
            return Err(Refused::request(&format!("node {node} is not held; expected it to be grabbed before")));
        }
        self.mover.place(NodeId(node), DVec3::from_array(to))?;
        self.wishes.pins.insert(node, to);
        self.moved(1.0);
        Ok(())
    }

    pub(crate) fn release(&mut self, node: u32) -> Result<(), Refused> {
        self.check_node(node)?;
        if self.wishes.pins.remove(&node).is_some() {
            self.mover.release(NodeId(node))?;
            self.moved(1.0);
        }
        Ok(())
    }

    fn position(&mut self, node: u32) -> Result<DVec3, Refused> {
        let state = self.state()?;
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
