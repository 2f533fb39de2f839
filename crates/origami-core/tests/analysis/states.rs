//! What is known of one state: vibrations, first-order answers, pressure.

use std::ops::ControlFlow;

use origami_core::analysis::{
    Axis, Bar, BarLaw, Dof, Event, Hinge, HingeKind, HingeLaw, ModeKind, Path, Refused, Start, Structure, Until,
};
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::Axes;

use crate::case::case;
use crate::miura::miura;

/// Two triangles over the crease from (0, 0, 0) to (0, 1, 0), apexes half a unit (or `height`) to both sides.
fn crease(height: f64, stiffness: f64, rigidity: f64) -> Structure {
    let nodes = vec![
        DVec3::new(0.0, 0.0, 0.0),
        DVec3::new(0.0, 1.0, 0.0),
        DVec3::new(-height, 0.5, 0.0),
        DVec3::new(height, 0.5, 0.0),
    ];
    let bar = |a: usize, b: usize| Bar {
        nodes: [NodeId::new(a), NodeId::new(b)],
        rest_length: nodes[a].distance(nodes[b]),
        rigidity,
        law: BarLaw::Linear,
    };
    let bars = vec![bar(0, 1), bar(0, 2), bar(1, 2), bar(0, 3), bar(1, 3)];
    let nodes_of_hinge = [2, 3, 0, 1].map(NodeId);
    let law = HingeLaw::Linear;
    let hinge = Hinge { nodes: nodes_of_hinge, rest_angle: 0.0, stiffness, law, kind: HingeKind::Crease };
    Structure { nodes, bars, hinges: vec![hinge], ..Structure::default() }
}

#[test]
fn a_single_crease_has_its_frequency() {
    // omega^2 = k L (sum of |dtheta/dx|^2 / m) = 4 k L / (m h^2).
    let mut free = crease(0.5, 0.2, 1000.0);
    free.masses = vec![0.01; 4];
    let modes = free.modes(&free.as_drawn(), 0.0, 12).expect("modes");
    assert_eq!(modes.iter().filter(|mode| mode.kind == ModeKind::Free).count(), 6);
    assert_eq!(modes[6].kind, ModeKind::Creases);
    assert!((modes[6].eigenvalue / 320.0 - 1.0).abs() < 1e-9, "{}", modes[6].eigenvalue);
    // With unequal masses: 1 / m of each apex, and of each end once more.
    free.masses = vec![0.01, 0.02, 0.03, 0.04];
    let modes = free.modes(&free.as_drawn(), 0.0, 7).expect("modes");
    let wanted = 0.2 * (1.0 / 0.03 + 1.0 / 0.04 + 1.0 / 0.01 + 1.0 / 0.02) / 0.25;
    assert!((modes[6].eigenvalue / wanted - 1.0).abs() < 1e-9, "{} {wanted}", modes[6].eigenvalue);

    let mut clamped = crease(0.5, 0.2, 1000.0);
    clamped.masses = vec![0.01; 4];
    [0, 1, 2].map(NodeId).iter().for_each(|node| clamped.hold(*node, Axes::ALL));
    let modes = clamped.modes(&clamped.as_drawn(), 0.0, 3).expect("modes");
    assert!((modes[0].eigenvalue / 80.0 - 1.0).abs() < 1e-9, "{}", modes[0].eigenvalue);
    assert!((modes[0].shape[3].z.abs() - 1.0).abs() < 1e-9 && modes[0].shape[0] == DVec3::ZERO);
}

#[test]
fn a_free_miura_is_soft_in_one_fold_and_in_its_facets() {
    for (cells, soft) in [([1, 1], 5), ([2, 2], 13), ([3, 2], 17)] {
        let structure = miura(cells, 60_f64.to_radians(), 50_f64.to_radians(), [1e-6, 1e-3, 1e3]);
        let modes = structure.modes(&structure.as_drawn(), 0.0, 6 + soft + 2).expect("modes");
        let count = |kind| modes.iter().filter(|mode| mode.kind == kind).count();
        assert_eq!([count(ModeKind::Free), count(ModeKind::Creases)], [6, 1], "{cells:?}");
        assert_eq!(count(ModeKind::Facets), soft - 1, "{cells:?}");
        let (last, next) = (&modes[6 + soft - 1], &modes[6 + soft]);
        assert!(next.eigenvalue > 1e4 * last.eigenvalue, "{cells:?}: {} {}", last.eigenvalue, next.eigenvalue);
    }
}

#[test]
fn the_first_answer_is_the_beginning_of_the_path() {
    for text in [include_str!("cases/merlin1_kresling.json"), include_str!("cases/merlin1_miura_popthrough.json")] {
        let structure = case(text);
        let drawn = structure.as_drawn();
        let first = structure.first_order(&drawn, 0.0).expect("an answer");
        let by = 1e-5;
        let loaded = [by, -by].map(|factor| structure.equilibrium(&drawn, factor).expect("an equilibrium"));
        let largest = first.displacements.iter().map(|u| u.length()).fold(0.0, f64::max);
        for (i, u) in first.displacements.iter().enumerate() {
            let difference = (loaded[0].positions[i] - loaded[1].positions[i]) / (2.0 * by);
            assert!((difference - *u).length() < 1e-6 * largest, "node {i}: {u} {difference}");
        }
        let work: f64 =
            structure.loads.points.iter().map(|(node, force)| force.dot(first.displacements[node.index()])).sum();
        assert!((first.compliance / work - 1.0).abs() < 1e-9);
        let sum: f64 = first.reactions.iter().filter(|(dof, _)| dof.axis == Axis::Z).map(|(_, force)| force).sum();
        let load: f64 = structure.loads.points.iter().map(|(_, force)| force.z).sum();
        assert!((sum + load).abs() < 1e-9 * load.abs(), "{sum} {load}");
    }
}

#[test]
fn pressure_follows_a_triangle_and_a_dead_load_does_not() {
    let follow = |structure: &Structure| {
        let trace = structure.trace(&Start::default(), &Path::default(), &mut |_| ControlFlow::Continue(()));
        let trace = trace.expect("a path");
        let end = trace.points.last().expect("some").clone();
        assert_eq!(end.load_factor, 1.0);
        end.configuration.fold_angles[0].abs()
    };
    let mut structure = crease(1.0, 0.1, 1e6);
    [0, 1, 2].map(NodeId).iter().for_each(|node| structure.hold(*node, Axes::ALL));
    let (pressure, area, height, stiffness) = (0.9, 0.5, 1.0, 0.1);
    structure.loads.pressures = vec![([0, 3, 1].map(NodeId), pressure)];
    // theta = p A h / (3 K) at any angle.
    let theta = follow(&structure);
    assert!((theta - pressure * area * height / (3.0 * stiffness)).abs() < 1e-8, "{theta}");
    // K theta = p A h cos theta / 3.
    structure.loads.pressures.clear();
    structure.loads.points = vec![(NodeId(3), DVec3::Z * (pressure * area / 3.0))];
    let theta = follow(&structure);
    let left = stiffness * theta - pressure * area * height / 3.0 * theta.cos();
    assert!(left.abs() < 1e-6 && (theta - 0.9148565).abs() < 1e-6, "{theta}");
}

/// A strip of `links` square panels of side `a` above a clamped one, with springs `stiffness` between them, rigid but for that.
fn column(links: u32, a: f64, stiffness: f64) -> Structure {
    let mut structure = Structure::default();
    for j in 0..links + 2 {
        let z = a * (f64::from(j) - 1.0);
        structure.nodes.extend([DVec3::new(-0.5 * a, 0.0, z), DVec3::new(0.5 * a, 0.0, z)]);
    }
    let node = |j: u32, right: u32| NodeId(2 * j + right);
    let mut bar = |nodes: [NodeId; 2]| {
        let rest_length = structure.nodes[nodes[0].index()].distance(structure.nodes[nodes[1].index()]);
        structure.bars.push(Bar { nodes, rest_length, rigidity: 1e5, law: BarLaw::Linear });
    };
    for j in 0..links + 2 {
        bar([node(j, 0), node(j, 1)]);
        if j <= links {
            bar([node(j, 0), node(j + 1, 0)]);
            bar([node(j, 1), node(j + 1, 1)]);
            bar([node(j, 0), node(j + 1, 1)]);
        }
    }
    let mut hinge = |nodes: [NodeId; 4], stiffness: f64, kind| {
        structure.hinges.push(Hinge { nodes, rest_angle: 0.0, stiffness, law: HingeLaw::Linear, kind });
    };
    for j in 0..=links {
        hinge([node(j + 1, 0), node(j, 1), node(j, 0), node(j + 1, 1)], 1e3, HingeKind::Facet);
        if j > 0 {
            hinge([node(j + 1, 1), node(j - 1, 0), node(j, 0), node(j, 1)], stiffness, HingeKind::Crease);
        }
    }
    for clamped in 0..4 {
        structure.hold(NodeId(clamped), Axes::ALL);
    }
    structure.loads.points = [0, 1].map(|right| (node(links + 1, right), -0.5 * DVec3::Z)).to_vec();
    structure
}

#[test]
fn a_column_of_rigid_links_buckles_at_its_load() {
    // P = (4 K / a) sin^2((2 m - 1) pi / (2 (2 n + 1))) for the m-th shape.
    let (links, a, stiffness) = (8, 0.1, 0.03);
    let structure = column(links, a, stiffness);
    let found = structure.buckling(2).expect("critical loads");
    let load = |m: f64| {
        let half = (2.0 * m - 1.0) * std::f64::consts::PI / (2.0 * f64::from(2 * links + 1));
        4.0 * stiffness / a * half.sin().powi(2)
    };
    assert!((load(1.0) - 0.010216140189658931).abs() < 1e-12, "{}", load(1.0));
    for (m, buckling) in [1.0, 2.0].into_iter().zip(&found) {
        let error = buckling.load_factor / load(m) - 1.0;
        assert!(error.abs() < 2e-5, "{m}: {} is not {}", buckling.load_factor, load(m));
    }
    // It leans over to the side, farthest at the top.
    let tip = found[0].shape.last().expect("a node");
    assert!(tip.y.abs() > 0.999 && tip.z.abs() < 1e-6, "{tip}");
    // A path finds the same: there the straight column's inertia changes.
    let trace = structure.trace(
        &Start::default(),
        &Path { until: vec![Until::LoadFactor(1.05 * load(1.0))], ..Path::default() },
        &mut |_| ControlFlow::Continue(()),
    );
    let trace = trace.expect("a path");
    let first = trace.points.iter().find(|p| matches!(p.event, Event::Bifurcation { .. })).expect("a bifurcation");
    assert!((first.load_factor / load(1.0) - 1.0).abs() < 1e-4, "{}", first.load_factor);
    // Followed to the side, the load hardly rises: the tip goes down and in.
    let aside = Start::branch(first, 0, 1.0).expect("a branch");
    let path = Path::steps(20);
    let branch = structure.trace(&aside, &path, &mut |_| ControlFlow::Continue(())).expect("a path");
    let last = branch.points.last().expect("some");
    let lean = last.configuration.positions[17].y.abs();
    assert!(lean > 0.1 && last.load_factor > load(1.0) && last.negative == 0, "{lean} {}", last.load_factor);
}

#[test]
fn a_cantilever_of_rigid_links_bends_as_its_chain_does() {
    let (links, a, stiffness) = (8, 0.1, 0.03);
    let mut structure = column(links, a, stiffness);
    let facets = structure.hinges.iter_mut().filter(|hinge| hinge.kind == HingeKind::Facet);
    facets.for_each(|hinge| hinge.stiffness *= 100.0);
    let tip = structure.nodes.len() - 1;
    let across = |load: f64| [tip - 1, tip].map(|n| (NodeId::new(n), 0.5 * load * DVec3::Y)).to_vec();
    structure.loads.points = across(1.0);
    // P a^2 / K times the sum of j^2, to first order.
    let first = structure.first_order(&structure.as_drawn(), 0.0).expect("an answer");
    let wanted = a * a / stiffness * (1..=links).map(|j| f64::from(j * j)).sum::<f64>();
    assert!((first.displacements[tip].y / wanted - 1.0).abs() < 5e-6, "{} {wanted}", first.displacements[tip].y);
    // The chain's large deflections: K theta_j = P times the arm beyond j.
    for (load, down, inward) in
        [(0.01, 0.46158698135360166, 0.17087903809091054), (0.1, 0.7411293765082173, 0.6031553014558695)]
    {
        structure.loads.points = across(load);
        let trace = structure.trace(&Start::default(), &Path::default(), &mut |_| ControlFlow::Continue(()));
        let end = trace.expect("a path").points.pop().expect("some");
        let moved = end.configuration.positions[tip] - structure.nodes[tip];
        assert!((moved.y / down - 1.0).abs() < 5e-6 && (-moved.z - inward).abs() < 5e-6, "{moved}");
    }
}

#[test]
fn what_does_not_buckle_has_no_critical_load() {
    let mut structure = column(3, 0.1, 0.03);
    structure.loads.points.iter_mut().for_each(|(_, force)| *force = -*force);
    assert_eq!(structure.buckling(3), Ok(Vec::new()));
}

#[test]
fn states_that_cannot_be_are_refused() {
    let free = crease(0.5, 0.2, 1.0);
    let drawn = free.as_drawn();
    assert_eq!(free.first_order(&drawn, 0.0), Err(Refused::RigidMotions { free: 6 }));
    assert_eq!(free.equilibrium(&drawn, 0.0), Err(Refused::RigidMotions { free: 6 }));
    let mut light = crease(0.5, 0.2, 1.0);
    light.masses = vec![1.0, 0.0, 1.0, 1.0];
    let told = light.modes(&drawn, 0.0, 3).expect_err("refused").to_string();
    assert_eq!(told, "masses[1]: 0; expected a number above 0");
    let dof = Dof::new(NodeId(0), Axis::X);
    assert_eq!((dof.of(&free.nodes), dof.axis.name()), (0.0, "x"));
}

#[test]
fn a_lattice_of_triangles_has_its_moduli() {
    // Springs k along all lines: E = 2 k / sqrt 3, nu = 1 / 3, G = sqrt 3 k / 4.
    let (a, b) = (DVec3::X, DVec3::new(0.5, 0.75_f64.sqrt(), 0.0));
    let (side, rigidity) = (4_u32, 7.0);
    let node = |i: u32, j: u32| NodeId(i * side + j);
    let mut structure = Structure::default();
    for i in 0..side {
        structure.nodes.extend((0..side).map(|j| a * f64::from(i) + b * f64::from(j)));
    }
    for i in 0..side {
        for j in 0..side {
            let ends = [(i + 1, j), (i, j + 1), (i + 1, j.wrapping_sub(1))];
            for (p, q) in ends.into_iter().filter(|(p, q)| *p < side && *q < side) {
                let nodes = [node(i, j), node(p, q)];
                structure.bars.push(Bar { nodes, rest_length: 1.0, rigidity, law: BarLaw::Linear });
            }
        }
    }
    let mut hinge = |nodes: [NodeId; 4]| {
        let (law, kind) = (HingeLaw::Linear, HingeKind::Facet);
        structure.hinges.push(Hinge { nodes, rest_angle: 0.0, stiffness: 1.0, law, kind });
    };
    for i in 1..side - 1 {
        for j in 1..side - 1 {
            hinge([node(i, j + 1), node(i + 1, j - 1), node(i, j), node(i + 1, j)]);
            hinge([node(i - 1, j + 1), node(i + 1, j), node(i, j), node(i, j + 1)]);
            hinge([node(i + 1, j), node(i, j - 1), node(i, j), node(i + 1, j - 1)]);
        }
    }
    for cell in [[a, b], [2.0 * a, b], [a - b, a + b]] {
        let moduli = structure.moduli(cell).expect("moduli");
        let young = 2.0 * rigidity / 3_f64.sqrt();
        let near =
            |got: f64, wanted: f64| assert!((got / wanted - 1.0).abs() < 1e-12, "{cell:?}: {got} is not {wanted}");
        moduli.young.into_iter().for_each(|own| near(own, young));
        moduli.poisson.into_iter().for_each(|own| near(own, 1.0 / 3.0));
        near(moduli.shear, 0.25 * 3_f64.sqrt() * rigidity);
    }
    let told = |cell| structure.moduli(cell).expect_err("refused").to_string();
    assert!(told([a, 2.0 * a]).contains("expected two vectors in the plane of x and y"));
    assert!(told([1.7 * a, b]).contains("lies at the border in all of its copies"), "{}", told([1.7 * a, b]));
}

#[test]
fn a_miura_of_rigid_facets_has_its_poisson_ratio() {
    let (theta, gamma) = (60_f64.to_radians(), 50_f64.to_radians());
    let structure = miura([3, 3], theta, gamma, [1e-7, 1e1, 1e3]);
    let [x, y] = [structure.nodes[14] - structure.nodes[0], structure.nodes[2] - structure.nodes[0]];
    assert!(x.y.abs() < 1e-12 && y.x.abs() < 1e-12, "{x} {y}");
    let moduli = structure.moduli([x, y]).expect("moduli");
    // nu = -cos^2 gamma tan^2 theta (Schenk and Guest), as much along y as along x.
    let wanted = -(gamma.cos() * theta.tan()).powi(2);
    let [along_x, along_y] = moduli.poisson;
    let near = |got: f64, wanted: f64| (got / wanted - 1.0).abs() < 1e-5;
    assert!(
        near(along_x, wanted) && near(along_y, 1.0 / wanted) || near(along_y, wanted) && near(along_x, 1.0 / wanted),
        "{moduli:?} {wanted}"
    );
}
