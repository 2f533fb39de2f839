//! SVG, as drawing programs write crease patterns: the colour of a stroke is the letter, its opacity the fold angle.
//!
//! [`read`] walks the tree as a browser does (groups, transforms, `use`, style sheets), takes the strokes and leaves the
//! rest out, with a warning for each kind. Coordinates are in user units, with y up: SVG's own points down.

mod cascade;
mod dashes;
mod drawing;
mod join;
mod notes;
mod path;
mod places;
mod shapes;
mod style;
mod text;
mod view;
mod walk;

use std::collections::BTreeSet;

use origami_core::CreasePattern;
use origami_core::error::{Error, ErrorCode, Place, Warning, WarningCode};
use origami_core::fold::Document;

use crate::Options;
use crate::colours::{Colours, Letter, name_of};
use crate::{curves, xml};
use drawing::{Drawing, Mark};
use notes::Notes;

/// Reads an SVG file.
///
/// # Errors
/// [`Error::Syntax`] with line and column for what is not XML; [`Error::Invalid`] if the root is not `svg`, if no line is
/// drawn, if a coordinate is not finite, or if elements are nested too deeply or are too many.
pub fn read(bytes: &[u8], options: &Options) -> Result<Document, Error> {
    let text = text::decode(bytes)?;
    let tree = xml::parse(&text, "an SVG file, that is XML")?;
    let Drawing { marks, title, mut notes } = walk::drawing(&tree)?;
    let strokes = strokes(marks, &options.colours, &mut notes);
    if strokes.is_empty() {
        let problem = format!("no line of a crease pattern is drawn{}", notes.summary());
        let expected =
            "strokes: black the border, red mountains, blue valleys, green cuts, yellow flat lines, magenta free ones";
        return Err(Error::new(ErrorCode::NoLines, Place::Line { line: 1, column: None }, problem, expected));
    }
    let join = join::distance(&strokes);
    let mut document = curves::lines(strokes, options.curve_tolerance)?.into_document();
    // The largest distance that leaves a pattern; what cannot be read with any is refused where the pattern is made.
    let tried = join.into_iter().flat_map(|join| [join, join / 8.0, join / 64.0]);
    document.join = tried.into_iter().find(|join| {
        document.join = Some(*join);
        CreasePattern::from_document(&document, 0).is_ok()
    });
    document.warnings.splice(0..0, notes.into_warnings());
    document.metadata.extend(title.map(|title| ("file_title".to_owned(), title.into())));
    Ok(document)
}

/// The marks whose colours are letters, each with its letter and angle.
fn strokes(marks: Vec<Mark>, colours: &Colours, notes: &mut Notes) -> Vec<curves::Stroke> {
    let by_dashes = letters_are_dashes(&marks, colours);
    if let Some(first) = marks.first().filter(|_| by_dashes) {
        let message = "all lines are of one colour: dashed ones are taken for valleys, dash-dotted ones for mountains";
        notes.say(Warning::new(WarningCode::Colour, first.element.place.clone(), message));
    }
    let mut told = BTreeSet::new();
    let mut strokes = Vec::with_capacity(marks.len());
    for mark in marks {
        let of_colour = colours.letter(mark.colour);
        if let Some((letter, Some(taken))) = of_colour
            && told.insert(mark.colour)
        {
            let message = format!(
                "{} has the colour {}; it is taken for {taken}, {}",
                mark.element.name,
                name_of(mark.colour),
                letter.map_or("which is left out", Letter::meaning)
            );
            notes.say(Warning::new(WarningCode::Colour, mark.element.place.clone(), message));
        }
        let letter = match of_colour {
            Some((letter, _)) => letter,
            None => {
                let message = format!("has the colour {}, which stands for nothing", name_of(mark.colour));
                notes.left_out(&mark.element, &message);
                continue;
            }
        };
        let letter = if by_dashes { Some(mark.dashes.letter()) } else { letter };
        let Some(letter) = letter else { continue };
        let angle = match letter {
            Letter::Mountain if mark.opacity < 1.0 => Some(-180.0 * mark.opacity),
            Letter::Valley if mark.opacity < 1.0 => Some(180.0 * mark.opacity),
            _ => None,
        };
        strokes.push(curves::Stroke { path: mark.path, letter: letter.letter(), angle, source: mark.element.source() });
    }
    strokes
}

/// Whether the dashes are the letters: they differ, and the colours, all one, do not stand for different things. A colour
/// that the table names is a letter.
fn letters_are_dashes(marks: &[Mark], colours: &Colours) -> bool {
    let Some(first) = marks.first() else { return false };
    let one_colour = marks.iter().all(|mark| mark.colour == first.colour);
    one_colour && !colours.names(first.colour) && marks.iter().any(|mark| mark.dashes != first.dashes)
}

#[cfg(test)]
mod tests;
