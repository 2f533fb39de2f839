//! Structures from files, with what the programs that they are of found.

use std::f64::consts::PI;

use origami_core::analysis::{Axis, Bar, BarLaw, Dof, Hinge, HingeKind, HingeLaw, Loads, Structure, Supports};
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use serde::Deserialize;

/// One number for all, or one for each.
#[derive(Deserialize)]
#[serde(untagged)]
enum Numbers {
    All(f64),
    Each(Vec<f64>),
}

impl Numbers {
    fn at(&self, i: usize) -> f64 {
        match self {
            Self::All(x) => *x,
            Self::Each(list) => list[i],
        }
    }
}

#[derive(Deserialize)]
struct Case {
    nodes: Vec<[f64; 3]>,
    bars: Vec<[u32; 2]>,
    law: String,
    rigidity: Numbers,
    creases: Vec<[u32; 4]>,
    crease_rest: Numbers,
    crease_stiffness: Option<Numbers>,
    crease_stiffness_per_length: Option<Numbers>,
    facets: Vec<[u32; 4]>,
    facet_rest: Numbers,
    facet_stiffness_per_length: Numbers,
    /// Interior angles in degrees between which hinges are linear.
    between: [f64; 2],
    /// Of facets with a power law.
    facet_exponent: Option<f64>,
    fixed: Vec<usize>,
    loaded: Vec<usize>,
    load: Numbers,
}

/// What a program found.
#[derive(Deserialize)]
pub(crate) struct Found {
    /// The least eigenvalues of the tangent as drawn, over the free degrees of freedom.
    #[serde(default)]
    pub(crate) eigenvalues: Vec<f64>,
    /// The largest one.
    #[serde(default)]
    pub(crate) eigenvalue_max: f64,
    pub(crate) states: Vec<FoundState>,
    /// The degree of freedom that `curve` is of.
    pub(crate) monitor: usize,
    /// Displacement and load factor, in the order of the path.
    pub(crate) curve: Vec<[f64; 2]>,
}

/// A state that a program found.
#[derive(Deserialize)]
pub(crate) struct FoundState {
    pub(crate) factor: f64,
    pub(crate) energy: f64,
    pub(crate) positions: Vec<[f64; 3]>,
}

/// What was found of a case.
pub(crate) fn found(text: &str) -> Found {
    serde_json::from_str(text).expect("what was found")
}

/// The degree of freedom that those programs number so.
pub(crate) fn dof(number: usize) -> Dof {
    Dof::new(NodeId::new(number / 3), Axis::ALL[number % 3])
}

/// The structure of a case.
pub(crate) fn case(text: &str) -> Structure {
    let case: Case = serde_json::from_str(text).expect("a case");
    let nodes: Vec<DVec3> = case.nodes.iter().map(|p| DVec3::from_array(*p)).collect();
    let length = |a: u32, b: u32| nodes[a as usize].distance(nodes[b as usize]);
    let law = match case.law.as_str() {
        "green" => BarLaw::Green,
        "ogden" => BarLaw::Ogden,
        other => panic!("{other}"),
    };
    let bars = case.bars.iter().enumerate().map(|(i, [a, b])| Bar {
        nodes: [NodeId(*a), NodeId(*b)],
        rest_length: length(*a, *b),
        rigidity: case.rigidity.at(i),
        law,
    });
    let hinge = |nodes: &[u32; 4], interior: f64, stiffness: f64, kind| {
        let [a, b, c, d] = *nodes;
        Hinge {
            nodes: [c, d, a, b].map(NodeId),
            rest_angle: PI - interior,
            stiffness,
            law: match (kind, case.facet_exponent) {
                (HingeKind::Facet, Some(exponent)) => HingeLaw::Power { exponent },
                _ => HingeLaw::Stiffened {
                    between: [PI - case.between[1].to_radians(), PI - case.between[0].to_radians()],
                },
            },
            kind,
        }
    };
    let creases = case.creases.iter().enumerate().map(|(i, nodes)| {
        let per_length = case.crease_stiffness_per_length.as_ref();
        let whole = case.crease_stiffness.as_ref().map(|k| k.at(i));
        let stiffness = whole.or(per_length.map(|k| k.at(i) * length(nodes[0], nodes[1]))).expect("one of the two");
        hinge(nodes, case.crease_rest.at(i), stiffness, HingeKind::Crease)
    });
    let facets = case.facets.iter().enumerate().map(|(i, nodes)| {
        let stiffness = case.facet_stiffness_per_length.at(i) * length(nodes[0], nodes[1]);
        hinge(nodes, case.facet_rest.at(i), stiffness, HingeKind::Facet)
    });
    let mut points = Vec::new();
    for (i, number) in case.loaded.iter().enumerate() {
        let mut force = DVec3::ZERO;
        force[number % 3] = case.load.at(i);
        points.push((NodeId::new(number / 3), force));
    }
    let mut structure = Structure {
        bars: bars.collect(),
        hinges: creases.chain(facets).collect(),
        supports: Supports { fixed: case.fixed.iter().map(|n| dof(*n)).collect(), moved: Vec::new() },
        loads: Loads { points, pressures: Vec::new() },
        nodes,
        ..Structure::default()
    };
    // Those programs' order of the apexes does not tell which way a hinge folds: where it is drawn it does.
    let drawn = structure.fold_angles(&structure.nodes, &vec![0.0; structure.hinges.len()]);
    let same = structure.hinges.iter().zip(&drawn).map(|(hinge, drawn)| hinge.rest_angle * drawn).sum::<f64>();
    if same < 0.0 {
        for hinge in &mut structure.hinges {
            hinge.rest_angle *= -1.0;
            if let HingeLaw::Stiffened { between } = &mut hinge.law {
                *between = [-between[1], -between[0]];
            }
        }
    }
    structure
}
