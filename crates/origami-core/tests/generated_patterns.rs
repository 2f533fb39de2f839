//! The fold angles that the generators set are those of a rigidly folded sheet: the solver reaches them all, and
//! nothing is strained.

use origami_core::CreasePattern;
use origami_core::generate::catalog;
use origami_core::measure::{Strain, angle_error};
use origami_core::model::{Material, Model};
use origami_core::solve::{Relax, Solver};

/// No rigid state exists with these letters, or at these angles.
const STRAINED: [&str; 3] = ["hypar", "curved-pleat", "fan"];

/// Largest strain, and largest difference from the fold angles asked for, in degrees.
fn folded(pattern: &CreasePattern) -> Result<(f64, f64), Box<dyn std::error::Error>> {
    let model = Model::new(pattern, &Material::default())?;
    let folded = Relax { tolerance: 1e-6, ..Relax::default() }.fold_from_rest(&model, 100.0)?;
    assert!(folded.converged() && folded.state.tangled_creases() == 0);
    Ok((Strain::of(&model, &folded.state.positions).beams.max, angle_error(&folded.state).max))
}

#[test]
fn angles_are_reached_without_strain() -> Result<(), Box<dyn std::error::Error>> {
    for name in catalog::names().iter().filter(|name| !STRAINED.contains(name)) {
        let (strain, angle) = folded(&catalog::generate(name, &[])?)?;
        assert!(strain < 1e-5 && angle < 1e-2, "{name}: strain {strain}, angles {angle} degrees off");
    }
    Ok(())
}

#[test]
fn other_parameters_keep_it_so() -> Result<(), Box<dyn std::error::Error>> {
    let cases: [(&str, &[(&str, f64)]); 5] = [
        ("miura", &[("theta", 50.0), ("gamma", 75.0), ("columns", 5.0), ("rows", 6.0)]),
        ("degree-4", &[("mode", 1.0), ("angle", 70.0)]),
        ("square-twist", &[("columns", 2.0), ("rows", 2.0), ("pleat", 30.0)]),
        ("yoshimura", &[("columns", 8.0), ("rows", 3.0), ("alpha", 25.0)]),
        ("crane", &[("neck", 50.0), ("tail", 20.0), ("wing", 60.0), ("head", 90.0)]),
    ];
    for (name, parameters) in cases {
        let parameters: Vec<(String, f64)> = parameters.iter().map(|&(name, value)| (name.into(), value)).collect();
        let (strain, angle) = folded(&catalog::generate(name, &parameters)?)?;
        assert!(strain < 1e-5 && angle < 1e-2, "{name}: strain {strain}, angles {angle} degrees off");
    }
    Ok(())
}

#[test]
fn patterns_without_a_rigid_state_stay_strained() -> Result<(), Box<dyn std::error::Error>> {
    for name in STRAINED {
        let (strain, _) = folded(&catalog::generate(name, &[])?)?;
        assert!(strain > 1e-3, "{name}: strain {strain}");
    }
    Ok(())
}

/// A hypar takes the shape of its name: two opposite corners rise and the other two sink by as much, with less energy than
/// where all diagonals turn the same way and the corners stay in one plane.
#[test]
fn a_hypar_is_a_saddle() -> Result<(), Box<dyn std::error::Error>> {
    for (percent, least_height) in [(60.0, 0.01), (100.0, 0.1)] {
        // How far corners lie above and below their plane, in sides of the sheet, and the energy.
        let folded = |alternating: f64| -> Result<(f64, f64), Box<dyn std::error::Error>> {
            let pattern = catalog::generate("hypar", &[("alternating".into(), alternating)])?;
            let model = Model::new(&pattern, &Material::default())?;
            let state = Relax::default().fold_from_rest(&model, percent)?.state;
            let corners: Vec<_> = (29..33).map(|node| state.positions[node]).collect();
            let height = (corners[0] + corners[2] - corners[1] - corners[3]).length() / 4.0;
            Ok((height / model.rest[29].distance(model.rest[30]), state.energy(&model).total()))
        };
        let ((saddle, least), (tray, more)) = (folded(1.0)?, folded(0.0)?);
        assert!(saddle > least_height && tray < 1e-5, "{percent} %: heights {saddle} and {tray}");
        assert!(least < more, "{percent} %: energies {least} and {more}");
    }
    Ok(())
}
