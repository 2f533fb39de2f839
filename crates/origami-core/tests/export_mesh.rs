//! OBJ and STL.

use glam::{DVec3, Vec3};
use origami_core::CreasePattern;
use origami_core::export::{write_obj, write_stl};
use origami_core::ids::VertexId;

/// A quad and a triangle, twice as long as high, off the origin.
fn sheet() -> CreasePattern {
    let places = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0], [3.0, 1.5], [2.0, 1.0]];
    CreasePattern {
        vertices: places.map(|[x, y]| DVec3::new(x, y, -1.0)).to_vec(),
        alias_of: [None, None, None, None, None, Some(VertexId(1))].to_vec(),
        faces: vec![[0, 1, 2, 3].map(VertexId).to_vec(), [1, 4, 2].map(VertexId).to_vec()],
        ..CreasePattern::default()
    }
}

fn folded() -> Vec<DVec3> {
    sheet().vertices.iter().map(|p| DVec3::new(p.x, 0.1, p.y * 1e-7)).collect()
}

/// The numbers behind each line that starts with `keyword`.
fn numbers(text: &str, keyword: &str) -> Vec<Vec<f64>> {
    let lines = text.lines().filter_map(|line| line.strip_prefix(keyword)?.strip_prefix(' '));
    lines.map(|line| line.split(' ').map(|word| word.parse().expect("a number")).collect()).collect()
}

#[test]
fn obj_keeps_vertices_and_faces() {
    let mut bytes = Vec::new();
    write_obj(&mut bytes, &sheet(), &folded()).expect("written");
    let text = String::from_utf8(bytes).expect("text");
    let mut expected: Vec<_> = folded().iter().map(|p| p.to_array().to_vec()).collect();
    expected[5] = expected[1].clone();
    assert_eq!(numbers(&text, "v"), expected);
    let faces: Vec<_> = text.lines().filter(|line| line.starts_with('f')).collect();
    assert_eq!(faces, ["f 1/1 2/2 3/3 4/4", "f 2/2 5/5 3/3"]);

    // Texture: within the unit square, touching it, and similar to the sheet.
    let texture = numbers(&text, "vt");
    assert_eq!(texture[0], [0.0, 0.0]);
    assert_eq!(texture[4], [1.0, 0.25]);
    assert_eq!(texture.len(), 6);
    assert!(texture.iter().flatten().all(|number| (0.0..=1.0).contains(number)));
    for (a, b) in [(0, 1), (1, 2), (0, 2), (2, 4)] {
        let side = |u: &[f64], v: &[f64]| (u[0] - v[0]).hypot(u[1] - v[1]);
        let rest = sheet().vertices[a].distance(sheet().vertices[b]);
        assert!((side(&texture[a], &texture[b]) - rest / 2.0).abs() < 1e-15);
    }
}

#[test]
fn obj_of_a_sheet_that_is_not_flat_has_no_texture() {
    let mut pattern = sheet();
    pattern.vertices[0].z = 0.0;
    let mut bytes = Vec::new();
    write_obj(&mut bytes, &pattern, &folded()).expect("written");
    let text = String::from_utf8(bytes).expect("text");
    assert!(numbers(&text, "vt").is_empty());
    assert_eq!(numbers(&text, "f"), [vec![1.0, 2.0, 3.0, 4.0], vec![2.0, 5.0, 3.0]]);
}

#[test]
fn obj_refuses_what_does_not_fit() {
    let mut positions = folded();
    positions[2].y = f64::NAN;
    let error = write_obj(Vec::new(), &sheet(), &positions).expect_err("NaN").to_string();
    assert!(error.starts_with("vertex 2: "), "{error}");
    let error = write_obj(Vec::new(), &sheet(), &positions[..2]).expect_err("too few").to_string();
    assert!(error.contains("2 positions for 6 vertices"), "{error}");
}

#[test]
fn stl_holds_each_triangle_with_its_normal() {
    let positions = [DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 3.0, DVec3::new(0.5, 0.25, 4.0)];
    let triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2], [0, 0, 1]];
    let mut bytes = Vec::new();
    assert_eq!(write_stl(&mut bytes, &positions, &triangles).expect("written"), None, "it lies near the origin");
    assert_eq!(bytes.len(), 84 + 50 * triangles.len());
    assert!(!bytes.starts_with(b"solid"));
    assert_eq!(bytes[80..84], 5u32.to_le_bytes());

    let mut volume = 0.0;
    for (record, triangle) in bytes[84..].chunks(50).zip(triangles) {
        let number = |i: usize| f32::from_le_bytes(record[4 * i..4 * i + 4].try_into().expect("four bytes"));
        let [normal, a, b, c] = [0, 3, 6, 9].map(|i| Vec3::new(number(i), number(i + 1), number(i + 2)));
        assert_eq!([a, b, c], triangle.map(|corner| positions[corner as usize].as_vec3()));
        assert_eq!(record[48..], [0, 0]);
        if triangle == [0, 0, 1] {
            assert_eq!(normal, Vec3::ZERO);
        } else {
            assert!((normal.length() - 1.0).abs() < 1e-6);
            assert!(normal.dot(b - a).abs() < 1e-6 && normal.dot(c - a).abs() < 1e-5);
            assert!(normal.dot((b - a).cross(c - a)) > 0.0);
        }
        volume += a.dot(b.cross(c)) / 6.0;
    }
    // Corners keep their order: the tetrahedron is not turned inside out.
    assert!((volume - 4.0).abs() < 1e-5, "volume {volume}");
}

#[test]
fn stl_refuses_what_it_cannot_hold() {
    let error = write_stl(Vec::new(), &[DVec3::ZERO], &[[0, 0, 0], [0, 1, 0]]).expect_err("index").to_string();
    assert!(error.starts_with("triangle 1: corner 1 of 1"), "{error}");
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        assert!(write_stl(Vec::new(), &[DVec3::ZERO, DVec3::X * bad], &[[0, 1, 0]]).is_err(), "{bad}");
    }
    // Positions that no triangle uses do not matter.
    assert!(write_stl(Vec::new(), &[DVec3::ZERO, DVec3::NAN], &[[0, 0, 0]]).is_ok());
}

/// The area of all triangles, as read.
fn area(stl: &[u8]) -> f64 {
    let number = |bytes: &[u8]| f64::from(f32::from_le_bytes(bytes.try_into().expect("four bytes")));
    let area = |triangle: &[u8]| {
        let numbers: Vec<f64> = triangle[12..48].chunks(4).map(number).collect();
        let [a, b, c] = [0, 3, 6].map(|i| DVec3::from_slice(&numbers[i..]));
        0.5 * (b - a).cross(c - a).length()
    };
    stl[84..].chunks(50).map(area).sum()
}

#[test]
fn stl_of_a_sheet_far_from_the_origin_is_moved_there_and_says_so() {
    let corners = [DVec3::ZERO, DVec3::X * 2.0, DVec3::new(2.0, 1.0, 0.0), DVec3::Y];
    for far in [0.0, 150.0, 250.0, 1e6, 1e9] {
        let offset = DVec3::new(far, far, 0.0);
        let mut bytes = Vec::new();
        let moved = write_stl(&mut bytes, &corners.map(|p| p + offset), &[[0, 1, 2], [0, 2, 3]]).expect("written");
        assert_eq!(moved, (far > 200.0).then(|| -offset - DVec3::new(1.0, 0.5, 0.0)), "{far}");
        assert!((area(&bytes) - 2.0).abs() < 1e-4, "{far}: {}", area(&bytes));
    }
    let small = corners.map(|p| p * 1e-30);
    let error = write_stl(Vec::new(), &small, &[[0, 1, 2]]).expect_err("nothing is left of it").to_string();
    assert!(error.contains("the sheet is 2e-30 large; expected at least 1e-18"), "{error}");
}
