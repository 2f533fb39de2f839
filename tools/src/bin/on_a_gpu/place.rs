//! What a section has: the GPU, the time until it has to end, and where its figures go.

use std::error::Error;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use origami::gpu::{AdapterChoice, Gpu};

use crate::results::{Results, Row};

/// Where a section works.
pub(crate) struct Place {
    /// The adapter that `ORIGAMI_ADAPTER` names, or else the best there is.
    pub(crate) gpu: Gpu,
    /// Whether it is enough that everything runs.
    pub(crate) rehearse: bool,
    pub(crate) deadline: Instant,
    pub(crate) folder: PathBuf,
    results: Results,
}

impl Place {
    /// Opens the adapter for a section that has so many seconds.
    ///
    /// # Errors
    /// If there is no adapter.
    pub(crate) fn open(section: &str, folder: PathBuf, seconds: f64, rehearse: bool) -> Result<Self, Box<dyn Error>> {
        let deadline = Instant::now() + Duration::from_secs_f64(seconds);
        let gpu = Gpu::open(&AdapterChoice::from_env())?;
        let results = Results::new(&folder, section);
        Ok(Self { gpu, rehearse, deadline, folder, results })
    }

    /// Whether the time is over; what has not begun then is left out.
    pub(crate) fn is_over(&self) -> bool {
        Instant::now() >= self.deadline
    }

    /// How long one figure is measured.
    pub(crate) fn lasting(&self) -> Duration {
        Duration::from_millis(if self.rehearse { 30 } else { 250 })
    }

    /// Writes a figure down.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(crate) fn add(&self, row: Row) -> Result<(), Box<dyn Error>> {
        println!(
            "{} {} x {}, {}, {}: {} = {:.4e}",
            row.sheet, row.vertices, row.sheets, row.solver, row.by, row.quantity, row.value
        );
        self.results.add(row)
    }
}
