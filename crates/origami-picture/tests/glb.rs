//! Reads the glTF files that we write with another reader.

use origami_core::generate::catalog;
use origami_core::glam::DVec3;
use origami_core::model::Normalisation;
use origami_core::solve::{fold_path, frame_percents};
use origami_core::{Material, Model, Relax};
use origami_picture::{ColourMap, Figure, Glb, LineSet, Map, Quantity};

struct Folded {
    figure: Figure,
    states: Vec<Vec<[f32; 3]>>,
}

fn folded(frames: u32) -> Folded {
    let pattern = catalog::generate("miura", &[]).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let path = fold_path(&model, &Relax::default(), &frame_percents(60.0, frames), &mut |_, _| {
        std::ops::ControlFlow::Continue(())
    })
    .expect("states");
    let states = path.iter().map(|f| f.state.positions.iter().map(|p| p.to_array().map(|x| x as f32)).collect());
    let last = &path.last().expect("the first").state;
    let map = Map::new(Quantity::Strain, &model, last, ColourMap::Viridis, None);
    Folded { figure: Figure::new(&pattern, &model, &last.positions).with_map(map), states: states.collect() }
}

/// The positions that a viewer shows for these weights of the targets.
fn shown(primitive: &gltf::Primitive<'_>, blob: &[u8], weights: &[f32]) -> Vec<[f32; 3]> {
    let data = |_: gltf::Buffer<'_>| Some(blob);
    let reader = primitive.reader(data);
    let mut places: Vec<[f32; 3]> = reader.read_positions().expect("positions").collect();
    for ((moved, ..), weight) in reader.read_morph_targets().zip(weights) {
        for (place, by) in places.iter_mut().zip(moved.expect("moved positions")) {
            (0..3).for_each(|axis| place[axis] += weight * by[axis]);
        }
    }
    places
}

#[test]
fn another_reader_sees_the_sheet_fold() {
    let Folded { figure, states } = folded(3);
    let mut bytes = Vec::new();
    Glb::default().write(&figure, &states, &mut bytes).unwrap();
    // The reader validates the document.
    let file = gltf::Gltf::from_slice(&bytes).unwrap();
    let blob = file.blob.as_deref().unwrap();
    let mesh = file.meshes().next().unwrap();
    let [faces, lines] = &mesh.primitives().collect::<Vec<_>>()[..] else { panic!("faces and lines") };
    assert!(faces.material().double_sided());
    assert_eq!(lines.mode(), gltf::mesh::Mode::Lines);
    assert_eq!(mesh.weights().unwrap().len(), 3);
    // At the last key frame, and so in the file's y-up world, the sheet lies where the last state has it.
    let animation = file.animations().next().unwrap();
    let channel = animation.channels().next().unwrap();
    let reader = channel.reader(|_| Some(blob));
    let times: Vec<f32> = reader.read_inputs().unwrap().collect();
    assert_eq!((times.len(), times[0], times[3]), (4, 0.0, 4.0));
    let Some(gltf::animation::util::ReadOutputs::MorphTargetWeights(weights)) = reader.read_outputs() else {
        panic!("weights")
    };
    let weights: Vec<f32> = weights.into_f32().collect();
    for (state, weights) in states.iter().zip(weights.chunks(3)) {
        for (shown, node) in shown(faces, blob, weights).iter().zip(figure.triangles.iter().flatten()) {
            let [x, y, z] = state[*node as usize];
            let far = [shown[0] - x, shown[1] - z, shown[2] + y];
            assert!(far.iter().all(|d| d.abs() < 1e-6), "{shown:?} {:?}", state[*node as usize]);
        }
    }
}

#[test]
fn accessors_are_aligned_and_their_bounds_hold() {
    let Folded { figure, states } = folded(2);
    let mut bytes = Vec::new();
    Glb { edges: LineSet::ALL, ..Glb::default() }.write(&figure, &states, &mut bytes).unwrap();
    assert_eq!(bytes.len() % 4, 0);
    assert_eq!(u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize, bytes.len());
    let file = gltf::Gltf::from_slice(&bytes).unwrap();
    let blob = file.blob.as_deref().unwrap();
    for accessor in file.accessors() {
        let view = accessor.view().unwrap();
        assert_eq!(view.offset() % 4, 0);
        assert!(accessor.count() * accessor.size() <= view.length() && view.offset() + view.length() <= blob.len());
    }
    for primitive in file.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>()) {
        let bounds = primitive.bounding_box();
        let places = shown(&primitive, blob, &[]);
        for axis in 0..3 {
            let low = places.iter().map(|p| p[axis]).fold(f32::INFINITY, f32::min);
            let high = places.iter().map(|p| p[axis]).fold(f32::NEG_INFINITY, f32::max);
            assert_eq!((low, high), (bounds.min[axis], bounds.max[axis]));
        }
        let reader = primitive.reader(|_| Some(blob));
        for normal in reader.read_normals().into_iter().flatten() {
            assert!((normal.iter().map(|x| x * x).sum::<f32>() - 1.0).abs() < 1e-5);
        }
        assert!(reader.read_colors(0).is_some());
    }
}

/// A sheet of 10 by 20 far off: the reader finds it where the file had it, and a picture lies on its front unmirrored.
#[test]
fn lengths_are_the_file_s_and_pictures_lie_on_the_paper() {
    let mut pattern = catalog::generate("single-crease", &[]).expect("a pattern");
    let size = pattern.size();
    let low = pattern.vertices.iter().copied().reduce(DVec3::min).expect("vertices");
    let high = pattern.vertices.iter().copied().reduce(DVec3::max).expect("vertices");
    let offset = DVec3::new(3e6, -7e6, 2.0);
    pattern.vertices.iter_mut().for_each(|p| *p = (*p - low) * (20.0 / size) + offset);
    let extent = (high - low) * (20.0 / size);
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let mut bytes = Vec::new();
    Glb::of(&model).write(&Figure::new(&pattern, &model, &model.rest), &[], &mut bytes).expect("written");
    let file = gltf::Gltf::from_slice(&bytes).expect("valid");
    let blob = file.blob.as_deref().expect("bytes");
    let node = file.nodes().next().expect("a node");
    let (translation, ..) = node.transform().decomposed();
    let faces = node.mesh().expect("a mesh").primitives().next().expect("faces");
    let reader = faces.reader(|_| Some(blob));
    let texture: Vec<[f32; 2]> = reader.read_tex_coords(0).expect("texture").into_f32().collect();
    let places: Vec<[f32; 3]> = reader.read_positions().expect("positions").collect();
    let bounds = faces.bounding_box();
    for (axis, expected) in [(0, extent.x), (1, 0.0), (2, extent.y)] {
        assert!((f64::from(bounds.max[axis] - bounds.min[axis]) - expected).abs() < 1e-5, "{bounds:?} for {extent}");
    }
    // Back to the file's axes: z up.
    let middle = DVec3::new(f64::from(translation[0]), f64::from(-translation[2]), f64::from(translation[1]));
    assert!((middle - offset - 0.5 * extent).length() < 1.0, "as near as 32 bits hold it: {middle}");
    for ([x, _, z], [u, v]) in places.iter().zip(&texture) {
        let along = [f64::from(*x) + 0.5 * extent.x, 0.5 * extent.y - f64::from(*z)].map(|at| at / 20.0);
        // v goes down from the top of the picture.
        assert!((along[0] - f64::from(*u)).abs() < 1e-6 && (along[1] - f64::from(1.0 - *v)).abs() < 1e-6);
    }
    let tiny = Glb { placement: Normalisation { radius: 1e-30, ..model.normalisation }, ..Glb::of(&model) };
    let error = tiny.write(&Figure::new(&pattern, &model, &model.rest), &[], Vec::new()).unwrap_err().to_string();
    assert!(error.contains("radius 1e-30"), "{error}");
    let other = Glb { texture: Some(vec![[0.0; 2]]), ..Glb::default() };
    let error = other.write(&Figure::new(&pattern, &model, &model.rest), &[], Vec::new()).unwrap_err().to_string();
    assert!(error.starts_with("texture: 1 places; expected "), "{error}");
}

#[test]
fn a_single_state_needs_no_animation_and_nonsense_is_refused() {
    let Folded { figure, states } = folded(1);
    let mut bytes = Vec::new();
    Glb::default().write(&figure, &[], &mut bytes).unwrap();
    let file = gltf::Gltf::from_slice(&bytes).unwrap();
    assert_eq!((file.animations().count(), file.meshes().next().unwrap().weights()), (0, None));
    let short = [states[0].clone(), vec![[0.0; 3]; 3]];
    let error = Glb::default().write(&figure, &short, Vec::new()).unwrap_err().to_string();
    assert!(error.starts_with("state 1: 3 positions; expected "), "{error}");
    assert!(Glb::default().write(&Figure::default(), &[], Vec::new()).is_err());
}

#[test]
fn a_file_grows_as_its_states_do() {
    let Folded { figure, states } = folded(1);
    let written = |count: usize| {
        let states: Vec<_> = (0..count).map(|i| states[i % 2].clone()).collect();
        let mut bytes = Vec::new();
        Glb::default().write(&figure, &states, &mut bytes).unwrap();
        bytes
    };
    let [one, two] = [400, 800].map(|count| written(count).len() as f64);
    assert!((two / one - 2.0).abs() < 0.02, "{one} {two}");

    // 128 states have a table of weights in full, 129 its ones alone; a reader sees the same in both.
    for count in [128, 129] {
        let bytes = written(count);
        let file = gltf::Gltf::from_slice(&bytes).unwrap();
        let blob = file.blob.as_deref().unwrap();
        let animation = file.animations().next().unwrap();
        let channel = animation.channels().next().unwrap();
        let Some(gltf::animation::util::ReadOutputs::MorphTargetWeights(weights)) =
            channel.reader(|_| Some(blob)).read_outputs()
        else {
            panic!("weights")
        };
        let weights: Vec<f32> = weights.into_f32().collect();
        assert_eq!(weights.len(), count * (count - 1));
        for (i, weights) in weights.chunks(count - 1).enumerate() {
            let expected: Vec<f32> = (1..count).map(|target| if target == i { 1.0 } else { 0.0 }).collect();
            assert!(weights == expected, "state {i} of {count}");
        }
    }
}

#[test]
fn more_states_than_a_file_holds_are_refused_by_arithmetic() {
    let Folded { figure, .. } = folded(1);
    let check = |states| Glb::default().check(&figure, states);
    assert!([0, 1, 2, 10_000].map(check).iter().all(Result::is_ok));
    for states in [16_001, 100_000, usize::MAX] {
        let told = check(states).unwrap_err().to_string();
        assert!(told.contains("states are more than a file holds; expected at most 16000"), "{told}");
    }
    // Of a large sheet the 4 GB come first.
    let mut large = figure.clone();
    large.triangles = figure.triangles.iter().copied().cycle().take(100_000).collect();
    large.map = None;
    let told = Glb::default().check(&large, 1000).unwrap_err().to_string();
    let most: u64 = told.rsplit(' ').next().unwrap().parse().unwrap();
    assert!((500..600).contains(&most), "{told}");
    assert!(Glb::default().check(&large, most as usize).is_ok());
}
