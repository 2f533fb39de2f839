//! What can be said of a state.

use origami::contact::Crossings;
use origami::measure::{Strain, Summary, angle_error};
use origami::model::Model;
use origami::solve::{Folded, Stop};
use serde::{Deserialize, Serialize};

use super::{ContactFacts, CrossingFacts};
use crate::numbers::percent_of;

/// How a state was reached and what it is like. Numbers that are not known are null.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Measured {
    /// Of a sequence the step.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) step: Option<String>,
    /// Null in a sequence.
    pub(crate) percent: f64,
    pub(crate) time_step: Option<f64>,
    pub(crate) steps: u64,
    pub(crate) converged: bool,
    pub(crate) stop: Ending,
    pub(crate) attempts: u32,
    #[serde(default)]
    pub(crate) saddles: u32,
    #[serde(default)]
    pub(crate) factorisations: u32,
    pub(crate) residual: Option<f64>,
    pub(crate) distance: Option<f64>,
    pub(crate) strain: Option<Statistics>,
    pub(crate) nodes_strain: Option<Statistics>,
    pub(crate) energy: Option<Energy>,
    pub(crate) angle_error_deg: Option<AngleError>,
    pub(crate) tangled: Option<bool>,
    pub(crate) tangled_creases: Option<usize>,
    /// With `--check`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) crossings: Option<CrossingFacts>,
    /// With `--contact`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) contact: Option<ContactFacts>,
}

/// Why a solver stopped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Ending {
    Converged,
    StepsDone,
    StepLimit,
    /// The time that it was given was over.
    TimeLimit,
    /// A triangle was crushed to a line.
    Crushed,
    /// Contact keeps it from its angles.
    Blocked,
    /// What computes gave up; in a sweep only.
    Failed,
    /// Also what holds of a state that no solver arrived at.
    #[default]
    Diverged,
}

/// Of absolute values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Statistics {
    pub(crate) mean: f64,
    pub(crate) rms: f64,
    pub(crate) max: f64,
}

/// By kind of spring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Energy {
    beams: f64,
    creases: f64,
    corner_angles: f64,
    areas: f64,
    total: f64,
}

/// In degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct AngleError {
    pub(crate) mean: f64,
    pub(crate) max: f64,
}

impl From<Summary> for Statistics {
    fn from(summary: Summary) -> Self {
        Self { mean: summary.mean, rms: summary.rms, max: summary.max }
    }
}

impl Measured {
    /// That of a state that a solver arrived at.
    pub(crate) fn new(model: &Model, folded: &Folded) -> Self {
        let strain = Strain::of(model, &folded.state.positions);
        let energy = folded.state.energy(model);
        let angles = angle_error(&folded.state);
        let tangled = folded.state.tangled_creases();
        Self {
            step: None,
            percent: percent_of(folded),
            time_step: Some(folded.time_step),
            steps: folded.steps,
            converged: folded.converged(),
            stop: folded.stop.into(),
            attempts: folded.attempts,
            saddles: folded.saddles,
            factorisations: folded.factorisations,
            residual: Some(folded.residual),
            distance: Some(folded.distance),
            strain: Some(strain.beams.into()),
            nodes_strain: Some(strain.nodes.into()),
            energy: Some(Energy {
                beams: energy.beams,
                creases: energy.creases,
                corner_angles: energy.corner_angles,
                areas: energy.areas,
                total: energy.total(),
            }),
            angle_error_deg: Some(AngleError { mean: angles.mean, max: angles.max }),
            tangled: Some(tangled > 0),
            tangled_creases: Some(tangled),
            crossings: None,
            contact: None,
        }
    }

    /// The same with the crossings of the state, if they are asked for.
    pub(crate) fn checked(self, check: bool, model: &Model, folded: &Folded) -> Self {
        let crossings = check.then(|| CrossingFacts::new(&Crossings::of(&model.mesh, &folded.state.positions), 1.0));
        Self { crossings, ..self }
    }
}

impl From<Stop> for Ending {
    fn from(stop: Stop) -> Self {
        match stop {
            Stop::Converged => Self::Converged,
            Stop::StepsDone => Self::StepsDone,
            Stop::Crushed => Self::Crushed,
            Stop::Blocked => Self::Blocked,
            // The command line breaks nothing off for another reason.
            Stop::Cancelled => Self::TimeLimit,
            _ => Self::StepLimit,
        }
    }
}
