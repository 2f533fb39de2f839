//! Title and note above, axes with their curves, the legend below: no text ever covers a point.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::marks::{Area, Drawn, Look};
use super::ruler::Ruler;
use super::{Plot, Series};

/// Width of the picture, in pixels.
const WIDTH: u32 = 800;
/// Height of the axes with their labels, in pixels.
const AXES: u32 = 470;
/// Pixels left free on all sides.
const MARGIN: i32 = 16;
/// The library's sizes are 1.24 times those that SVG files have.
const EM: f64 = 1.24;
/// Heights of text, in pixels: of titles.
const TITLE: f64 = 18.0;
const NOTE: f64 = 12.0;
const LABEL: f64 = 13.0;
/// A line of text, in its sizes.
const LINE: f64 = 1.5;
/// Mean width of a letter of a sans-serif font, in its sizes; on the safe side.
const LETTER: f64 = 0.56;
/// The same for bold letters, which are wider.
const BOLD_LETTER: f64 = 0.62;
/// Width of a sample in the legend, and of the gap to its text and to the next.
const SAMPLE: i32 = 30;
const GAP: i32 = 8;
/// Lines of title and note, at most.
const LINES: usize = 4;

const INK: RGBColor = RGBColor(34, 34, 34);
const GREY: RGBColor = RGBColor(90, 90, 90);
const GRID: RGBColor = RGBColor(205, 205, 205);
const LIGHT_GRID: RGBColor = RGBColor(234, 234, 234);

type Failure = DrawingAreaErrorKind<std::io::Error>;

pub(super) fn svg(plot: &Plot) -> Result<String, Failure> {
    let room = WIDTH.cast_signed() - 2 * MARGIN;
    let title = wrapped(&plot.title, room, TITLE * BOLD_LETTER);
    let note = wrapped(&plot.note, room, NOTE * LETTER);
    let legend = Legend::new(&plot.series, room);
    let above = MARGIN + title.len() as i32 * line(TITLE) + note.len() as i32 * line(NOTE);
    let height = above + AXES.cast_signed() + legend.height() + MARGIN;

    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (WIDTH, height.cast_unsigned())).into_drawing_area();
        area.fill(&WHITE)?;
        let mut y = MARGIN;
        let bold = font(TITLE).style(FontStyle::Bold).color(&INK).pos(Pos::new(HPos::Left, VPos::Top));
        for row in title {
            area.draw(&Text::new(row, (MARGIN, y), bold.clone()))?;
            y += line(TITLE);
        }
        let small = font(NOTE).color(&GREY).pos(Pos::new(HPos::Left, VPos::Top));
        for row in note {
            area.draw(&Text::new(row, (MARGIN, y), small.clone()))?;
            y += line(NOTE);
        }
        draw_axes(plot, &area, above)?;
        legend.draw(&area, above + AXES.cast_signed())?;
        area.present()?;
    }
    Ok(text)
}

fn draw_axes<DB: DrawingBackend>(plot: &Plot, area: &Area<DB>, top: i32) -> Drawn<DB> {
    let points = plot.series.iter().flat_map(|series| &series.points);
    // A point of which one axis cannot show its part is not shown at all, and makes the other no longer.
    let shown = points.filter(|(x, y)| plot.x.scale.shows(*x) && plot.y.scale.shows(*y));
    let x = Ruler::new(plot.x.scale, shown.clone().map(|(x, _)| *x));
    let y = Ruler::new(plot.y.scale, shown.map(|(_, y)| *y));
    let (_, below) = area.split_vertically(top);
    let (axes, _) = below.split_vertically(AXES.cast_signed());
    let label = font(LABEL).color(&INK);
    let mut chart = ChartBuilder::on(&axes)
        .margin_top(GAP)
        .margin_left(MARGIN / 2)
        .margin_right(MARGIN + GAP)
        .x_label_area_size(pixels(2.4 * f64::from(line(LABEL))))
        .y_label_area_size(2 * line(LABEL) + pixels(y.longest_label() as f64 * LABEL * LETTER))
        .build_cartesian_2d(x.clone(), y.clone())?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(LIGHT_GRID)
        .axis_style(INK)
        .label_style(label.clone())
        .axis_desc_style(label)
        .x_desc(clean(&plot.x.label))
        .y_desc(clean(&plot.y.label))
        .draw()?;
    for (i, series) in plot.series.iter().enumerate() {
        let positions = series.points.iter().filter_map(|(a, b)| Some((x.position(*a)?, y.position(*b)?)));
        let pixels: Vec<(i32, i32)> = positions.map(|at| chart.backend_coord(&at)).collect();
        Look::new(i, series.mark).draw(area, &pixels)?;
    }
    Ok(())
}

/// Samples and names, in columns.
struct Legend {
    entries: Vec<(Look, String)>,
    columns: usize,
    /// Width of a column of the legend, in pixels.
    width: i32,
}

impl Legend {
    fn new(series: &[Series], room: i32) -> Self {
        let most = whole(f64::from(room - SAMPLE - GAP) / (LABEL * LETTER));
        let entries: Vec<(Look, String)> =
            { series.iter().enumerate() }.map(|(i, s)| (Look::new(i, s.mark), cut(&clean(&s.label), most))).collect();
        let longest = entries.iter().map(|(_, name)| name.chars().count()).max().unwrap_or(0);
        let width = SAMPLE + 3 * GAP + pixels(longest as f64 * LABEL * LETTER);
        Self { entries, columns: usize::try_from(room / width).unwrap_or(0).max(1), width }
    }

    fn height(&self) -> i32 {
        GAP + self.entries.len().div_ceil(self.columns) as i32 * line(LABEL)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>, top: i32) -> Drawn<DB> {
        let style = font(LABEL).color(&INK).pos(Pos::new(HPos::Left, VPos::Center));
        for (i, (look, name)) in self.entries.iter().enumerate() {
            let left = MARGIN + (i % self.columns) as i32 * self.width;
            let y = top + GAP + (i / self.columns) as i32 * line(LABEL) + line(LABEL) / 2;
            look.draw_sample(area, (left, y), SAMPLE)?;
            area.draw(&Text::new(name.clone(), (left + SAMPLE + GAP, y), style.clone()))?;
        }
        Ok(())
    }
}

fn font(size: f64) -> FontDesc<'static> {
    FontDesc::new(FontFamily::SansSerif, size * EM, FontStyle::Normal)
}

/// Height of a line of text.
fn line(size: f64) -> i32 {
    pixels(size * LINE)
}

#[expect(clippy::cast_possible_truncation, reason = "less than the picture")]
fn pixels(x: f64) -> i32 {
    x.ceil() as i32
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "letters of a line")]
fn whole(x: f64) -> usize {
    x as usize
}

/// Without characters that XML has no place for.
fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') { ' ' } else { c }).collect()
}

/// No longer than `most` letters.
fn cut(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    text.chars().take(most.saturating_sub(1)).chain(['…']).collect()
}

/// In lines of `room` pixels.
fn wrapped(text: &str, room: i32, letter: f64) -> Vec<String> {
    let most = whole(f64::from(room) / letter);
    let mut lines: Vec<String> = Vec::new();
    for word in clean(text).split_whitespace() {
        let fits = |last: &String| last.chars().count() + 1 + word.chars().count() <= most;
        match lines.pop() {
            Some(last) if fits(&last) => lines.push(format!("{last} {word}")),
            Some(last) if lines.len() + 1 == LINES => {
                lines.push(cut(&format!("{last} …"), most));
                break;
            }
            last => lines.extend(last.into_iter().chain([cut(word, most)])),
        }
    }
    lines
}
