//! Plots of what a run wrote.

use std::error::Error;
use std::path::{Path, PathBuf};

use origami::study::{Axis, Mark, Plot, Scale, Series};

use crate::kept::{Run, distinct};
use crate::results::Row;

/// Draws the plots of a run into a folder, and names them; none where there are no figures for it.
///
/// # Errors
/// If one cannot be drawn or written.
pub(crate) fn draw(run: &Run, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    let mut drawn = Vec::new();
    let kinds = [("dynamics", "speed", "seconds a step"), ("relax", "speed", "seconds a step")];
    for (solver, section, quantity) in kinds {
        let plot = Plot {
            title: format!("Vertices times steps in a second, {solver}"),
            note: format!("Miura sheets on their way to 60 %; {}", run.adapter()),
            x: Axis { label: "vertices".into(), scale: Scale::Log },
            y: Axis { label: "vertices times steps a second".into(), scale: Scale::Log },
            series: series(run.of(section, quantity).filter(|row| row.solver == solver), |row| {
                (row.vertices as f64, row.vertices as f64 / row.value)
            }),
        };
        drawn.extend(write(&plot, folder.join(format!("{}-{solver}.svg", run.name)))?);
    }
    let plot = Plot {
        title: "Time until all of many bird bases are folded".into(),
        note: run.adapter(),
        x: Axis { label: "sheets".into(), scale: Scale::Log },
        y: Axis { label: "seconds".into(), scale: Scale::Log },
        series: series(
            run.of("ensembles", "seconds until all are folded").filter(|row| row.sheet == "bird-base"),
            |row| (row.sheets as f64, row.value),
        ),
    };
    drawn.extend(write(&plot, folder.join(format!("{}-ensembles.svg", run.name)))?);
    Ok(drawn)
}

/// A curve for each thing that computed, from left to right.
fn series<'r>(rows: impl Iterator<Item = &'r Row>, point: impl Fn(&Row) -> (f64, f64)) -> Vec<Series> {
    let rows: Vec<&Row> = rows.collect();
    let curve = |by: &str| {
        let mut points: Vec<(f64, f64)> = rows.iter().filter(|row| row.by == by).map(|row| point(row)).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mark = if by.starts_with("CPU") { Mark::Dashed } else { Mark::Line };
        Series { label: by.to_owned(), mark, points }
    };
    distinct(rows.iter().map(|row| row.by.as_str())).into_iter().map(curve).collect()
}

fn write(plot: &Plot, path: PathBuf) -> Result<Option<PathBuf>, Box<dyn Error>> {
    if plot.series.is_empty() {
        return Ok(None);
    }
    std::fs::write(&path, plot.svg()?)?;
    Ok(Some(path))
}
