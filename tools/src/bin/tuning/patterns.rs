//! What the recipe is tuned on: every generator as it comes, and with other numbers; files.

use std::error::Error;

use origami::CreasePattern;
use origami::generate::catalog;

/// Numbers for the generators; each line is a sheet besides those of the defaults.
const VARIATIONS: &[(&str, &str)] = &[
    ("single-crease", "height=0.3"),
    ("single-crease", "angle=-120"),
    ("degree-4", "a=40 b=110"),
    ("degree-4", "mode=1"),
    ("degree-4", "driven_only=1"),
    ("degree-4", "angle=170"),
    ("miura", "columns=4 rows=4"),
    ("miura", "columns=16 rows=16"),
    ("miura", "columns=24 rows=6"),
    ("miura", "columns=24 rows=24"),
    ("miura", "gamma=75"),
    ("miura", "theta=60"),
    ("miura", "gamma=45 a=0.5"),
    ("waterbomb", "columns=3 rows=3"),
    ("waterbomb", "columns=10 rows=10"),
    ("waterbomb", "columns=12 rows=4"),
    ("waterbomb", "columns=16 rows=16"),
    ("waterbomb", "angle=120"),
    ("waterbomb-vertex", "n=3"),
    ("waterbomb-vertex", "n=6"),
    ("waterbomb-vertex", "polar=85"),
    ("yoshimura", "columns=10 rows=10 alpha=20"),
    ("yoshimura", "columns=24 rows=24 alpha=20"),
    ("yoshimura", "alpha=50"),
    ("yoshimura", "columns=8 rows=12"),
    ("yoshimura-ring", "driven=1"),
    ("yoshimura-ring", "columns=20 rows=20 driven=1"),
    ("kresling", "n=8 rows=5"),
    ("kresling", "n=12 rows=30"),
    ("kresling", "twist=60"),
    ("kresling", "height=1"),
    ("kresling-ring", "driven=1"),
    ("kresling-ring", "n=12 rows=30 driven=1"),
    ("kresling-ring", "twist=50 height=1"),
    ("square-twist", "columns=2 rows=2"),
    ("square-twist", "columns=4 rows=4"),
    ("square-twist", "columns=8 rows=8"),
    ("square-twist", "pleat=60"),
    ("square-twist", "pleat=30 columns=3"),
    ("hypar", "rings=4"),
    ("hypar", "rings=16"),
    ("hypar", "rings=24"),
    ("hypar", "angle=150"),
    ("hypar", "free_facets=1"),
    ("curved-pleat", "sweep=180"),
    ("curved-pleat", "creases=5"),
    ("curved-pleat", "angle=150"),
    ("curved-pleat", "segments=24"),
    ("curved-pleat", "segments=72"),
    ("curved-pleat", "segments=96"),
    ("bird-base", "angle=150"),
    ("crane", "neck=50 tail=50"),
    ("crane", "wing=45"),
    ("crane", "head=40 head_length=0.5"),
    ("crane", "wing_length=0.3"),
    ("strip", "panels=30"),
    ("strip", "panels=60"),
    ("strip", "width=0.3"),
    ("strip", "angle=90"),
    ("fan", "valence=8"),
    ("fan", "valence=32"),
    ("fan", "valence=64"),
    ("fan", "angle=150"),
];

/// A name, whether it is a generator's own or a file's, and the pattern.
type Pattern = (String, bool, CreasePattern);

/// What the generators make.
pub(crate) fn generated() -> Result<Vec<Pattern>, Box<dyn Error>> {
    let mut patterns = Vec::new();
    for name in catalog::names() {
        patterns.push(((*name).to_owned(), true, catalog::generate(name, &[])?));
    }
    for (name, numbers) in VARIATIONS {
        let numbers: Vec<(String, f64)> = numbers
            .split(' ')
            .filter_map(|number| number.split_once('='))
            .map(|(key, value)| Ok((key.to_owned(), value.parse()?)))
            .collect::<Result<_, std::num::ParseFloatError>>()?;
        let told: Vec<String> = numbers.iter().map(|(key, value)| format!("{key} {value}")).collect();
        patterns.push((format!("{name} {}", told.join(" ")), false, catalog::generate(name, &numbers)?));
    }
    Ok(patterns)
}

/// What files hold.
pub(crate) fn read(files: &[String]) -> Result<Vec<Pattern>, Box<dyn Error>> {
    let name = |file: &String| file.rsplit('/').next().unwrap_or(file).to_owned();
    files.iter().map(|file| Ok((name(file), true, CreasePattern::read(file)?))).collect()
}
