//! Bars and hinges of a job: stiffnesses from the file's edges, the job's numbers, the sheet's material or the model.

use super::{Job, Rest};
use crate::analysis::{HingeKind, Structure};
use crate::error::{Error, ErrorCode, Place};
use crate::ids::{NodeId, SideId};
use crate::mesh::Side;
use crate::model::{Crease, Model};
use crate::pattern::{CreasePattern, PatternEdge};

impl Job {
    /// Gives the members of `structure`, which is of `model` and in the job's lengths, their laws, stiffnesses and rest angles.
    /// `scale` is how long a radius is.
    pub(super) fn set_members(
        &self,
        structure: &mut Structure,
        pattern: &CreasePattern,
        model: &Model,
        scale: f64,
    ) -> Result<(), Error> {
        let edge_of = |side: SideId| -> Option<&PatternEdge> {
            model.mesh.sides[side.index()].edge.map(|e| &pattern.edges[e.index()])
        };
        let from_sheet = self.rigidities(model, scale);
        for (i, bar) in structure.bars.iter_mut().enumerate() {
            bar.law = self.bar.law;
            let own = edge_of(SideId::new(i)).and_then(|edge| edge.ea);
            bar.rigidity = match own.or(self.bar.ea).or(from_sheet.as_ref().map(|all| all[i])) {
                Some(rigidity) => rigidity,
                None if self.units.is_none() => bar.rigidity,
                None => return Err(missing("bar.ea", "a rigidity, or a `sheet` to take it from")),
            };
        }
        for (hinge, crease) in structure.hinges.iter_mut().zip(&model.creases) {
            let (job, key) = match hinge.kind {
                HingeKind::Crease => (&self.crease, "crease.k"),
                HingeKind::Facet => (&self.facet, "facet.k"),
            };
            let edge = edge_of(crease.side);
            let ends = [2, 3].map(|i| hinge.nodes[i].index());
            let length = structure.nodes[ends[0]].distance(structure.nodes[ends[1]]);
            let per_length = edge.and_then(|edge| edge.k_crease).or(job.k);
            hinge.law = job.law();
            hinge.stiffness = match (per_length, &self.sheet) {
                (Some(k), _) => k * length,
                (None, Some(sheet)) if hinge.kind == HingeKind::Facet => sheet.facet(length),
                (None, Some(sheet)) => match job.length_scale {
                    Some(l) => sheet.crease(length, l),
                    None => {
                        return Err(missing("crease.length_scale", "the creases' L*, or their stiffness `crease.k`"));
                    }
                },
                (None, None) if self.units.is_none() => hinge.stiffness,
                (None, None) => return Err(missing(key, "a stiffness, or a `sheet` to take it from")),
            };
            hinge.rest_angle = rest_angle(self.rest, crease);
        }
        // Without units the model's springs are all there; a sheet of material has its shear in the bars.
        if self.units.is_some() {
            structure.corners.clear();
        }
        Ok(())
    }

    /// EA of each bar from the sheet's material.
    fn rigidities(&self, model: &Model, scale: f64) -> Option<Vec<f64>> {
        let sheet = self.sheet.as_ref()?;
        let of_side = |side: &Side| {
            let share = |apex: NodeId| {
                let [a, b, c] = [side.nodes[0], side.nodes[1], apex].map(|n| model.rest[n.index()] * scale);
                let area = 0.5 * (b - a).cross(c - a).length();
                sheet.rigidity(area, a.distance(b) + b.distance(c) + c.distance(a))
            };
            side.apexes.into_iter().flatten().map(share).sum()
        };
        Some(model.mesh.sides.iter().map(of_side).collect())
    }

    /// Whether its numbers are in range.
    pub(super) fn check(&self) -> Result<(), Error> {
        let wrong = |key: &str, x: f64, expected: &str| {
            Err(Error::new(ErrorCode::WrongValue, Place::key(key.to_owned()), format!("is {x}"), expected))
        };
        let above_zero = [("bar.ea", self.bar.ea), ("crease.length_scale", self.crease.length_scale)];
        for (key, x) in above_zero.into_iter().filter_map(|(key, x)| x.map(|x| (key, x))) {
            if !(x.is_finite() && x > 0.0) {
                return wrong(key, x, "a number above 0");
            }
        }
        for (name, hinge) in [("crease", &self.crease), ("facet", &self.facet)] {
            if let Some(k) = hinge.k.filter(|k| !(k.is_finite() && *k >= 0.0)) {
                return wrong(&format!("{name}.k"), k, "a number of at least 0");
            }
            let [least, most] = hinge.from.unwrap_or_default().between();
            if !(0.0 < least && least < most && most < 360.0) {
                let place = Place::key(format!("{name}.from"));
                let expected = "angles above 0 and below 360 degrees, in order; one alone below 180";
                return Err(Error::new(ErrorCode::WrongValue, place, format!("is from {least} to {most}"), expected));
            }
            if let Some(exponent) = hinge.exponent.filter(|x| !(x.is_finite() && *x >= 1.0)) {
                return wrong(&format!("{name}.exponent"), exponent, "a number of at least 1");
            }
        }
        if self.facet.length_scale.is_some() {
            let (problem, expected) = ("facets have none", "`crease.length_scale`, or no such key");
            return Err(Error::new(ErrorCode::WrongValue, Place::key("facet.length_scale"), problem, expected));
        }
        match (&self.sheet, &self.units) {
            (Some(_), None) => Err(missing("units", "units of length and force, in which `sheet` is")),
            (Some(sheet), Some(units)) => units.check().and_then(|()| sheet.check()),
            (None, Some(units)) => units.check(),
            (None, None) => Ok(()),
        }
    }
}

fn missing(key: &'static str, expected: &str) -> Error {
    Error::new(ErrorCode::MissingKey, Place::key(key), "is missing", expected)
}

fn rest_angle(rest: Rest, crease: &Crease) -> f64 {
    match rest {
        Rest::AsDrawn => crease.rest_angle,
        Rest::Flat => 0.0,
        Rest::Target => crease.full_target,
    }
}
