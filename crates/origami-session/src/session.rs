//! What answers.

use origami_core::glam::DVec3;

use crate::catalog::catalog;
use crate::computer::Computer;
use crate::message::{MapWish, Reply, Request, Wishes};
use crate::open::Open;
use crate::packet::Packet;
use crate::refused::Refused;
use crate::sheet::Sheet;
use crate::undo::{Mark, Undo};
use crate::{export, numbers, saved};

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
        open.advance_or_stop(self.computer.as_ref(), steps);
    }

    /// The picture that was asked for, where there is something new to see.
    pub fn take_frame(&mut self) -> Option<Packet> {
        let map = self.wanted?;
        let open = self.open.as_mut()?;
        let (state, report) = open.new_to_see()?;
        self.wanted = None;
        self.frames += 1;
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
                let (report, state) = (open.report(), open.state()?);
                let bytes = export::file(format, &open.sheet, &state, open.wishes.percent, report)?;
                let name = format!("{}-folded.{}", open.sheet.named.stem(), format.extension());
                return Ok(vec![Packet::new(&Reply::File { name, media: format.media() }, bytes)]);
            }
            Request::Save => {
                let state = open.state()?;
                let bytes = saved::write(&open.sheet, &open.wishes, &state.positions, &state.fold_angles)?;
                let name = format!("{}.origami-session.json", open.sheet.named.stem());
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
        sheet: Sheet,
        wishes: Wishes,
        at: Option<(Vec<DVec3>, Vec<f64>)>,
    ) -> Result<Vec<Packet>, Refused> {
        let open = Open::new(self.computer.as_ref(), sheet, wishes, at)?;
        let (head, body) = open.sheet.opened(&open.wishes, self.computer.name());
        self.undo = Undo::default();
        self.open = Some(open);
        Ok(vec![Packet::new(&Reply::Opened(Box::new(head)), body)])
    }
}

fn wishes_of(open: &Open, undo: &Undo) -> Packet {
    let (can_undo, can_redo) = undo.can();
    Packet::new(&Reply::Wishes { wishes: open.wishes.clone(), can_undo, can_redo }, Vec::new())
}

impl std::fmt::Debug for Session {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("frames", &self.frames).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests;
