//! The properties that an element declares: as attributes, by style sheets, and in its attribute `style`.

use std::cell::Cell;

use origami_core::error::{Error, ErrorCode, Place};
use roxmltree::{Document, Node};
use simplecss::{AttributeOperator, DeclarationTokenizer, Element, PseudoClass, StyleSheet};

/// Comparing selectors with elements takes at most so many looks at an element.
const LOOKS: u64 = 1 << 27;
/// A selector that goes through more elements than this does not match.
const STEPS: u16 = 200;

/// Properties as declared for one element, before inheritance.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Declared<'a> {
    pub(super) stroke: Option<&'a str>,
    pub(super) color: Option<&'a str>,
    pub(super) stroke_opacity: Option<&'a str>,
    pub(super) opacity: Option<&'a str>,
    pub(super) display: Option<&'a str>,
    pub(super) visibility: Option<&'a str>,
    pub(super) dashes: Option<&'a str>,
    pub(super) clip: Option<&'a str>,
    pub(super) mask: Option<&'a str>,
    pub(super) transform: Option<&'a str>,
    pub(super) origin: Option<&'a str>,
}

impl<'a> Declared<'a> {
    fn set(&mut self, name: &str, value: &'a str) {
        let slot = match name {
            "stroke" => &mut self.stroke,
            "color" => &mut self.color,
            "stroke-opacity" => &mut self.stroke_opacity,
            "opacity" => &mut self.opacity,
            "display" => &mut self.display,
            "visibility" => &mut self.visibility,
            "stroke-dasharray" => &mut self.dashes,
            "clip-path" => &mut self.clip,
            "mask" => &mut self.mask,
            "transform" => &mut self.transform,
            "transform-origin" => &mut self.origin,
            _ => return,
        };
        *slot = Some(value.trim());
    }
}

/// The text of all style sheets of a file, one after the other.
pub(super) fn sheets(tree: &Document) -> String {
    let styles = tree.descendants().filter(|node| node.tag_name().name() == "style");
    let css = |node: &Node| node.attribute("type").is_none_or(|kind| kind.is_empty() || kind.contains("css"));
    let texts = styles
        .filter(css)
        .flat_map(|node| node.descendants().filter_map(|inner| inner.is_text().then(|| inner.text())?));
    texts.flat_map(|text| [text, "\n"]).collect()
}

/// All declarations of a file.
pub(super) struct Cascade<'a> {
    sheet: StyleSheet<'a>,
    looks: Cell<u64>,
}

impl<'a> Cascade<'a> {
    /// Of the text of all style sheets.
    pub(super) fn new(sheets: &'a str) -> Self {
        Self { sheet: StyleSheet::parse(sheets), looks: Cell::new(0) }
    }

    /// What `node` declares: its attributes, then rules by how specific they are, then `style`, then what is important.
    pub(super) fn of(&self, node: Node<'a, '_>) -> Result<Declared<'a>, Error> {
        let mut declared = Declared::default();
        for attribute in node.attributes().filter(|attribute| attribute.namespace().is_none()) {
            declared.set(attribute.name(), attribute.value());
        }
        let element = Seen { node, looks: &self.looks, steps: 0 };
        let rules = self.sheet.rules.iter().filter(|rule| rule.selector.matches(&element));
        let own = DeclarationTokenizer::from(node.attribute("style").unwrap_or_default());
        let (important, normal): (Vec<_>, Vec<_>) =
            rules.flat_map(|rule| rule.declarations.iter().copied()).chain(own).partition(|d| d.important);
        normal.iter().chain(&important).for_each(|declaration| declared.set(declaration.name, declaration.value));
        if self.looks.get() > LOOKS {
            let place = Place::Line { line: 1, column: None };
            let problem = "its style sheets take too long to be compared with its elements";
            return Err(Error::new(ErrorCode::TooManyEntries, place, problem, "fewer or simpler rules"));
        }
        Ok(declared)
    }
}

/// An element as selectors see it. Those that look at too much see nothing more.
#[derive(Clone, Copy)]
struct Seen<'c, 'a, 'i> {
    node: Node<'a, 'i>,
    looks: &'c Cell<u64>,
    steps: u16,
}

impl Seen<'_, '_, '_> {
    fn look(&self) -> bool {
        self.looks.set(self.looks.get() + 1);
        self.looks.get() <= LOOKS && self.steps <= STEPS
    }

    fn step(&self, node: Option<Self>) -> Option<Self> {
        node.filter(|_| self.look()).map(|seen| Self { steps: self.steps + 1, ..seen })
    }
}

impl Element for Seen<'_, '_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.step(self.node.parent_element().map(|node| Self { node, ..*self }))
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.step(self.node.prev_sibling_element().map(|node| Self { node, ..*self }))
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.look() && self.node.tag_name().name() == name
    }

    fn attribute_matches(&self, local_name: &str, operator: AttributeOperator<'_>) -> bool {
        self.look() && self.node.attribute(local_name).is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        self.look() && class == PseudoClass::FirstChild && self.node.prev_sibling_element().is_none()
    }
}
