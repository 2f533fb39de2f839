//! `origami fold`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use origami::measure::attitude::Hold;
use origami::solve::{DEFAULT_MAX_STEPS, DEFAULT_TOLERANCE, TimeStep};

use super::hold::hold;
use super::values::{finite, index, positive, share, steps, threads, time_step, whole};
use super::{ContactArgs, MaterialArgs, PictureArgs, ReadingArgs};
use crate::files::Format;

const EXAMPLES: &str = "\
Examples:
  origami fold crane.fold -o folded.fold                   Fold all the way
  origami fold crane.fold --percent 90 -o a.fold -o a.obj  To 90 %, as two files
  origami fold crane.fold --frames 20 -o film.fold         An animation of 20 stages
  origami fold crane.fold --percent 90 -o a.png --strain   A picture of the strain
  origami fold crane.fold --frames 60 --animate film.apng  A film of the folding
  origami fold *.fold -o out/ --format obj --report r.json Many at once, into a folder
  origami fold crane.fold --percent 60 --check             Which faces go through others
  origami fold crane.fold --sequence steps.json -o a.fold  One step after the other
  origami fold twist.fold --backwards -o film.fold         A way that is found from the flat state
  origami fold - -o - < crane.fold > folded.fold           As a filter
  origami fold crane.fold --solver reflect -o flat.fold    The flat-folded state itself, at once
  origami fold crane.fold --percent 60 --from-flat -o a.fold  Opened from there, not closed from the sheet
  origami fold crane.fold --solver dynamics --time-step paper --percent 60 --steps 300 -o a.fold
                                                           300 steps of the paper's own scheme

Exit codes:
  0  done and converged, or the asked number of steps done
  1  bad input or usage
  2  the state diverged; no geometry is written and older files stay as they were
  3  the step limit, or that of time, came before convergence, or contact blocks the sheet; the
     output is written and says so
  Of several inputs the most severe counts, in the order 1, 2, 3, 0; none stops the others.";

/// The environment variable that stands in for `--adapter`.
pub(crate) const ADAPTER_VARIABLE: &str = "ORIGAMI_ADAPTER";

/// Whether an adapter is named for this run: what the environment names is meant for others too.
pub(crate) fn is_named(adapter: Option<&str>) -> bool {
    adapter.is_some() && adapter.map(str::to_owned) != std::env::var(ADAPTER_VARIABLE).ok()
}

/// Fold crease patterns.
///
/// Reads crease patterns, folds each sheet to a percentage of its fold angles and writes the folded form. The units and the
/// numbering of vertices, edges and faces are those of the input. A line on standard output says whether it converged,
/// how strained the sheet is and how long it took. Files are written whole or not at all.
#[derive(Args)]
#[command(after_help = EXAMPLES, override_usage = "origami fold [OPTIONS] <INPUT>... -o <OUT>")]
pub(crate) struct FoldArgs {
    /// Crease patterns: FOLD, CP, OPX, ORI, SVG, OBJ and others; `-` is standard input
    #[arg(value_name = "INPUT", required = true)]
    pub(crate) inputs: Vec<PathBuf>,

    /// Where to write; can be given more than once
    ///
    /// The extension tells the format: .fold, .obj, .stl (binary), .glb (binary glTF), .html (a page with the folding
    /// as a film that one can turn; --frames says of how many stages), .png (a picture) or .svg (a picture
    /// of the crease pattern; `origami convert` writes one for plotters). `-` is FOLD on standard output. A folder (one that exists, or a path that ends in `/`, which is
    /// made) takes one file for each input, with the name of the input; several inputs need one.
    #[arg(short, long = "output", value_name = "OUT", required_unless_present_any = ["report", "png", "sheet", "animate", "check"])]
    pub(crate) outputs: Vec<PathBuf>,

    /// A picture of the folded sheet: the same as -o OUT.png
    #[arg(long, value_name = "OUT.png")]
    pub(crate) png: Option<PathBuf>,

    /// One picture of the crease pattern and all stages of --frames [default: 4 after the flat one]
    #[arg(long, value_name = "OUT.png")]
    pub(crate) sheet: Option<PathBuf>,

    /// A film of the stages of --frames, of a --turntable or of both
    ///
    /// The extension tells the format: .apng, .gif, or .png for one file for each picture, numbered: DIR/a-.png becomes
    /// DIR/a-000.png and so on, in a folder that is made where it is missing.
    #[arg(long, value_name = "OUT")]
    pub(crate) animate: Option<PathBuf>,

    /// Formats of the files in folders [default: fold]
    #[arg(long = "format", value_name = "FORMAT", value_delimiter = ',')]
    pub(crate) formats: Vec<Format>,

    /// How far to fold: 100 is all the way, 0 flat, -100 the other way
    #[arg(long, value_name = "P", value_parser = finite, default_value_t = 100.0, allow_negative_numbers = true)]
    pub(crate) percent: f64,

    /// Settle N stages after the flat one, and write an animation
    ///
    /// The stages are evenly spaced up to the percentage; with --from-flat, down to it. FOLD and glTF files then hold all of
    /// them, OBJ, STL and PNG files the last.
    #[arg(long, value_name = "N", value_parser = whole::<u32>(1..=100_000))]
    pub(crate) frames: Option<u32>,

    /// Go once round the sheet in N pictures of --animate; with --frames while it folds
    ///
    /// If N is more than there are stages the last stage stays; if less, the round begins again.
    #[arg(long, value_name = "N", requires = "animate", value_parser = whole::<u32>(1..=100_000))]
    pub(crate) turntable: Option<u32>,

    /// Pictures in a second of --animate, 1 to 100 [default: 20]
    #[arg(long, value_name = "X", requires = "animate", value_parser = whole::<u16>(1..=100))]
    pub(crate) fps: Option<u16>,

    /// Which frame of the input to fold: 0 is the key frame [default: the first with vertex positions]
    #[arg(long, value_name = "N", value_parser = index)]
    pub(crate) frame: Option<usize>,

    /// What keeps its place: `sheet`, `none` or the number of a face [default: sheet]
    ///
    /// Folding does not say how the folded sheet lies. With `sheet` it lies as near as can be to where it lay before, by
    /// rotation and translation alone, and flat where it is folded flat; a face stays where it lay itself; with `none` the
    /// sheet lies where the solver left it. Pictures, films and files have the same. Sheets with fixed vertices are not
    /// turned, unless by a face that is named here.
    #[arg(long, value_name = "FACE", value_parser = hold)]
    pub(crate) hold: Option<Hold>,

    /// Write what was built, done and measured as JSON; `-` is standard output
    ///
    /// One object for one input, an array for several. docs/REPORT.md has the keys.
    #[arg(long, value_name = "FILE")]
    pub(crate) report: Option<PathBuf>,

    /// How many threads to fold with [default: as many as there are processors]
    ///
    /// One input is shared out among them if it is large and that is faster; of several, each takes one. Outputs do not
    /// depend on it. More than 64 are used only where there are so many processors.
    #[arg(long, value_name = "N", value_parser = threads)]
    pub(crate) threads: Option<NonZeroUsize>,

    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// How the input is read.
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,

    /// The way of solving.
    #[command(flatten)]
    pub(crate) solving: SolvingArgs,

    /// Begin at the exact flat-folded state and open the sheet from there
    ///
    /// For patterns that fold flat, and less than 100 %: no crease closes the wrong way on a way that is not gone. States of
    /// creases that hinder each other are often lower than those from the open sheet. With a negative percentage it begins at
    /// -100 %.
    #[arg(long, help_heading = "Solver")]
    pub(crate) from_flat: bool,

    /// Seconds after which to give up, for each input; all its stages together [default: none]
    ///
    /// What has been reached by then is written, as at --max-steps. The clock is looked at every 50 steps.
    #[arg(long, value_name = "S", value_parser = positive, help_heading = "Solver")]
    pub(crate) max_seconds: Option<f64>,

    /// How far relax moves each vertex at the start, as a share of its shortest beam; 0 is not at all [default: 0.01]
    ///
    /// A symmetric sheet would else stay on the saddle between two ways to buckle. Larger: saddles are left sooner. So too
    /// with newton, which begins with relax.
    #[arg(long, value_name = "X", value_parser = share, help_heading = "Solver")]
    pub(crate) perturbation: Option<f64>,

    /// The paper.
    #[command(flatten)]
    pub(crate) material: MaterialArgs,

    /// In which order, and whether paper goes through paper.
    #[command(flatten)]
    pub(crate) contact: ContactArgs,

    /// How pictures look.
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// Options of the solver.
#[derive(Args)]
#[command(next_help_heading = "Solver")]
pub(crate) struct SolvingArgs {
    /// What computes
    #[arg(long, value_enum, value_name = "BACKEND", default_value_t = BackendName::Auto)]
    pub(crate) backend: BackendName,

    /// The GPU adapter to use: part of a name that `origami adapters` lists, in whatever case [default: the first]
    ///
    /// `--backend auto` takes it only if it is hardware.
    #[arg(long, value_name = "NAME", env = ADAPTER_VARIABLE, hide_env_values = true)]
    pub(crate) adapter: Option<String>,

    /// How the folded state is found
    #[arg(long, value_enum, value_name = "SOLVER", default_value_t = SolverName::Relax)]
    pub(crate) solver: SolverName,

    /// The numbers in which the processor computes [default: f64]
    ///
    /// Where it is given, `--backend auto` is the processor. GPUs compute in f32, with places in two parts.
    #[arg(long, value_enum, value_name = "PRECISION")]
    pub(crate) precision: Option<PrecisionName>,

    /// Distance from the equilibrium at which to stop, in units of the sheet's radius
    ///
    /// With newton: at which relax hands over to it. With reflect: how far the sheet may miss itself.
    #[arg(long, value_name = "T", value_parser = positive, default_value_t = DEFAULT_TOLERANCE)]
    pub(crate) tolerance: f64,

    /// Largest force on a vertex at which newton stops, in the model's unit of force [default: 1e-10]
    #[arg(long, value_name = "F", value_parser = positive)]
    pub(crate) residual: Option<f64>,

    /// Steps after which to give up, for each stage; all its attempts together
    #[arg(long, value_name = "N", value_parser = steps, default_value_t = DEFAULT_MAX_STEPS)]
    pub(crate) max_steps: u64,

    /// Run exactly N steps, converged or not; with --frames, N for each stage
    #[arg(long, value_name = "N", value_parser = steps)]
    pub(crate) steps: Option<u64>,

    /// Steps over which the fold angles rise; 0 is a jump [default: dynamics 0; relax 400, more above 300 vertices,
    /// shared by the stages]
    #[arg(long, value_name = "N", value_parser = whole::<u32>(0..=u32::MAX.into()))]
    pub(crate) ramp: Option<u32>,

    /// Length of a step of dynamics: `paper`, `safe` or a number [default: paper]
    ///
    /// `paper` is the paper's, which blows up on thin triangles, hubs and stiff creases. `safe` is a bound that holds,
    /// renewed as the sheet folds. A number is in units of the model's time.
    #[arg(long, value_name = "paper|safe|SECONDS", value_parser = time_step, allow_negative_numbers = true)]
    pub(crate) time_step: Option<TimeStep>,

    /// How dynamics steps through time [default: euler]
    #[arg(long, value_enum, value_name = "INTEGRATOR")]
    pub(crate) integrator: Option<IntegratorName>,
}

/// What computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum BackendName {
    /// A hardware GPU, if there is one, for 10000 vertices or more (an estimate, not measured); else the processor
    Auto,
    /// The processor
    Cpu,
    /// A GPU; a software one where there is no other
    Gpu,
}

/// The numbers in which the processor computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PrecisionName {
    /// f64 throughout
    F64,
    /// Places in f64, all else in f32: faster, for tolerances of 1e-6 and more
    Mixed,
}

/// How the folded state is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SolverName {
    /// Straight to the folded state, by FIRE
    Relax,
    /// The paper's motion through time; slow to converge
    Dynamics,
    /// Relax, then Newton's method to the equilibrium itself: what errors are measured against
    Newton,
    /// The exact flat-folded state, by reflecting the faces; at 100 or -100 % of patterns that fold flat
    Reflect,
}

impl SolverName {
    /// As on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Relax => "relax",
            Self::Dynamics => "dynamics",
            Self::Newton => "newton",
            Self::Reflect => "reflect",
        }
    }
}

/// How dynamics steps through time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum IntegratorName {
    /// The paper's, of first order
    Euler,
    /// Velocity Verlet, of second order
    Verlet,
}

#[cfg(test)]
mod tests {
    use origami::solve::Relax;

    use super::*;

    #[test]
    fn the_text_tells_the_default_of_perturbation() {
        let definition = FoldArgs::augment_args(clap::Command::new("test"));
        let help = definition.get_arguments().find(|a| a.get_id() == "perturbation").and_then(|a| a.get_help());
        let default = format!("[default: {}]", Relax::default().perturbation);
        assert!(help.expect("perturbation has a help text").to_string().ends_with(&default));
    }

    #[cfg(feature = "newton")]
    #[test]
    fn the_text_tells_the_default_of_residual() {
        let definition = FoldArgs::augment_args(clap::Command::new("test"));
        let help = definition.get_arguments().find(|a| a.get_id() == "residual").and_then(|a| a.get_help());
        let default = format!("[default: {:e}]", origami::Newton::default().residual);
        assert!(help.expect("residual has a help text").to_string().ends_with(&default));
    }

    #[cfg(feature = "gpu")]
    #[test]
    fn the_text_tells_from_which_size_a_gpu_is_taken() {
        let auto = BackendName::Auto.to_possible_value();
        let text = auto.as_ref().and_then(|value| value.get_help()).expect("auto has a help text").to_string();
        assert!(text.contains(&format!("for {} vertices or more", origami::gpu::AUTO_NODES)), "{text}");
        assert_eq!(text.contains("an estimate, not measured"), !origami::gpu::AUTO_NODES_MEASURED, "{text}");
    }
}
