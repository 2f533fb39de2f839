//! Marks on a crease pattern where something is wrong with it: rings in the plane of the picture, with a legend above.

use std::fmt::Write as _;

use origami_core::flat::FlatFoldability;
use origami_core::glam::DVec3;
use origami_core::{CreasePattern, Error};

use crate::camera::{Frame, View};
use crate::colour::Rgb;
use crate::extent::in_figure;
use crate::figure::Figure;
use crate::image::Image;
use crate::legend::text_size;
use crate::picture::Picture;
use crate::text;

/// What is wrong at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MarkKind {
    /// The vertex breaks a rule of flat folding.
    Rule,
    /// The sheet that is folded flat by reflection misses itself most here.
    Gap,
    /// A crease ends inside a face, or a line in the air.
    OpenEnd,
    /// Why no sheet can be made of it.
    Refusal,
}

impl MarkKind {
    /// All of them, in the order of the legend.
    pub const ALL: [Self; 4] = [Self::Rule, Self::Gap, Self::OpenEnd, Self::Refusal];

    /// Its name in SVG.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rule => "rule",
            Self::Gap => "gap",
            Self::OpenEnd => "open-end",
            Self::Refusal => "refusal",
        }
    }

    /// Its colour: none that lines have.
    #[must_use]
    pub const fn colour(self) -> Rgb {
        match self {
            Self::Rule => Rgb(240, 140, 0),
            Self::Gap => Rgb(0, 150, 136),
            Self::OpenEnd => Rgb(190, 0, 190),
            Self::Refusal => Rgb(120, 90, 40),
        }
    }

    /// Radius of its ring, in [`text sizes`](text_size): rings of different kinds at one place do not cover each other.
    const fn radius(self) -> f32 {
        match self {
            Self::Rule => 0.5,
            Self::Gap => 0.95,
            Self::OpenEnd => 0.65,
            Self::Refusal => 0.8,
        }
    }

    fn legend(self, count: usize) -> String {
        let s = if count == 1 { "" } else { "s" };
        match self {
            Self::Rule if count == 1 => "1 vertex that breaks a rule of flat folding".to_owned(),
            Self::Rule => format!("{count} vertices that break a rule of flat folding"),
            Self::Gap => "the reflected sheet misses itself most here".to_owned(),
            Self::OpenEnd => format!("{count} line{s} with an open end"),
            Self::Refusal => "what the reason below names".to_owned(),
        }
    }
}

/// Places where something is wrong, in the file's unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// Each with its kind.
    pub at: Vec<(MarkKind, DVec3)>,
    /// Words below the legend; as many lines as they need.
    pub why: String,
}

/// A sheet that misses itself by more than this, in radii, has its worst place marked.
const GAP: f64 = 1e-3;
/// Width of a ring, in text sizes.
const STROKE: f32 = 0.16;
/// Where the words begin, in text sizes from the left.
const INDENT: f32 = 1.35;
/// From one line of the legend to the next, in text sizes.
const LINE: f32 = 1.5;

impl Marks {
    /// The faults of a pattern that asks for flat folding, and all its open ends.
    #[must_use]
    pub fn of(pattern: &CreasePattern) -> Self {
        let flat = FlatFoldability::of(pattern);
        let place = |vertex: origami_core::ids::VertexId| pattern.vertices[vertex.index()];
        let mut at: Vec<(MarkKind, DVec3)> = Vec::new();
        if flat.applies() {
            // They come by vertex, which may break several rules.
            let mut vertices: Vec<_> = flat.faults.iter().map(|fault| fault.vertex).collect();
            vertices.dedup();
            at.extend(vertices.into_iter().map(|vertex| (MarkKind::Rule, place(vertex))));
            let gap = flat.closure.filter(|closure| closure.spread > GAP).and_then(|closure| closure.vertex);
            at.extend(gap.map(|vertex| (MarkKind::Gap, place(vertex))));
        }
        at.extend(flat.open_ends.iter().map(|end| (MarkKind::OpenEnd, place(end.vertex))));
        Self { at, why: String::new() }
    }

    /// Whether nothing is marked and nothing said.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.at.is_empty() && self.why.is_empty()
    }

    /// The words below the legend, in lines that are no wider than `width` in text sizes.
    fn words(&self, width: f32) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        // Control characters have no place in SVG.
        let ends_a_word = |c: char| c.is_whitespace() || c.is_control();
        for word in self.why.split(ends_a_word).filter(|word| !word.is_empty()) {
            match lines.last_mut() {
                Some(line) if text::width(&format!("{line} {word}"), 1.0) <= width => {
                    line.push(' ');
                    line.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        lines
    }

    /// The kinds that there are, each with the line of the legend.
    fn legend(&self) -> Vec<(MarkKind, String)> {
        let count = |kind| self.at.iter().filter(|(other, _)| *other == kind).count();
        let line = |kind: MarkKind| (count(kind) > 0).then(|| (kind, kind.legend(count(kind))));
        MarkKind::ALL.into_iter().filter_map(line).collect()
    }

    /// The view in which `figure` fills what the legend leaves of the picture.
    ///
    /// # Errors
    /// As [`Picture::view`].
    pub fn view(&self, picture: &Picture, figure: &Figure) -> Result<View, Error> {
        let size = text_size(picture.width, picture.height);
        let mut margins = [0.05 * f64::from(picture.width.min(picture.height)); 4];
        let words = self.words(picture.width as f32 / size - 2.0 * INDENT);
        margins[1] += f64::from(LINE * size) * (self.legend().len() + words.len()) as f64;
        if !picture.caption.is_empty() {
            margins[3] += 1.5 * f64::from(size);
        }
        let frame = Frame { width: picture.width, height: picture.height, margins };
        picture.camera.view(figure.positions.iter().copied(), &frame)
    }

    /// Draws rings and legend over a picture of `pattern`, which was drawn in this view.
    pub fn draw(&self, image: &mut Image, picture: &Picture, view: &View, pattern: &CreasePattern) {
        let size = text_size(image.width, image.height);
        let [width, height] = [image.width as f32, image.height as f32];
        for (kind, at) in &self.at {
            let p = in_figure(pattern, *at).map(f64::from);
            let row = |r: usize| {
                (0..3).map(|c| f64::from(view.matrix[c][r]) * p[c]).sum::<f64>() + f64::from(view.matrix[3][r])
            };
            let w = row(3);
            let x = 0.5 * width * (1.0 + (row(0) / w) as f32);
            let y = 0.5 * height * (1.0 - (row(1) / w) as f32);
            ring(image, [x, y], kind.radius() * size, STROKE * size, kind.colour());
        }
        let legend = self.legend();
        let y = |line: usize| size * (1.6 + LINE * line as f32);
        for (line, (kind, legend)) in legend.iter().enumerate() {
            ring(image, [1.8 * size, y(line) - 0.35 * size], 0.45 * size, STROKE * size, kind.colour());
            text::draw(image, legend, [2.8 * size, y(line)], size, picture.theme.text);
        }
        for (line, words) in self.words(width / size - 2.0 * INDENT).iter().enumerate() {
            text::draw(image, words, [INDENT * size, y(legend.len() + line)], size, picture.theme.text);
        }
    }

    /// Rings as SVG, one group a kind; `place` puts a point into the picture, `size` is that of its text.
    pub(crate) fn svg(&self, place: impl Fn(DVec3) -> (f64, f64), size: f64) -> String {
        let mut svg = String::new();
        for (kind, _) in self.legend() {
            // Writing to a string cannot fail.
            let _ = write!(
                svg,
                "<g id=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2}\">",
                kind.name(),
                kind.colour(),
                f64::from(STROKE) * size
            );
            for (_, at) in self.at.iter().filter(|(other, _)| *other == kind) {
                let (x, y) = place(*at);
                let _ =
                    write!(svg, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{:.2}\"/>", f64::from(kind.radius()) * size);
            }
            svg += "</g>\n";
        }
        svg
    }

    /// The legend as SVG, from a corner downwards; the picture is so wide.
    pub(crate) fn svg_legend(&self, [left, top]: [f64; 2], size: f64, width: f64, colour: Rgb) -> String {
        let mut svg = String::new();
        let legend = self.legend();
        let y = |line: usize| top + size * (1.6 + f64::from(LINE) * line as f64);
        for (line, words) in self.words((width / size) as f32 - 2.0 * INDENT).iter().enumerate() {
            let escaped = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
            let _ = writeln!(
                svg,
                "<text x=\"{:.2}\" y=\"{:.2}\" font-family=\"sans-serif\" font-size=\"{size:.2}\" fill=\"{colour}\">{escaped}</text>",
                left + f64::from(INDENT) * size,
                y(legend.len() + line),
            );
        }
        for (line, (kind, legend)) in legend.into_iter().enumerate() {
            let y = y(line);
            let _ = writeln!(
                svg,
                "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"{:.2}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2}\"/>\
                 <text x=\"{:.2}\" y=\"{y:.2}\" font-family=\"sans-serif\" font-size=\"{size:.2}\" fill=\"{colour}\">{legend}</text>",
                left + 1.8 * size,
                y - 0.35 * size,
                0.45 * size,
                kind.colour(),
                f64::from(STROKE) * size,
                left + 2.8 * size,
            );
        }
        svg
    }

    /// How high the legend is, in text sizes, where the picture is so many of them wide.
    pub(crate) fn legend_height(&self, width: f64) -> f64 {
        f64::from(LINE) * (self.legend().len() + self.words(width as f32 - 2.0 * INDENT).len()) as f64
    }
}

/// A circle of a line so wide around a point, in pixels.
fn ring(image: &mut Image, [x, y]: [f32; 2], radius: f32, stroke: f32, colour: Rgb) {
    if !(x.is_finite() && y.is_finite() && x.abs() < 1e6 && y.abs() < 1e6) {
        return;
    }
    let reach = (radius + stroke).ceil() as i64 + 1;
    let (column, row) = (x.floor() as i64, y.floor() as i64);
    for j in row - reach..=row + reach {
        for i in column - reach..=column + reach {
            let off = (i as f32 + 0.5 - x).hypot(j as f32 + 0.5 - y) - radius;
            image.blend(i, j, colour, (0.5 * stroke + 0.5 - off.abs()).clamp(0.0, 1.0));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_has_the_area_of_a_ring_and_is_empty_within() {
        let mut image = Image::new(60, 60, Some(Rgb::WHITE)).unwrap();
        ring(&mut image, [30.2, 29.7], 15.0, 3.0, Rgb::BLACK);
        let ink: f32 = image.pixels.chunks(4).map(|p| 1.0 - f32::from(p[0]) / 255.0).sum();
        let area = 2.0 * std::f32::consts::PI * 15.0 * 3.0;
        assert!((ink / area - 1.0).abs() < 0.02, "{ink} of {area}");
        assert_eq!(image.pixel(30, 30), [255; 4]);
        ring(&mut image, [f32::NAN, 3.0], 15.0, 3.0, Rgb::BLACK);
        ring(&mut image, [1e30, -1e30], 15.0, 3.0, Rgb::BLACK);
    }

    #[test]
    fn words_are_broken_into_lines_that_fit_and_none_is_lost() {
        let why = "edges_vertices[3]: a very long reason indeed, which no picture has room for in one line";
        let marks = Marks { at: Vec::new(), why: why.to_owned() };
        let lines = marks.words(12.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| text::width(line, 1.0) <= 12.0), "{lines:?}");
        assert_eq!(lines.join(" "), why);
    }
}
