//! From vertices, faces and lines to a FOLD document.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};
use origami_core::error::{Place, Warning, WarningCode};
use origami_core::fold::{Coordinates, Document, Frame};
use origami_core::pattern::{fold_angle, keys};

use super::Obj;

/// Texture coordinates are the flat sheet where the lengths of all sides, those on the texture against those in space, have
/// one ratio to this much: paper that was folded by a simulation is a few percent strained.
const ISOMETRIC: f64 = 0.1;
/// Nearer to 180 degrees than this a fold angle, in radians, has no sign that could be measured.
const SIGNLESS: f64 = 1e-3;

/// The document: one frame, or the pattern and its folded form.
pub(super) fn document(obj: Obj) -> Document {
    let mut warnings = obj.warnings.clone();
    let flat = obj.vertices.iter().all(|vertex| vertex.z == obj.vertices[0].z);
    let on_texture = if flat { None } else { obj.texture.as_deref().and_then(|texture| flat_sheet(&obj, texture)) };
    if let (false, Some(_), None) = (flat, &obj.texture, &on_texture) {
        let message =
            "texture coordinates that are no flat sheet of these faces; the sheet is taken as it lies in space";
        warnings.push(Warning::new(WarningCode::LeftOut, Place::Line { line: obj.faces_at[0], column: None }, message));
    }
    let mut key_frame = Frame { classes: Some(vec!["creasePattern".into()]), ..Frame::default() };
    let mut frames = Vec::new();
    if !obj.faces.is_empty() {
        key_frame.faces_vertices = Some(obj.faces.clone());
        let at: Vec<String> = obj.faces_at.iter().map(|line| format!("line {line}")).collect();
        key_frame.extra.insert(keys::FACES_SOURCE.into(), at.into());
    }
    lines(&obj, &mut key_frame);
    match on_texture {
        Some(sheet) => {
            if key_frame.edges_vertices.is_none() {
                measured(&obj, &mut key_frame, &mut warnings);
            }
            key_frame.vertices_coords = Some(sheet.iter().map(|p| Coordinates::planar(p.extend(0.0))).collect());
            frames.push(Frame {
                parent: Some(0),
                inherit: true,
                classes: Some(vec!["foldedForm".into()]),
                vertices_coords: Some(obj.vertices.iter().map(|&p| Coordinates::spatial(p)).collect()),
                ..Frame::default()
            });
        }
        None => {
            let point = if flat { Coordinates::planar } else { Coordinates::spatial };
            key_frame.vertices_coords = Some(obj.vertices.iter().map(|&p| point(p)).collect());
        }
    }
    Document { key_frame, frames, warnings, ..Document::default() }
}

/// The lines of the file as edges. One whose letter nothing says is unassigned.
fn lines(obj: &Obj, frame: &mut Frame) {
    if obj.lines.is_empty() {
        return;
    }
    let lines = || obj.lines.iter().filter(|line| line.ends[0] != line.ends[1]);
    frame.edges_vertices = Some(lines().map(|line| line.ends).collect());
    if lines().any(|line| line.letter.is_some()) {
        frame.edges_assignment = Some(lines().map(|line| line.letter.unwrap_or("U").into()).collect());
    }
    let at: Vec<String> = lines().map(|line| format!("line {}", line.at)).collect();
    frame.extra.insert(keys::SOURCE.into(), at.into());
}

/// The sheet that the texture coordinates are, in the unit of the vertices; `None` where its sides are not as long as those
/// of the faces.
fn flat_sheet(obj: &Obj, texture: &[DVec2]) -> Option<Vec<DVec2>> {
    let (mut in_space, mut on_texture) = (0.0, 0.0);
    let mut ratios = Vec::new();
    for [a, b] in sides(obj) {
        let length = obj.vertices[a as usize].distance(obj.vertices[b as usize]);
        let flat = texture[a as usize].distance(texture[b as usize]);
        in_space += length;
        on_texture += flat;
        ratios.push(length / flat);
    }
    let scale: f64 = in_space / on_texture;
    let alike = ratios.iter().all(|ratio| (ratio / scale - 1.0).abs() <= ISOMETRIC);
    (scale.is_finite() && scale > 0.0 && alike).then(|| texture.iter().map(|&point| point * scale).collect())
}

/// The sides of all faces, in their directions.
fn sides(obj: &Obj) -> impl Iterator<Item = [u32; 2]> {
    obj.faces.iter().flat_map(|face| face.iter().zip(face.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]))
}

/// Letters and fold angles as the faces lie in space.
fn measured(obj: &Obj, frame: &mut Frame, warnings: &mut Vec<Warning>) {
    let normals: Vec<DVec3> = obj.faces.iter().map(|face| normal(obj, face)).collect();
    // The faces that run along a line, from its lower vertex to the higher and back.
    let mut faces_at: BTreeMap<[u32; 2], [Option<usize>; 2]> = BTreeMap::new();
    for (index, face) in obj.faces.iter().enumerate() {
        for (&a, &b) in face.iter().zip(face.iter().cycle().skip(1)).filter(|(a, b)| a != b) {
            faces_at.entry([a.min(b), a.max(b)]).or_default()[usize::from(a > b)] = Some(index);
        }
    }
    let (mut letters, mut angles, mut signless) = (Vec::new(), Vec::new(), Vec::new());
    for (&[a, b], faces) in &faces_at {
        let [Some(along), Some(against)] = *faces else {
            letters.push("B".into());
            angles.push(Some(0.0));
            continue;
        };
        let [from, to] = [a, b].map(|vertex| obj.vertices[vertex as usize]);
        let edge = to - from;
        let [one, other] = [normals[along].cross(edge), normals[against].cross(-edge)];
        let angle = fold_angle(from + one, from + other, from, to);
        if angle.abs() > std::f64::consts::PI - SIGNLESS {
            signless.push([a, b]);
        }
        let degrees = if angle.is_finite() { angle.to_degrees() } else { 0.0 };
        let letter = if degrees.abs() < 1e-6 {
            "F"
        } else if degrees < 0.0 {
            "M"
        } else {
            "V"
        };
        letters.push(letter.into());
        angles.push(Some(degrees));
    }
    if let Some([a, b]) = signless.first() {
        let message = format!(
            "{} of the creases, the first between vertices {a} and {b}, lie folded flat: whether as mountains or valleys cannot be measured",
            signless.len()
        );
        warnings.push(Warning::new(WarningCode::MissingLetters, Place::key("edges_assignment"), message));
    }
    frame.edges_vertices = Some(faces_at.into_keys().collect());
    frame.edges_assignment = Some(letters);
    frame.edges_fold_angle = Some(angles);
}

/// The direction from which a face is seen counterclockwise; zero for one without area.
fn normal(obj: &Obj, face: &[u32]) -> DVec3 {
    let at = |vertex: &u32| obj.vertices[*vertex as usize];
    let origin = at(&face[0]);
    let pairs = face.iter().zip(&face[1..]);
    pairs.map(|(a, b)| (at(a) - origin).cross(at(b) - origin)).sum::<DVec3>().normalize_or_zero()
}
