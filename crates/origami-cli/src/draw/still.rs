//! Single pictures, crease patterns and glTF.

use std::io::Write;

use origami::picture::{Figure, Glb, Image, Marks, Picture};
use origami::{CreasePattern, Error};

use super::{Artist, Subject};

/// Pixels of a picture of its own.
pub(super) const SIZE: [u32; 2] = [1000, 800];

/// The last state as PNG.
pub(super) fn png(artist: &Artist, subject: Subject<'_>, writer: &mut dyn Write) -> Result<(), Error> {
    let Some(figure) = last(artist, subject) else { return Ok(()) };
    let picture = artist.style.picture(SIZE);
    let view = artist.style.view(&picture, &figure)?;
    artist.draw(&picture, &figure, &view)?.write_png(writer)
}

/// The figure of the last state.
fn last(artist: &Artist, subject: Subject<'_>) -> Option<Figure> {
    let (_, state) = subject.states.last()?;
    let only = [(0.0, *state)];
    let clip = artist.style.clip(Subject { states: &only, ..subject });
    Some(artist.style.figure(subject, state, clip))
}

/// A picture of the flat pattern.
pub(super) fn draw_pattern(artist: &Artist, pattern: &CreasePattern, picture: &Picture) -> Result<Image, Error> {
    refuse_bent(pattern)?;
    let figure = Figure::of_pattern(pattern)?;
    let view = picture.view(&figure, figure.positions.iter().copied())?;
    artist.draw(picture, &figure, &view)
}

/// The flat pattern as PNG.
pub(super) fn pattern_png(artist: &Artist, pattern: &CreasePattern, writer: &mut dyn Write) -> Result<(), Error> {
    draw_pattern(artist, pattern, &artist.style.pattern(SIZE))?.write_png(writer)
}

/// The same with marks where something is wrong; `caption` is the line below where none was asked for.
pub(super) fn marked_png(
    artist: &Artist,
    pattern: &CreasePattern,
    (marks, caption): (&Marks, &str),
    writer: &mut dyn Write,
) -> Result<(), Error> {
    refuse_bent(pattern)?;
    let mut picture = artist.style.pattern(SIZE);
    if picture.caption.is_empty() {
        picture.caption = caption.to_owned();
    }
    let figure = Figure::of_pattern(pattern)?;
    let view = marks.view(&picture, &figure)?;
    let mut image = artist.draw(&picture, &figure, &view)?;
    marks.draw(&mut image, &picture, &view, pattern);
    image.write_png(writer)
}

/// The flat pattern as SVG.
pub(super) fn svg(
    artist: &Artist,
    pattern: &CreasePattern,
    marks: &Marks,
    writer: &mut dyn Write,
) -> Result<(), Error> {
    refuse_bent(pattern)?;
    let Picture { theme, edges, width, height, .. } = artist.style.pattern(SIZE);
    let svg = origami::picture::pattern::svg_with(pattern, &theme, edges, f64::from(width.max(height)), marks);
    writer.write_all(svg.as_bytes()).map_err(|source| Error::Io { path: "-".into(), source })
}

pub(super) fn refuse_bent(pattern: &CreasePattern) -> Result<(), Error> {
    if pattern.is_flat() {
        return Ok(());
    }
    Err(Error::invalid(
        "vertices_coords",
        "the sheet is not flat, so it has no picture as a crease pattern",
        "a flat one",
    ))
}

/// Binary glTF that goes through all states.
pub(super) fn glb(
    artist: &Artist,
    subject: Subject<'_>,
    fps: Option<u16>,
    writer: &mut dyn Write,
) -> Result<(), Error> {
    let Some(figure) = last(artist, subject) else { return Ok(()) };
    let Picture { theme, edges, .. } = artist.style.picture(SIZE);
    let positions = |(_, state): &(f64, &origami::State)| -> Vec<[f32; 3]> {
        state.positions.iter().map(|p| p.to_array().map(|x| x as f32)).collect()
    };
    let states: Vec<_> = subject.states.iter().map(positions).collect();
    let own = Glb::default().seconds;
    let seconds = fps.map_or(own, |fps| states.len().saturating_sub(1) as f32 / f32::from(fps));
    Glb { theme, edges, seconds, ..Glb::of(subject.model) }.write(&figure, &states, writer)
}
