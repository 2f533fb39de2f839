//! The families, in the order of the table.

use origami_core::generate::{Degree4, Fan, Hypar, SingleCrease, catalog, miura};
use origami_core::{CreasePattern, Error, Material};

use super::Case;
use super::patterns::{beside, hinge, hub, in_turn, narrow_pleat, nested_squares, placed, random_letters};

type Made = Result<CreasePattern, Error>;

/// The cases of all families, one family after the other.
pub(in crate::stability) fn all() -> Vec<Case> {
    let mut cases = shipped();
    cases.extend(materials());
    cases.extend(hubs());
    cases.extend(thin());
    cases.extend(placements());
    cases.extend(targets());
    cases.extend(frustrated());
    cases.extend(disconnected());
    cases.extend(jumps());
    cases.extend(large());
    cases
}

fn sheet() -> Made {
    miura(4, 4)
}

fn fan(valence: usize) -> Made {
    Fan { valence, ..Fan::default() }.pattern()
}

/// Each generator's default.
fn shipped() -> Vec<Case> {
    let case = |name: &&'static str| {
        [60.0, 100.0].map(|percent| {
            let quick = ["degree-4", "fan"].contains(name) && percent == 60.0;
            let case = Case::new("shipped patterns", *name, catalog::generate(name, &[]));
            case.with("percent", percent).sent_to(&[percent]).quick(quick)
        })
    };
    catalog::names().iter().flat_map(case).collect()
}

/// One number of the material at a time.
fn materials() -> Vec<Case> {
    let default = Material::default();
    let mut cases = Vec::new();
    let mut add = |family, parameter, value: f64, material: Material, quick: bool| {
        let on_sheet = Case::new(family, "Miura 4x4", sheet()).made_of(material).with(parameter, value);
        // A fan has no facets.
        let other = match family {
            "k_facet" => Case::new(family, "square twist", catalog::generate("square-twist", &[])),
            _ => Case::new(family, "fan of 16", fan(16)),
        };
        cases.extend([on_sheet.quick(quick), other.made_of(material).with(parameter, value)]);
    };
    for exponent in 0..=8 {
        let ea = 10f64.powi(exponent);
        add("EA", "EA", ea, Material { ea, ..default }, [0, 8].contains(&exponent));
    }
    for k in [0.0, 1e-4, 1e-2, 1.0, 10.0, 1e2, 1e3, 1e4, 1e5] {
        let quick = [0.0, 1e5].contains(&k);
        add("k_fold", "k_fold", k, Material { k_fold: k, ..default }, quick);
        add("k_facet", "k_facet", k, Material { k_facet: k, ..default }, quick);
        add("k_face", "k_face", k, Material { k_face: k, ..default }, quick);
    }
    for zeta in [0.0, 0.01, 0.1, 0.2, 0.45, 0.7, 1.0, 1.5, 2.0] {
        add("zeta", "zeta", zeta, Material { zeta, ..default }, [0.0, 2.0].contains(&zeta));
    }
    let place = |family| ["EA", "k_fold", "k_facet", "k_face", "zeta"].iter().position(|f| *f == family);
    cases.sort_by_key(|case| (place(case.family), case.pattern_name != "Miura 4x4"));
    cases
}

fn hubs() -> Vec<Case> {
    let case = |valence: usize| {
        let case = Case::new("valence", "hub", Ok(hub(valence, in_turn)));
        case.with("valence", valence as f64).quick([3, 32].contains(&valence))
    };
    [3, 4, 5, 6, 7, 8, 12, 16, 24, 32, 64, 128, 256].map(case).into()
}

/// Slivers, and edges of very different lengths.
fn thin() -> Vec<Case> {
    // In the model's radii; the crease is 2 long. The last two lie on both sides of what carries a spring.
    let heights = [0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3, 1e-4, 1e-5, 2e-6, 1.001e-6, 0.999e-6];
    let sliver = |height: f64| {
        let case = Case::new("slivers", "single crease", Ok(hinge(height, 1.0)));
        case.with("height / edge", height / 2.0).quick([0.01, 2e-6, 0.999e-6].contains(&height))
    };
    let ratios = [1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
    let pleat = |ratio: f64| {
        let case = Case::new("edge lengths", "narrow pleat", Ok(narrow_pleat(1.0 / ratio)));
        case.with("longest / shortest edge", ratio)
    };
    let nested = |ratio: f64| {
        let case = Case::new("edge lengths", "nested squares", Ok(nested_squares(ratio)));
        case.with("longest / shortest edge", ratio).quick(ratio == 1e6)
    };
    heights.into_iter().map(sliver).chain(ratios.into_iter().map(pleat)).chain(ratios.into_iter().map(nested)).collect()
}

fn placements() -> Vec<Case> {
    let scaled = |scale: f64| {
        let case = Case::new("scale of coordinates", "Miura 4x4", sheet().map(|p| placed(p, scale, 0.0)));
        case.with("scale", scale).quick(scale == 1e-9)
    };
    let shifted = |shift: f64| {
        let case = Case::new("scale of coordinates", "Miura 4x4", sheet().map(|p| placed(p, 1.0, shift)));
        case.with("distance from the origin", shift)
    };
    let scales = [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9];
    scales.into_iter().map(scaled).chain([1e3, 1e6, 1e9].into_iter().map(shifted)).collect()
}

/// Fold targets, beyond half a turn too, and percentages.
fn targets() -> Vec<Case> {
    let degrees = [-1080.0, -720.0, -360.0, -200.0, -180.0, 90.0, 180.0, 200.0, 270.0, 360.0, 720.0, 1080.0_f64];
    let turned = |degrees: f64| {
        let case = Case::new("fold targets", "single crease", Ok(hinge(0.8, degrees.to_radians())));
        case.with("target in degrees", degrees).sent_to(&[100.0]).quick([180.0, 720.0].contains(&degrees))
    };
    let percents = [-100.0, -60.0, -20.0, 0.0, 20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 200.0];
    let sheet_at = |percent: f64| {
        let case = Case::new("percent", "Miura 4x4", sheet()).with("percent", percent);
        case.sent_to(&[percent]).quick([-100.0, 0.0].contains(&percent))
    };
    let twist_at = |percent: f64| {
        let case = Case::new("percent", "square twist", catalog::generate("square-twist", &[]));
        case.with("percent", percent).sent_to(&[percent])
    };
    let turned = degrees.into_iter().map(turned);
    turned.chain(percents.into_iter().map(sheet_at)).chain(percents.into_iter().map(twist_at)).collect()
}

/// Letters that no rigid sheet can follow.
fn frustrated() -> Vec<Case> {
    let family = "cannot fold";
    let drawn = |seed: u32| {
        let pattern = miura(6, 6).map(|p| random_letters(p, u64::from(seed)));
        Case::new(family, "Miura 6x6, random letters", pattern).with("seed", f64::from(seed)).quick(seed == 1)
    };
    let mountains = |valence: usize| {
        let case = Case::new(family, "hub of mountains", Ok(hub(valence, |_| -1.0)));
        case.with("valence", valence as f64).quick(valence == 6)
    };
    let hypar = |degrees: f64| {
        let angle = degrees.to_radians();
        let pattern = Hypar { rings: 5, angle, alternating: false, ..Hypar::default() }.pattern();
        Case::new(family, "hypar of 5 squares", pattern).with("target in degrees", degrees).sent_to(&[100.0])
    };
    let mut cases: Vec<Case> = (1..=6).map(drawn).collect();
    cases.extend([3, 4, 6, 12, 32].map(mountains));
    cases.extend([90.0, 180.0].map(hypar));
    cases
}

fn disconnected() -> Vec<Case> {
    let family = "disconnected";
    let two = |distance: f64, scale: f64| {
        let other = placed(sheet()?, scale, distance);
        beside(sheet()?, &other)
    };
    let creases = || {
        let one = SingleCrease::default().pattern()?;
        (1..5).try_fold(one.clone(), |all, i| beside(all, &placed(one.clone(), 1.0, 3.0 * f64::from(i))))
    };
    let vertex = || beside(sheet()?, &placed(Degree4::default().pattern()?, 1.0, 10.0));
    vec![
        Case::new(family, "two Miuras 4x4", two(8.0, 1.0)).with("size of the second", 1.0).quick(true),
        Case::new(family, "two Miuras 4x4", two(8.0, 1e-3)).with("size of the second", 1e-3),
        Case::new(family, "five single creases", creases()),
        Case::new(family, "Miura 4x4 and a degree-4 vertex", vertex()),
    ]
}

/// The target jumps to one percentage, from there to the next.
fn jumps() -> Vec<Case> {
    let mut cases = Vec::new();
    for name in ["miura", "waterbomb", "kresling", "bird-base", "square-twist", "yoshimura", "fan"] {
        for path in [&[60.0, -60.0][..], &[60.0, -60.0, 100.0]] {
            let pattern = catalog::generate(name, &[]);
            let quick = name == "square-twist" && path.len() == 2;
            let case = Case::new("sudden jumps", name, pattern).sent_to(path).quick(quick);
            cases.push(case.with("jumps", path.len() as f64));
        }
    }
    cases
}

/// More nodes than can be waited for.
fn large() -> Vec<Case> {
    let of = |side: usize| {
        let nodes = (side + 1) * (side + 1);
        Case::new("large sheets", format!("Miura {side}x{side}"), miura(side, side)).with("nodes", nodes as f64)
    };
    [20, 100, 320].map(|side| of(side).large().quick(side == 20)).into()
}
