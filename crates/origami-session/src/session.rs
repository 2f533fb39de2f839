//! What answers.

use origami_core::glam::DVec3;

use crate::catalog::catalog;
use crate::computer::Computer;
use crate::message::{Crossed, MapWish, Reply, Request, Wishes};
use crate::open::Open;
use crate::packet::Packet;
use crate::reading::Reading;
use crate::recording::{Recording, Seen};
use crate::refused::Refused;
use crate::sheet::{Named, Sheet};
use crate::undo::{Mark, Undo};
use crate::{export, numbers, saved};

/// Of sheets with so few nodes it is told while they move where they go through themselves, once in so many pictures.
const FEW_NODES: usize = 2000;
const NOW_AND_THEN: u64 = 16;
/// Steps that one request may ask for.
const MOST_STEPS: u64 = 100_000;

/// One sheet and one page that looks at it.
pub struct Session {
    computer: Box<dyn Computer>,
    open: Option<Open>,
    /// What was recorded of the sheet, while that is looked at.
    recording: Option<Recording>,
    undo: Undo,
    reading: Reading,
    /// Whether a picture was asked for and not taken yet.
    wanted: bool,
    /// The map of the last that was asked for.
    map: Option<MapWish>,
    frames: u64,
}

impl Session {
    /// One without a sheet.
    #[must_use]
    pub fn new(computer: Box<dyn Computer>) -> Self {
        let (undo, reading) = (Undo::default(), Reading::default());
        Self { computer, open: None, recording: None, undo, reading, wanted: false, map: None, frames: 0 }
    }

    /// The same, which reads files so.
    #[must_use]
    pub fn reading(self, reading: Reading) -> Self {
        Self { reading, ..self }
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
        self.open.as_ref().is_some_and(|open| match &self.recording {
            Some(recording) => open.running && recording.has_work(),
            None => open.has_work(),
        })
    }

    /// Moves the sheet by so many steps at most; what is recorded goes on by one state, or one step of a sequence. More: fewer
    /// pictures in a second, and later answers.
    pub fn advance(&mut self, steps: u64) {
        if !self.has_work() {
            return;
        }
        match (&mut self.open, &mut self.recording) {
            (Some(_), Some(recording)) => recording.advance(),
            (Some(open), None) => open.advance_or_stop(self.computer.as_ref(), steps),
            (None, _) => {}
        }
    }

    /// The picture that was asked for, where there is something new to see.
    pub fn take_frame(&mut self) -> Option<Packet> {
        let map = self.map.filter(|_| self.wanted)?;
        let open = self.open.as_mut()?;
        let (mut head, body) = match &mut self.recording {
            Some(recording) => {
                let running = open.running && recording.has_work();
                let Seen { model, state, report, percent, crossed, recorded } = recording.new_to_see()?;
                let (mut head, values) = numbers::head(model, &state, &state.targets, report, map);
                head.percent = percent.unwrap_or_default();
                (head.running, head.crossings, head.recorded) = (running, crossed, Some(recorded));
                (head, numbers::body(&state, &values))
            }
            None => {
                let (state, report) = open.new_to_see()?;
                let wanted = open.sheet.targets(&open.wishes).of(&open.sheet.model).unwrap_or_default();
                let (mut head, values) = numbers::head(&open.sheet.model, &state, &wanted, report, map);
                head.percent = open.wishes.percent;
                head.running = open.running && !report.settled;
                head.failed.clone_from(&open.failed);
                let small = open.sheet.model.node_count() <= FEW_NODES && self.frames.is_multiple_of(NOW_AND_THEN);
                if !head.running || small {
                    head.crossings = Some(Crossed::of(&open.sheet.model, &state.positions));
                }
                (head, numbers::body(&state, &values))
            }
        };
        self.wanted = false;
        self.frames += 1;
        head.frame = self.frames;
        Some(Packet::new(&Reply::Frame(Box::new(head)), body))
    }

    fn answered(&mut self, request: Request, body: &[u8]) -> Result<Vec<Packet>, Refused> {
        match request {
            Request::Catalog => return Ok(vec![catalog()]),
            Request::Open { name } => {
                let wishes = self.kept();
                let sheet = Sheet::read(&name, body, &self.reading, &wishes.material);
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
                // Another map of the same sheet is something new.
                if self.map.replace(map).is_some_and(|old| old != map) {
                    self.open.iter_mut().for_each(|open| open.changed = true);
                    self.recording.iter_mut().for_each(Recording::see_again);
                }
                self.wanted = true;
                return Ok(Vec::new());
            }
            _ => {}
        }
        let Self { computer, open, recording, undo, .. } = self;
        let Some(open) = open else { return Err(Refused::request("no pattern is open")) };
        let computer = computer.as_ref();
        if request.moves_the_sheet() && recording.take().is_some() {
            open.changed = true;
        }
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
            Request::Record { way, contact, parts } => {
                *recording = Some(Recording::new(&open.sheet, &open.wishes, (way, contact, parts))?);
                open.running = true;
            }
            Request::Show { at } => {
                let none = || Refused::request("nothing was recorded");
                recording.as_mut().ok_or_else(none)?.show(at)?;
            }
            Request::Film => {
                let none = || Refused::request("nothing was recorded");
                let (sheet, recording) = (&open.sheet, recording.as_ref().ok_or_else(none)?);
                let Named { name, title, .. } = &sheet.named;
                let film = recording.film(name, title.clone(), &sheet.pattern)?;
                let page = export::page(&film, sheet.named.stem())?;
                let name = format!("{}.html", sheet.named.stem());
                return Ok(vec![Packet::new(&Reply::File { name, media: "text/html" }, page)]);
            }
            Request::Export { format } => {
                let bytes = match recording {
                    Some(recording) => recording.file(format, &open.sheet)?,
                    None => {
                        let (report, state) = (open.report(), open.state()?);
                        let seen = (&*open.sheet.model, &state, Some(open.wishes.percent), None);
                        export::file(format, &open.sheet, seen, report)?
                    }
                };
                let name = format!("{}-folded.{}", open.sheet.named.stem(), format.extension());
                return Ok(vec![Packet::new(&Reply::File { name, media: format.media() }, bytes)]);
            }
            Request::Save => {
                let state = open.state()?;
                let bytes = saved::write(&open.sheet, &open.wishes, &state.positions, &state.fold_angles)?;
                let name = format!("{}.origami-session.json", open.sheet.named.stem());
                return Ok(vec![Packet::new(&Reply::File { name, media: "application/json" }, bytes)]);
            }
            // Answered above.
            Request::Catalog | Request::Open { .. } | Request::Generate { .. } | Request::Restore => {}
            Request::Frame { .. } | Request::Live => {}
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
        (self.undo, self.recording) = (Undo::default(), None);
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
