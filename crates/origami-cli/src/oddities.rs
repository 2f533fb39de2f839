//! What is allowed but odd about the command line: nothing that is asked for is dropped in silence.

use origami::solve::{DEFAULT_MAX_STEPS, Sweep};

use crate::args::{BackendName, FoldArgs, PictureArgs, RenderArgs, SolverName, SolvingArgs, SweepArgs, is_named};
use crate::draw;
use crate::files::Format;
use crate::numbers::plain;
use crate::threads;

/// What is allowed but odd about the arguments.
pub(crate) fn of_fold(args: &FoldArgs, formats: &[Format]) -> Vec<String> {
    let mut oddities = past_the_angles(&[args.percent]);
    oddities.extend(of_picture(&args.picture, &formats.iter().filter_map(|f| Drawn::of(*f)).collect::<Vec<_>>()));
    oddities.extend(without_effect(&args.solving, args.material.zeta.is_some(), args.perturbation.is_some()));
    let given = [("--from-flat", args.from_flat), ("--max-seconds", args.max_seconds.is_some())];
    let idle = given.iter().filter(|(_, given)| *given && args.solving.solver == SolverName::Reflect);
    oddities.extend(idle.map(|(name, _)| format!("{name} has no effect with --solver reflect")));
    let numbered = args.animate.as_ref().is_some_and(|path| Format::of(path) == Ok(Format::Png));
    if args.fps.is_some() && numbered && !formats.contains(&Format::Glb) {
        oddities.push("--fps has no effect on pictures with numbers".to_owned());
    }
    oddities.extend(threads::oddity(args.threads));
    oddities
}

/// What can be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Drawn {
    /// A folded sheet in pixels.
    Sheet,
    /// A crease pattern in pixels.
    Pattern,
    Svg,
    Glb,
}

impl Drawn {
    /// What `origami fold` draws as this.
    fn of(format: Format) -> Option<Self> {
        match format {
            Format::Png | Format::Contact | Format::Film => Some(Self::Sheet),
            Format::Svg => Some(Self::Svg),
            Format::Glb => Some(Self::Glb),
            _ => None,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Sheet => "pictures of sheets",
            Self::Pattern => "pictures of crease patterns",
            Self::Svg => "SVG",
            Self::Glb => "glTF",
        }
    }

    /// Whether an option of pictures changes it.
    fn heeds(self, option: &str) -> bool {
        use Drawn::{Glb, Pattern, Sheet, Svg};
        let by: &[Self] = match option {
            "--size" | "--background" => &[Sheet, Pattern, Svg],
            "--samples" | "--line-width" | "--caption" => &[Sheet, Pattern],
            "--camera" | "--azimuth" | "--elevation" | "--roll" | "--zoom" | "--perspective" | "--no-legend"
            | "--shading" => &[Sheet],
            "--strain" | "--map" | "--colours" | "--clip" => &[Sheet, Glb],
            _ => &[Sheet, Pattern, Svg, Glb],
        };
        by.contains(&self)
    }
}

/// The same of how pictures shall look.
pub(crate) fn of_picture(args: &PictureArgs, drawn: &[Drawn]) -> Vec<String> {
    if drawn.is_empty() {
        let given = *args != PictureArgs::default();
        return given.then(|| "options of pictures have no effect: none is asked for".to_owned()).into_iter().collect();
    }
    let mut names: Vec<&str> = Vec::new();
    for name in drawn.iter().map(|drawn| drawn.name()) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let idle = args.given().filter(|option| !drawn.iter().any(|drawn| drawn.heeds(option)));
    let mut oddities: Vec<String> =
        idle.map(|option| format!("{option} has no effect on {}", names.join(" and "))).collect();
    let without_map = args.idle_of_maps().filter(|option| drawn.iter().any(|drawn| drawn.heeds(option)));
    oddities.extend(without_map.map(|name| format!("{name} has no effect without --map or --strain")));
    let only_svg = drawn.iter().all(|drawn| !matches!(drawn, Drawn::Sheet | Drawn::Pattern));
    if let (Some([width, height]), true) = (args.size, only_svg && drawn.contains(&Drawn::Svg))
        && width != height
    {
        let longer = width.max(height);
        oddities
            .push(format!("--size {width}x{height}: SVG has the pattern's proportions, its longer side is {longer}"));
    }
    if !only_svg {
        oddities.extend(draw::oddities(args));
    }
    oddities
}

/// The same of `origami render`.
pub(crate) fn of_render(args: &RenderArgs, drawn: &[Drawn]) -> Vec<String> {
    let mut oddities = of_picture(&args.picture, drawn);
    if is_named(args.adapter.as_deref()) && args.backend != BackendName::Gpu {
        oddities.push("--adapter has no effect without --backend gpu".to_owned());
    }
    oddities
}

/// The same of a sweep, where either solver takes the perturbation.
pub(crate) fn of_sweep(args: &SweepArgs, sweep: &Sweep) -> Vec<String> {
    let mut oddities = past_the_angles(&sweep.percents);
    oddities.extend(without_effect(&args.solving, args.has_zeta(), false));
    if args.has_idle_seeds(sweep) {
        oddities.push("--seeds has no effect where --perturbation is 0".to_owned());
    }
    oddities.extend(threads::oddity(args.threads));
    oddities
}

fn past_the_angles(percents: &[f64]) -> Vec<String> {
    let past = percents.iter().find(|percent| percent.abs() > 100.0);
    past.map(|p| format!("--percent {}: folds past the pattern's own angles", plain(*p))).into_iter().collect()
}

fn without_effect(solving: &SolvingArgs, zeta: bool, perturbation: bool) -> Vec<String> {
    use SolverName::{Dynamics, Newton, Reflect, Relax};
    let given = [
        ("--time-step", &[Dynamics][..], solving.time_step.is_some()),
        ("--integrator", &[Dynamics], solving.integrator.is_some()),
        ("--zeta", &[Dynamics], zeta),
        ("--perturbation", &[Relax, Newton], perturbation),
        ("--steps", &[Relax, Dynamics], solving.steps.is_some()),
        ("--residual", &[Newton], solving.residual.is_some()),
        ("--precision", &[Relax, Dynamics], solving.precision.is_some()),
        ("--ramp", &[Relax, Dynamics, Newton], solving.ramp.is_some()),
        ("--max-steps", &[Relax, Dynamics, Newton], solving.max_steps != DEFAULT_MAX_STEPS),
    ];
    let given = given.iter().filter(|(_, solvers, given)| *given && !solvers.contains(&solving.solver));
    let mut oddities: Vec<String> =
        given.map(|(name, ..)| format!("{name} has no effect with --solver {}", solving.solver.name())).collect();
    if solving.steps.is_some() && matches!(solving.solver, Relax | Dynamics) && solving.max_steps != DEFAULT_MAX_STEPS {
        oddities.push("--max-steps has no effect with --steps".to_owned());
    }
    let named = is_named(solving.adapter.as_deref());
    if named && matches!(solving.solver, Newton | Reflect) {
        oddities.push(format!("--adapter has no effect with --solver {}", solving.solver.name()));
    } else if named && solving.precision.is_some() {
        oddities.push("--adapter has no effect with --precision".to_owned());
    } else if named && solving.backend == BackendName::Cpu {
        oddities.push("--adapter has no effect with --backend cpu".to_owned());
    } else if named && cfg!(not(feature = "gpu")) {
        oddities.push("--adapter has no effect in a build without the feature `gpu`".to_owned());
    }
    oddities
}
