//! From a job and a sheet to a structure and its path.

use glam::DVec3;

use super::keys::{self, press};
use super::masses;
use super::pick::node_of;
use super::rest;
use super::{ControlJob, ControlName, Job, PathJob, SupportJob, Units};
use crate::analysis::{Axis, BarLaw, Configuration, Control, Dof, Path, Refused, Structure, Until};
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;
use crate::model::Model;
use crate::pattern::CreasePattern;
use crate::solve::State;

/// A sheet ready to be analysed, in the job's units.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Members, supports and loads. Nodes, bars and hinges are numbered as nodes, beams and creases of the model.
    pub structure: Structure,
    /// The path that is followed.
    pub path: Path,
    /// Displacements that tables and plots show, with the vertices that they are of.
    pub monitors: Vec<(u32, Dof)>,
    /// The job's unit of length in words: `mm`, or `radii`.
    pub length: String,
    /// Its unit of force.
    pub force: String,
    /// What the root of a vibration's eigenvalue is to be multiplied by to be a frequency in hertz; none where the job has no
    /// masses, or a unit that is not known.
    pub hertz: Option<f64>,
    /// How long a radius of the sheet is, in the job's unit of length.
    pub radius: f64,
    /// By which vectors the sheet repeats itself, where the job says so.
    pub cell: Option<[DVec3; 2]>,
}

impl Job {
    /// The structure that the job, and the frame with it, make of a sheet.
    ///
    /// # Errors
    /// [`Error::Invalid`] that names the key of what is missing, out of range, or on no vertex of the sheet.
    pub fn setup(&self, frame: &Frame, pattern: &CreasePattern, model: &Model) -> Result<Setup, Error> {
        self.check()?;
        let frame_unit = frame.extra.get("frame_unit").and_then(|unit| unit.as_str());
        let radius = match &self.units {
            Some(units) => units.of_file(frame_unit)? * model.normalisation.radius,
            None => 1.0,
        };
        let mut structure = Structure::of(model);
        structure.nodes.iter_mut().for_each(|p| *p *= radius);
        structure.bars.iter_mut().for_each(|bar| bar.rest_length *= radius);
        self.set_members(&mut structure, pattern, model, radius)?;
        rest::set(frame, pattern, model, &mut structure)?;
        keys::add(frame, pattern, model, &mut structure)?;
        self.hold(&mut structure, pattern, model)?;
        self.load(&mut structure, pattern, model)?;
        masses::set(self, frame, pattern, model, &mut structure)?;
        let at = |place: &str, vertex: u32, axis: Axis| {
            node_of(place, vertex, pattern, model).map(|node| Dof::new(node, axis))
        };
        let mut monitors = Vec::new();
        for (i, (vertex, axis)) in self.path.monitor.iter().enumerate() {
            monitors.push((*vertex, at(&format!("path.monitor[{i}]"), *vertex, *axis)?));
        }
        let control = match self.path.control {
            ControlJob::Named(ControlName::Arc) => Control::Arc,
            ControlJob::Named(ControlName::Load) => Control::Load,
            ControlJob::Displacement(vertex, axis) => Control::Displacement(at("path.control", vertex, axis)?),
        };
        if monitors.is_empty() {
            monitors.extend(first_moved(&structure, control).map(|dof| {
                let vertex = model.mesh.vertex_of_node[dof.node.index()];
                (vertex.0, dof)
            }));
        }
        let mut until: Vec<Until> = Vec::new();
        until.extend(self.path.to.map(|to| match control {
            Control::Displacement(dof) => Until::Displacement(dof, to),
            _ => Until::LoadFactor(to),
        }));
        for (i, (vertex, axis, way)) in self.path.ends.iter().enumerate() {
            until.push(Until::Displacement(at(&format!("path.ends[{i}]"), *vertex, *axis)?, *way));
        }
        let PathJob { steps, backwards, step, longest, .. } = self.path;
        let path = Path { control, until, steps, backwards, step, longest, ..Path::default() };
        let units = self.units.as_ref().map(|units| (units.length.clone(), units.force.clone()));
        let (length, force) = units.unwrap_or_else(|| ("radii".to_owned(), "the model's".to_owned()));
        let hertz = self.units.as_ref().and_then(Units::hertz).filter(|_| !structure.masses.is_empty());
        structure.check().map_err(|refused| self.wrong(&refused, pattern, model))?;
        let in_file = radius / model.normalisation.radius;
        let cell = self.cell.map(|cell| cell.map(|v| DVec3::from_array(v) * in_file));
        Ok(Setup { structure, path, monitors, length, force, hertz, radius, cell })
    }

    /// What a structure is refused for, by the job's key.
    fn wrong(&self, refused: &Refused, pattern: &CreasePattern, model: &Model) -> Error {
        let Refused::Contradiction { dof, one, other } = refused else {
            return Error::invalid("the job", refused.to_string(), "another one");
        };
        let is_own = |support: &SupportJob| {
            let axis = dof.axis.index();
            let moves = support.fixed.0.to_array()[axis] || support.displacement[axis].is_some();
            moves && support.on.nodes("", pattern, model).is_ok_and(|nodes| nodes.contains(&dof.node))
        };
        let last = self.supports.iter().rposition(is_own);
        let place = last.map_or_else(|| keys::DISPLACEMENT.to_owned(), |i| format!("supports[{i}]"));
        let vertex = model.mesh.vertex_of_node[dof.node.index()];
        let problem = format!("vertex {} is held at {one} and at {other} along {}", vertex.0, dof.axis.name());
        Error::new(ErrorCode::WrongValue, Place::key(place), problem, "one displacement of each vertex and axis")
    }

    fn hold(&self, structure: &mut Structure, pattern: &CreasePattern, model: &Model) -> Result<(), Error> {
        for (i, support) in self.supports.iter().enumerate() {
            let place = format!("supports[{i}]");
            let held = support.fixed.0.to_array();
            if !held.contains(&true) && support.displacement.iter().all(Option::is_none) {
                let (problem, expected) = ("holds nothing", "`fixed` or `displacement`");
                return Err(Error::new(ErrorCode::MissingKey, Place::key(place), problem, expected));
            }
            for node in support.on.nodes(&format!("{place}.on"), pattern, model)? {
                structure.hold(node, support.fixed.0);
                for (axis, way) in Axis::ALL.into_iter().zip(support.displacement) {
                    structure.supports.moved.extend(way.map(|way| (Dof::new(node, axis), way)));
                }
            }
        }
        Ok(())
    }

    fn load(&self, structure: &mut Structure, pattern: &CreasePattern, model: &Model) -> Result<(), Error> {
        for (i, load) in self.loads.iter().enumerate() {
            let place = format!("loads[{i}]");
            match (&load.on, load.force, &load.faces, load.pressure) {
                (Some(on), Some(force), None, None) => {
                    let nodes = on.nodes(&format!("{place}.on"), pattern, model)?;
                    let force = DVec3::from_array(force);
                    structure.loads.points.extend(nodes.into_iter().map(|node| (node, force)));
                }
                (None, None, Some(faces), Some(pressure)) => {
                    for (j, face) in faces.iter().enumerate() {
                        press(&format!("{place}.faces[{j}]"), *face as usize, pressure, model, structure)?;
                    }
                }
                _ => {
                    let (problem, expected) = ("is no load", "`on` with `force`, or `faces` with `pressure`");
                    return Err(Error::new(ErrorCode::MissingKey, Place::key(place), problem, expected));
                }
            }
        }
        Ok(())
    }
}

/// What a plot shows unless it is told: what is controlled, loaded or moved, along the largest component.
fn first_moved(structure: &Structure, control: Control) -> Option<Dof> {
    if let Control::Displacement(dof) = control {
        return Some(dof);
    }
    let loaded = structure.loads.points.first().map(|(node, force)| {
        let largest = Axis::ALL.into_iter().max_by(|a, b| force[a.index()].abs().total_cmp(&force[b.index()].abs()));
        Dof::new(*node, largest.unwrap_or(Axis::Z))
    });
    let pressed = structure.loads.pressures.first().map(|(nodes, _)| Dof::new(nodes[0], Axis::Z));
    loaded.or(structure.supports.moved.first().map(|(dof, _)| *dof)).or(pressed)
}

impl Setup {
    /// The law of its bars.
    #[must_use]
    pub fn bar_law(&self) -> BarLaw {
        self.structure.bars.first().map_or_else(BarLaw::default, |bar| bar.law)
    }

    /// A configuration of the structure as a state of the sheet, in radii.
    #[must_use]
    pub fn state(&self, model: &Model, at: &Configuration) -> State {
        let positions = at.positions.iter().map(|p| *p / self.radius).collect();
        State { positions, fold_angles: at.fold_angles.clone(), ..State::at_rest(model) }
    }
}
