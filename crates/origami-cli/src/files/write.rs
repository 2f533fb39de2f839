//! Folded sheets into files.

use std::fs;

use origami::error::WarningCode;
use origami::export::{Pose, Template, plates, write_obj, write_stl, write_whole};
use origami::fold::Document;
use origami::glam::DVec3;
use origami::ids::TriangleId;
use origami::layers::FaceOrder;
use origami::model::Model;
use origami::solve::{Folded, State, Stop};
use origami::{CreasePattern, Error, Warning};

use super::{Destination, Format, Target, page};
use crate::console;
use crate::draw::{self, Artist, Subject};
use crate::numbers::percent_of;

/// Own key: whether the state is within the tolerance of the equilibrium.
const CONVERGED: &str = "origami:converged";
/// Own key: the estimated distance of the farthest vertex from the equilibrium, in radii of the sheet.
const DISTANCE: &str = "origami:distance";

/// Own key: whether contact keeps the sheet from its angles.
const BLOCKED: &str = "origami:blocked";

/// FOLD's key for which face lies upon which.
const FACE_ORDERS: &str = "faceOrders";

/// All that a file may need to know of a folded sheet.
pub(crate) struct Sheet<'a> {
    /// What the input is called, without its extension.
    pub(crate) name: &'a str,
    /// What a FOLD file keeps of the input.
    pub(crate) template: &'a Template,
    /// The pattern in it.
    pub(crate) pattern: &'a CreasePattern,
    /// Its model.
    pub(crate) model: &'a Model,
    /// The states on the way, the last of them the result.
    pub(crate) states: &'a [Folded],
    /// Of a sequence the step of each; else empty.
    pub(crate) steps: &'a [String],
    /// Which face lies on which in the last state, where that is known and its positions do not tell it.
    pub(crate) orders: Option<&'a [FaceOrder]>,
    /// Whether all of them go into files that can hold more than one.
    pub(crate) animated: bool,
    /// What draws it.
    pub(crate) artist: &'a Artist,
    /// How thick the paper is, in the file's unit, where it is.
    pub(crate) thickness: Option<f64>,
    /// Pictures in a second, where that was asked for.
    pub(crate) fps: Option<u16>,
}

impl Sheet<'_> {
    /// Those of its states that go into a file of this format, with their percentages.
    pub(crate) fn states_of(&self, format: Format) -> Vec<(f64, &State)> {
        let all = match format {
            Format::Contact => true,
            Format::Glb | Format::Html | Format::Film => self.animated,
            _ => false,
        };
        let first = if all { 0 } else { self.states.len().saturating_sub(1) };
        self.states[first..].iter().map(|folded| (percent_of(folded), &folded.state)).collect()
    }
}

impl<'a> Sheet<'a> {
    /// The steps of those states.
    pub(crate) fn steps_of(&self, format: Format) -> &'a [String] {
        let shown = self.states_of(format).len();
        &self.steps[self.steps.len().saturating_sub(shown)..]
    }
}

/// Writes one file, whole or not at all; tells what is not in it as it was asked for.
///
/// # Errors
/// [`Error::Io`] where the system refuses.
pub(crate) fn write(target: &Target, sheet: &Sheet<'_>) -> Result<Option<Warning>, Error> {
    let mut warning = None;
    make_folder(target)?;
    let states = sheet.states_of(target.format);
    let subject =
        Subject { pattern: sheet.pattern, model: sheet.model, states: &states, steps: sheet.steps_of(target.format) };
    match target.format {
        Format::Png | Format::Glb | Format::Contact => {
            whole(&target.destination, |writer| draw::sheet(target.format, sheet.artist, subject, sheet.fps, writer))
        }
        Format::Svg => {
            whole(&target.destination, |writer| draw::pattern(target.format, sheet.artist, sheet.pattern, writer))
        }
        // Written by whoever shows how far it has come.
        Format::Film => Ok(()),
        Format::Html => whole(&target.destination, |writer| {
            // One that does not move has its last state alone.
            let only = if sheet.animated { 0 } else { sheet.states.len().saturating_sub(1) };
            let shown = (&sheet.states[only..], sheet.steps.get(only..).unwrap_or_default());
            page::write(sheet.name, sheet.pattern, sheet.model, shown, writer)
        }),
        Format::Fold => write_document(&target.destination, &sheet.fold()?),
        Format::Obj => {
            let Some(last) = sheet.states.last() else { return Ok(None) };
            let positions = sheet.model.file_positions(sheet.pattern, &last.state.positions);
            whole(&target.destination, |writer| write_obj(writer, sheet.pattern, &positions))
        }
        Format::Stl => {
            let Some(last) = sheet.states.last() else { return Ok(None) };
            let points: Vec<_> = last.state.positions.iter().map(|p| sheet.model.normalisation.to_file(*p)).collect();
            let mesh = &sheet.model.mesh;
            let corners = |t: &TriangleId| mesh.triangles[t.index()].map(|n| n.0);
            let (points, triangles) = match sheet.thickness {
                Some(thickness) => plates(sheet.model, &points, thickness),
                None => (points, mesh.triangles_by_face.iter().map(corners).collect()),
            };
            whole(&target.destination, |writer| {
                warning = write_stl(writer, &points, &triangles)?.map(|by| moved(-by));
                Ok(())
            })
        }
    }?;
    Ok(warning)
}

/// That a sheet at `from` was moved to the origin.
fn moved(from: DVec3) -> Warning {
    let why = "which its 32 bits cannot hold: it was moved to the origin";
    // In full, but for what rounding leaves: what was taken away is to be added again.
    let [x, y, z] = from.to_array().map(|x| if x.abs() < 1e-9 * from.length() { 0.0 } else { x });
    let problem = format!("the sheet lies around {x} {y} {z}, {why}");
    Warning::new(WarningCode::Fallback, "STL", problem)
}

/// Makes the folder that a file goes into, where one is to be made.
///
/// # Errors
/// [`Error::Io`] where the system refuses.
pub(crate) fn make_folder(target: &Target) -> Result<(), Error> {
    let Some(folder) = &target.folder else { return Ok(()) };
    fs::create_dir_all(folder).map_err(|source| Error::Io { path: folder.display().to_string(), source })
}

/// Writes a FOLD file, whole or not at all.
///
/// # Errors
/// [`Error::Io`] where the system refuses.
pub(crate) fn write_document(destination: &Destination, document: &Document) -> Result<(), Error> {
    whole(destination, |writer| document.write_to(writer))
}

/// Writes anything, whole or not at all.
///
/// # Errors
/// [`Error::Io`] where the system refuses, and whatever `content` returns.
pub(crate) fn whole(
    destination: &Destination,
    content: impl FnOnce(&mut dyn std::io::Write) -> Result<(), Error>,
) -> Result<(), Error> {
    match destination {
        Destination::File(path) => write_whole(path, content),
        Destination::Stdout => {
            let mut bytes = Vec::new();
            content(&mut bytes)?;
            console::print(&bytes).map_err(|source| Error::Io { path: "-".to_owned(), source })
        }
    }
}

impl Sheet<'_> {
    /// As a FOLD document that says how far each state is from the equilibrium.
    fn fold(&self) -> Result<Document, Error> {
        let mut poses: Vec<Pose> =
            self.states.iter().map(|folded| Pose::of(self.model, self.pattern, folded)).collect();
        for (pose, step) in poses.iter_mut().zip(self.steps) {
            pose.step = Some(step.clone());
        }
        if self.animated {
            let mut document = self.template.animation(self.pattern, &poses)?;
            // Of an input that was folded itself.
            document.key_frame.extra.retain(|key, _| key != CONVERGED && key != DISTANCE && key != BLOCKED);
            let orders_at_rest = document.key_frame.extra.contains_key(FACE_ORDERS);
            for (frame, folded) in document.frames.iter_mut().zip(self.states) {
                self.mark(&mut frame.extra, folded);
                if orders_at_rest {
                    // Not to be inherited.
                    frame.extra.entry(FACE_ORDERS).or_insert(serde_json::Value::Null);
                }
            }
            return Ok(document);
        }
        let (Some(pose), Some(folded)) = (poses.last(), self.states.last()) else { return Ok(Document::default()) };
        let mut document = self.template.folded_form(self.pattern, pose)?;
        self.mark(&mut document.key_frame.extra, folded);
        Ok(document)
    }

    /// Own keys, of which a distance that is not known is null; and the order of faces, where that can be told.
    fn mark(&self, extra: &mut serde_json::Map<String, serde_json::Value>, folded: &Folded) {
        extra.insert(CONVERGED.into(), folded.converged().into());
        extra.insert(DISTANCE.into(), folded.distance.into());
        extra.shift_remove(BLOCKED);
        if folded.stop == Stop::Blocked {
            extra.insert(BLOCKED.into(), true.into());
        }
        // That of the input was of another state.
        extra.shift_remove(FACE_ORDERS);
        let is_last = self.states.last().is_some_and(|last| std::ptr::eq(last, folded));
        let known = self.orders.filter(|_| is_last).map(draw::listed);
        if let Some(orders) = known.or_else(|| draw::orders(self.model, &folded.state)) {
            extra.insert(FACE_ORDERS.into(), orders);
        }
    }
}
