//! So many sheets at once as memory holds.

use std::ops::{ControlFlow, Range};
use std::sync::{Mutex, OnceLock, PoisonError};

use origami::export::Template;
use origami::measure::attitude::{self, Hold};
use origami::model::{Inventory, Model};
use origami::solve::{Failed, Folded, Instance, Point, Progress, Solver, Sweep};
use origami::{CreasePattern, Error, Warning};

use super::folder::Folder;
use super::ledger::Ledger;
use super::shares::Shares;
use crate::draw::Artist;
use crate::files::{self, Destination, Sheet, Target};
use crate::progress::ProgressLine;
use crate::report::{Divergence, Ending, Measured, Row, SceneFacts, Varied};
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

/// Some of the sheets.
#[derive(Clone, Copy)]
struct Batch<'a> {
    points: &'a [Point],
    models: &'a [Model],
    /// The place of the first.
    begun: usize,
    /// The sheets before this place have rows already.
    taken: usize,
}

fn goes_on(failed: &OnceLock<Error>) -> ControlFlow<()> {
    if failed.get().is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// What is known of all sheets.
#[derive(Default)]
pub(super) struct Known {
    /// The message of the first sheet that diverged, with its place.
    pub(super) first_divergence: Option<(usize, String)>,
    /// What is dangerous about them, each once.
    pub(super) scene_warnings: Vec<Warning>,
    inventories: Vec<Inventory>,
}

impl Known {
    fn diverged(&mut self, index: usize, message: Option<String>) {
        let Some(message) = message else { return };
        if self.first_divergence.as_ref().is_none_or(|(first, _)| index < *first) {
            self.first_divergence = Some((index, message));
        }
    }
}

impl Work<'_> {
    /// Folds the sheets of `places` but the first `taken`, which have rows, in batches; nothing depends on how large these are.
    /// `begin` makes the ledger, once there is something to be written; it stays in its place, whatever comes.
    ///
    /// # Errors
    /// From a model that cannot be built, or a file that cannot be written.
    pub(super) fn run(
        &self,
        places: Range<usize>,
        taken: usize,
        begin: impl FnOnce() -> Result<Ledger, Error>,
        place: &mut Option<Ledger>,
    ) -> Result<Known, Error> {
        let size = (NODES_AT_ONCE / self.pattern.vertices.len().max(1)).max(rayon::current_num_threads());
        let points: Vec<Point> = self.sweep.points().skip(places.start).take(places.len()).collect();
        let shares = Shares::new(places.clone());
        places.clone().take(taken).for_each(|i| self.line.show_sheets(shares.advance(i, 1.0)));
        let mut known = Known::default();
        let mut begin = Some(begin);
        for (i, points) in points.chunks(size).enumerate() {
            let watch = Stopwatch::start();
            let models = self.models(points)?;
            if let Some(begin) = begin.take() {
                // A face that is not there is refused before the work.
                models.first().map(|model| attitude::motion(model, &model.rest, self.hold)).transpose()?;
                *place = Some(begin()?);
            }
            let Some(ledger) = place.as_mut() else { break };
            let begun = places.start + i * size;
            let batch = Batch { points, models: &models, begun, taken: places.start + taken };
            self.batch(&batch, &shares, &mut known, ledger, watch)?;
        }
        if let Some(begin) = begin.take() {
            // A part without a sheet has tables too.
            *place = Some(begin()?);
        }
        place.as_mut().map_or(Ok(()), Ledger::flush)?;
        Ok(known)
    }

    /// A model for each material, which varies slowest.
    fn models(&self, points: &[Point]) -> Result<Vec<Model>, Error> {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return Ok(Vec::new()) };
        Model::of_each(self.pattern, &self.sweep.materials[first.material..=last.material])
    }

    fn batch(
        &self,
        batch: &Batch<'_>,
        shares: &Shares,
        known: &mut Known,
        ledger: &mut Ledger,
        mut watch: Stopwatch,
    ) -> Result<(), Error> {
        let Batch { points, models, begun, taken } = *batch;
        let first = points.first().map_or(0, |point| point.material);
        let scenes: Vec<usize> = models.iter().map(|model| self.scene(model, known, &mut ledger.scenes)).collect();
        // What has rows already is only counted.
        let skipped = taken.saturating_sub(begun).min(points.len());
        let (points, begun) = (&points[skipped..], begun + skipped);
        let instances: Vec<Instance<'_>> = points.iter().map(|p| p.instance(&models[p.material - first])).collect();
        ledger.seconds.build += watch.lap();

        let written = Mutex::new((ledger, 0.0, known));
        let lock = || written.lock().unwrap_or_else(PoisonError::into_inner);
        // The first error counts; the others follow from it.
        let failed = OnceLock::new();
        let observe = |i: usize, progress: Progress| {
            self.line.show_sheets(shares.advance(begun + i, progress.ramp));
            goes_on(&failed)
        };
        let keep = |i: usize, folded: Result<Folded, Failed>| {
            // What was broken off for it is no result.
            goes_on(&failed)?;
            let (index, point) = (begun + i, &points[i]);
            let kept = || {
                let mut watch = Stopwatch::start();
                self.line.show_sheets(shares.advance(index, 1.0));
                let scene = scenes[point.material - first];
                let (row, divergence) = self.row(index, scene, point, &instances[i], folded)?;
                let mut kept = lock();
                let (ledger, write, known) = &mut *kept;
                known.diverged(index, divergence);
                ledger.push(row)?;
                *write += watch.lap();
                Ok::<(), Error>(())
            };
            if let Err(error) = kept() {
                let _ = failed.set(error);
            }
            goes_on(&failed)
        };
        if self.on_gpu.is_some() {
            // Rows are made on the processor's threads while the GPU goes on.
            rayon::in_place_scope(|scope| {
                self.solver.fold_each(&instances, &observe, &|i, folded| {
                    let keep = &keep;
                    scope.spawn(move |_| {
                        let _ = keep(i, folded);
                    });
                    goes_on(&failed)
                });
            });
        } else {
            self.solver.fold_each(&instances, &observe, &keep);
        }
        let done = failed.into_inner().map_or(Ok(()), Err);
        let (ledger, write, _) = written.into_inner().unwrap_or_else(PoisonError::into_inner);
        // Threads wait for each other to write: their times overlap.
        let all = watch.lap();
        let write = all.min(write);
        ledger.seconds.write += write;
        ledger.seconds.solve += all - write;
        if done.is_err() {
            // What is done before it is kept.
            let _ = ledger.flush();
        }
        done
    }

    /// The place of the model's scene among those seen so far.
    fn scene(&self, model: &Model, known: &mut Known, scenes: &mut Vec<SceneFacts>) -> usize {
        let inventory = self.solver.inventory(model);
        let seen = known.inventories.iter().position(|other| *other == inventory);
        seen.unwrap_or_else(|| {
            let of_scene = scene_warnings(self.pattern, model, &self.sweep.percents, self.on_gpu);
            let warnings: Vec<Warning> = self.pattern.warnings.iter().chain(&of_scene).cloned().collect();
            scenes.push(SceneFacts::new(self.pattern, model, &inventory, &warnings));
            of_scene.into_iter().for_each(|warning| {
                if !known.scene_warnings.contains(&warning) {
                    known.scene_warnings.push(warning);
                }
            });
            known.inventories.push(inventory);
            scenes.len() - 1
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
            name: "sheet",
            steps: &[],
            orders: None,
            template: self.template,
            pattern: self.pattern,
            model,
            states: &[folded],
            animated: false,
            artist: &artist,
            thickness: None,
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
