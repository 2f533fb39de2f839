//! So many sheets at once as memory holds.

use std::ops::ControlFlow;
use std::sync::OnceLock;

use origami::export::Template;
use origami::measure::attitude::{self, Hold};
use origami::model::{Inventory, Model};
use origami::solve::{Failed, Folded, Instance, Point, Solver, Sweep};
use origami::{CreasePattern, Error, Warning};
use rayon::prelude::*;

use super::folder::Folder;
use super::shares::Shares;
use crate::draw::Artist;
use crate::files::{self, Destination, Sheet, Target};
use crate::progress::ProgressLine;
use crate::report::{Divergence, Ending, Measured, Row, SceneFacts, Seconds, Varied};
use crate::settings::scene_warnings;
use crate::stopwatch::Stopwatch;

/// Nodes of all sheets that are held at once: some hundred megabytes, each with a model and states of its own.
const NODES_AT_ONCE: usize = 1 << 18;

/// What is to be done.
pub(super) struct Work<'a> {
    pub(super) template: &'a Template,
    pub(super) pattern: &'a CreasePattern,
    pub(super) sweep: &'a Sweep,
    pub(super) solver: &'a dyn Solver,
    pub(super) folder: &'a Folder<'a>,
    pub(super) line: &'a ProgressLine,
    /// What keeps its place in the files.
    pub(super) hold: Hold,
    /// What is not in the files of the sheets as it was asked for.
    pub(super) told: OnceLock<Warning>,
    /// The tolerance, where a GPU computes.
    pub(super) on_gpu: Option<f64>,
}

/// What came of it.
#[derive(Default)]
pub(super) struct Done {
    pub(super) rows: Vec<Row>,
    pub(super) scenes: Vec<SceneFacts>,
    /// The message of the first sheet that diverged.
    pub(super) first_divergence: Option<String>,
    /// What is dangerous about them, each once.
    pub(super) scene_warnings: Vec<Warning>,
    inventories: Vec<Inventory>,
}

impl Work<'_> {
    /// Folds all `count` sheets, in batches; nothing depends on how large these are. `seconds` is added to.
    ///
    /// # Errors
    /// From a model that cannot be built, or a file that cannot be written.
    pub(super) fn run(&self, count: usize, seconds: &mut Seconds) -> Result<Done, Error> {
        let size = (NODES_AT_ONCE / self.pattern.vertices.len().max(1)).max(rayon::current_num_threads());
        let points: Vec<Point> = self.sweep.points().collect();
        let shares = Shares::new(count);
        let mut done = Done::default();
        for batch in points.chunks(size) {
            self.batch(batch, &shares, &mut done, seconds)?;
        }
        Ok(done)
    }

    fn batch(&self, points: &[Point], shares: &Shares, done: &mut Done, seconds: &mut Seconds) -> Result<(), Error> {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return Ok(()) };
        let mut watch = Stopwatch::start();
        // The material varies slowest.
        let models = Model::of_each(self.pattern, &self.sweep.materials[first.material..=last.material])?;
        if done.rows.is_empty() {
            // A face that is not there is refused before the work.
            attitude::motion(&models[0], &models[0].rest, self.hold)?;
            // Not before it is known that there is something to be written.
            self.folder.make()?;
        }
        let scenes: Vec<usize> = models.iter().map(|model| self.scene(model, done)).collect();
        let of_batch = |point: &Point| point.material - first.material;
        let instances: Vec<Instance<'_>> = points.iter().map(|p| p.instance(&models[of_batch(p)])).collect();
        seconds.build += watch.lap();

        let begun = done.rows.len();
        let observe = |i: usize, progress: origami::solve::Progress| {
            self.line.show_sheets(shares.advance(begun + i, progress.ramp));
            ControlFlow::Continue(())
        };
        let folded = self.solver.fold_all(&instances, &observe);
        seconds.solve += watch.lap();

        let each = points.par_iter().zip(&instances).zip(folded).enumerate();
        let rows = each.map(|(i, ((point, instance), folded))| {
            self.line.show_sheets(shares.advance(begun + i, 1.0));
            self.row(begun + i, scenes[of_batch(point)], point, instance, folded)
        });
        for row in rows.collect::<Vec<_>>() {
            let (row, divergence) = row?;
            done.rows.push(row);
            done.first_divergence = done.first_divergence.take().or(divergence);
        }
        seconds.write += watch.lap();
        Ok(())
    }

    /// The place of the model's scene among those seen so far.
    fn scene(&self, model: &Model, done: &mut Done) -> usize {
        let inventory = self.solver.inventory(model);
        let seen = done.inventories.iter().position(|other| *other == inventory);
        seen.unwrap_or_else(|| {
            let of_scene = scene_warnings(self.pattern, model, &self.sweep.percents, self.on_gpu);
            let warnings: Vec<Warning> = self.pattern.warnings.iter().chain(&of_scene).cloned().collect();
            done.scenes.push(SceneFacts::new(self.pattern, model, &inventory, &warnings));
            of_scene.into_iter().for_each(|warning| {
                if !done.scene_warnings.contains(&warning) {
                    done.scene_warnings.push(warning);
                }
            });
            done.inventories.push(inventory);
            done.scenes.len() - 1
        })
    }

    /// Measures a sheet and writes it where that is asked for; also tells how it diverged.
    fn row(
        &self,
        index: usize,
        scene: usize,
        point: &Point,
        instance: &Instance<'_>,
        folded: Result<Folded, Failed>,
    ) -> Result<(Row, Option<String>), Error> {
        let model = instance.model;
        let varied = Varied::new(&model.material, point);
        let mut row = Row {
            index,
            scene,
            varied,
            measured: Measured::default(),
            diverged: None,
            error: None,
            outputs: Vec::new(),
        };
        match folded {
            Ok(folded) => {
                row.measured = Measured::new(model, &folded);
                row.outputs = self.write(index, model, folded)?;
                Ok((row, None))
            }
            Err(failed) => {
                row.measured = Measured { percent: point.percent, attempts: 1, ..Measured::default() };
                let message = failed.to_string();
                if let Failed::Diverged(diverged) = &failed {
                    row.measured.steps = diverged.step;
                    row.diverged = Some(Divergence::from(diverged));
                    return Ok((row, Some(message)));
                }
                row.measured.stop = Ending::Failed;
                row.error = Some(message);
                Ok((row, None))
            }
        }
    }

    fn write(&self, index: usize, model: &Model, mut folded: Folded) -> Result<Vec<String>, Error> {
        folded.state = attitude::turned(model, &folded.state, self.hold)?;
        let artist = Artist::default();
        let sheet = Sheet {
            template: self.template,
            pattern: self.pattern,
            model,
            states: &[folded],
            animated: false,
            artist: &artist,
            fps: None,
        };
        let write = |format: &files::Format| {
            let destination = Destination::File(self.folder.sheet(index, *format));
            let target = Target { destination, format: *format, folder: None };
            if let Some(warning) = files::write(&target, &sheet)? {
                // The same of all sheets.
                self.told.get_or_init(|| warning);
            }
            Ok(target.destination.to_string())
        };
        self.folder.formats.iter().map(write).collect()
    }
}
