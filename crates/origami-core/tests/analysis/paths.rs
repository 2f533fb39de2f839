//! Whole paths, through every limit point.

use std::ops::ControlFlow;

use origami_core::analysis::{
    Axis, Bar, BarLaw, Control, Dof, Ended, Event, Loads, Path, Point, Refused, Start, Structure, Supports, Trace,
    Until,
};
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;

use crate::case::{case, dof};

const KRESLING: &str = include_str!("cases/merlin1_kresling.json");
const POP_THROUGH: &str = include_str!("cases/merlin1_miura_popthrough.json");
const WATERBOMB: &str = include_str!("cases/merlin2_waterbomb.json");
const SIM_FAST: &str = include_str!("cases/simfast_kresling.json");
const YOSHIMURA: &str = include_str!("cases/merlin2_yoshimura.json");

fn trace(structure: &Structure, path: &Path) -> Trace {
    structure.trace(&Start::default(), path, &mut |_| ControlFlow::Continue(())).expect("a path")
}

/// The limit points: load factor, displacement, energy.
fn limits(structure: &Structure, trace: &Trace, monitor: Dof) -> Vec<(f64, f64, f64)> {
    of(trace, |event| matches!(event, Event::LimitPoint { .. }), structure, monitor)
}

/// The states without load, likewise.
fn without_load(structure: &Structure, trace: &Trace, monitor: Dof) -> Vec<(f64, f64, f64)> {
    of(trace, |event| *event == Event::ZeroLoad, structure, monitor)
}

fn of(trace: &Trace, is: impl Fn(&Event) -> bool, structure: &Structure, monitor: Dof) -> Vec<(f64, f64, f64)> {
    let figures =
        |point: &Point| (point.load_factor, point.displacement(&structure.nodes, monitor), point.energies.total());
    trace.points.iter().filter(|point| is(&point.event)).map(figures).collect()
}

#[track_caller]
fn assert_near(got: f64, wanted: f64, tolerance: f64) {
    assert!((got - wanted).abs() <= tolerance, "{got} is not {wanted} within {tolerance}");
}

#[test]
fn merlins_kresling_has_its_limits_and_four_negative_directions_without_load() {
    let (structure, top) = (case(KRESLING), dof(26));
    let trace = trace(&structure, &Path::steps(500).until(Until::Displacement(top, -0.7)));
    assert_eq!(trace.ended, Ended::Reached);
    let limits = limits(&structure, &trace, top);
    assert_eq!(limits.len(), 2);
    assert_near(limits[0].0, 0.432297769, 1e-9);
    assert_near(limits[0].1, -0.123757631, 1e-7);
    assert_near(limits[1].0, -0.102125919, 1e-9);
    assert_near(limits[1].1, -0.6406038, 1e-7);
    let free = trace.points.iter().find(|p| p.event == Event::ZeroLoad).expect("one");
    assert_near(free.displacement(&structure.nodes, top), -0.428844, 1e-6);
    assert_near(free.energies.total(), 0.861989, 1e-6);
    // No transition state: its energy is no barrier.
    assert_eq!(free.negative, 4);
    // Where its stability changes by the independent program, but for the limit points.
    let changes = trace.points.iter().filter_map(|point| match &point.event {
        Event::Bifurcation { before, after, modes } => {
            assert_eq!(modes.len(), after.abs_diff(*before));
            Some((*before, *after, point.displacement(&structure.nodes, top)))
        }
        _ => None,
    });
    let changes: Vec<(usize, usize, f64)> = changes.collect();
    let wanted = [(1, 2), (2, 4), (4, 6), (5, 7)];
    assert_eq!(changes.iter().map(|(before, after, _)| (*before, *after)).collect::<Vec<_>>(), wanted);
    // Located there between two steps of 0.003 to 0.02.
    for (change, near) in changes.iter().zip([-0.33144, -0.36577, -0.49147, -0.66514]) {
        assert_near(change.2, near, 0.02);
    }
}

#[test]
fn merlins_miura_pops_through_to_its_second_stable_state() {
    let (structure, loaded) = (case(POP_THROUGH), dof(182));
    let trace = trace(&structure, &Path::steps(500).until(Until::Displacement(loaded, -1.95)));
    assert_eq!(trace.ended, Ended::Reached);
    let limits = limits(&structure, &trace, loaded);
    assert_eq!(limits.len(), 2);
    assert_near(limits[0].0, 2.311783656, 1e-8);
    assert_near(limits[0].1, -0.940924, 1e-6);
    assert_near(limits[1].0, -1.751595094, 1e-8);
    assert_near(limits[1].1, -1.263972, 1e-6);
    // The displacement itself has turned back in between, where displacement control would jump.
    let farthest = trace.points.iter().map(|p| p.displacement(&structure.nodes, loaded));
    let before = trace.points.iter().position(|p| p.load_factor < -1.7).expect("unloaded beyond 0");
    assert!(farthest.take(before).fold(0.0, f64::min) < -1.37);
    let free = without_load(&structure, &trace, loaded);
    assert_eq!(free.len(), 2);
    assert_near(free[0].1, -1.325563, 1e-6);
    assert_near(free[0].2, 2.185070, 1e-6);
    assert_near(free[1].1, -1.907868, 1e-6);
    assert_near(free[1].2, 1.488867, 1e-6);
    let negative: Vec<usize> = trace.points.iter().filter(|p| p.event == Event::ZeroLoad).map(|p| p.negative).collect();
    assert_eq!(negative, [1, 0]);
}

#[test]
fn the_waterbomb_does_not_turn_back() {
    let (structure, apex) = (case(WATERBOMB), dof(2));
    let trace = trace(&structure, &Path::steps(500).until(Until::Displacement(apex, -55.0)));
    assert_eq!(trace.ended, Ended::Reached);
    let limits = limits(&structure, &trace, apex);
    assert_eq!(limits.len(), 2);
    assert_near(limits[0].0, 0.611089, 1e-6);
    assert_near(limits[0].1, -10.6577, 1e-4);
    assert_near(limits[1].0, -0.605846, 1e-6);
    assert_near(limits[1].1, -29.3430, 1e-4);
    let free = without_load(&structure, &trace, apex);
    assert_eq!(free.len(), 2);
    assert_near(free[0].2, 1.296637, 1e-6);
    assert_near(free[1].1, -51.99644, 1e-5);
    assert_near(free[1].2, 0.00805176, 1e-8);
    // The apex goes down all the way.
    let heights: Vec<f64> = trace.points.iter().map(|p| p.displacement(&structure.nodes, apex)).collect();
    assert!(heights.windows(2).all(|pair| pair[1] < pair[0] + 1e-9));
}

#[test]
fn sim_fasts_kresling_snaps_at_its_force() {
    let (structure, top) = (case(SIM_FAST), dof(20));
    let trace = trace(&structure, &Path::steps(500).until(Until::Displacement(top, -0.01)));
    let limits = limits(&structure, &trace, top);
    assert_eq!(limits.len(), 1);
    assert_near(limits[0].0, 0.827637604, 1e-9);
    assert_near(limits[0].1, -6.35e-3, 1e-6);
    let Event::LimitPoint { before, after } = trace.events().next().expect("the limit").event else { panic!() };
    assert_eq!((before, after), (0, 1));
}

#[test]
fn merlins_yoshimura_has_its_first_maximum() {
    let (structure, top) = (case(YOSHIMURA), dof(56));
    let trace = trace(&structure, &Path::steps(500).until(Until::Displacement(top, -0.55)));
    let limits = limits(&structure, &trace, top);
    assert_near(limits[0].0, 151.584548, 1e-6);
    assert_near(limits[0].1, -0.539009, 1e-6);
    assert_near(limits[0].2, 97.59658, 1e-5);
}

/// Von Mises' truss: two bars from the ground to an apex that is pressed down and kept in their plane.
fn truss(law: BarLaw) -> Structure {
    let bar = |a, b, length| Bar { nodes: [NodeId(a), NodeId(b)], rest_length: length, rigidity: 20.0, law };
    let rest = 1.25_f64.sqrt();
    let held = [0, 1, 2, 3, 4, 5, 6, 7].map(dof);
    Structure {
        nodes: vec![DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 0.0, 0.5)],
        bars: vec![bar(0, 2, rest), bar(1, 2, rest)],
        supports: Supports { fixed: held.to_vec(), moved: Vec::new() },
        loads: Loads { points: vec![(NodeId(2), -DVec3::Z)], pressures: Vec::new() },
        ..Structure::default()
    }
}

#[test]
fn von_mises_truss_under_three_laws() {
    let rest = 1.25_f64.sqrt();
    let (cubed, ea) = (rest.powi(3), 20.0);
    // 2 EA sqrt(l^2 - b^2) (1/l - 1/l0) at l^3 = b^2 l0, and 2 EA h^3 / (3 sqrt 3 l0^3).
    let length = rest.cbrt();
    let linear = 2.0 * ea * (length * length - 1.0).sqrt() * (1.0 / length - 1.0 / rest);
    let green = 2.0 * ea * 0.125 / (3.0 * 3.0_f64.sqrt() * cubed);
    let apex = Dof::new(NodeId(2), Axis::Z);
    for (law, limit, barrier) in [
        (BarLaw::Linear, linear, 0.24922359499621477),
        (BarLaw::Green, green, 0.22360679774997932),
        (BarLaw::Ogden, 0.6902970543521607, 0.22427190999915897),
    ] {
        let structure = truss(law);
        let trace = trace(&structure, &Path::steps(500).until(Until::Displacement(apex, -1.1)));
        let limits = limits(&structure, &trace, apex);
        assert_eq!(limits.len(), 2, "{law:?}");
        assert_near(limits[0].0, limit, 1e-10);
        assert_near(limits[1].0, -limit, 1e-10);
        // Flat, and turned inside out.
        let free = without_load(&structure, &trace, apex);
        assert_near(free[0].1, -0.5, 1e-10);
        assert_near(free[0].2, barrier, 1e-10);
        assert_near(free[1].1, -1.0, 1e-10);
        assert_near(free[1].2, 0.0, 1e-12);
    }
}

#[test]
fn a_spring_in_series_snaps_back_in_displacement() {
    // The truss is pulled down by a bar of stiffness 1.5 whose other end is moved by 1: D = u + P / k turns back twice.
    let mut structure = truss(BarLaw::Linear);
    let (length, far) = (10.0, DVec3::new(0.0, 0.0, -9.5));
    structure.nodes.push(far);
    let nodes = [NodeId(2), NodeId(3)];
    structure.bars.push(Bar { nodes, rest_length: length, rigidity: 1.5 * length, law: BarLaw::Linear });
    structure.supports.fixed.extend([9, 10].map(dof));
    structure.supports.moved.push((dof(11), -1.0));
    structure.loads.points.clear();
    let trace = trace(&structure, &Path::default());
    assert_eq!(trace.ended, Ended::Reached);
    let turns: Vec<&Point> = trace.events().filter(|p| matches!(p.event, Event::LimitPoint { .. })).collect();
    assert_eq!(turns.len(), 2);
    let pull = |point: &Point| point.reactions.iter().find(|(own, _)| *own == dof(11)).map_or(0.0, |(_, f)| -f);
    for (turn, at, load) in
        [(turns[0], 0.7623444671270827, 0.7225690457744391), (turns[1], 0.23765553287291735, -0.7225690457744391)]
    {
        assert_near(turn.load_factor, at, 1e-10);
        assert_near(pull(turn), load, 1e-8);
    }
    // Controlled by the load factor, which is the displacement here, it ends at the first turn.
    let path = Path { control: Control::Load, ..Path::default() };
    let ended = structure.trace(&Start::default(), &path, &mut |_| ControlFlow::Continue(())).expect("a path");
    assert_eq!(ended.ended, Ended::Stuck);
    assert_near(ended.points.last().expect("some").load_factor, 0.7623444671270827, 1e-3);
}

#[test]
fn controls_meet_the_same_states() {
    let (structure, apex) = (truss(BarLaw::Linear), Dof::new(NodeId(2), Axis::Z));
    let by = |control, until| {
        let path = Path { control, until: vec![until], ..Path::default() };
        let trace = trace(&structure, &path);
        assert_eq!(trace.ended, Ended::Reached, "{control:?}");
        let end = trace.points.last().expect("some").clone();
        (end.load_factor, end.displacement(&structure.nodes, apex))
    };
    let arc = by(Control::Arc, Until::LoadFactor(0.5));
    let load = by(Control::Load, Until::LoadFactor(0.5));
    let displacement = by(Control::Displacement(apex), Until::Displacement(apex, arc.1));
    assert_eq!(arc.0, 0.5);
    assert_near(load.1, arc.1, 1e-12);
    assert_near(displacement.0, 0.5, 1e-10);
    // Past the limit point only the displacement leads on.
    let past = by(Control::Displacement(apex), Until::Displacement(apex, -0.5));
    assert_near(past.0, 0.0, 1e-10);
}

#[test]
fn an_end_that_a_step_meets_exactly_is_one() {
    let (structure, apex) = (truss(BarLaw::Linear), Dof::new(NodeId(2), Axis::Z));
    let before = trace(&structure, &Path::steps(6));
    let last = before.points.last().expect("some");
    assert_eq!(last.event, Event::Step);
    for until in
        [Until::LoadFactor(last.load_factor), Until::Displacement(apex, last.displacement(&structure.nodes, apex))]
    {
        let again = trace(&structure, &Path::steps(20).until(until));
        assert_eq!((again.ended, again.points.len()), (Ended::Reached, before.points.len()), "{until:?}");
        assert_eq!(again.points.last().map(|p| p.load_factor), Some(last.load_factor));
    }
}

#[test]
fn a_path_taken_up_again_is_the_same() {
    let (structure, top) = (case(KRESLING), dof(26));
    let path = Path::steps(500).until(Until::Displacement(top, -0.7));
    let whole = trace(&structure, &path);
    for (at, point) in whole.points.iter().enumerate().take(whole.points.len() - 1) {
        let rest = structure.trace(&Start::again(point), &path, &mut |_| ControlFlow::Continue(())).expect("a path");
        assert_eq!(rest.ended, Ended::Reached, "from {at}");
        let (a, b) = (limits(&structure, &whole, top), limits(&structure, &rest, top));
        let last = whole.points.iter().rposition(|p| matches!(p.event, Event::LimitPoint { .. }));
        assert!(!b.is_empty() || last <= Some(at), "from {at}");
        for (got, wanted) in b.iter().rev().zip(a.iter().rev()) {
            assert_near(got.0, wanted.0, 1e-10);
        }
        let ends = [&whole, &rest].map(|trace| trace.points.last().expect("some").load_factor);
        assert_near(ends[1], ends[0], 1e-10);
    }
}

#[test]
fn the_energy_is_the_work_done_to_second_order() {
    let (structure, top) = (case(KRESLING), dof(26));
    let error = |longest: f64| {
        let path = Path { longest, ..Path::steps(5000) }.until(Until::Displacement(top, -0.3));
        let trace = trace(&structure, &path);
        let end = trace.points.last().expect("some");
        (end.work - end.energies.total()).abs()
    };
    let errors = [0.01, 0.005, 0.0025].map(error);
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((1.7..2.3).contains(&order), "order {order} of {errors:?}");
    }
}

#[test]
fn reactions_balance_the_loads() {
    for text in [KRESLING, POP_THROUGH, YOSHIMURA] {
        let structure = case(text);
        let trace = trace(&structure, &Path::steps(20));
        for point in &trace.points {
            let positions = &point.configuration.positions;
            let (mut force, mut moment, mut largest) = (DVec3::ZERO, DVec3::ZERO, 0.0_f64);
            let mut act = |node: NodeId, f: DVec3| {
                force += f;
                moment += positions[node.index()].cross(f);
                largest = largest.max(f.length());
            };
            structure.loads.points.iter().for_each(|(node, f)| act(*node, *f * point.load_factor));
            for (dof, reaction) in &point.reactions {
                let mut f = DVec3::ZERO;
                f[dof.axis.index()] = *reaction;
                act(dof.node, f);
            }
            // What the last iteration left over is balanced too.
            let mut left = structure.unbalanced(&point.configuration, point.load_factor).expect("a state");
            structure.supports.fixed.iter().for_each(|held| left[held.node.index()][held.axis.index()] = 0.0);
            left.iter().enumerate().for_each(|(i, f)| act(NodeId::new(i), *f));
            let pull = |bar: &Bar| {
                let [a, b] = bar.nodes.map(|n| positions[n.index()]);
                bar.law.respond(bar.rigidity, bar.rest_length, a.distance(b)).slope.abs()
            };
            let arm = positions.iter().map(|p| p.length()).fold(1.0, f64::max);
            let tolerance = 1e-12 * structure.bars.iter().map(pull).fold(largest, f64::max);
            assert!(force.length() <= tolerance && moment.length() <= arm * tolerance, "{force} {moment} {tolerance}");
        }
    }
}

#[test]
fn what_cannot_be_followed_is_refused_by_name() {
    let follow = |structure: &Structure, path: &Path| {
        structure.trace(&Start::default(), path, &mut |_| ControlFlow::Continue(())).expect_err("refused")
    };
    let path = Path::default();
    let whole = case(WATERBOMB);

    // As published: free to turn about the vertical.
    let mut turning = whole.clone();
    turning.supports.fixed.retain(|own| *own != dof(4));
    assert_eq!(follow(&turning, &path), Refused::RigidMotions { free: 1 });
    turning.supports.fixed.clear();
    assert_eq!(follow(&turning, &path), Refused::RigidMotions { free: 6 });

    let mut hinged = truss(BarLaw::Linear);
    hinged.supports.fixed.retain(|own| *own != dof(7));
    assert_eq!(follow(&hinged, &path), Refused::RigidMotions { free: 1 });

    // A square of four bars without a diagonal.
    let corner = |x, y| DVec3::new(x, y, 0.0);
    let bar = |a, b| Bar { nodes: [NodeId(a), NodeId(b)], rest_length: 1.0, rigidity: 1.0, law: BarLaw::Linear };
    let square = Structure {
        nodes: vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)],
        bars: vec![bar(0, 1), bar(1, 2), bar(2, 3), bar(3, 0)],
        supports: Supports { fixed: [0, 1, 2, 4, 5, 8, 11].map(dof).to_vec(), moved: Vec::new() },
        loads: Loads { points: vec![(NodeId(2), DVec3::X)], pressures: Vec::new() },
        ..Structure::default()
    };
    assert_eq!(follow(&square, &path), Refused::Mechanisms { count: 1 });

    let mut idle = whole.clone();
    idle.loads.points.clear();
    assert_eq!(follow(&idle, &path), Refused::Unloaded);

    let mut astray = whole.clone();
    astray.loads.points.push((NodeId(9), DVec3::X));
    assert_eq!(follow(&astray, &path).to_string(), "loads.points[1]: node 9; expected one of the 9 nodes");

    let mut torn = whole.clone();
    torn.supports.moved.push((dof(17), 0.5));
    let told = follow(&torn, &path).to_string();
    assert_eq!(told, "supports: node 5 along z is held at 0 and at 0.5; expected one place");

    let held = Path { control: Control::Displacement(dof(0)), ..Path::default() };
    assert!(follow(&whole, &held).to_string().starts_with("path.control: node 0 along x; expected a free"));
    let endless = Path { longest: 0.0, ..Path::default() };
    assert!(follow(&whole, &endless).to_string().starts_with("path.longest: 0; expected"));
}
