//! Lengths, and the coordinate systems that nested `svg` elements and symbols set up.

use kurbo::{Affine, Vec2};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, ViewBox};

/// Points of a font, which `em` counts in: what browsers have where nothing is said.
const FONT: f64 = 16.0;

/// The size of the viewport around an element, which percentages refer to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Viewport {
    pub(super) width: f64,
    pub(super) height: f64,
}

/// What a percentage is a part of.
#[derive(Clone, Copy, Debug)]
pub(super) enum Along {
    Width,
    Height,
    Diagonal,
}

impl Viewport {
    /// The root's: its view box, or else its width and height, or else what browsers take.
    pub(super) fn root(svg: Node) -> Self {
        let around = Self { width: 300.0, height: 150.0 };
        match view_box(svg) {
            Some(view) => Self { width: view.w, height: view.h },
            None => Self {
                width: around.length(svg, "width", Along::Width).unwrap_or(around.width),
                height: around.length(svg, "height", Along::Height).unwrap_or(around.height),
            },
        }
    }

    /// An attribute in user units, if it is there and a length.
    pub(super) fn length(&self, node: Node, attribute: &str, along: Along) -> Option<f64> {
        let Length { number, unit } = node.attribute(attribute)?.trim().parse().ok()?;
        let whole = match along {
            Along::Width => self.width,
            Along::Height => self.height,
            Along::Diagonal => self.width.hypot(self.height) / std::f64::consts::SQRT_2,
        };
        // An inch has 96 units, whatever the screen.
        Some(
            number
                * match unit {
                    LengthUnit::None | LengthUnit::Px => 1.0,
                    LengthUnit::In => 96.0,
                    LengthUnit::Cm => 96.0 / 2.54,
                    LengthUnit::Mm => 96.0 / 25.4,
                    LengthUnit::Pt => 96.0 / 72.0,
                    LengthUnit::Pc => 16.0,
                    LengthUnit::Em => FONT,
                    LengthUnit::Ex => 0.5 * FONT,
                    LengthUnit::Percent => whole / 100.0,
                },
        )
    }

    /// The coordinates inside of a nested `svg` or a symbol, and its viewport. `size` is that of a `use`, which goes first.
    pub(super) fn nested(&self, node: Node, size: [Option<f64>; 2]) -> (Affine, Self) {
        let at = Vec2::new(
            self.length(node, "x", Along::Width).unwrap_or(0.0),
            self.length(node, "y", Along::Height).unwrap_or(0.0),
        );
        let own =
            |size: Option<f64>, name, along, whole| size.or_else(|| self.length(node, name, along)).unwrap_or(whole);
        let width = own(size[0], "width", Along::Width, self.width);
        let height = own(size[1], "height", Along::Height, self.height);
        let Some(view) = view_box(node) else {
            return (Affine::translate(at), Self { width, height });
        };
        let ratio: AspectRatio = node
            .attribute("preserveAspectRatio")
            .and_then(|text| text.parse().ok())
            .unwrap_or(AspectRatio { defer: false, align: Align::XMidYMid, slice: false });
        let (x, y) = (width / view.w, height / view.h);
        let one = if ratio.slice { x.max(y) } else { x.min(y) };
        let (scale, [left, top]) = match ratio.align {
            Align::None => ([x, y], [0.0, 0.0]),
            Align::XMinYMin => ([one; 2], [0.0, 0.0]),
            Align::XMidYMin => ([one; 2], [0.5, 0.0]),
            Align::XMaxYMin => ([one; 2], [1.0, 0.0]),
            Align::XMinYMid => ([one; 2], [0.0, 0.5]),
            Align::XMidYMid => ([one; 2], [0.5, 0.5]),
            Align::XMaxYMid => ([one; 2], [1.0, 0.5]),
            Align::XMinYMax => ([one; 2], [0.0, 1.0]),
            Align::XMidYMax => ([one; 2], [0.5, 1.0]),
            Align::XMaxYMax => ([one; 2], [1.0, 1.0]),
        };
        let rest = Vec2::new(left * (width - scale[0] * view.w), top * (height - scale[1] * view.h));
        let inside = Affine::translate(at + rest)
            * Affine::scale_non_uniform(scale[0], scale[1])
            * Affine::translate((-view.x, -view.y));
        (inside, Self { width: view.w, height: view.h })
    }
}

/// A view box with an area.
fn view_box(node: Node) -> Option<ViewBox> {
    node.attribute("viewBox")?.parse().ok().filter(|view: &ViewBox| view.w > 0.0 && view.h > 0.0)
}
