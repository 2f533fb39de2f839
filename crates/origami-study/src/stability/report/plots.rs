//! Curves of the study.

use crate::plot::{Axis, Mark, Plot, Scale, Series};
use crate::stability::drift::Drift;
use crate::stability::found::Found;
use crate::stability::row::Row;

use super::summary::ratios;

fn axis(label: &str, scale: Scale) -> Axis {
    Axis { label: label.into(), scale }
}

fn series(label: &str, mark: Mark, points: Vec<(f64, f64)>) -> Series {
    Series { label: label.into(), mark, points }
}

/// Bound over largest step of every row, a series for each family.
pub(super) fn ratios_by_family(rows: &[Row]) -> Plot {
    let mut all: Vec<Series> = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let points = row.found().into_iter().flat_map(ratios).map(|(_, ratio)| ((i + 1) as f64, ratio));
        let family = row.case.family;
        match all.last_mut().filter(|last| last.label == family) {
            Some(last) => last.points.extend(points),
            None => all.push(series(family, Mark::Points, points.collect())),
        }
    }
    Plot {
        title: "The bound against the largest step that holds".into(),
        note: "At rest with Euler and Verlet, and folded with Euler; a bound that holds lies at 1 or below".into(),
        x: axis("row of the table", Scale::Linear),
        y: axis("bound / largest step that holds", Scale::Linear),
        series: all,
    }
}

/// A family whose steps are drawn against its parameter.
struct Curve {
    file: &'static str,
    family: &'static str,
    pattern: &'static str,
    x: &'static str,
    scale: Scale,
}

const CURVES: [Curve; 5] = [
    Curve { file: "steps-ea", family: "EA", pattern: "Miura 4x4", x: "EA", scale: Scale::Log },
    Curve { file: "steps-k-fold", family: "k_fold", pattern: "Miura 4x4", x: "k_fold", scale: Scale::Log },
    Curve { file: "steps-zeta", family: "zeta", pattern: "Miura 4x4", x: "zeta", scale: Scale::Linear },
    Curve { file: "steps-valence", family: "valence", pattern: "hub", x: "valence", scale: Scale::Log },
    Curve { file: "steps-slivers", family: "slivers", pattern: "single crease", x: "height / edge", scale: Scale::Log },
];

/// Name of the file, and largest step, bound and paper's step against what is varied.
pub(super) fn steps(rows: &[Row]) -> Vec<(&'static str, Plot)> {
    CURVES.iter().map(|curve| (curve.file, curve.plot(rows))).collect()
}

impl Curve {
    fn plot(&self, rows: &[Row]) -> Plot {
        let these =
            || rows.iter().filter(|row| row.case.family == self.family && row.case.pattern_name == self.pattern);
        let points = |y: &dyn Fn(&Found) -> Option<f64>| {
            let mut points: Vec<(f64, f64)> =
                these().filter_map(|row| Some((row.case.value, y(row.found()?)?))).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            points
        };
        Plot {
            title: format!("Time steps against {}", self.x),
            note: format!("{}, at rest, Euler", self.pattern),
            x: axis(self.x, self.scale),
            y: axis("time step, in units of model time", Scale::Log),
            series: vec![
                series("largest step that holds", Mark::Line, points(&|found| found.at_rest.largest)),
                series("bound", Mark::Line, points(&|found| Some(found.at_rest.bound))),
                series("paper's step", Mark::Dashed, points(&|found| Some(found.paper_step))),
            ],
        }
    }
}

/// Energy of the undamped runs over their steps.
pub(super) fn drift(drifts: &[Drift]) -> Plot {
    let curves = drifts.iter().filter(|drift| !drift.energies.is_empty()).map(|drift| {
        let points = drift.energies.iter().map(|(step, energy)| (*step as f64, *energy)).collect();
        series(drift.name, Mark::Line, points)
    });
    Plot {
        title: "Energy of a sheet without damping".into(),
        note: "Miura 2x2, the target jumps from 0 to 20 %, the sheet spins; the energy that a discrete step keeps"
            .into(),
        x: axis("steps", Scale::Linear),
        y: axis("energy, in shares of that at the start", Scale::Linear),
        series: curves.collect(),
    }
}

/// How far 32 bits are from 64 against EA.
pub(super) fn in_32_bits(rows: &[Row], gpu: &str) -> Plot {
    let of = |pattern: &str, distance: &dyn Fn(&Row) -> Option<f64>| {
        let these = rows.iter().filter(|row| row.case.family == "EA" && row.case.pattern_name == pattern);
        these.filter_map(|row| Some((row.case.value, distance(row)?))).collect::<Vec<_>>()
    };
    let mut all = Vec::new();
    for pattern in ["Miura 4x4", "fan of 16"] {
        let steps = of(pattern, &|row| row.gpu.as_ref().and_then(|gpu| gpu.after_steps));
        let end = of(pattern, &|row| row.gpu.as_ref().and_then(|gpu| gpu.at_equilibrium));
        all.push(series(&format!("{pattern}, after the same steps"), Mark::Dashed, steps));
        all.push(series(&format!("{pattern}, relaxed"), Mark::Line, end));
    }
    Plot {
        title: "How far 32 bits are from 64".into(),
        note: gpu.into(),
        x: axis("EA", Scale::Log),
        y: axis("largest distance of a vertex, in radii", Scale::Log),
        series: all,
    }
}
