//! Faulty files, one fault each, and what is right: what is read, what is said, and the folded sheet.

use std::path::Path;

use origami_core::error::{Warning, WarningCode};
use origami_core::fold::Document;
use origami_core::glam::DVec3;
use origami_core::measure::{Strain, edge_fold_angles};
use origami_core::model::{Material, Model};
use origami_core::solve::{Relax, Solver};
use origami_core::{CreasePattern, Error};

/// What a file must come to.
struct Right {
    file: &'static str,
    faces: usize,
    pieces: usize,
    /// Ends of a crease, and the angle between its two faces at 100 %, in degrees.
    crease: ([u32; 2], f64),
    /// The greatest distance between two of its vertices once folded: the diagonal of its box, or of a face.
    across: f64,
    /// What is said of the fault: its kind, and words of the message or its place.
    says: (WarningCode, &'static [&'static str]),
}

const RIGHT: [Right; 12] = [
    Right {
        file: "open_border",
        faces: 2,
        pieces: 1,
        crease: ([5, 6], 180.0),
        across: 4.472135955,
        says: (WarningCode::BorderJoined, &["vertices_coords[2]", "vertices_coords[1]", "4"]),
    },
    Right {
        file: "gap_1e-05",
        faces: 2,
        pieces: 1,
        crease: ([4, 5], 180.0),
        across: 4.472135955,
        says: (WarningCode::NearMissJoined, &["vertices_coords[4]", "edges_vertices[0]", "0.00001"]),
    },
    Right {
        file: "short_crease",
        faces: 2,
        pieces: 1,
        crease: ([4, 5], 180.0),
        across: 4.472135955,
        says: (WarningCode::NearMissJoined, &["vertices_coords[5]", "edges_vertices[2]", "0.0001"]),
    },
    Right {
        file: "crease_across_given_face_nov",
        faces: 2,
        pieces: 1,
        crease: ([4, 5], 90.0),
        across: 3.464101615,
        says: (
            WarningCode::FacesRepaired,
            &["faces_vertices[0]", "contradicts the lines; the faces were found anew from the lines: 2"],
        ),
    },
    Right {
        file: "spur_on_border_refused",
        faces: 2,
        pieces: 1,
        crease: ([1, 4], 90.0),
        across: 3.464101615,
        says: (WarningCode::FacesRepaired, &["faces_vertices[0]"]),
    },
    Right {
        file: "tjunction",
        faces: 3,
        pieces: 1,
        crease: ([1, 7], 90.0),
        across: 3.464101615,
        says: (WarningCode::FacesRepaired, &["faces_vertices[0]"]),
    },
    Right {
        file: "unwelded",
        faces: 2,
        pieces: 1,
        crease: ([1, 2], 90.0),
        across: 3.464101615,
        says: (WarningCode::VerticesMerged, &["vertices_coords[4]"]),
    },
    Right {
        file: "outer_face",
        faces: 2,
        pieces: 1,
        crease: ([1, 4], 90.0),
        across: 3.464101615,
        says: (WarningCode::FacesRepaired, &["faces_vertices[2]", "the outside of the sheet?"]),
    },
    Right {
        file: "radians",
        faces: 2,
        pieces: 1,
        crease: ([1, 4], std::f64::consts::FRAC_PI_2),
        across: 2.2359,
        says: (WarningCode::Radians, &["edges_foldAngle", "3.15", "radians?"]),
    },
    Right {
        file: "folded_first_cp_second",
        faces: 2,
        pieces: 1,
        crease: ([1, 4], 90.0),
        across: 3.464101615,
        says: (WarningCode::OtherFrame, &["frame 0", "foldedForm", "frame 1 is a creasePattern"]),
    },
    Right {
        file: "typo_assignments",
        faces: 2,
        pieces: 1,
        crease: ([1, 4], 0.0),
        across: 4.472135955,
        says: (WarningCode::UnknownKey, &["edges_assignments", "edges_assignment meant"]),
    },
    Right {
        file: "yzplane_nf",
        faces: 2,
        pieces: 1,
        crease: ([1, 4], 90.0),
        across: 1.732050808,
        says: (WarningCode::FacesBuilt, &["faces_vertices"]),
    },
];

fn read(file: &str) -> Result<CreasePattern, Error> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases").join(file).with_extension("fold");
    // The name of one has a dot.
    let path = if path.exists() { path } else { path.with_file_name(format!("{file}.fold")) };
    let document = Document::read(&path)?;
    CreasePattern::from_document(&document, document.pattern_frame()?)
}

fn has(pattern: &CreasePattern, code: WarningCode, words: &[&str]) -> bool {
    let says = |warning: &Warning| words.iter().all(|word| warning.to_string().contains(word));
    pattern.warnings.iter().any(|warning| warning.code == code && says(warning))
}

/// The greatest distance between two points.
fn across(points: &[DVec3]) -> f64 {
    points.iter().flat_map(|a| points.iter().map(move |b| a.distance(*b))).fold(0.0, f64::max)
}

#[test]
fn faults_come_right() {
    for right in RIGHT {
        let file = right.file;
        let pattern = read(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        pattern.sanity_check().unwrap_or_else(|broken| panic!("{file}: {broken}"));
        assert_eq!(pattern.faces.len(), right.faces, "{file}: {:#?}", pattern.warnings);
        let paper = pattern.paper();
        assert_eq!((paper.pieces, paper.lost), (right.pieces, 0.0), "{file}");
        let (code, words) = right.says;
        assert!(has(&pattern, code, words), "{file}: no {code} of {words:?} in {:#?}", pattern.warnings);

        let model = Model::new(&pattern, &Material::default()).unwrap_or_else(|error| panic!("{file}: {error}"));
        let folded = Relax::default().fold_from_rest(&model, 100.0).expect("it folds");
        assert!(folded.converged(), "{file}");
        let strain = Strain::of(&model, &folded.state.positions).beams.max;
        assert!(strain < 1e-5, "{file}: strain {strain}");
        let (ends, degrees) = right.crease;
        let alias = |v: u32| pattern.alias_of[v as usize].map_or(v, |v| v.0);
        let wanted = ends.map(alias);
        let edge = pattern.edges.iter().position(|edge| {
            let [a, b] = edge.vertices.map(|v| v.0);
            edge.alias_of.is_none() && ([a, b] == wanted || [b, a] == wanted)
        });
        let edge = edge.unwrap_or_else(|| panic!("{file}: no edge {wanted:?}"));
        let angle = edge_fold_angles(&model, &pattern, &folded.state)[edge];
        let angle = angle.unwrap_or_else(|| panic!("{file}: edge {edge} is a border")).to_degrees();
        assert!((angle - degrees).abs() < 0.01, "{file}: {angle} in place of {degrees} degrees");
        let positions = model.file_positions(&pattern, &folded.state.positions);
        let far = across(&positions);
        assert!((far - right.across).abs() < 2e-3, "{file}: {far} across in place of {}", right.across);
    }
}

#[test]
fn a_sheet_in_a_frame_is_told_of() {
    let pattern = read("frame_around").expect("a frame");
    assert!(has(&pattern, WarningCode::CreaseInHole, &["edges_vertices[8]", "hole"]), "{:#?}", pattern.warnings);
}

#[test]
fn a_bent_quadrilateral_lies_in_no_plane() {
    let pattern = read("hypar_quad").expect("a face");
    assert!(pattern.warnings.iter().all(|warning| warning.code != WarningCode::TiltedPlane), "{:#?}", pattern.warnings);
}
