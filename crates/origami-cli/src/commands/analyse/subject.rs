//! What is analysed: a sheet, and what is asked of it.

use std::path::PathBuf;

use origami::analysis::job::{Job, Setup};
use origami::analysis::{Configuration, Refused};
use origami::export::{Pose, Template, write_whole};
use origami::fold::Document;
use origami::glam::DVec3;
use origami::measure::edge_fold_angles;
use origami::{CreasePattern, Error, Material, Model};
use serde::Serialize;
use serde_json::Value;

use crate::args::SubjectArgs;
use crate::commands::study::folder;
use crate::console;
use crate::exit::Failure;
use crate::files::{Input, Reading};

/// A sheet that has been read, and what is asked of it.
pub(super) struct Subject {
    /// The input's name.
    pub(super) name: String,
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
        let in_job = |error: &Error| match &args.job {
            Some(path) => format!("{}: {error}", path.display()),
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
        Ok(Self { name, output: args.output.clone(), quiet: args.quiet, document, frame, pattern, model, job, setup })
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
        let mut animation = Template::new(document, *frame, pattern)?.animation(pattern, &poses)?;
        for (frame, (key, note)) in animation.frames.iter_mut().zip(notes) {
            frame.extra.insert(key.to_owned(), note);
        }
        write_whole(self.output.join(name), |writer| animation.write_to(writer)).map_err(Failure::from)
    }

    /// The sheet as drawn, its nodes moved by `shape` so that the farthest goes `amplitude` radii.
    pub(super) fn moved(&self, shape: &[DVec3], amplitude: f64) -> Configuration {
        let structure = &self.setup.structure;
        let far = amplitude * self.setup.radius;
        let positions: Vec<DVec3> = structure.nodes.iter().zip(shape).map(|(p, s)| *p + *s * far).collect();
        Configuration { fold_angles: structure.fold_angles(&positions, &structure.as_drawn().fold_angles), positions }
    }

    /// Tells one line, where that is wanted.
    pub(super) fn say(&self, line: &str) -> Result<(), Failure> {
        if self.quiet { Ok(()) } else { console::print_text(&format!("{line}\n")).map_err(Failure::from) }
    }
}
