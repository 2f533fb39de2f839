//! Curves and points over two axes, as SVG.

mod draw;
mod marks;
mod ruler;

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal distances stand for equal differences.
    Linear,
    /// By powers of ten; values that are not above 0 are left out.
    Log,
}

impl Scale {
    /// Whether `value` has a place on it.
    fn shows(self, value: f64) -> bool {
        value.is_finite() && (self == Self::Linear || value > 0.0)
    }
}

/// An axis of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it shows, with its unit.
    pub label: String,
    /// How the axis is divided.
    pub scale: Scale,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Points joined by a line.
    Line,
    /// The same, dashed: the same solver elsewhere, say.
    Dashed,
    /// A mark at each point, and no line.
    Points,
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What the legend calls the series.
    pub label: String,
    /// How the series is drawn.
    pub mark: Mark,
    /// Its points; those that are not finite are left out.
    pub points: Vec<(f64, f64)>,
}

/// A plot of one or more series over two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Its title.
    pub title: String,
    /// A line below it: machine, adapter, case.
    pub note: String,
    /// The axis from left to right.
    pub x: Axis,
    /// The axis from bottom to top.
    pub y: Axis,
    /// The series, drawn in this order.
    pub series: Vec<Series>,
}

/// A plot could not be drawn.
#[derive(Clone, Debug, thiserror::Error)]
#[error("the plot \"{title}\" could not be drawn: {why}")]
pub struct PlotError {
    /// Its title.
    pub title: String,
    /// What the drawing library says.
    pub why: String,
}

impl Plot {
    /// As SVG: 800 pixels wide, and as high as title, axes and legend need. Equal plots give equal bytes.
    ///
    /// # Errors
    /// [`PlotError`] names what cannot be drawn.
    pub fn svg(&self) -> Result<String, PlotError> {
        draw::svg(self).map_err(|error| PlotError { title: self.title.clone(), why: error.to_string() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(scale: Scale, series: Vec<Series>) -> Plot {
        let axis = |label: &str| Axis { label: label.into(), scale };
        let note = "adapter \"A & B\"".into();
        Plot { title: "Error <miura>".into(), note, x: axis("time (s)"), y: axis("error (radii)"), series }
    }

    fn series(mark: Mark, points: &[(f64, f64)]) -> Series {
        Series { label: format!("{mark:?}"), mark, points: points.to_vec() }
    }

    /// Centres of the circles in it: the points of the first series, and its sample in the legend.
    fn circles(svg: &str) -> Vec<(f64, f64)> {
        let number = |line: &str, key: &str| {
            line.split_once(&format!(" {key}=\"")).and_then(|(_, rest)| rest.split('"').next()?.parse().ok()).unwrap()
        };
        svg.lines().filter(|line| line.starts_with("<circle")).map(|l| (number(l, "cx"), number(l, "cy"))).collect()
    }

    #[test]
    fn points_stand_where_they_should() {
        let points = [(1.0, 1e-6), (10.0, 1e-4), (100.0, 1e-2), (1000.0, 0.0), (f64::NAN, 1.0), (-1.0, 1.0)];
        let svg = plot(Scale::Log, vec![series(Mark::Points, &points)]).svg().unwrap();
        let circles = circles(&svg);
        assert_eq!(circles.len(), 3 + 1, "{svg}");
        // Even on log axes, rising to the right; a pixel for rounding.
        let [a, b, c] = [circles[0], circles[1], circles[2]];
        assert!(a.0 < b.0 && b.0 < c.0 && a.1 > b.1 && b.1 > c.1);
        assert!((c.0 - 2.0 * b.0 + a.0).abs() <= 2.0 && (c.1 - 2.0 * b.1 + a.1).abs() <= 2.0);
        // What is left out stretches no axis: the outermost points are near the edges.
        assert!(c.0 - a.0 > 550.0 && a.1 - c.1 > 320.0, "{circles:?}");
    }

    #[test]
    fn text_is_escaped_and_stays_text() {
        let svg = plot(Scale::Linear, vec![series(Mark::Line, &[(0.0, 1.0), (1.0, 2.0)])]).svg().unwrap();
        assert!(svg.contains("Error &lt;miura&gt;") && svg.contains("adapter &quot;A &amp; B&quot;"), "{svg}");
        assert!(
            svg.contains("time (s)") && svg.contains("error (radii)") && svg.contains("font-family=\"sans-serif\"")
        );
        let mut plot = plot(Scale::Linear, Vec::new());
        plot.title = "\0\u{1b}\u{ffff}\n]]>".repeat(200);
        plot.x.label = "x".repeat(10_000);
        let svg = plot.svg().unwrap();
        assert!(!svg.contains(['\0', '\u{1b}', '\u{ffff}']));
    }

    #[test]
    fn the_legend_lies_below_and_has_all_names() {
        let many: Vec<Series> = (0..50)
            .map(|i| Series { label: format!("solver number {i}"), ..series(Mark::Dashed, &[(1.0, 2.0), (3.0, 1.0)]) })
            .collect();
        let svg = plot(Scale::Log, many).svg().unwrap();
        assert!((0..50).all(|i| svg.contains(&format!("solver number {i}\n"))));
        // Each sixth series has circles: nine of them, with two points each, and then their samples.
        let bottom = circles(&svg).iter().skip(18).map(|circle| circle.1).fold(f64::MAX, f64::min);
        assert!(circles(&svg)[..18].iter().all(|circle| circle.1 < bottom - 50.0), "the axes' labels are between");
    }

    #[test]
    fn nothing_at_all_can_be_drawn() {
        let values = [0.0, 1.0, -1.0, 5e-324, 1e-300, 1e300, f64::MAX, f64::MIN, f64::NAN, f64::INFINITY];
        let mut sets = vec![Vec::new(), vec![(2.0, 3.0); 5]];
        for a in values {
            sets.push(vec![(a, 1.0)]);
            sets.extend(values.iter().map(|b| vec![(a, *b), (*b, a), (1.0, 1.0)]));
        }
        for points in sets {
            for scale in [Scale::Log, Scale::Linear] {
                let all = [Mark::Line, Mark::Dashed, Mark::Points].map(|mark| series(mark, &points));
                let plot = plot(scale, all.to_vec());
                let svg = plot.svg().unwrap();
                assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{points:?}");
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{points:?}");
                assert_eq!(svg, plot.svg().unwrap());
            }
        }
        assert!(plot(Scale::Log, Vec::new()).svg().unwrap().contains("time (s)"));
    }
}
