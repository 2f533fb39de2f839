//! The flat crease pattern: as a figure for pictures, and as SVG.

use std::fmt::Write as _;

use origami_core::glam::DVec3;
use origami_core::ids::EdgeId;
use origami_core::mesh::triangulate::triangulate;
use origami_core::pattern::PatternEdge;
use origami_core::{CreasePattern, Error};

use crate::camera::Camera;
use crate::colour::Rgb;
use crate::extent::extent;
use crate::figure::{Figure, Line, LineKind, LineSet, chains, lips};
use crate::marks::Marks;
use crate::picture::Picture;
use crate::theme::Theme;

impl Figure {
    /// The pattern as it lies on the table, with all its edges; lengths are in half diagonals of its box.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a face that cannot be cut into triangles, or a pattern of no size.
    pub fn of_pattern(pattern: &CreasePattern) -> Result<Self, Error> {
        let (centre, radius) = extent(pattern);
        let positions: Vec<DVec3> = pattern.vertices.iter().map(|p| (*p - centre) / radius).collect();
        let mut lines: Vec<Line> = lines(pattern).map(|(_, line)| line).collect();
        chains::measure(&mut lines, &positions);
        Ok(Self {
            positions: positions.iter().map(|p| p.to_array().map(|x| x as f32)).collect(),
            triangles: triangulate(pattern)?.triangles.into_iter().map(|t| t.map(|v| v.0)).collect(),
            lines,
            ..Self::default()
        })
    }
}

impl Picture {
    /// This picture as crease patterns are drawn: from above, on plain white paper, facets in grey, lines with their dashes.
    #[must_use]
    pub fn for_pattern(self) -> Self {
        Self { camera: Camera::top(), theme: self.theme.for_pattern(), edges: LineSet::ALL, dashed: true, ..self }
    }
}

impl Theme {
    /// These colours and lines on plain paper without shading, its facets in grey.
    #[must_use]
    pub fn for_pattern(&self) -> Self {
        let mut theme = Self { front: Rgb(253, 253, 251), back: Rgb(253, 253, 251), shading: 0.0, ..self.clone() };
        theme.lines[LineKind::Facet as usize].colour = Rgb(176, 176, 176);
        theme
    }
}

/// All edges that stand for themselves, as lines with their vertices for nodes.
fn lines(pattern: &CreasePattern) -> impl Iterator<Item = (EdgeId, Line)> {
    let own = |(_, edge): &(usize, &PatternEdge)| {
        edge.alias_of.is_none() && edge.vertices.iter().all(|v| v.index() < pattern.vertices.len())
    };
    let edges: Vec<(usize, &PatternEdge)> = pattern.edges.iter().enumerate().filter(own).collect();
    let on_rim: Vec<Option<[DVec3; 2]>> = { edges.iter() }
        .map(|(_, edge)| {
            (LineKind::of(edge) == LineKind::Boundary).then(|| edge.vertices.map(|v| pattern.vertices[v.index()]))
        })
        .collect();
    let lips = lips::find(&on_rim);
    edges.into_iter().zip(lips).map(|((i, edge), lip)| {
        let kind = if lip { LineKind::Cut } else { LineKind::of(edge) };
        let nodes = edge.vertices.map(|v| v.0);
        (EdgeId::new(i), Line { nodes, along: [0.0; 2], kind, triangles: [None; 2] })
    })
}

/// The pattern as SVG, seen from above; `width` in pixels is that of the longer side.
///
/// Each kind of line is a group with its name for an id, under the sheet's faces.
#[must_use]
pub fn svg(pattern: &CreasePattern, theme: &Theme, edges: LineSet, width: f64) -> String {
    svg_with(pattern, theme, edges, width, &Marks::default())
}

/// The same with rings where something is wrong, each kind a group with its name for an id, and a legend above.
#[must_use]
pub fn svg_with(pattern: &CreasePattern, theme: &Theme, edges: LineSet, width: f64, marks: &Marks) -> String {
    let (centre, _) = extent(pattern);
    let scale = 0.92 * width / pattern.size().max(f64::MIN_POSITIVE);
    let place = |p: DVec3| ((p.x - centre.x) * scale, (centre.y - p.y) * scale);
    let low = pattern.vertices.iter().copied().reduce(DVec3::min).unwrap_or_default();
    let margin = 0.04 * width;
    let (left, bottom) = place(low);
    let (w, h) = (2.0 * (margin - left), 2.0 * (margin + bottom));
    let line_scale = f64::from(Theme::line_scale(w as u32, h as u32));

    let text_size = 0.025 * width;
    let legend = marks.legend_height(w / text_size) * text_size;
    let (top, h) = (-0.5 * h - legend, h + legend);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w:.2}\" height=\"{h:.2}\" viewBox=\"{:.2} {top:.2} {w:.2} {h:.2}\">\n",
        -0.5 * w,
    );
    // Writing to a string cannot fail.
    let mut put = |text: std::fmt::Arguments<'_>| svg.write_fmt(text).unwrap_or_default();
    if let Some(ground) = theme.background {
        put(format_args!(
            "<rect x=\"{:.2}\" y=\"{top:.2}\" width=\"100%\" height=\"100%\" fill=\"{ground}\"/>\n",
            -0.5 * w,
        ));
    }
    put(format_args!("<path id=\"sheet\" fill=\"{}\" d=\"", theme.front));
    for face in &pattern.faces {
        for (corner, vertex) in face.iter().enumerate() {
            let (x, y) = place(pattern.vertices.get(vertex.index()).copied().unwrap_or_default());
            put(format_args!("{}{x:.2} {y:.2}", if corner == 0 { 'M' } else { 'L' }));
        }
        put(format_args!("Z"));
    }
    put(format_args!("\"/>\n"));
    let lines: Vec<Line> = lines(pattern).map(|(_, line)| line).collect();
    for kind in
        [LineKind::Facet, LineKind::Undriven, LineKind::Valley, LineKind::Mountain, LineKind::Boundary, LineKind::Cut]
    {
        if !edges.has(kind) || !lines.iter().any(|line| line.kind == kind) {
            continue;
        }
        let style = theme.line(kind);
        put(format_args!(
            "<path id=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2}\" stroke-linecap=\"{}\"",
            kind.name(),
            style.colour,
            f64::from(style.width) * line_scale,
            if style.dash.is_some() { "butt" } else { "round" },
        ));
        if let Some(dash) = style.dash {
            let gap = f64::from(0.5 * (dash.off - dash.dot)) * line_scale;
            let [on, off, dot] = [dash.on, dash.off, dash.dot].map(|x| f64::from(x) * line_scale);
            if dash.dot > 0.0 {
                put(format_args!(" stroke-dasharray=\"{on:.2} {gap:.2} {dot:.2} {gap:.2}\""));
            } else {
                put(format_args!(" stroke-dasharray=\"{on:.2} {off:.2}\""));
            }
        }
        put(format_args!(" d=\""));
        for line in lines.iter().filter(|line| line.kind == kind) {
            let [(x, y), (u, v)] = line.nodes.map(|n| place(pattern.vertices[n as usize]));
            put(format_args!("M{x:.2} {y:.2}L{u:.2} {v:.2}"));
        }
        put(format_args!("\"/>\n"));
    }
    svg += &marks.svg(place, text_size);
    svg += &marks.svg_legend([-0.5 * w, top], text_size, w, theme.text);
    svg += "</svg>\n";
    svg
}

#[cfg(test)]
mod tests {
    use super::*;
    use origami_core::fold::Document;
    use origami_core::generate::catalog;

    #[test]
    fn every_edge_is_drawn_once_and_in_its_kind() {
        let pattern = catalog::generate("miura", &[]).unwrap();
        let figure = Figure::of_pattern(&pattern).unwrap();
        figure.check().unwrap();
        assert_eq!(figure.lines.len(), pattern.edges.len());
        let text = svg(&pattern, &Theme::paper(), LineSet::ALL, 500.0);
        let lines = |id: &str| {
            let path = text.lines().find(|line| line.contains(&format!("id=\"{id}\""))).unwrap_or_default();
            path.split(" d=\"").nth(1).unwrap_or_default().matches('M').count()
        };
        let count = |kind| figure.lines.iter().filter(|line| line.kind == kind).count();
        for kind in LineKind::ALL {
            assert_eq!(lines(kind.name()), count(kind), "{kind:?}");
        }
        assert!(count(LineKind::Mountain) > 10 && count(LineKind::Valley) > 10);
        assert!(text.ends_with("</svg>\n") && !text.contains("NaN"));
    }

    #[test]
    fn what_is_wrong_is_ringed_in_a_group_of_its_kind() {
        let text = r#"{"vertices_coords": [[0,0],[4,0],[4,4],[0,4],[1,2],[2,1]],
            "edges_vertices": [[0,1],[1,2],[2,3],[3,0],[5,0],[5,1],[5,2],[3,4]],
            "edges_assignment": ["B","B","B","B","V","V","V","M"]}"#;
        let document = Document::from_reader(text.as_bytes()).unwrap();
        let pattern = CreasePattern::from_frame(&document.frame(0).unwrap()).unwrap();
        let marks = Marks { why: "a < b & c".to_owned(), ..Marks::of(&pattern) };
        let svg = svg_with(&pattern, &Theme::paper(), LineSet::ALL, 400.0, &marks);
        let rings = |id: &str| {
            let group = svg.lines().find(|line| line.contains(&format!("<g id=\"{id}\"")));
            group.unwrap_or_default().matches("<circle").count()
        };
        assert_eq!((rings("rule"), rings("open-end"), rings("refusal")), (1, 1, 0), "{svg}");
        assert!(svg.contains("1 vertex that breaks a rule") && svg.contains("a &lt; b &amp; c"), "{svg}");
        // (1, 2) in a square of 4, drawn over 0.92 of 400 pixels around its middle.
        assert!(
            svg.contains("<circle cx=\"-92.00\" cy=\"-0.00\"") || svg.contains("<circle cx=\"-92.00\" cy=\"0.00\"")
        );
        let plain = super::svg(&pattern, &Theme::paper(), LineSet::ALL, 400.0);
        assert!(!plain.contains("<circle") && !plain.contains("<text"));
    }

    #[test]
    fn lips_of_a_cut_are_cuts() {
        let text = r#"{"vertices_coords": [[0,0],[1,0],[2,0],[2,1],[1,1],[0,1]],
            "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,0],[1,4]],
            "edges_assignment": ["B","B","B","B","B","B","C"]}"#;
        let document = Document::from_reader(text.as_bytes()).unwrap();
        let pattern = CreasePattern::from_frame(&document.frame(0).unwrap()).unwrap();
        let kinds: Vec<LineKind> = Figure::of_pattern(&pattern).unwrap().lines.iter().map(|line| line.kind).collect();
        assert_eq!(kinds.iter().filter(|kind| **kind == LineKind::Cut).count(), 2, "{kinds:?}");
        assert_eq!(kinds.iter().filter(|kind| **kind == LineKind::Boundary).count(), 6);
    }
}
