//! OPX, ORIPA's own files: XML as Java writes its beans, one object `oripa.OriLineProxy` a line.
//!
//! Java leaves out what has its default value, so a coordinate that is missing is 0 and so is a type. Old versions set
//! properties of the data set, newer ones fields (`getField`, then `set`); both have the same lines.

use glam::DVec2;
use origami_core::error::{Error, ErrorCode, Place};
use origami_core::fold::Document;
use roxmltree::Node;

use crate::lines::Lines;
use crate::{number, text, xml};

const EXPECTED: &str = "a file of ORIPA: XML with an object oripa.DataSet";
/// What ORIPA says of a pattern, and the key that has it here.
const ABOUT: [(&str, &str); 6] = [
    ("title", "frame_title"),
    ("memo", "frame_description"),
    ("editorName", "file_author"),
    ("originalAuthorName", "frame_author"),
    ("reference", "oripa:reference"),
    ("paperSize", "oripa:paperSize"),
];

/// Reads an OPX file.
///
/// # Errors
/// [`Error::Invalid`] with the line where it is no XML, where a coordinate is no finite number or a type is not 0 to 4.
pub fn read(bytes: &[u8]) -> Result<Document, Error> {
    let text = text::decode(bytes);
    let document = xml::parse(&text, EXPECTED)?;
    let mut lines = Lines::default();
    lines.about("file_creator", "ORIPA");
    for object in document.descendants().filter(|node| is_object(*node, "OriLineProxy")) {
        line(object, &mut lines)?;
    }
    if let Some(set) = document.descendants().find(|node| is_object(*node, "DataSet")) {
        for (name, key) in ABOUT {
            lines.about(key, &value_of(set, name).and_then(|value| value.text()).unwrap_or_default());
        }
    } else if lines.is_empty() {
        let place = Place::Line { line: xml::line_of(document.root_element()), column: None };
        return Err(Error::new(ErrorCode::NotAPattern, place, "has no object of ORIPA", EXPECTED));
    }
    Ok(lines.into_document())
}

/// Whether `node` is an object of a class of this name, whatever package it is in.
fn is_object(node: Node, class: &str) -> bool {
    let name = node.attribute("class").unwrap_or_default();
    node.has_tag_name("object") && name.rsplit('.').next() == Some(class)
}

/// The element that has the value of a property or field of `object`.
fn value_of<'a, 'i>(object: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    let named = |node: &Node| {
        let field = || {
            let first = node.first_element_child().and_then(|child| child.text());
            node.attribute("method") == Some("getField") && first.map(str::trim) == Some(name)
        };
        node.attribute("property") == Some(name) || field()
    };
    let found = object.children().find(|node| node.has_tag_name("void") && named(node))?;
    if found.attribute("property").is_some() {
        return found.first_element_child();
    }
    found.children().find(|node| node.attribute("method") == Some("set"))?.last_element_child()
}

fn line(object: Node, lines: &mut Lines) -> Result<(), Error> {
    let number = |name: &str| {
        let Some(value) = value_of(object, name) else { return Ok(0.0) };
        let place = || Place::Line { line: xml::line_of(value), column: None };
        number::finite(value.text().unwrap_or_default().trim(), place, name)
    };
    let kind = number("type")?;
    let letter = ["F", "B", "M", "V", "F"].into_iter().zip(0..).find(|(_, number)| kind == f64::from(*number));
    let Some((letter, _)) = letter else {
        let line = value_of(object, "type").map_or_else(|| xml::line_of(object), xml::line_of);
        let (problem, expected) = (format!("{kind} is no type of a line"), "0 to 4 (1 border, 2 mountain, 3 valley)");
        return Err(Error::new(ErrorCode::WrongValue, Place::Line { line, column: None }, problem, expected));
    };
    let [x0, y0, x1, y1] = [number("x0")?, number("y0")?, number("x1")?, number("y1")?];
    let ends = [DVec2::new(x0, y0), DVec2::new(x1, y1)];
    lines.push(ends, letter, None, format!("line {}", xml::line_of(object)));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The old form, as ORIPA 0.35 writes it, with properties in an order of its own.
    const OLD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<java version="1.5.0_05" class="java.beans.XMLDecoder">
 <object class="oripa.DataSet">
  <void property="lines">
   <array class="oripa.OriLineProxy" length="2">
    <void index="0"><object class="oripa.OriLineProxy">
      <void property="y1"><double>1.5</double></void>
      <void property="type"><int>2</int></void>
    </object></void>
    <void index="1"><object class="oripa.OriLineProxy"><void property="x0"><double>-2.0E0</double></void></object></void>
   </array>
  </void>
  <void property="paperSize"><double>400.0</double></void>
  <void property="title"><string>a &amp; b</string></void>
  <void property="originalAuthorName"><string>me</string></void>
 </object>
</java>"#;

    /// The new form, of fields.
    const NEW: &str = r#"<java version="21" class="java.beans.XMLDecoder">
 <object class="oripa.DataSet" id="DataSet0">
  <void class="oripa.DataSet" method="getField"><string>title</string>
   <void method="set"><object idref="DataSet0"/><string>fields</string></void></void>
  <void class="oripa.DataSet" method="getField"><string>lines</string>
   <void method="set"><object idref="DataSet0"/><array class="oripa.OriLineProxy" length="1">
    <void index="0"><object class="oripa.OriLineProxy"><void property="x1"><double>3</double></void>
     <void property="type"><int>3</int></void></object></void></array></void></void>
 </object></java>"#;

    fn frame(text: &str) -> (Vec<[f64; 2]>, String) {
        let frame = read(text.as_bytes()).expect("OPX").key_frame;
        let at = frame.vertices_coords.expect("vertices").iter().map(|c| [c.position.x, c.position.y]).collect();
        (at, frame.edges_assignment.expect("letters").concat())
    }

    #[test]
    fn both_forms_are_read_and_what_is_missing_is_zero() {
        assert_eq!(frame(OLD), (vec![[0.0, 0.0], [0.0, 1.5], [-2.0, 0.0]], "MF".to_owned()));
        assert_eq!(frame(NEW), (vec![[0.0, 0.0], [3.0, 0.0]], "V".to_owned()));
    }

    #[test]
    fn titles_and_authors_are_kept() {
        let document = read(OLD.as_bytes()).expect("OPX");
        let extra = &document.key_frame.extra;
        assert_eq!((&extra["frame_title"], &extra["oripa:paperSize"]), (&"a & b".into(), &"400.0".into()));
        assert_eq!((&extra["frame_author"], &document.metadata["file_creator"]), (&"me".into(), &"ORIPA".into()));
        assert_eq!(read(NEW.as_bytes()).expect("OPX").key_frame.extra["frame_title"], "fields");
    }

    #[test]
    fn errors_name_the_line() {
        let bad = |old: &str, new: &str| read(OLD.replace(old, new).as_bytes()).expect_err(new).to_string();
        assert_eq!(bad("1.5<", "1,5,1<"), "line 7: \"1,5,1\" is no number; expected a number for y1");
        assert_eq!(bad("1.5<", "NaN<"), "line 7: \"NaN\" is not finite; expected a number for y1");
        assert!(bad("<int>2", "<int>9").starts_with("line 8: 9 is no type of a line; expected 0 to 4"));
        assert!(bad("</array>", "").starts_with("line 12 column"), "{}", bad("</array>", ""));
        assert!(bad("</array>", "").contains("not XML: "));
        let none = read(b"<java><object class='x.Y'/></java>").expect_err("no data set");
        assert_eq!(
            (none.code(), none.to_string().starts_with("line 1: has no object of ORIPA")),
            (ErrorCode::NotAPattern, true)
        );
    }

    #[test]
    fn bombs_are_refused() {
        let deep = "<a>".repeat(2_000_000);
        assert_eq!(read(deep.as_bytes()).expect_err("deep").code(), ErrorCode::NestedTooDeeply);
        let mut laughs = String::from("<!DOCTYPE a [<!ENTITY b0 \"ha\">");
        (1..40).for_each(|i| laughs += &format!("<!ENTITY b{i} \"&b{0};&b{0};\">", i - 1));
        assert_eq!(read((laughs + "]><a>&b39;</a>").as_bytes()).expect_err("a bomb").code(), ErrorCode::NotXml);
    }
}
