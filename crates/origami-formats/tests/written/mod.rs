//! Lines as the programs of each format write them.

#![allow(dead_code, reason = "each test uses its part")]

use std::fmt::Write;

use origami_formats::Format;

/// A line of a pattern.
pub(crate) struct Segment {
    /// FOLD's: B, M, V or F.
    pub(crate) letter: &'static str,
    pub(crate) ends: [[f64; 2]; 2],
}

impl Segment {
    /// The place of its letter in a list for B, M, V and all others.
    fn of<T: Copy>(&self, [b, m, v, other]: [T; 4]) -> T {
        match self.letter {
            "B" => b,
            "M" => m,
            "V" => v,
            _ => other,
        }
    }
}

/// The lines in every format.
pub(crate) fn in_all_formats(segments: &[Segment]) -> Vec<(Format, String)> {
    vec![
        (Format::Fold, fold(segments)),
        (Format::Cp, cp(segments)),
        (Format::Opx, opx(segments)),
        (Format::Ori, ori(segments)),
        (Format::Orh, orh(segments)),
        (Format::Svg, svg(segments)),
        (Format::Obj, obj(segments)),
        (Format::Dxf, dxf(segments)),
    ]
}

fn each(segments: &[Segment], mut write: impl FnMut(&mut String, usize, &Segment, [f64; 4])) -> String {
    let mut text = String::new();
    for (index, segment) in segments.iter().enumerate() {
        let [[x1, y1], [x2, y2]] = segment.ends;
        write(&mut text, index, segment, [x1, y1, x2, y2]);
    }
    text
}

/// The different ends of lines, and for each line which these are.
fn shared<'s>(segments: impl Iterator<Item = &'s Segment>) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut number = |point: [f64; 2]| {
        points.iter().position(|other| *other == point).unwrap_or_else(|| {
            points.push(point);
            points.len() - 1
        })
    };
    let edges = segments.map(|segment| segment.ends.map(&mut number)).collect();
    (points, edges)
}

/// FOLD has no lines without length.
fn fold(segments: &[Segment]) -> String {
    let long = || segments.iter().filter(|segment| segment.ends[0] != segment.ends[1]);
    let (points, edges) = shared(long());
    let letters: Vec<&str> = long().map(|segment| segment.letter).collect();
    format!("{{\"vertices_coords\": {points:?}, \"edges_vertices\": {edges:?}, \"edges_assignment\": {letters:?}}}")
}

pub(crate) fn cp(segments: &[Segment]) -> String {
    each(segments, |text, _, segment, [x1, y1, x2, y2]| {
        let _ = writeln!(text, "{} {x1:?} {y1:?} {x2:?} {y2:?}", segment.of([1, 2, 3, 4]));
    })
}

pub(crate) fn opx(segments: &[Segment]) -> String {
    let lines = each(segments, |text, index, segment, [x0, y0, x1, y1]| {
        let _ = writeln!(text, "<void index=\"{index}\"><object class=\"oripa.OriLineProxy\">");
        let kind = segment.of([1, 2, 3, 0]);
        if kind != 0 {
            let _ = writeln!(text, "<void property=\"type\"><int>{kind}</int></void>");
        }
        for (name, value) in [("x0", x0), ("x1", x1), ("y0", y0), ("y1", y1)] {
            if value != 0.0 {
                let _ = writeln!(text, "<void property=\"{name}\"><double>{value:?}</double></void>");
            }
        }
        text.push_str("</object></void>\n");
    });
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<java version=\"1.8\" class=\"java.beans.XMLDecoder\">\n\
         <object class=\"oripa.DataSet\"><void property=\"lines\"><array class=\"oripa.OriLineProxy\" length=\"{}\">\n\
         {lines}</array></void><void property=\"paperSize\"><double>400.0</double></void>\
         <void property=\"title\"><string>a title</string></void></object></java>\n",
        segments.len()
    )
}

pub(crate) fn ori(segments: &[Segment]) -> String {
    let lines = each(segments, |text, index, segment, [x1, y1, x2, y2]| {
        let comma = if index > 0 { "," } else { "" };
        let color = segment.of(["BLACK_0", "RED_1", "BLUE_2", "CYAN_3"]);
        let _ = write!(
            text,
            "{comma}{{\"a\":\"{x1:?},{y1:?}\",\"b\":\"{x2:?},{y2:?}\",\"color\":\"{color}\",\"selected\":0}}"
        );
    });
    format!("{{\"@version\":\"v1.1\",\"lineSegments\":[{lines}],\"circles\":[],\"title\":\"_\",\"points\":[]}}")
}

pub(crate) fn orh(segments: &[Segment]) -> String {
    let lines = each(segments, |text, index, segment, [x1, y1, x2, y2]| {
        let colour = segment.of([0, 1, 2, 3]);
        let _ = writeln!(text, "番号,{}\n色,{colour}\niactive,0\n選択,0\n座標,{x1:?},{y1:?},{x2:?},{y2:?}", index + 1);
    });
    format!("<タイトル>\nタイトル,_\n</タイトル>\n<線分集合>\n{lines}</線分集合>\n")
}

/// y is down in SVG.
pub(crate) fn svg(segments: &[Segment]) -> String {
    let lines = each(segments, |text, _, segment, [x1, y1, x2, y2]| {
        let colour = segment.of(["#000", "red", "blue", "yellow"]);
        let [y1, y2] = [-y1, -y2];
        let _ = writeln!(text, "<line x1=\"{x1:?}\" y1=\"{y1:?}\" x2=\"{x2:?}\" y2=\"{y2:?}\" stroke=\"{colour}\"/>");
    });
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\">\n{lines}</svg>\n")
}

pub(crate) fn obj(segments: &[Segment]) -> String {
    let (points, edges) = shared(segments.iter());
    let vertices: String = points.iter().map(|[x, y]| format!("v {x:?} {y:?} 0.0\n")).collect();
    let lines = segments.iter().zip(&edges).map(|(segment, [a, b])| {
        format!("usemtl {}\nl {} {}\n", segment.of(["border", "mountain", "valley", "flat"]), a + 1, b + 1)
    });
    format!("# a test\nmtllib none.mtl\n{vertices}{}", lines.collect::<String>())
}

pub(crate) fn dxf(segments: &[Segment]) -> String {
    let lines = each(segments, |text, _, segment, [x1, y1, x2, y2]| {
        let layer = segment.of(["CutLine", "MountainLine", "ValleyLine", "AuxiliaryLine"]);
        let _ = writeln!(text, "  0\nLINE\n  8\n{layer}\n  6\nCONTINUOUS\n 62\n{}", segment.of([250, 1, 5, 4]));
        let _ = writeln!(text, " 10\n{x1:?}\n 20\n{y1:?}\n 11\n{x2:?}\n 21\n{y2:?}");
    });
    format!("  0\nSECTION\n  2\nENTITIES\n{lines}  0\nENDSEC\n  0\nEOF\n")
}
