//! From text to vertices, faces and lines.

use std::borrow::Cow;

use glam::{DVec2, DVec3};
use origami_core::error::{Error, ErrorCode, Place};

use super::{Line, Obj};
use crate::colours::Letter;
use crate::lines::Lines;
use crate::{Colours, letters, number, text};

/// What is understood and says nothing of a pattern.
const SILENT: [&str; 8] = ["vn", "vp", "s", "mtllib", "end", "call", "lod", "shadow_obj"];

/// All that one file says.
pub(super) fn read(text: &str, rule: &Colours) -> Result<Obj, Error> {
    let mut reader = Reader::default();
    for (line, statement) in statements(text) {
        reader.line = line;
        reader.statement(&statement)?;
    }
    reader.finish(rule)
}

/// Statements with the lines on which they begin: a backslash at its end continues a line.
fn statements(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = text::numbered_lines(text);
    std::iter::from_fn(move || {
        let (line, first) = lines.next()?;
        let Some(start) = first.strip_suffix('\\') else { return Some((line, first.into())) };
        let mut whole = start.to_owned();
        for (_, next) in lines.by_ref() {
            whole.push(' ');
            whole.push_str(next.trim_end_matches('\\'));
            if !next.ends_with('\\') {
                break;
            }
        }
        Some((line, whole.into()))
    })
}

/// A corner: a vertex and, where given, its texture coordinates, both by index from 0.
type Corner = (usize, Option<usize>);

#[derive(Default)]
struct Reader {
    line: usize,
    vertices: Vec<DVec3>,
    colours: Vec<Option<[f64; 3]>>,
    texture: Vec<DVec2>,
    /// Corners of faces and lines, with the line on which each stands.
    faces: Vec<(Vec<Corner>, usize)>,
    lines: Vec<([Corner; 2], Option<&'static str>, usize)>,
    /// The letters that the names of the object, group and material say.
    names: [Option<&'static str>; 3],
    odd: Lines,
}

impl Reader {
    fn place(&self) -> Place {
        Place::Line { line: self.line, column: None }
    }

    fn statement(&mut self, text: &str) -> Result<(), Error> {
        let mut words = text.split_whitespace();
        let Some(keyword) = words.next() else { return Ok(()) };
        let words: Vec<&str> = words.take_while(|word| !word.starts_with('#')).collect();
        match keyword {
            "v" => self.vertex(&words)?,
            "vt" => {
                let [u, v] = [0, 1].map(|i| words.get(i).copied().unwrap_or("0"));
                self.texture.push(DVec2::new(self.number(u, "u")?, self.number(v, "v")?));
            }
            "f" | "fo" => {
                let corners = self.corners(&words, 3)?;
                self.faces.push((corners, self.line));
            }
            "l" => {
                let corners = self.corners(&words, 2)?;
                let letter = self.names.iter().rev().find_map(|letter| *letter);
                self.lines.extend(corners.windows(2).map(|ends| ([ends[0], ends[1]], letter, self.line)));
            }
            "o" => self.names = [letters::of_name(&words.join(" ")), None, None],
            "g" => self.names[1] = letters::of_name(&words.join(" ")),
            "usemtl" => self.names[2] = letters::of_name(&words.join(" ")),
            "#e" => self.edge_of_freeform(&words),
            "p" => self.left_out("points; left out"),
            _ if keyword.starts_with('#') || SILENT.contains(&keyword) => {}
            _ => self.left_out("a statement that is no vertex, face or line; left out"),
        }
        Ok(())
    }

    fn left_out(&mut self, message: &'static str) {
        let place = self.place();
        self.odd.left_out(|| place, message);
    }

    fn number(&self, word: &str, what: &str) -> Result<f64, Error> {
        number::finite(word, || self.place(), what)
    }

    /// `v x y z`, with a weight or a colour or both behind.
    fn vertex(&mut self, words: &[&str]) -> Result<(), Error> {
        if words.len() < 3 {
            let problem = format!("a vertex of {} numbers", words.len());
            return Err(Error::new(ErrorCode::WrongLength, self.place(), problem, "v x y z"));
        }
        let [x, y, z] = [("x", 0), ("y", 1), ("z", 2)].map(|(what, i)| self.number(words[i], what));
        self.vertices.push(DVec3::new(x?, y?, z?));
        let colour = match words.len() {
            6.. => {
                let part = |i: usize| self.number(words[words.len() - 3 + i], "a colour");
                Some([part(0)?, part(1)?, part(2)?])
            }
            _ => None,
        };
        self.colours.push(colour);
        Ok(())
    }

    /// At least `least` corners, such as `3`, `3/1`, `3/1/2`, `3//2` or `-1`, the vertex before.
    fn corners(&self, words: &[&str], least: usize) -> Result<Vec<Corner>, Error> {
        if words.len() < least {
            let (problem, expected) = (format!("has {} corners", words.len()), format!("{least} or more"));
            return Err(Error::new(ErrorCode::FaceOfFewCorners, self.place(), problem, expected));
        }
        let corner = |word: &&str| {
            let mut parts = word.split('/');
            let vertex = self.index(parts.next().unwrap_or_default(), self.vertices.len())?;
            let texture = parts.next().filter(|part| !part.is_empty());
            Ok((vertex, texture.map(|part| self.index(part, self.texture.len())).transpose()?))
        };
        words.iter().map(corner).collect()
    }

    /// From OBJ's count, from 1 or backwards from -1, to one from 0.
    fn index(&self, word: &str, so_far: usize) -> Result<usize, Error> {
        let refuse =
            |code, problem| Err(Error::new(code, self.place(), problem, "numbers from 1, or from -1 backwards"));
        let Ok(number) = word.parse::<i64>() else {
            return refuse(ErrorCode::WrongType, format!("{} is no number of a vertex", text::quoted(word)));
        };
        let index = if number > 0 { number - 1 } else { number.saturating_add(so_far as i64) };
        match usize::try_from(index) {
            Ok(index) if number != 0 => Ok(index),
            _ => refuse(ErrorCode::NoSuchVertex, format!("vertex {number} does not exist")),
        }
    }

    /// `#e a b type angle`, which Freeform Origami and others hide in a comment: 1 border, 2 valley, 3 mountain. What is
    /// not of this form is a comment.
    fn edge_of_freeform(&mut self, words: &[&str]) {
        let [a, b, kind, ..] = words else { return };
        let (Ok(a), Ok(b), Ok(kind)) = (a.parse::<usize>(), b.parse::<usize>(), kind.parse::<i64>()) else { return };
        let (Some(a), Some(b)) = (a.checked_sub(1), b.checked_sub(1)) else { return };
        let letter = match kind {
            1 => "B",
            2 => "V",
            3 => "M",
            _ => "F",
        };
        self.lines.push(([(a, None), (b, None)], Some(letter), self.line));
    }

    fn finish(self, rule: &Colours) -> Result<Obj, Error> {
        let count = self.vertices.len();
        let exists = |&(vertex, texture): &Corner, line: usize| {
            let place = || Place::Line { line, column: None };
            let missing = |what: &str, index: usize, count: usize| {
                let (problem, expected) = (format!("{what} {} does not exist", index + 1), format!("up to {count}"));
                Error::new(ErrorCode::NoSuchVertex, place(), problem, expected)
            };
            if vertex >= count {
                return Err(missing("vertex", vertex, count));
            }
            match texture.filter(|texture| *texture >= self.texture.len()) {
                Some(texture) => Err(missing("texture vertex", texture, self.texture.len())),
                None => Ok(()),
            }
        };
        let mut texture: Vec<Option<usize>> = vec![None; count];
        let mut one_each = !self.texture.is_empty();
        for (corners, line) in &self.faces {
            for corner in corners {
                exists(corner, *line)?;
                let own = &mut texture[corner.0];
                let at = |index: Option<usize>| index.map(|index| self.texture[index]);
                one_each &= corner.1.is_some() && (own.is_none() || at(*own) == at(corner.1));
                *own = corner.1;
            }
        }
        let mut lines = Vec::with_capacity(self.lines.len());
        for (ends, letter, at) in &self.lines {
            ends.iter().try_for_each(|end| exists(end, *at))?;
            let ends = ends.map(|(vertex, _)| vertex);
            let colours = ends.map(|vertex| self.colours[vertex]);
            let by_colour =
                || if colours[0] == colours[1] { colours[0].and_then(|colour| of_colour(colour, rule)) } else { None };
            let letter = letter.or_else(by_colour);
            lines.push(Line { ends: ends.map(|vertex| vertex as u32), letter, at: *at });
        }
        let texture: Option<Vec<DVec2>> = texture
            .iter()
            .map(|index| index.map(|index| self.texture[index]))
            .collect::<Option<_>>()
            .filter(|_| one_each);
        let (faces, faces_at) =
            self.faces.iter().map(|(face, at)| (face.iter().map(|corner| corner.0 as u32).collect(), *at)).unzip();
        let warnings = self.odd.into_document().warnings;
        Ok(Obj { vertices: self.vertices, texture, faces, faces_at, lines, warnings })
    }
}

/// The letter of a colour, each part from 0 to 1.
fn of_colour(colour: [f64; 3], rule: &Colours) -> Option<&'static str> {
    let colour = colour.map(|part| (255.0 * part).round() as u8);
    rule.letter(colour)?.0.map(Letter::letter)
}
