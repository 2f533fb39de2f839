//! Curves against closed forms: concentric circles, whose rulings are their radii, and generated pleats.

use std::fmt::Write;

use origami_core::fold::Document;
use origami_core::generate::CurvedPleat;
use origami_core::measure::Strain;
use origami_core::{CreasePattern, Material, Model, Relax, Solver};

use crate::{Options, svg};

fn read(body: &str, tolerance: Option<f64>) -> Document {
    let options = Options { curve_tolerance: tolerance, ..Options::default() };
    svg::read(format!("<svg>{body}</svg>").as_bytes(), &options).unwrap_or_else(|error| panic!("{error}"))
}

/// The lines of a letter, by their ends.
fn lines(document: &Document, letter: &str) -> Vec<[glam::DVec2; 2]> {
    let frame = &document.key_frame;
    let at = |v: u32| frame.vertices_coords.as_ref().unwrap()[v as usize].position.truncate();
    let edges = frame.edges_vertices.as_ref().unwrap().iter().zip(frame.edges_assignment.as_ref().unwrap());
    edges.filter(|(_, own)| *own == letter).map(|(ends, _)| ends.map(at)).collect()
}

/// A ring pleated along two circles, its radii those of the generator's default.
fn ring() -> String {
    let mut body = String::new();
    for (radius, colour) in [(0.5, "black"), (0.75, "red"), (1.0, "blue"), (1.25, "black")] {
        write!(body, "<circle r='{radius}' cx='3' cy='2' stroke='{colour}'/>").unwrap();
    }
    body
}

#[test]
fn pieces_are_as_near_to_the_curve_as_asked() {
    for tolerance in [1e-2, 1e-3, 1e-4] {
        let document = read("<path d='M-1 0A1 1 0 0 0 1 0z' stroke='black'/>", Some(tolerance));
        let mut arc = lines(&document, "B");
        arc.retain(|ends| ends.iter().all(|end| (end.length() - 1.0).abs() < 1e-6));
        let off: Vec<f64> = arc.iter().map(|[a, b]| 1.0 - (0.5 * (*a + *b)).length()).collect();
        let most = off.iter().copied().fold(0.0, f64::max);
        assert!(most <= 1.01 * tolerance, "{most} with {tolerance}");
        // As many as chords of that sagitta, and a third more at most.
        let needed = std::f64::consts::PI / (2.0 * (1.0 - tolerance).acos());
        assert!((arc.len() as f64) < 1.34 * needed + 2.0, "{} in place of {needed}", arc.len());
    }
}

/// The surface between concentric circles is a cone wherever it is folded: rulings are radii.
#[test]
fn rulings_of_concentric_circles_are_radii() {
    let document = read(&ring(), None);
    let center = glam::DVec2::new(3.0, -2.0);
    let around: Vec<glam::DVec2> = lines(&document, "M").iter().map(|ends| ends[0]).collect();
    let mut rulings = lines(&document, "F");
    // A bridge is a ruling too, and both are there.
    let order = |ends: &[glam::DVec2; 2]| ends.map(|at| at.to_array().map(f64::to_bits));
    rulings.iter_mut().for_each(|ends| ends.sort_by(|a, b| a.length().total_cmp(&b.length())));
    rulings.sort_by_key(order);
    rulings.dedup();
    let is_radius = |[a, b]: &[glam::DVec2; 2]| {
        let along = (*b - *a).normalize();
        along.perp_dot((0.5 * (*a + *b) - center).normalize()).abs() < 0.025
    };
    let radii = rulings.iter().filter(|line| is_radius(line)).count();
    // Three strips, each with a radius at each point, and a diagonal between two radii.
    assert!(radii as f64 >= 0.95 * 3.0 * around.len() as f64, "{radii} of {} lines", rulings.len());
    assert_eq!(rulings.len(), 6 * around.len());
}

fn fold(pattern: &CreasePattern, percent: f64) -> (f64, f64) {
    let model = Model::new(pattern, &Material::default()).unwrap();
    let folded = Relax::default().fold_from_rest(&model, percent).unwrap();
    assert!(folded.converged());
    let energy = folded.state.energy(&model);
    (energy.beams + energy.creases + energy.corner_angles, Strain::of(&model, &folded.state.positions).beams.mean)
}

/// The same ring, drawn and generated. The generated one has all its diagonals on one hand, and is a little stiffer for it.
#[test]
fn a_drawn_pleat_folds_as_the_generated_one() {
    let drawn = CreasePattern::from_document(&read(&ring(), None), 0).unwrap();
    let segments = drawn.edges.iter().filter(|edge| edge.assignment.letter() == "M").count();
    let made = CurvedPleat { creases: 2, segments, angle: std::f64::consts::PI, ..CurvedPleat::default() };
    let (own, generated) = (fold(&drawn, 30.0), fold(&made.pattern().unwrap(), 30.0));
    assert!((0.85..1.02).contains(&(own.0 / generated.0)), "energy {} and {}", own.0, generated.0);
    assert!((0.8..1.05).contains(&(own.1 / generated.1)), "strain {} and {}", own.1, generated.1);
}

/// Without rulings, on the same points.
fn without_rulings(document: &Document) -> Document {
    let mut bare = document.clone();
    let frame = &mut bare.key_frame;
    let keep: Vec<bool> = frame.edges_assignment.iter().flatten().map(|letter| letter != "F").collect();
    fn only<T>(all: &mut Option<Vec<T>>, keep: &[bool]) {
        let mut keep = keep.iter();
        all.iter_mut().for_each(|all| all.retain(|_| *keep.next().unwrap()));
    }
    only(&mut frame.edges_vertices, &keep);
    only(&mut frame.edges_assignment, &keep);
    frame.extra.clear();
    bare
}

/// A tower of waves: with rulings the sheet is bent less than with the triangles that a mesh would have.
#[test]
fn rulings_lower_the_energy() {
    let mut body = "<rect width='10' height='10' stroke='black'/>".to_owned();
    for (x, colour) in [(2, "red"), (4, "blue"), (6, "red"), (8, "blue")] {
        write!(body, "<path d='M{x} 0c-1.5 2 -1.5 4 0 5s1.5 3 0 5' stroke='{colour}'/>").unwrap();
    }
    let with = read(&body, Some(0.02));
    let without = without_rulings(&with);
    let [with, without] =
        [with, without].map(|document| fold(&CreasePattern::from_document(&document, 0).unwrap(), 40.0));
    assert!(with.0 < 0.97 * without.0, "energy {} and {}", with.0, without.0);
}

#[test]
fn ends_near_a_curve_meet_it() {
    // A line that ends 0.002 before a circle of radius 1, and one that crosses it.
    let body = "<circle r='1' stroke='black'/><path d='M0 0.1V0.998M-2 0.1H2' stroke='red'/>";
    let pattern = CreasePattern::from_document(&read(body, Some(0.005)), 0).unwrap();
    let inside = pattern.vertices.iter().filter(|at| at.truncate().length() < 0.9).count();
    assert_eq!(pattern.faces.iter().filter(|face| face.len() > 3).count(), 0, "all is cut");
    assert!(inside >= 2);
    let end = glam::DVec2::new(0.0, -0.998);
    let meets = pattern.edges.iter().filter(|edge| {
        edge.alias_of.is_none() && edge.vertices.iter().any(|v| pattern.vertices[v.index()].truncate() == end)
    });
    assert!(meets.count() >= 3, "the end is a point of the circle");
}

#[test]
fn straight_lines_in_pieces_are_one() {
    let body = "<rect width='4' height='4' stroke='black'/><path d='M0 1h2h2M4 2h-1m1 0' stroke='red'/>\
                <line x1='0' y1='2' x2='3' y2='2' stroke='red'/><path d='M0 3h2' stroke='blue'/><path d='M4 3h-2' stroke='red'/>";
    let document = read(body, None);
    assert_eq!(lines(&document, "M").len(), 3, "two whole ones, and one that goes on as a valley");
    assert_eq!(lines(&document, "V").len(), 1);
    let polygon: String = (0..=200).map(|i| f64::from(i) * 0.01).map(|t| format!("{},{} ", t.cos(), t.sin())).collect();
    let curve = read(&format!("<polyline points='{polygon}' stroke='red'/>"), None);
    assert_eq!(lines(&curve, "M").len(), 200, "points of a curve stay");
}

#[test]
fn odd_curves_do_no_harm() {
    for path in [
        "M0 0C0 0 0 0 0 0",
        "M0 0C1 1 -1 1 0 0z",
        "M0 0C1e9 1 1e-9 2 3 3",
        "M0 0Q1 0 2 0T4 0",
        "M0 0C9 9 -9 9 0 0C-9 -9 9 -9 0 0",
        "M0 0A1 1 0 1 1 1e-9 0A1 1 0 1 1 0 0",
        "M0 0C1 0 2 0 3 0M0 0C1 0 2 0 3 0",
        "M1e300 0C0 1e300 0 0 5 5",
        "M0 0C0 1e-300 1e-300 0 1e-300 1e-300",
        "M0 0C1 2 3 4 5 6z",
        "M0 0C0 3 3 3 3 0C3 3 0 3 0 0",
    ] {
        let text = format!("<svg><path d='{path}' stroke='red'/><circle r='2' stroke='black'/></svg>");
        if let Ok(document) = svg::read(text.as_bytes(), &Options::default()) {
            let _ = CreasePattern::from_document(&document, 0);
        }
    }
    let zero = Options { curve_tolerance: Some(0.0), ..Options::default() };
    let error = svg::read(b"<svg><circle r='1' stroke='red'/></svg>", &zero).unwrap_err().to_string();
    assert_eq!(error, "curve-tolerance: is 0; expected a length above 0");
    let fine = Options { curve_tolerance: Some(1e-300), ..Options::default() };
    let many = "<circle r='1' stroke='red'/>".repeat(2000);
    let error = svg::read(format!("<svg>{many}</svg>").as_bytes(), &fine).unwrap_err().to_string();
    assert!(error.contains("pieces of the curves"), "{error}");
}
