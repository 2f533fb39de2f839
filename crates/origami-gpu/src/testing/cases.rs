//! Sheets, and comparisons of what comes of them on a GPU with what the core computes.

use glam::{DQuat, DVec3};
use origami_core::forces::{creases, unwrapped};
use origami_core::generate::{BirdBase, Kresling, Miura};
use origami_core::ids::VertexId;
use origami_core::model::Softening;
use origami_core::pattern::{Assignment, CreasePattern, PatternEdge, fold_angle};
use origami_core::{Material, Model, State};

/// Half of the distance from 1 to the next f32: what one rounding loses.
pub(crate) const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;

/// Numbers in a fixed sequence without any order.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Evenly between two bounds.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        // A 64-bit linear congruential generator, of which the upper half is used.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 32) as f64 / (1_u64 << 32) as f64
    }

    /// Evenly in its logarithm.
    fn log(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    pub(crate) fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.between(-size, size)))
    }

    fn turn(&mut self) -> DQuat {
        let axis = self.vector(1.0).normalize_or(DVec3::X);
        DQuat::from_axis_angle(axis, self.between(-3.0, 3.0))
    }
}

/// A sheet in a state that f32 holds exactly as displacement from rest, so that both sides see the same.
#[derive(Clone)]
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) model: Model,
    pub(crate) state: State,
}

/// The kinds of hinges of which the heights and fold angles make trouble.
#[derive(Clone, Copy)]
struct Kind {
    name: &'static str,
    /// Heights of the triangles, in units of the crease.
    heights: [f64; 2],
    /// Fold angles, in degrees; one half of the hinges have their opposites.
    angles: [f64; 2],
}

const KINDS: [Kind; 3] = [
    Kind { name: "random hinges", heights: [0.2, 2.0], angles: [0.0, 150.0] },
    Kind { name: "nearly degenerate hinges", heights: [1e-4, 1e-2], angles: [0.0, 150.0] },
    Kind { name: "strongly folded hinges", heights: [0.05, 2.0], angles: [165.0, 200.0] },
];

/// Hinges of all kinds, and sheets of which every node has been moved.
pub(crate) fn cases() -> Vec<Case> {
    let hinges = KINDS.iter().map(|kind| hinges(*kind));
    let sheets = patterns().into_iter().map(|(name, model)| moved(name, model));
    hinges.chain(sheets).collect()
}

/// Two hundred hinges, each a sheet of its own within the same radius: rest angles small, moved to the angles of its kind
/// and turned as a whole.
fn hinges(kind: Kind) -> Case {
    let mut random = Random(kind.name.len() as u64);
    let mut pattern = CreasePattern::default();
    let mut now = Vec::new();
    let mut angles = Vec::new();
    for i in 0..200_u32 {
        let [low, high] = kind.heights;
        let heights = [random.log(low, high), random.log(low, high)];
        let feet = [random.between(-0.5, 1.5), random.between(-0.5, 1.5)];
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        let angle = sign * random.between(kind.angles[0], kind.angles[1]).to_radians();
        let rest = points(heights, feet, random.between(-0.3, 0.3));
        let stretched = points(heights.map(|h| h * random.between(0.8, 1.25)), feet, angle);
        let (turn, shift) = (random.turn(), random.vector(0.3));
        now.extend(stretched.map(|p| turn * p + shift));
        angles.push(angle);
        let vertex = |place: u32| VertexId(4 * i + place);
        pattern.vertices.extend(rest);
        pattern.faces.extend([[2, 3, 0], [3, 2, 1]].map(|face| face.map(vertex).to_vec()));
        pattern.edges.push(PatternEdge {
            vertices: [vertex(2), vertex(3)],
            assignment: Assignment::Valley,
            fold_angle: Some(random.between(-3.0, 3.0)),
            // Some have stiffnesses of their own.
            k_crease: (i % 3 == 0).then(|| random.log(0.1, 10.0)),
            ea: (i % 5 == 0).then(|| random.log(1.0, 100.0)),
            alias_of: None,
        });
    }
    pattern.alias_of = vec![None; pattern.vertices.len()];
    (pattern.vertices_in_file, pattern.edges_in_file) = (pattern.vertices.len(), pattern.edges.len());
    let model = Model::new(&pattern, &Material::paper()).expect("proper triangles");
    let positions = now.iter().map(|p| model.normalisation.to_model(*p)).collect();
    assert_eq!(model.creases.len(), angles.len(), "no hinge is too thin");
    Case { name: kind.name, state: state(&model, positions, &angles, &mut random), model }
}

fn points(heights: [f64; 2], feet: [f64; 2], angle: f64) -> [DVec3; 4] {
    let left = DQuat::from_rotation_x(angle) * DVec3::new(0.0, heights[0], 0.0) + DVec3::X * feet[0];
    [left, DVec3::new(feet[1], -heights[1], 0.0), DVec3::ZERO, DVec3::X]
}

/// Nodes moved at random by up to a tenth of the radius, and the sheet turned.
fn moved(name: &'static str, model: Model) -> Case {
    let mut random = Random(7);
    let turn = random.turn();
    let positions: Vec<DVec3> = model.rest.iter().map(|p| turn * (*p + random.vector(0.03))).collect();
    let none = vec![0.0; model.creases.len()];
    Case { name, state: state(&model, positions, &none, &mut random), model }
}

/// Rounded to what f32 holds; `near` tells whole turns apart. The angles before are up to a radian away.
fn state(model: &Model, positions: Vec<DVec3>, near: &[f64], random: &mut Random) -> State {
    let rounded = |v: DVec3| v.as_vec3().as_dvec3();
    let positions: Vec<DVec3> =
        positions.iter().zip(&model.rest).map(|(p, rest)| *rest + rounded(*p - *rest)).collect();
    let angle = |(crease, near): (&origami_core::model::Crease, &f64)| {
        let [p1, p2, p3, p4] = crease.nodes.map(|n| positions[n.index()]);
        f64::from((unwrapped(fold_angle(p1, p2, p3, p4), *near) + random.between(-1.0, 1.0)) as f32)
    };
    let fold_angles = model.creases.iter().zip(near).map(angle).collect();
    let targets = model.targets(60.0).iter().map(|target| f64::from(*target as f32)).collect();
    let velocities = positions.iter().map(|_| rounded(random.vector(0.5))).collect();
    State { positions, velocities, fold_angles, targets }
}

pub(crate) fn miura() -> Model {
    model(Miura { columns: 5, rows: 4, ..Miura::default() }.pattern().expect("a pattern"))
}

/// What trajectories are compared on: sheets of several kinds, one with cuts, one with fixed nodes, stiffnesses of its own
/// and creases that nothing drives.
pub(crate) fn patterns() -> Vec<(&'static str, Model)> {
    let mut fixed = Miura { columns: 4, rows: 4, ..Miura::default() }.pattern().expect("a pattern");
    fixed.fixed = vec![VertexId(0), VertexId(6)];
    for (i, edge) in fixed.edges.iter_mut().enumerate() {
        match i % 4 {
            0 => edge.k_crease = Some(2.0),
            1 => edge.ea = Some(35.0),
            2 => edge.fold_angle = None,
            _ => {}
        }
    }
    vec![
        ("miura", miura()),
        ("bird base", model(BirdBase::default().pattern().expect("a pattern"))),
        ("kresling", model(Kresling::default().pattern().expect("a pattern"))),
        ("cuts", model(with_cuts())),
        ("fixed vertices", model(fixed)),
    ]
}

fn model(pattern: CreasePattern) -> Model {
    Model::new(&pattern, &Material::paper()).expect("a model")
}

/// A square grid with two slits that nearly part it.
fn with_cuts() -> CreasePattern {
    let side = 5_usize;
    let mut edges = Vec::new();
    let mut letters = Vec::new();
    for row in 0..side {
        for column in 0..side {
            let here = side * row + column;
            let edge = |inside: bool, odd: bool| {
                if !inside {
                    "B"
                } else if odd {
                    "M"
                } else {
                    "V"
                }
            };
            if column + 1 < side {
                edges.push(format!("[{here},{}]", here + 1));
                let cut = row == 2 && (column == 1 || column == 2);
                letters.push(if cut { "C" } else { edge(row > 0 && row + 1 < side, (row + column) % 2 == 0) });
            }
            if row + 1 < side {
                edges.push(format!("[{here},{}]", here + side));
                letters.push(edge(column > 0 && column + 1 < side, column % 2 == 0));
            }
        }
    }
    let coordinates: Vec<String> = (0..side * side).map(|i| format!("[{},{}]", i % side, i / side)).collect();
    let text = format!(
        r#"{{"vertices_coords":[{}],"edges_vertices":[{}],"edges_assignment":["{}"]}}"#,
        coordinates.join(","),
        edges.join(","),
        letters.join("\",\"")
    );
    let document = origami_core::fold::Document::from_slice(text.as_bytes()).expect("a document");
    CreasePattern::from_document(&document, 0).expect("a pattern")
}

/// How far a vector between two nodes may be off for every rounding of 1: its part at rest, the part that moved and the sum
/// are rounded.
pub(crate) fn reach(case: &Case, [from, to]: [usize; 2]) -> f64 {
    let (rest, now) =
        (case.model.rest[to] - case.model.rest[from], case.state.positions[to] - case.state.positions[from]);
    rest.length() + (now - rest).length() + now.length()
}

/// A case whose plain forces are those of `case` where it is soft: softer beams and corner angles, and creases that are pulled
/// back from the wrong side.
pub(crate) fn softened(case: &Case, softening: Softening) -> Case {
    let mut soft = case.clone();
    soft.model.beams.iter_mut().for_each(|beam| beam.stiffness = softening.of_beam(&case.model, beam));
    soft.model.material.k_face *= softening.corner_angles;
    let angles = creases::fold_angles(&case.model, &case.state.positions, &case.state.fold_angles);
    for ((crease, target), angle) in soft.model.creases.iter_mut().zip(&mut soft.state.targets).zip(angles) {
        if angle * *target < 0.0 {
            *target /= 1.0 + softening.wrong_side;
            crease.stiffness *= 1.0 + softening.wrong_side;
        }
    }
    soft
}

/// The case with one node moved a little: what a comparison must find.
pub(crate) fn tampered(case: &Case) -> Case {
    let mut wrong = case.clone();
    wrong.state.positions[1] += DVec3::new(0.6e-3, 0.8e-3, 0.5e-3);
    wrong
}

/// Hinges of which the first has one apex on its end, and the second both ends in one place.
pub(crate) fn collapsed() -> Case {
    let mut case = hinges(KINDS[0]);
    for (moved, to) in [(0, 2), (4 + 3, 4 + 2)] {
        case.state.positions[moved] = case.state.positions[to];
    }
    case
}

/// The largest distance between two lists of points; what is no number is infinitely far.
pub(crate) fn farthest(a: &[DVec3], b: &[DVec3]) -> f64 {
    worst(a.iter().zip(b).map(|(p, q)| (p.distance(*q), 1.0)))
}

/// The largest of errors, each in units of its scale; infinite where one is no number.
pub(crate) fn worst(errors: impl Iterator<Item = (f64, f64)>) -> f64 {
    errors.map(|(error, scale)| error / scale).fold(0.0, |most, e| if e.is_nan() { f64::INFINITY } else { most.max(e) })
}

#[test]
fn comparisons_find_one_wrong_number() {
    let points = [DVec3::ZERO, DVec3::X, DVec3::Y];
    assert_eq!(farthest(&points, &points), 0.0);
    assert_eq!(farthest(&points, &[DVec3::ZERO, DVec3::X * 1.5, DVec3::Y]), 0.5);
    assert_eq!(farthest(&points, &[DVec3::ZERO, DVec3::NAN, DVec3::Y]), f64::INFINITY);
    assert_eq!(worst([(1.0, 1.0), (1.0, 0.1)].into_iter()), 10.0);
    assert_eq!(worst([(f64::NAN, 1.0), (1.0, 0.1)].into_iter()), f64::INFINITY);
}

#[test]
fn patterns_are_what_their_names_say() {
    let patterns = patterns();
    let model = |wanted: &str| &patterns.iter().find(|(name, _)| *name == wanted).expect("one of this name").1;
    assert!(model("cuts").node_count() > 25, "the cuts have two lips");
    let fixed = model("fixed vertices");
    assert_eq!(fixed.fixed.len(), 2);
    assert!(fixed.inventory.left_out.iter().any(|group| group.why == "their edges are undriven"));
    let own = |beam: &&origami_core::model::Beam| (beam.stiffness * beam.rest_length - 35.0).abs() < 1e-9;
    assert!(fixed.beams.iter().any(|beam| own(&beam)) && !fixed.beams.iter().all(|beam| own(&beam)));
    assert!(patterns.iter().all(|(_, model)| !model.corner_angles.is_empty()));
}
