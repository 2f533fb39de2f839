//! The contact sheet: the pattern and stages of folding side by side.

use std::io::Write;

use origami::picture::legend::bar;
use origami::picture::{Image, Picture};
use origami::{CreasePattern, Error};

use super::{Artist, Style, Subject, still};
use crate::numbers;

/// Pixels of each part, where no size is asked for.
pub(super) const SIZE: [u32; 2] = [480, 384];

/// How many parts stand beside each other: as many as below each other or one more, whichever leaves less room empty.
fn columns(parts: u32) -> u32 {
    let root = parts.max(1).isqrt();
    let least = if root * root < parts { root + 1 } else { root };
    let empty = |columns: &u32| parts.div_ceil(*columns) * columns - parts;
    (least..=least + 1).min_by_key(empty).unwrap_or(least)
}

/// Pixels of the whole.
pub(super) fn extent(style: &Style, parts: u32) -> [u32; 2] {
    let Picture { width, height, .. } = style.picture(SIZE);
    // Beyond this any picture is too large.
    let parts = parts.min(1 << 20);
    let columns = columns(parts);
    let bar = style.bar_width(SIZE).unwrap_or(0);
    [width.saturating_mul(columns).saturating_add(bar), height.saturating_mul(parts.div_ceil(columns))]
}

/// The pattern, where it is flat, and all states as one PNG: each state as a picture of its own would be, with one scale of
/// colours for all, and one bar.
pub(super) fn contact(artist: &Artist, subject: Subject<'_>, writer: &mut dyn Write) -> Result<(), Error> {
    let Some((_, first)) = subject.states.first() else { return Ok(()) };
    let style = &artist.style;
    let picture = Picture { legend: false, ..style.picture(SIZE) };
    let flat = subject.pattern.is_flat();
    let parts = u32::try_from(subject.states.len()).unwrap_or(u32::MAX).saturating_add(flat.into());
    let [width, height] = extent(style, parts);
    let mut whole = Image::new(width, height, picture.theme.background)?;
    let columns = columns(parts);
    let mut places = (0..parts).map(|i| [i % columns * picture.width, i / columns * picture.height]);
    let mut put = |image: &Image| {
        if let Some([left, top]) = places.next() {
            whole.place(image, left, top);
        }
    };

    if flat {
        put(&pattern(artist, subject.pattern)?);
    }
    let clip = style.clip(subject);
    let mut figure = style.figure(subject, first, clip);
    let captioned = |i: usize, percent: f64| {
        let part = subject.steps.get(i).cloned().unwrap_or_else(|| numbers::percent(percent));
        Picture { caption: caption(&picture, &part), ..picture.clone() }
    };
    for (i, (percent, state)) in subject.states.iter().enumerate() {
        if i > 0 {
            style.move_to(&mut figure, subject, state, clip);
        }
        let picture = captioned(i, *percent);
        let view = style.view(&picture, &figure)?;
        put(&artist.draw(&picture, &figure, &view)?);
    }
    if let (Some(map), Some(_)) = (&figure.map, style.bar_width(SIZE)) {
        let bar = bar(&map.scale, &picture.theme, [picture.width, picture.height], height)?;
        whole.place(&bar, picture.width * columns, 0);
    }
    whole.write_png(writer)
}

fn pattern(artist: &Artist, pattern: &CreasePattern) -> Result<Image, Error> {
    let picture = artist.style.pattern(SIZE);
    let caption = caption(&picture, "crease pattern");
    still::draw_pattern(artist, pattern, &Picture { caption, ..picture })
}

/// What was asked for, and what the part shows.
pub(super) fn caption(picture: &Picture, part: &str) -> String {
    if picture.caption.is_empty() { part.to_owned() } else { format!("{}, {part}", picture.caption) }
}

#[cfg(test)]
mod tests {
    use super::columns;

    #[test]
    fn parts_stand_in_rows_that_are_nearly_full() {
        assert_eq!([1, 2, 3, 4, 5, 6, 7, 9, 10, 12].map(columns), [1, 2, 3, 2, 3, 3, 4, 3, 5, 4]);
    }
}
