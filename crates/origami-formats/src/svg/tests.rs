//! What each construct of SVG comes out as: lines in order, with letters, angles and sources.

use origami_core::fold::Document;
use origami_core::pattern::keys;

use super::read;
use crate::Options;

fn document(body: &str) -> Document {
    let text =
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\">{body}</svg>");
    read(text.as_bytes(), &Options::default()).unwrap_or_else(|error| panic!("{error}\n{body}"))
}

/// Such as `M 0 0 1 -1`: letter and ends.
fn lines(document: &Document) -> Vec<String> {
    let frame = &document.key_frame;
    let at = |v: u32| frame.vertices_coords.as_ref().unwrap()[v as usize].position;
    let edges = frame.edges_vertices.as_ref().unwrap().iter().zip(frame.edges_assignment.as_ref().unwrap());
    // Rounded, and without a negative zero.
    let number = |x: f64| (x * 1e9).round() / 1e9 + 0.0;
    edges
        .map(|([a, b], letter)| {
            let [a, b] = [at(*a), at(*b)];
            format!("{letter} {} {} {} {}", number(a.x), number(a.y), number(b.x), number(b.y))
        })
        .collect()
}

fn read_lines(body: &str) -> Vec<String> {
    lines(&document(body))
}

fn warnings(body: &str) -> Vec<String> {
    document(body).warnings.iter().map(ToString::to_string).collect()
}

fn angles(body: &str) -> Vec<Option<f64>> {
    document(body).key_frame.edges_fold_angle.unwrap_or_default()
}

fn refusal(body: &str) -> String {
    read(body.as_bytes(), &Options::default()).unwrap_err().to_string()
}

const RED: &str = "<line x2='1' y2='1' stroke='red'/>";

#[test]
fn shapes_become_lines_with_y_up() {
    assert_eq!(read_lines("<line x1='1' y1='2' x2='3' y2='4' stroke='#f00'/>"), ["M 1 -2 3 -4"]);
    assert_eq!(read_lines("<polyline points='0,0 1,0 1-1' stroke='blue'/>"), ["V 0 0 1 0", "V 1 0 1 1"]);
    let square = ["B 0 0 1 0", "B 1 0 1 -1", "B 1 -1 0 -1", "B 0 -1 0 0"];
    assert_eq!(read_lines("<polygon points='0 0 1 0 1 1 0 1' stroke='black'/>"), square);
    assert_eq!(read_lines("<rect width='1' height='1' stroke='black'/>"), square);
    assert_eq!(read_lines("<path d='m0 0h1v1h-1z' stroke='black'/>"), square);
    assert_eq!(read_lines("<path d='M0 0H1M5 5v1' stroke='lime'/>"), ["C 0 0 1 0", "C 5 -5 5 -6"]);
}

#[test]
fn units_and_percentages_are_user_units() {
    assert_eq!(read_lines("<line x2='1in' y2='25.4mm' stroke='red'/>"), ["M 0 0 96 -96"]);
    let boxed = |view: &str| format!("<svg viewBox='{view}'><line x2='100%' y2='50%' stroke='red'/></svg>");
    let own = read(boxed("5 5 40 20").as_bytes(), &Options::default()).unwrap();
    assert_eq!(lines(&own), ["M 0 0 40 -10"], "the root's view box moves nothing, and no namespace is needed");
}

#[test]
fn transforms_nest() {
    let body = "<g transform='translate(10 0)'><g transform='rotate(90) scale(2)'><line x2='1' stroke='red'/></g></g>";
    assert_eq!(read_lines(body), ["M 10 0 10 -2"]);
    let styled = "<g style='transform: translate(3px, 4px)'><line x2='1' stroke='red'/></g>";
    assert_eq!(read_lines(styled), ["M 3 -4 4 -4"]);
    let broken = "<g transform='turn(5)'><line x2='1' stroke='red'/></g>";
    assert_eq!(warnings(broken), ["line 1 column 84: <g> has a transform that cannot be read; that is not looked at"]);
}

#[test]
fn a_nested_view_is_scaled_into_its_place() {
    let nested = |ratio: &str| {
        format!(
            "<svg x='100' y='100' width='20' height='10' viewBox='0 0 1 1' {ratio}><line x2='1' y2='1' stroke='red'/></svg>"
        )
    };
    assert_eq!(read_lines(&nested("")), ["M 105 -100 115 -110"], "in the middle, as large as fits");
    assert_eq!(read_lines(&nested("preserveAspectRatio='none'")), ["M 100 -100 120 -110"]);
    assert_eq!(read_lines(&nested("preserveAspectRatio='xMinYMax slice'")), ["M 100 -90 120 -110"]);
}

#[test]
fn what_is_used_is_drawn_where_it_is_used() {
    let defs = "<defs><g id='a'><line x2='1' /></g></defs>";
    let body = format!(
        "{defs}<use href='#a' x='5' y='1' stroke='red'/><g stroke='blue'><use xlink:href='#a' transform='scale(2)'/></g>"
    );
    assert_eq!(read_lines(&body), ["M 5 -1 6 -1", "V 0 0 2 0"]);
    let symbol = "<symbol id='s' viewBox='0 0 10 10'><line x2='10' y2='10' stroke='red'/></symbol><use href='#s' x='1' width='5' height='5'/>";
    assert_eq!(read_lines(symbol), ["M 1 0 6 -5"]);
}

#[test]
fn colours_come_from_attributes_sheets_and_styles_in_that_order() {
    let sheet = "<style>/* a sheet */ .v{stroke:#00f} #c { stroke : lime } line.w, g > line { stroke: yellow } .i{stroke:red!important}</style>";
    let of = |line: &str| read_lines(&format!("{sheet}<g>{line}</g>{RED}"))[0].chars().next().unwrap();
    for (line, letter) in [
        ("<path d='M0 0h1' stroke='magenta'/>", 'U'),
        ("<path d='M0 0h1' class='x v' stroke='magenta'/>", 'V'),
        ("<path d='M0 0h1' class='v' id='c'/>", 'C'),
        ("<line x2='1' class='v w'/>", 'F'),
        ("<line x2='1'/>", 'F'),
        ("<path d='M0 0h1' class='v' style='stroke:#ff0000'/>", 'M'),
        ("<path d='M0 0h1' class='i' style='stroke:black'/>", 'M'),
        ("<path d='M0 0h1' style='color:blue;stroke:currentColor'/>", 'V'),
        ("<g stroke='rgb(0,0,255)'><path d='M0 0h1'/></g>", 'V'),
        ("<g stroke='blue'><path d='M0 0h1' stroke='inherit'/></g>", 'V'),
        ("<path d='M0 0h1' stroke='hsl(300, 100%, 50%)'/>", 'U'),
        ("<path d='M0 0h1' stroke='#FF0'/>", 'F'),
        ("<path d='M0 0h1' stroke=' Red '/>", 'M'),
    ] {
        assert_eq!(of(line), letter, "{line}");
    }
    let cdata = "<style><![CDATA[ path{stroke:blue} ]]></style><path d='M0 0h1'/>";
    assert_eq!(read_lines(cdata), ["V 0 0 1 0"]);
}

#[test]
fn opacity_is_the_fold_angle() {
    let line = |attributes: &str| angles(&format!("<line x2='1' {attributes}/>{RED}"))[0];
    assert_eq!(line("stroke='red' stroke-opacity='0.5'"), Some(-90.0));
    assert_eq!(line("stroke='blue' opacity='.25'"), Some(45.0));
    assert_eq!(line("stroke='blue' style='opacity:50%;stroke-opacity:0.5'"), Some(45.0));
    assert_eq!(line("stroke='#0000ff80'"), Some(180.0 * (128.0 / 255.0)));
    assert_eq!(
        angles(&format!("<line y2='1' stroke='yellow' opacity='0.5'/>{RED}")),
        [],
        "only mountains and valleys have one"
    );
    assert_eq!(angles("<g opacity='0.5'><g stroke-opacity='0.5'><line x2='1' stroke='blue'/></g></g>"), [Some(45.0)]);
    assert_eq!(angles(&format!("<line y2='1' stroke='blue' opacity='0'/>{RED}")), [Some(0.0), Some(-180.0)]);
}

#[test]
fn sources_name_the_element() {
    let body = "\n<line id='m3' x2='1' stroke='red'/>\n  <line y2='1' stroke='red'/><line x2='-1' stroke='red'/>\n<path id='p' d='M0 0h3v4' stroke='red'/>";
    let document = document(body);
    let sources: Vec<&str> = document.key_frame.extra[keys::SOURCE]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|source| source.as_str())
        .collect();
    assert_eq!(
        sources,
        [
            "<line id=\"m3\">",
            "<line> at line 3",
            "<line> at line 3 column 30",
            "<path id=\"p\"> piece 1",
            "<path id=\"p\"> piece 2"
        ]
    );
}

#[test]
fn what_is_left_out_is_said_once_for_each_kind() {
    for (body, said) in [
        ("<text>a</text>", "<text> is text; it is left out"),
        ("<g display='none'><line x2='5' stroke='red'/></g>", "<g> is hidden; it is left out"),
        ("<g style='display:none'/>", "<g> is hidden; it is left out"),
        ("<line id='h' x2='5' stroke='red' visibility='hidden'/>", "<line id=\"h\"> is hidden; it is left out"),
        ("<rect id='r' width='5' height='5'/>", "<rect id=\"r\"> has no stroke; it is left out"),
        ("<image id='i'/>", "<image id=\"i\"> is an image; it is left out"),
        ("<use id='u' href='#none'/>", "<use id=\"u\"> uses what is not in the file; it is left out"),
        (
            "<line id='c' x2='5' stroke='cyan'/>",
            "<line id=\"c\"> has the colour #00ffff, which stands for nothing; it is left out",
        ),
        (
            "<line id='c' x2='5' stroke='url(#x)'/>",
            "<line id=\"c\"> is painted with url(#x), which is no colour; it is left out",
        ),
        ("<rect id='r' width='5' stroke='red'/>", "<rect id=\"r\"> has no length; it is left out"),
        ("<blink id='b'/>", "<blink id=\"b\"> is an element <blink>, which is not known; it is left out"),
    ] {
        let told = warnings(&format!("{body}{RED}"));
        assert_eq!(told, [format!("line 1 column 84: {said}")], "{body}");
        assert_eq!(read_lines(&format!("{body}{RED}")), ["M 0 0 1 -1"], "{body}");
        let more = warnings(&format!("{body}{body}{body}{RED}"));
        assert_eq!(more, [format!("line 1 column 84: {said}; so are 2 more")], "{body}");
    }
    let own = "<g id='g'><use id='u' href='#g'/><line x2='1' stroke='red'/></g>";
    assert_eq!(warnings(own), ["line 1 column 94: <use id=\"u\"> uses what it is a part of; it is left out"]);
    let clipped = "<line id='l' x2='1' y2='1' stroke='red' clip-path='url(#c)'/>";
    assert_eq!(warnings(clipped), ["line 1 column 84: <line id=\"l\"> is clipped or masked; that is not looked at"]);
    assert_eq!(
        warnings("<defs><text/><line/></defs><metadata/><title>t</title><x:y xmlns:x='z'/><line x2='1' stroke='red'/>"),
        [""; 0]
    );
}

#[test]
fn near_colours_and_dashes_are_said() {
    assert_eq!(
        warnings("<line id='a' x2='1' stroke='#ed1c24'/><line x2='1' y2='2' stroke='#ed1c24'/>"),
        ["line 1 column 84: <line id=\"a\"> has the colour #ed1c24; it is taken for red, a mountain"]
    );
    let dashed = "<g stroke='black'><rect width='2' height='2'/><path d='M1 0v2' stroke-dasharray='3 2'/><path d='M0 1h2' stroke-dasharray='6,2,1,2'/></g>";
    let told = document(dashed);
    assert_eq!(lines(&told)[4..], ["V 1 0 1 -2", "M 0 -1 2 -1"]);
    assert!(told.warnings[0].to_string().contains("dashed ones are taken for valleys"), "{:?}", told.warnings);
    let coloured = dashed.replace("<path d='M1", "<path stroke='red' d='M1");
    assert_eq!(read_lines(&coloured)[4..], ["M 1 0 1 -2", "B 0 -1 2 -1"], "colours go before dashes");
}

#[test]
fn a_table_of_colours_is_obeyed() {
    let options = Options { colours: "cyan=V,red=none,#808080=B".parse().unwrap(), ..Options::default() };
    let body =
        "<svg><path d='M0 0h1' stroke='cyan'/><path d='M0 0h2' stroke='red'/><path d='M0 0h3' stroke='gray'/></svg>";
    let document = read(body.as_bytes(), &options).unwrap();
    assert_eq!(lines(&document), ["V 0 0 1 0", "B 0 0 3 0"]);
    assert_eq!(document.warnings.len(), 0, "what was asked for is not said: {:?}", document.warnings);
}

#[test]
fn encodings_doctypes_and_entities() {
    let svg = |head: &str| format!("{head}<svg><title>Pap\u{ed}r</title><line x2='1' stroke='red'/></svg>");
    let wide: Vec<u8> = svg("\u{feff}").encode_utf16().flat_map(u16::to_le_bytes).collect();
    let latin: Vec<u8> = svg("<?xml version='1.0' encoding='ISO-8859-1'?>").chars().map(|c| c as u8).collect();
    for bytes in [svg("\u{feff}").into_bytes(), wide, latin] {
        let document = read(&bytes, &Options::default()).unwrap();
        assert_eq!(document.metadata["file_title"], "Pap\u{ed}r");
    }
    let drawn = "<!DOCTYPE svg [<!ENTITY ns 'http://www.w3.org/2000/svg'><!ENTITY st 'stroke:#FF0000;'>]>\
                 <svg xmlns='&ns;'><line style='&st;' x2='1'/></svg>";
    assert_eq!(lines(&read(drawn.as_bytes(), &Options::default()).unwrap()), ["M 0 0 1 0"]);
}

#[test]
fn refusals_say_where_and_what() {
    assert!(refusal("<svg><g></svg>").starts_with("line 1 column 9: not XML: "), "{}", refusal("<svg><g></svg>"));
    assert_eq!(refusal("<html><body/></html>"), "line 1: the root element is <html>; expected <svg>");
    let empty = refusal("<svg><text/><text/><rect width='1' height='1'/></svg>");
    assert!(
        empty.starts_with(
            "line 1: no line of a crease pattern is drawn (left out: 2 × is text, 1 × has no stroke); expected"
        ),
        "{empty}"
    );
    let huge = refusal("<svg>\n<path id='p' stroke='red' d='M0 0 l1e308 0 l1e308 0'/></svg>");
    assert_eq!(huge, "line 2: <path id=\"p\"> has a coordinate that is not finite; expected numbers");
    let deep = format!("<svg>{}{}</svg>", "<g>".repeat(200), "</g>".repeat(200));
    assert!(refusal(&deep).contains("nested too deeply"), "{}", refusal(&deep));
    let bad = "<svg><path id='p' stroke='red' d='M0 0 L5 0 L x'/></svg>";
    let told = read(bad.as_bytes(), &Options::default()).unwrap();
    assert_eq!(lines(&told), ["M 0 0 5 0"]);
    assert_eq!(
        told.warnings[0].to_string(),
        "line 1 column 6: <path id=\"p\"> has path data that cannot be read to its end; that is not looked at"
    );
}

/// `use` that doubles at each level would draw 2 to the 40 lines.
#[test]
fn what_swells_is_refused() {
    let doubling: String =
        (0..40).map(|i| format!("<g id='a{}'><use href='#a{i}'/><use href='#a{i}'/></g>", i + 1)).collect();
    let body = format!("<svg><defs><line id='a0' x2='1' stroke='red'/>{doubling}</defs><use href='#a40'/></svg>");
    let said = refusal(&body);
    assert!(said.contains("too many elements") || said.contains("nested too deeply"), "{said}");
    let circle = "<svg><defs><g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g></defs><use href='#a'/></svg>";
    assert!(refusal(circle).contains("nested too deeply, or uses itself"), "{}", refusal(circle));
    let entities: String =
        (1..20).map(|i| format!("<!ENTITY e{i} '{}'>", format!("&e{};", i - 1).repeat(10))).collect();
    let laughs = format!("<!DOCTYPE svg [<!ENTITY e0 'x'>{entities}]><svg>&e19;</svg>");
    assert!(refusal(&laughs).contains("not XML"), "{}", refusal(&laughs));
    // Selectors that would be tried in any order, and siblings without end.
    let sheet =
        format!("<style>{}{{stroke:red}} {}{{stroke:red}}</style>", "g ".repeat(60), "line+".repeat(5000) + "line");
    let nested = format!(
        "<svg>{sheet}{}<line x2='1'/>{}{}</svg>",
        "<g>".repeat(60),
        "</g>".repeat(60),
        "<line x2='1' stroke='blue'/>".repeat(6000)
    );
    let _ = read(nested.as_bytes(), &Options::default());
}
