//! What is analysed: a sheet, and what is asked of it.

use std::path::{Path, PathBuf};

use origami::analysis::job::{Job, Setup};
use origami::analysis::{Configuration, Refused};
use origami::export::{Pose, Template, write_whole};
use origami::fold::Document;
use origami::glam::DVec3;
use origami::ids::VertexId;
use origami::measure::edge_fold_angles;
use origami::{CreasePattern, Error, Material, Model, State};
use serde::Serialize;
use serde_json::Value;

use crate::args::SubjectArgs;
use crate::commands::study::folder;
use crate::console;
use crate::draw::{self, Artist, Film};
use crate::exit::Failure;
use crate::files::{Input, Reading};

/// Own key: by how much the loads are multiplied in a frame.
pub(super) const LOAD_FACTOR: &str = "origami:loadFactor";

/// A sheet that has been read, and what is asked of it.
pub(super) struct Subject {
    /// The input's name.
    pub(super) name: String,
    /// The name of the file that the job is in.
    source: String,
    /// The folder of the results.
    pub(super) output: PathBuf,
    quiet: bool,
    pub(super) document: Document,
    pub(super) frame: usize,
    pub(super) pattern: CreasePattern,
    pub(super) model: Model,
    pub(super) job: Job,
    pub(super) setup: Setup,
}

impl Subject {
    /// Reads the pattern and the job, from its file or else from the pattern's frame, and makes the folder for results, of
    /// which `result` is the first. What is odd about the pattern is told.
    ///
    /// # Errors
    /// What is wrong, with the file and the key.
    pub(super) fn read(args: &SubjectArgs, result: &str) -> Result<Self, String> {
        folder::check(&args.output)?;
        let input = Input::new(&args.input, &Reading::new(&args.reading)?);
        let in_input = |error: &Error| input.describe(error);
        let document = input.read().map_err(|error| in_input(&error))?;
        let frame = match args.frame {
            Some(frame) => frame,
            None => document.pattern_frame().map_err(|error| in_input(&error))?,
        };
        let pattern = CreasePattern::from_document(&document, frame).map_err(|error| in_input(&error))?;
        let model =
            Model::new(&pattern, &args.material.material(Material::default())).map_err(|error| in_input(&error))?;
        let content = document.frame(frame).map_err(|error| in_input(&error))?;
        let source = args.job.as_ref().map_or_else(|| input.to_string(), |path| path.display().to_string());
        let in_job = |error: &Error| match &args.job {
            Some(_) => format!("{source}: {error}"),
            None => in_input(error),
        };
        let job = match &args.job {
            Some(path) => {
                let bytes = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
                Job::from_slice(&bytes)
            }
            None => Job::in_frame(&content),
        };
        let job = job.map_err(|error| in_job(&error))?;
        let setup = job.setup(&content, &pattern, &model).map_err(|error| in_job(&error))?;
        if !args.quiet {
            pattern.warnings.iter().for_each(|warning| console::warning(format!("{input}: {warning}")));
        }
        folder::make(&args.output, result)?;
        let name = input.to_string();
        let (output, quiet) = (args.output.clone(), args.quiet);
        Ok(Self { name, source, output, quiet, document, frame, pattern, model, job, setup })
    }

    /// What is wrong with the job, as a person is told.
    pub(super) fn in_job(&self, error: &Error) -> String {
        format!("{}: {error}", self.source)
    }

    /// What an analysis refuses, as a person is told.
    pub(super) fn refused(&self, refused: &Refused) -> String {
        format!("{}: {refused}", self.name)
    }

    /// Writes a file of the folder, whole or not at all.
    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.output.join(name);
        let told = |source| Error::Io { path: path.display().to_string(), source };
        write_whole(&path, |writer| writer.write_all(bytes).map_err(told)).map_err(Failure::from)
    }

    /// The same as JSON.
    pub(super) fn write_json(&self, name: &str, content: &impl Serialize) -> Result<(), Failure> {
        let mut bytes = serde_json::to_vec_pretty(content).map_err(|error| error.to_string())?;
        bytes.push(b'\n');
        self.write(name, &bytes)
    }

    /// The same as FOLD: states of the sheet, each with a key of its own.
    pub(super) fn write_frames<'a>(
        &self,
        name: &str,
        states: impl IntoIterator<Item = (&'a Configuration, &'static str, Value)>,
    ) -> Result<(), Failure> {
        self.write_sheet(name, &self.pattern, Vec::new(), states)
    }

    /// The same of a sheet that is drawn as `drawn`, with values of its edges by key; where these are null they are as in the
    /// file.
    pub(super) fn write_sheet<'a>(
        &self,
        name: &str,
        drawn: &CreasePattern,
        keys: Vec<(&'static str, Value)>,
        states: impl IntoIterator<Item = (&'a Configuration, &'static str, Value)>,
    ) -> Result<(), Failure> {
        let Self { document, frame, pattern, model, setup, .. } = self;
        let mut poses = Vec::new();
        let mut notes = Vec::new();
        for (configuration, key, note) in states {
            let state = setup.state(model, configuration);
            let fold_angles = edge_fold_angles(model, pattern, &state);
            poses.push(Pose {
                percent: None,
                positions: model.file_positions(pattern, &state.positions),
                fold_angles,
                step: None,
            });
            notes.push((key, note));
        }
        let mut animation = Template::new(document, *frame, pattern)?.animation(drawn, &poses)?;
        for (key, mut value) in keys {
            let before = animation.key_frame.extra.get(key).and_then(Value::as_array).cloned().unwrap_or_default();
            for (own, before) in value.as_array_mut().into_iter().flatten().zip(before) {
                if own.is_null() {
                    *own = before;
                }
            }
            animation.key_frame.extra.insert(key.to_owned(), value);
        }
        for (frame, (key, note)) in animation.frames.iter_mut().zip(notes) {
            frame.extra.insert(key.to_owned(), note);
        }
        write_whole(self.output.join(name), |writer| animation.write_to(writer)).map_err(Failure::from)
    }

    /// The sheet at `at`, its nodes moved by `shape` so that the farthest goes `amplitude` radii.
    pub(super) fn moved(&self, at: &Configuration, shape: &[DVec3], amplitude: f64) -> Configuration {
        let structure = &self.setup.structure;
        let far = amplitude * self.setup.radius;
        let positions: Vec<DVec3> = at.positions.iter().zip(shape).map(|(p, s)| *p + *s * far).collect();
        Configuration { fold_angles: structure.fold_angles(&positions, &at.fold_angles), positions }
    }

    /// The sheet as a frame of a file has it, with the load factor that the frame tells; 0 where it tells none. Fold angles are
    /// taken to be within half a turn of those of the drawing.
    ///
    /// # Errors
    /// That the file cannot be read, or is of another sheet.
    pub(super) fn state_in(&self, path: &Path, frame: Option<usize>) -> Result<(Configuration, f64), String> {
        let shown = path.display();
        let told = |error: &Error| format!("{shown}: {error}");
        let document = Document::read(path).map_err(|error| told(&error))?;
        let frame = frame.unwrap_or_else(|| document.frame_count().saturating_sub(1));
        let frame = document.frame(frame).map_err(|error| told(&error))?;
        let coordinates = frame.vertices_coords.as_deref().unwrap_or_default();
        let place = |vertex: &VertexId| coordinates.get(vertex.index()).map(|own| own.position);
        let Some(places) = self.model.mesh.vertex_of_node.iter().map(place).collect::<Option<Vec<DVec3>>>() else {
            let expected = self.pattern.vertices.len();
            return Err(format!(
                "{shown}: vertices_coords: has {}; expected the sheet's {expected}",
                coordinates.len()
            ));
        };
        let Setup { structure, radius, .. } = &self.setup;
        let positions: Vec<DVec3> =
            places.into_iter().map(|p| self.model.normalisation.to_model(p) * *radius).collect();
        let fold_angles = structure.fold_angles(&positions, &structure.as_drawn().fold_angles);
        let load_factor = frame.extra.get(LOAD_FACTOR).and_then(Value::as_f64).unwrap_or_default();
        Ok((Configuration { positions, fold_angles }, load_factor))
    }

    /// Writes a film of states, one picture each; how many files it is made of.
    pub(super) fn write_film(&self, path: &Path, states: &[Configuration]) -> Result<usize, Failure> {
        let states: Vec<State> = states.iter().map(|at| self.setup.state(&self.model, at)).collect();
        let states: Vec<(f64, &State)> = states.iter().map(|state| (100.0, state)).collect();
        let subject = draw::Subject { pattern: &self.pattern, model: &self.model, states: &states, steps: &[] };
        Ok(draw::film(&Artist::default(), subject, Film::default(), path, &mut |_, _| ())?.len())
    }

    /// Tells one line, where that is wanted.
    pub(super) fn say(&self, line: &str) -> Result<(), Failure> {
        if self.quiet { Ok(()) } else { console::print_text(&format!("{line}\n")).map_err(Failure::from) }
    }
}
