//! From pairs to strokes: layers with their colours, and what is drawn in the section of entities.

use std::collections::BTreeMap;

use kurbo::{Affine, PathSeg, Point, Vec2};
use origami_core::error::{Error, ErrorCode, WarningCode};

use super::pairs::{Pair, pairs};
use super::{letters, shapes};
use crate::colours::Letter;
use crate::curves::Stroke;
use crate::letters::of_name;
use crate::lines::Lines;
use crate::{Colours, text};

/// What is drawn, and what of the file is left out.
pub(super) struct Drawing {
    pub(super) strokes: Vec<Stroke>,
    pub(super) odd: Lines,
}

/// An entity or an entry of a table: the pairs from its name to the next one.
type Entity<'p, 't> = &'p [Pair<'t>];

/// All that is drawn in the model.
pub(super) fn read(text: &str, rule: &Colours) -> Result<Drawing, Error> {
    let pairs = pairs(text)?;
    let mut drawing = Drawing { strokes: Vec::new(), odd: Lines::default() };
    let mut layers = BTreeMap::new();
    let mut section = "";
    let mut polyline: Option<Polyline> = None;
    // What comes before the first 0, such as comments, is no entity.
    for entity in pairs.chunk_by(|_, next| next.code != 0).filter(|entity| entity[0].code == 0) {
        let name = entity[0].value;
        match (section, name) {
            (_, "SECTION") => section = text_of(entity, 2).unwrap_or_default(),
            (_, "ENDSEC") => section = "",
            ("TABLES", "LAYER") => {
                let colour = entity.iter().find(|pair| pair.code == 62).map(Pair::integer).transpose()?;
                layers.insert(text_of(entity, 2).unwrap_or_default(), colour.unwrap_or(7));
            }
            // A polyline of the old kind: itself, its vertices, and an end.
            ("ENTITIES", "POLYLINE") => polyline = Some(Polyline { of: entity, vertices: Vec::new() }),
            ("ENTITIES", "VERTEX") => {
                let vertex = (point(entity, 10)?, value(entity, 42)?.unwrap_or(0.0));
                polyline.iter_mut().for_each(|polyline| polyline.vertices.push(vertex));
            }
            ("ENTITIES", "SEQEND") => {
                if let Some(Polyline { of, vertices }) = polyline.take() {
                    let path = polyline_path(&vertices, value(of, 70)?.unwrap_or(0.0) as i64 & 1 == 1);
                    draw(of, path, &layers, rule, &mut drawing)?;
                }
            }
            ("ENTITIES", _) => {
                if let Some(path) = path(entity, &mut drawing.odd)? {
                    draw(entity, path, &layers, rule, &mut drawing)?;
                }
            }
            _ => {}
        }
    }
    Ok(drawing)
}

/// A polyline of the old kind, until its end.
struct Polyline<'p, 't> {
    of: Entity<'p, 't>,
    vertices: Vec<(Point, f64)>,
}

/// The pieces of an entity; `None` for what is no line.
fn path(entity: Entity, odd: &mut Lines) -> Result<Option<Vec<PathSeg>>, Error> {
    let or = |code, default: f64| value(entity, code).map(|value| value.unwrap_or(default));
    let path = match entity[0].value {
        "LINE" => shapes::line(point(entity, 10)?, point(entity, 11)?),
        "LWPOLYLINE" => polyline_path(&vertices(entity)?, or(70, 0.0)? as i64 & 1 == 1),
        "CIRCLE" => shapes::arc(point(entity, 10)?, Vec2::new(or(40, 0.0)?, 0.0), 1.0, 0.0, std::f64::consts::TAU),
        "ARC" => {
            let [from, to] = [or(50, 0.0)?.to_radians(), or(51, 360.0)?.to_radians()];
            shapes::arc(point(entity, 10)?, Vec2::new(or(40, 0.0)?, 0.0), 1.0, from, to)
        }
        "ELLIPSE" => {
            let [from, to] = [or(41, 0.0)?, or(42, std::f64::consts::TAU)?];
            shapes::arc(point(entity, 10)?, point(entity, 11)?.to_vec2(), or(40, 1.0)?, from, to)
        }
        "SPLINE" => {
            let [knots, weights] = [values(entity, 40)?, values(entity, 41)?];
            match shapes::spline(or(71, 3.0)? as usize, &knots, &points(entity)?, &weights) {
                Some(path) => path,
                None => {
                    odd.left_out(|| entity[0].place(), "a spline without control points and knots that fit; left out");
                    return Ok(None);
                }
            }
        }
        "POINT" => return Ok(left_out(entity, "a point; left out", odd)),
        "TEXT" | "MTEXT" => return Ok(left_out(entity, "a text; left out", odd)),
        "INSERT" => return Ok(left_out(entity, "a block that is inserted; left out", odd)),
        "HATCH" | "SOLID" | "3DFACE" => return Ok(left_out(entity, "a filled area; left out", odd)),
        _ => return Ok(left_out(entity, "an entity that is no line; left out", odd)),
    };
    Ok(if path.is_empty() { left_out(entity, "a line without length; left out", odd) } else { Some(path) })
}

fn left_out(entity: Entity, message: &'static str, odd: &mut Lines) -> Option<Vec<PathSeg>> {
    odd.left_out(|| entity[0].place(), message);
    None
}

/// Adds a stroke, with the letter of its layer's name, its colour or its layer's colour.
fn draw(
    entity: Entity,
    path: Vec<PathSeg>,
    layers: &BTreeMap<&str, i64>,
    rule: &Colours,
    drawing: &mut Drawing,
) -> Result<(), Error> {
    let layer = text_of(entity, 8).unwrap_or_default();
    // Layers are hidden by a negative colour.
    if layers.get(layer).is_some_and(|colour| *colour < 0) {
        drawing.odd.left_out(|| entity[0].place(), "an entity of a layer that is hidden; left out");
        return Ok(());
    }
    if value(entity, 67)? == Some(1.0) {
        drawing.odd.left_out(|| entity[0].place(), "an entity of the paper space; left out");
        return Ok(());
    }
    if entity.iter().any(|pair| matches!(pair.code, 30 | 31 | 38) && pair.number().is_ok_and(|z| z != 0.0)) {
        drawing.odd.left_out(|| entity[0].place(), "heights (z) of a drawing that should be flat; left out");
    }
    let path = world(entity, path)?;
    let colour = value(entity, 62)?.map(|colour| colour as i64).filter(|colour| *colour != 256);
    let true_colour = value(entity, 420)?.map(|colour| (colour as i64).to_be_bytes());
    let of_true = true_colour.and_then(|[.., r, g, b]| rule.letter([r, g, b])?.0.map(Letter::letter));
    let of_index = || colour.or_else(|| layers.get(layer).copied()).and_then(letters::of_index);
    let letter = of_name(layer).or(of_true).or_else(of_index);
    let letter = letter.unwrap_or_else(|| {
        drawing.odd.note(
            WarningCode::MissingLetters,
            || entity[0].place(),
            "neither layer nor colour says what this line is; taken as unassigned",
        );
        "U"
    });
    let source = format!("line {}", entity[0].line);
    drawing.strokes.push(Stroke { path, letter, angle: None, source });
    Ok(())
}

/// Arcs and polylines that were drawn on the back of the plane have x the other way round.
fn world(entity: Entity, path: Vec<PathSeg>) -> Result<Vec<PathSeg>, Error> {
    const OWN_AXES: [&str; 4] = ["ARC", "CIRCLE", "LWPOLYLINE", "POLYLINE"];
    let from_behind = OWN_AXES.contains(&entity[0].value) && value(entity, 230)?.is_some_and(|z| z < 0.0);
    let turned = |piece| Affine::FLIP_X * piece;
    Ok(if from_behind { path.into_iter().map(turned).collect() } else { path })
}

fn polyline_path(vertices: &[(Point, f64)], closed: bool) -> Vec<PathSeg> {
    let next = vertices.iter().cycle().skip(1);
    let count = if closed && vertices.len() > 1 { vertices.len() } else { vertices.len().saturating_sub(1) };
    vertices
        .iter()
        .zip(next)
        .take(count)
        .flat_map(|((from, bulge), (to, _))| shapes::bulged(*from, *to, *bulge))
        .collect()
}

/// The vertices of a light polyline, each with its bulge: groups 10, 20 and, behind them, 42.
fn vertices(entity: Entity) -> Result<Vec<(Point, f64)>, Error> {
    let mut vertices: Vec<(Point, f64)> = Vec::new();
    for pair in entity {
        match (pair.code, vertices.last_mut()) {
            (10, _) => vertices.push((Point::new(pair.number()?, 0.0), 0.0)),
            (20, Some((point, _))) => point.y = pair.number()?,
            (42, Some((_, bulge))) => *bulge = pair.number()?,
            _ => {}
        }
    }
    Ok(vertices)
}

/// The control points of a spline.
fn points(entity: Entity) -> Result<Vec<Point>, Error> {
    Ok(vertices(entity)?.into_iter().map(|(point, _)| point).collect())
}

fn text_of<'t>(entity: &[Pair<'t>], code: i32) -> Option<&'t str> {
    entity.iter().skip(1).find(|pair| pair.code == code).map(|pair| pair.value)
}

fn value(entity: Entity, code: i32) -> Result<Option<f64>, Error> {
    entity.iter().skip(1).find(|pair| pair.code == code).map(Pair::number).transpose()
}

fn values(entity: Entity, code: i32) -> Result<Vec<f64>, Error> {
    entity.iter().filter(|pair| pair.code == code).map(Pair::number).collect()
}

/// The point in groups `code` and `code + 10`.
fn point(entity: Entity, code: i32) -> Result<Point, Error> {
    let part = |code| {
        let missing = || {
            let problem = format!("{} has no group {code}", text::quoted(entity[0].value));
            Error::new(ErrorCode::MissingKey, entity[0].place(), problem, "a coordinate")
        };
        value(entity, code)?.ok_or_else(missing)
    };
    Ok(Point::new(part(code)?, part(code + 10)?))
}
