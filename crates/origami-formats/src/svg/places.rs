//! Where an element is in the text, and what it is called in messages.

use origami_core::error::Place;
use roxmltree::Node;

/// Longer ids are cut.
const ID: usize = 40;

/// Finds lines and columns of a text without counting from its start each time.
pub(super) struct Places<'a> {
    text: &'a str,
    /// Where each line begins, in bytes.
    starts: Vec<usize>,
}

impl<'a> Places<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let after = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(at, _)| at + 1);
        Self { text, starts: std::iter::once(0).chain(after).collect() }
    }

    /// The line and column of an element.
    pub(super) fn place(&self, node: Node) -> Place {
        let at = node.range().start;
        let line = self.starts.partition_point(|start| *start <= at);
        let start = self.starts[line - 1];
        // The column where the line has more than this.
        let alone = self.text.get(start..at).is_some_and(|before| before.trim_ascii().is_empty());
        Place::Line { line, column: (!alone).then_some(at - start + 1) }
    }

    /// What messages say of an element.
    pub(super) fn element(&self, node: Node) -> Element {
        let tag = printable(node.tag_name().name());
        let id = node.attribute("id").filter(|id| !id.is_empty());
        let name = id.map_or_else(|| format!("<{tag}>"), |id| format!("<{tag} id=\"{}\">", printable(id)));
        Element { name, has_id: id.is_some(), place: self.place(node) }
    }
}

/// An element of the file, for messages.
#[derive(Clone, Debug)]
pub(super) struct Element {
    /// Such as `<path id="m3">`.
    pub(super) name: String,
    has_id: bool,
    pub(super) place: Place,
}

impl Element {
    /// What a person finds it by: `<path id="m3">`, or `<line> at line 12`.
    pub(super) fn source(&self) -> String {
        if self.has_id { self.name.clone() } else { format!("{} at {}", self.name, self.place) }
    }
}

/// Shortened, and without characters that a terminal obeys.
pub(super) fn printable(text: &str) -> String {
    crate::text::printable(text, ID)
}
