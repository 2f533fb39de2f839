//! A Kresling tube of bars without stress in two states, by closed forms: with the turn psi of its upper end the other state
//! has `pi - 2 pi / N - psi`, and the heights differ by `z1^2 - z2^2 = 4 R^2 cos(pi / N) cos(psi1 + pi / N)`.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use origami_core::analysis::{Bar, BarLaw, Dof, Ended, Event, Path, Point, Start, Structure, Until};
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::Axes;

pub(crate) const SIDES: u32 = 6;

/// Two hexagons of radius 1, the upper one `height` above and turned by `turn`; the lower one is fixed. Bars alone.
pub(crate) fn kresling(height: f64, turn: f64) -> Structure {
    let ring = |z: f64, turn: f64| {
        (0..SIDES).map(move |i| {
            let angle = turn + TAU * f64::from(i) / f64::from(SIDES);
            DVec3::new(angle.cos(), angle.sin(), z)
        })
    };
    let mut structure = Structure { nodes: ring(0.0, 0.0).chain(ring(height, turn)).collect(), ..Structure::default() };
    for i in 0..SIDES {
        let next = (i + 1) % SIDES;
        // One of each kind after the other: upright, leaning, around the top.
        for nodes in [[i, SIDES + i], [i, SIDES + next], [SIDES + i, SIDES + next]] {
            let nodes = nodes.map(NodeId);
            let rest_length = structure.nodes[nodes[0].index()].distance(structure.nodes[nodes[1].index()]);
            structure.bars.push(Bar { nodes, rest_length, rigidity: 20.0, law: BarLaw::Linear });
        }
        structure.hold(NodeId(i), Axes::ALL);
    }
    structure
}

#[test]
fn between_its_two_states_lies_a_saddle_of_index_1() {
    let mut tube = kresling(1.5, 40_f64.to_radians());
    tube.loads.points = (SIDES..2 * SIDES).map(|i| (NodeId(i), -DVec3::Z)).collect();
    let top = Dof::new(NodeId(SIDES), origami_core::analysis::Axis::Z);
    // On a little beyond the second state.
    let path = Path::steps(500).until(Until::Displacement(top, -0.5));
    let trace = tube.trace(&Start::default(), &path, &mut |_| ControlFlow::Continue(())).expect("a path");
    assert_eq!(trace.ended, Ended::Reached);
    let height = |point: &Point| top.of(&point.configuration.positions);
    let near = |got: f64, wanted: f64, tolerance: f64| assert!((got - wanted).abs() < tolerance, "{got}: {wanted}");
    let half = std::f64::consts::PI / f64::from(SIDES);
    let second = (1.5_f64.powi(2) - 4.0 * half.cos() * (40_f64.to_radians() + half).cos()).sqrt();
    near(second, 1.0320888862379558, 1e-15);

    let states = trace.equilibria();
    assert_eq!(states.iter().map(|state| state.index).collect::<Vec<_>>(), [0, 1, 0]);
    near(states[0].barrier.expect("a saddle"), 0.014176792690919695, 1e-9);
    near(height(&trace.points[states[1].point]), 1.2988822922887429, 1e-9);
    near(states[2].energy, 0.0, 1e-20);
    near(height(&trace.points[states[2].point]), second, 1e-9);

    let limits: Vec<&Point> = trace.events().filter(|p| matches!(p.event, Event::LimitPoint { .. })).collect();
    assert_eq!(limits.len(), 2);
    near(limits[0].load_factor, 0.018601274086751628, 1e-9);
    near(height(limits[0]), 1.4267415406130146, 1e-6);
    near(limits[1].load_factor, -0.01348365461937777, 1e-9);
    near(height(limits[1]), 1.164512338247433, 1e-6);
}
