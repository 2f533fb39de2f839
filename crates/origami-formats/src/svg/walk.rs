//! The walk over the tree, from the root to every shape that is painted.

use std::collections::BTreeMap;

use kurbo::{Affine, PathSeg};
use origami_core::error::{Error, ErrorCode};
use roxmltree::{Document, Node, NodeId};
use svgtypes::Transform;

use super::cascade::{self, Cascade, Declared};
use super::drawing::{Drawing, Mark};
use super::places::{Places, printable};
use super::shapes;
use super::style::{Ink, Style};
use super::view::{Along, Viewport};

const SVG: &str = "http://www.w3.org/2000/svg";
const XLINK: &str = "http://www.w3.org/1999/xlink";
/// Elements in each other, `use` included.
const DEEPEST: usize = 100;
/// Elements that are looked at: `use` of `use` can ask for any number.
const MOST: usize = 1 << 21;

/// All marks of a file.
///
/// # Errors
/// As [`super::read`].
pub(super) fn drawing(tree: &Document) -> Result<Drawing, Error> {
    let places = Places::new(tree.input_text());
    let root = tree.root_element();
    if !is(root, "svg") {
        let problem = format!("the root element is <{}>", printable(root.tag_name().name()));
        return Err(Error::new(ErrorCode::WrongType, places.place(root), problem, "<svg>"));
    }
    let sheets = cascade::sheets(tree);
    let with_id = tree.descendants().filter_map(|node| Some((node.attribute("id")?, node.id())));
    let mut walk = Walk {
        tree,
        cascade: Cascade::new(&sheets),
        places,
        // The first of an id counts.
        ids: with_id.collect::<Vec<_>>().into_iter().rev().collect(),
        seen: 0,
        drawing: Drawing::default(),
    };
    walk.drawing.title =
        root.children().find(|node| is(*node, "title")).and_then(|title| title.text().map(str::to_owned));
    let around = Around { style: Style::default(), to_paper: Affine::FLIP_Y, viewport: Viewport::root(root), depth: 0 };
    walk.element(root, &around)?;
    Ok(walk.drawing)
}

/// Whether `node` is an SVG element of this name; old programs name no namespace.
fn is(node: Node, name: &str) -> bool {
    let tag = node.tag_name();
    tag.name() == name && tag.namespace().is_none_or(|namespace| namespace == SVG)
}

struct Walk<'t> {
    tree: &'t Document<'t>,
    cascade: Cascade<'t>,
    places: Places<'t>,
    ids: BTreeMap<&'t str, NodeId>,
    seen: usize,
    drawing: Drawing,
}

/// What an element finds around it.
#[derive(Clone, Copy)]
struct Around<'t> {
    style: Style<'t>,
    to_paper: Affine,
    viewport: Viewport,
    depth: usize,
}

impl<'t> Walk<'t> {
    fn element(&mut self, node: Node<'t, 't>, around: &Around<'t>) -> Result<(), Error> {
        if node.tag_name().namespace().is_some_and(|namespace| namespace != SVG) {
            return Ok(());
        }
        let name = node.tag_name().name();
        match name {
            // Things that are never painted where they stand.
            "defs" | "symbol" | "clipPath" | "mask" | "marker" | "pattern" | "filter" | "linearGradient"
            | "radialGradient" | "style" | "title" | "desc" | "metadata" => return Ok(()),
            "text" | "image" | "foreignObject" | "script" | "animate" | "animateTransform" | "animateMotion"
            | "set" => {
                self.left_out(
                    node,
                    match name {
                        "text" => "is text",
                        "image" => "is an image",
                        "foreignObject" => "is no SVG",
                        "script" => "is a script",
                        _ => "is an animation",
                    },
                );
                return Ok(());
            }
            _ => {}
        }
        self.check(node, around.depth)?;
        let declared = self.cascade.of(node)?;
        if declared.display == Some("none") {
            self.left_out(node, "is hidden");
            return Ok(());
        }
        self.note_ignored(node, &declared);
        let own = Around {
            style: around.style.within(&declared),
            to_paper: around.to_paper * self.transform(node, &declared),
            depth: around.depth + 1,
            ..*around
        };
        match name {
            "g" | "a" => self.children(node, &own),
            "svg" if around.depth == 0 => self.children(node, &own),
            "svg" => self.nested(node, &own, [None, None]),
            "switch" => {
                let fits = |child: &Node| child.is_element() && child.attribute("requiredExtensions").is_none();
                node.children().find(fits).map_or(Ok(()), |child| self.element(child, &own))
            }
            "use" => self.used(node, &own),
            _ if shapes::SHAPES.contains(&name) => self.shape(node, &own),
            _ => {
                self.left_out(node, &format!("is an element <{}>, which is not known", printable(name)));
                Ok(())
            }
        }
    }

    fn children(&mut self, node: Node<'t, 't>, around: &Around<'t>) -> Result<(), Error> {
        node.children().filter(Node::is_element).try_for_each(|child| self.element(child, around))
    }

    fn nested(&mut self, node: Node<'t, 't>, around: &Around<'t>, size: [Option<f64>; 2]) -> Result<(), Error> {
        let (inside, viewport) = around.viewport.nested(node, size);
        self.children(node, &Around { to_paper: around.to_paper * inside, viewport, ..*around })
    }

    fn used(&mut self, node: Node<'t, 't>, around: &Around<'t>) -> Result<(), Error> {
        let link = node.attribute("href").or_else(|| node.attribute((XLINK, "href"))).unwrap_or_default().trim();
        let target = link.strip_prefix('#').and_then(|id| self.ids.get(id)).and_then(|id| self.tree.get_node(*id));
        let Some(target) = target else {
            self.left_out(node, "uses what is not in the file");
            return Ok(());
        };
        if node.ancestors().any(|ancestor| ancestor == target) {
            self.left_out(node, "uses what it is a part of");
            return Ok(());
        }
        let length = |name, along| around.viewport.length(node, name, along);
        let at = (length("x", Along::Width).unwrap_or(0.0), length("y", Along::Height).unwrap_or(0.0));
        let size = [length("width", Along::Width), length("height", Along::Height)];
        let inside = Around { to_paper: around.to_paper * Affine::translate(at), ..*around };
        if !(is(target, "symbol") || is(target, "svg")) {
            return self.element(target, &inside);
        }
        self.check(target, inside.depth)?;
        let declared = self.cascade.of(target)?;
        if declared.display == Some("none") {
            self.left_out(target, "is hidden");
            return Ok(());
        }
        let inside = Around {
            style: inside.style.within(&declared),
            to_paper: inside.to_paper * self.transform(target, &declared),
            depth: inside.depth + 1,
            ..inside
        };
        self.nested(target, &inside, size)
    }

    /// Counts an element, and refuses one too many or too deep.
    fn check(&mut self, node: Node, depth: usize) -> Result<(), Error> {
        self.seen += 1;
        if depth >= DEEPEST {
            let problem = "the element is nested too deeply, or uses itself";
            let expected = format!("at most {DEEPEST} elements in each other");
            return Err(Error::new(ErrorCode::NestedTooDeeply, self.places.place(node), problem, expected));
        }
        if self.seen > MOST {
            let expected = format!("at most {MOST} elements, those of each `use` counted");
            return Err(Error::new(
                ErrorCode::TooManyEntries,
                self.places.place(node),
                "there are too many elements",
                expected,
            ));
        }
        Ok(())
    }

    fn shape(&mut self, node: Node<'t, 't>, around: &Around<'t>) -> Result<(), Error> {
        let style = &around.style;
        if !style.visible {
            self.left_out(node, "is hidden");
            return Ok(());
        }
        let Some(colour) = style.colour() else {
            let why = match style.stroke {
                Ink::Other(paint) => format!("is painted with {}, which is no colour", printable(paint)),
                _ => "has no stroke".to_owned(),
            };
            self.left_out(node, &why);
            return Ok(());
        };
        let (outline, broken) = shapes::outline(node, &around.viewport);
        let element = self.places.element(node);
        if let Some(broken) = broken {
            self.drawing.notes.ignored(&element, broken);
        }
        let path: Vec<PathSeg> = outline.into_iter().map(|segment| around.to_paper * segment).collect();
        if !path.iter().all(is_finite) {
            let problem = format!("{} has a coordinate that is not finite", element.name);
            return Err(Error::new(ErrorCode::NotFinite, element.place, problem, "numbers"));
        }
        if path.is_empty() {
            self.drawing.notes.left_out(&element, "has no length");
            return Ok(());
        }
        self.drawing.marks.push(Mark {
            path,
            colour: [colour.red, colour.green, colour.blue],
            opacity: style.opacity(colour),
            dashes: style.dashes,
            element,
        });
        Ok(())
    }

    fn transform(&mut self, node: Node, declared: &Declared) -> Affine {
        let Some(text) = declared.transform.filter(|text| *text != "none") else { return Affine::IDENTITY };
        // Style sheets write units, attributes do not.
        let parsed = text.parse().or_else(|_| text.replace("px", "").replace("deg", "").parse());
        match parsed {
            Ok(Transform { a, b, c, d, e, f }) => Affine::new([a, b, c, d, e, f]),
            Err(_) => {
                self.ignored(node, "has a transform that cannot be read");
                Affine::IDENTITY
            }
        }
    }

    fn note_ignored(&mut self, node: Node, declared: &Declared) {
        let given = |value: Option<&str>| value.is_some_and(|value| value != "none");
        if given(declared.clip) || given(declared.mask) {
            self.ignored(node, "is clipped or masked");
        }
        if declared.origin.is_some() && given(declared.transform) {
            self.ignored(node, "has a transform-origin");
        }
    }

    fn left_out(&mut self, node: Node, why: &str) {
        self.drawing.notes.left_out(&self.places.element(node), why);
    }

    fn ignored(&mut self, node: Node, why: &str) {
        self.drawing.notes.ignored(&self.places.element(node), why);
    }
}

fn is_finite(segment: &PathSeg) -> bool {
    match segment {
        PathSeg::Line(line) => line.p0.is_finite() && line.p1.is_finite(),
        PathSeg::Quad(quad) => quad.is_finite(),
        PathSeg::Cubic(cubic) => cubic.is_finite(),
    }
}
