//! Files of the sheet as it is, as the command line writes them.

use origami_core::export::{Pose, write_obj, write_stl};
use origami_core::measure::attitude::{Hold, turned};
use origami_core::measure::edge_fold_angles;
use origami_core::solve::{Report, State};
use origami_core::{Error, Model};

use crate::message::ExportFormat;
use crate::packet::Packet;
use crate::sheet::Sheet;

impl ExportFormat {
    /// Without the dot.
    pub(crate) fn extension(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Glb => "glb",
        }
    }

    /// The media type.
    pub(crate) fn media(self) -> &'static str {
        match self {
            Self::Fold => "application/json",
            Self::Obj => "model/obj",
            Self::Stl => "model/stl",
            Self::Glb => "model/gltf-binary",
        }
    }
}

/// A state of a model: to how many per cent and in which step it was folded.
pub(crate) type Shown<'a> = (&'a Model, &'a State, Option<f64>, Option<&'a str>);

/// The file.
pub(crate) fn file(
    format: ExportFormat,
    sheet: &Sheet,
    (model, state, percent, step): Shown<'_>,
    report: Report,
) -> Result<Vec<u8>, Error> {
    let pattern = &sheet.pattern;
    let state = turned(model, state, Hold::Sheet)?;
    let mut bytes = Vec::new();
    match format {
        ExportFormat::Fold => {
            let pose = Pose {
                percent,
                positions: model.file_positions(pattern, &state.positions),
                fold_angles: edge_fold_angles(model, pattern, &state),
                step: step.map(str::to_owned),
            };
            let mut document = sheet.template.folded_form(pattern, &pose)?;
            let extra = &mut document.key_frame.extra;
            extra.insert("origami:converged".into(), report.settled.into());
            extra.insert("origami:distance".into(), report.distance.into());
            // That of the input was of another state.
            extra.shift_remove("faceOrders");
            if let Some(orders) = picture::orders(model, &state) {
                extra.insert("faceOrders".into(), orders);
            }
            document.write_to(&mut bytes)?;
        }
        ExportFormat::Obj => write_obj(&mut bytes, pattern, &model.file_positions(pattern, &state.positions))?,
        ExportFormat::Stl => {
            let points: Vec<_> = state.positions.iter().map(|p| model.normalisation.to_file(*p)).collect();
            let mesh = &model.mesh;
            let triangles: Vec<[u32; 3]> =
                mesh.triangles_by_face.iter().map(|t| mesh.triangles[t.index()].map(|node| node.0)).collect();
            write_stl(&mut bytes, &points, &triangles)?;
        }
        ExportFormat::Glb => picture::glb(pattern, model, &state, &mut bytes)?,
    }
    Ok(bytes)
}

/// A film as a page of its own, which is called `title`.
pub(crate) fn page(film: &Packet, title: &str) -> Result<Vec<u8>, Error> {
    let page = origami_page::film(&film.to_bytes(), title);
    page.map(String::into_bytes).map_err(|source| Error::Io { path: "-".to_owned(), source })
}

#[cfg(feature = "picture")]
mod picture {
    use origami_core::{CreasePattern, Error, Model, State};
    use origami_picture::layers::{FaceOrder, face_orders};
    use origami_picture::{Figure, Glb};
    use serde_json::{Value, json};

    /// FOLD's `faceOrders` of a state that is folded flat.
    pub(super) fn orders(model: &Model, state: &State) -> Option<Value> {
        let triple = |order: FaceOrder| json!([order.faces[0].0, order.faces[1].0, order.side]);
        face_orders(model, state).map(|orders| orders.into_iter().map(triple).collect())
    }

    pub(super) fn glb(pattern: &CreasePattern, model: &Model, state: &State, to: &mut Vec<u8>) -> Result<(), Error> {
        Glb::of(model).write(&Figure::of_state(pattern, model, state), &[], to)
    }
}

#[cfg(not(feature = "picture"))]
mod picture {
    use origami_core::{CreasePattern, Error, Model, State};
    use serde_json::Value;

    pub(super) fn orders(_model: &Model, _state: &State) -> Option<Value> {
        None
    }

    pub(super) fn glb(
        _pattern: &CreasePattern,
        _model: &Model,
        _state: &State,
        _to: &mut Vec<u8>,
    ) -> Result<(), Error> {
        Err(Error::invalid(
            "glTF",
            "this build draws nothing",
            "FOLD, OBJ or STL, or a build with the feature `render`",
        ))
    }
}
