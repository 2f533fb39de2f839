//! What the camera promises.

use super::*;

fn points() -> Vec<[f32; 3]> {
    (0..60).map(|i| i as f32).map(|i| [(2.1 * i).sin(), (1.3 * i).cos() * 0.7, (0.7 * i).sin() * 0.4 + 3.0]).collect()
}

/// Clip coordinates over w.
fn project(view: &View, p: [f32; 3]) -> [f64; 3] {
    let row = |r: usize| {
        (0..3).map(|c| f64::from(view.matrix[c][r]) * f64::from(p[c])).sum::<f64>() + f64::from(view.matrix[3][r])
    };
    [0, 1, 2].map(|r| row(r) / row(3))
}

#[test]
fn everything_fills_the_frame_from_everywhere() {
    let frame = Frame { width: 300, height: 200, margins: [10.0, 20.0, 60.0, 4.0] };
    for projection in [Projection::Orthographic, Projection::Perspective(30.0), Projection::Perspective(100.0)] {
        for (azimuth, elevation, roll) in [(0.0, 0.0, 0.0), (-60.0, 35.0, 0.0), (200.0, -80.0, 33.0), (0.0, 90.0, 0.0)]
        {
            let camera = Camera { azimuth, elevation, roll, projection, ..Camera::default() };
            let view = camera.view(points().into_iter(), &frame).unwrap();
            let seen: Vec<[f64; 3]> = points().into_iter().map(|p| project(&view, p)).collect();
            let pixels = |p: &[f64; 3]| [(p[0] + 1.0) * 150.0, (1.0 - p[1]) * 100.0];
            let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
            for p in &seen {
                assert!(p[2] > 0.0 && p[2] < 1.0, "depth {}", p[2]);
                for (axis, x) in pixels(p).into_iter().enumerate() {
                    low[axis] = low[axis].min(x);
                    high[axis] = high[axis].max(x);
                }
            }
            assert!(low[0] > 9.9 && high[0] < 240.1 && low[1] > 19.9 && high[1] < 196.1, "{low:?} {high:?}");
            let filled = ((high[0] - low[0]) / 230.0).max((high[1] - low[1]) / 176.0);
            // A wide angle would have the eye between the points.
            let least = if projection == Projection::Perspective(100.0) { 0.7 } else { 0.99 };
            assert!(filled > least, "{camera:?}: {filled}");
        }
    }
}

#[test]
fn directions_are_what_their_names_say() {
    let frame = Frame { width: 200, height: 200, margins: [0.0; 4] };
    let cube = || (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 }));
    let top = Camera::top().view(cube(), &frame).unwrap();
    let [x, y, _] = project(&top, [1.0, 0.5, 0.0]);
    assert!((x - 1.0).abs() < 1e-6 && (y - 0.5).abs() < 1e-6, "{x} {y}");
    assert!(project(&top, [0.0, 0.0, 1.0])[2] < project(&top, [0.0, 0.0, -1.0])[2], "up is near");
    let front = Camera::front().view(cube(), &frame).unwrap();
    let [x, y, _] = project(&front, [1.0, 0.0, 0.5]);
    assert!((x - 1.0).abs() < 1e-6 && (y - 0.5).abs() < 1e-6, "{x} {y}");
    let isometric = Camera::isometric().view(cube(), &frame).unwrap();
    let origin = project(&isometric, [0.0; 3]);
    let length = |p: [f32; 3]| {
        let [x, y, _] = project(&isometric, p);
        (x - origin[0]).hypot(y - origin[1])
    };
    let lengths = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(length);
    assert!((lengths[0] - lengths[1]).abs() < 1e-6 && (lengths[0] - lengths[2]).abs() < 1e-6, "{lengths:?}");
    let turned = Camera { roll: 90.0, ..Camera::top() }.view(cube(), &frame).unwrap();
    let [x, y, _] = project(&turned, [1.0, 0.0, 0.0]);
    assert!(x.abs() < 1e-6 && (y - 1.0).abs() < 1e-6, "the x axis has turned counterclockwise: {x} {y}");
}

#[test]
fn a_turntable_neither_grows_nor_sways_and_shows_everything() {
    let frame = Frame { width: 300, height: 200, margins: [10.0; 4] };
    let swept = swept(points().into_iter());
    let at = |azimuth| Camera { azimuth, ..Camera::default() }.view(swept.iter().copied(), &frame).unwrap();
    for azimuth in [0.0, 17.0, 45.0, 200.0] {
        assert!((at(azimuth).pixel / at(90.0).pixel - 1.0).abs() < 5e-3, "{azimuth}");
        for p in points() {
            let [x, y, z] = project(&at(azimuth), p);
            assert!(x.abs() < 1.0 && y.abs() < 1.0 && z > 0.0 && z < 1.0, "{azimuth} {p:?}");
        }
    }
}

#[test]
fn a_pixel_is_as_long_and_as_deep_as_said() {
    let frame = Frame { width: 400, height: 400, margins: [0.0; 4] };
    let cube = || (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 }));
    for projection in [Projection::Orthographic, Projection::Perspective(40.0)] {
        let view = Camera { projection, ..Camera::top() }.view(cube(), &frame).unwrap();
        let middle = project(&view, [0.0; 3]);
        let [x, ..] = project(&view, [view.pixel, 0.0, 0.0]);
        assert!(((x - middle[0]) * 200.0 - 1.0).abs() < 1e-3);
        let [.., z] = project(&view, [0.0, 0.0, 10.0 * view.pixel]);
        assert!(((middle[2] - z) / (10.0 * f64::from(view.depth)) - 1.0).abs() < 0.05, "{projection:?}");
    }
}

#[test]
fn strange_cameras_and_frames_are_refused() {
    let frame = Frame { width: 100, height: 100, margins: [0.0; 4] };
    let refused = |camera: Camera, frame: Frame| camera.view(points().into_iter(), &frame).is_err();
    assert!(refused(Camera { azimuth: f64::NAN, ..Camera::default() }, frame));
    assert!(refused(Camera { zoom: 0.0, ..Camera::default() }, frame));
    assert!(refused(Camera { projection: Projection::Perspective(180.0), ..Camera::default() }, frame));
    assert!(refused(Camera::default(), Frame { margins: [50.0; 4], ..frame }));
    // A point and nothing at all are seen all the same.
    for points in [vec![[1.0; 3]], vec![]] {
        let view = Camera::default().view(points.into_iter(), &frame).unwrap();
        assert!(view.matrix.iter().flatten().all(|x| x.is_finite()));
    }
}
