//! `origami analyse`.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::values::index;
use super::{MaterialArgs, ReadingArgs};

const EXAMPLES: &str = "\
Examples:
  origami analyse path kresling.fold press.json -o out         Press it, through every limit point
  origami analyse equilibria kresling.fold press.json -o out   Its states without load, and barriers between them
  origami analyse stiffness kresling.fold press.json -o out    How it answers to the first bit of load
  origami analyse modes kresling.fold -n 12 -o out             How it vibrates
  origami analyse buckling column.fold press.json -o out       At which load it buckles, roughly
  origami analyse path --help                                  What a job says, and all settings

docs/ANALYSIS.md is a tutorial.";

const PATH_EXAMPLES: &str = "\
Examples:
  origami analyse path kresling.fold press.json -o out
  origami analyse path loaded.fold -o out                  Supports and loads are in the file
  origami analyse path kresling.fold press.json --restart out/path.json -o further
  origami analyse path kresling.fold press.json --restart out/path.json --branch 0 -o aside

A job is JSON; all keys may be left out:
  {\"supports\": [{\"on\": {\"box\": [[null, null, null], [null, null, 0.01]]}, \"fixed\": true}],
   \"loads\": [{\"on\": {\"vertices\": [6, 7, 8]}, \"force\": [0, 0, -1]}],
   \"path\": {\"ends\": [[6, \"z\", -0.5]], \"monitor\": [[6, \"z\"]]}}

Exit codes:
  0  the path ended where it was to end, or has as many points as were asked for
  1  bad input or usage
  3  no step led on: what is controlled turns back, or facets have met";

const MODES_EXAMPLES: &str = "\
Examples:
  origami analyse modes kresling.fold press.json -n 12 -o out
  origami analyse modes kresling.fold press.json --at out/frames.fold --at-frame 9 -n 3 -o loaded
  origami analyse modes kresling.fold press.json -n 3 --animate modes.apng -o out";

/// Analyse a sheet as a structure: held, loaded, and followed through snap-through.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct AnalyseArgs {
    /// What to find out.
    #[command(subcommand)]
    pub(crate) analysis: Analysis,
}

/// What to find out.
#[derive(Subcommand)]
pub(crate) enum Analysis {
    Path(PathArgs),
    Equilibria(EquilibriaArgs),
    Stiffness(StiffnessArgs),
    Modes(ModesArgs),
    Buckling(BucklingArgs),
}

/// What is analysed, and where the results go.
#[derive(Args)]
pub(crate) struct SubjectArgs {
    /// A crease pattern, folded or not: FOLD or another format; `-` is standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: PathBuf,

    /// What it is made of, where it is held and loaded [default: what the file has under `origami:analysis`]
    #[arg(value_name = "JOB")]
    pub(crate) job: Option<PathBuf>,

    /// The folder to write into; made if it is missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,

    /// Which frame of the input is analysed: 0 is the key frame [default: the first with vertex positions]
    #[arg(long, value_name = "N", value_parser = index)]
    pub(crate) frame: Option<usize>,

    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// How the input is read.
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,

    /// The paper, where the job does not say it.
    #[command(flatten)]
    pub(crate) material: MaterialArgs,
}

/// Follow the equilibria as a load grows, through limit points where it turns back.
///
/// Writes curve.csv (every point), path.json (limit points, bifurcations and states without load, with the job, laws and
/// units), curve.svg (load over displacement) and frames.fold (the sheet on its way). Files are written whole or not at all.
#[derive(Args)]
#[command(after_help = PATH_EXAMPLES)]
pub(crate) struct PathArgs {
    /// What is analysed.
    #[command(flatten)]
    pub(crate) subject: SubjectArgs,

    /// Go on where an earlier path ended: its path.json
    #[arg(long, value_name = "FILE")]
    pub(crate) restart: Option<PathBuf>,

    /// With --restart, leave the earlier path at a bifurcation: the number of one of its `branches`
    #[arg(long, value_name = "N", requires = "restart")]
    pub(crate) branch: Option<usize>,

    /// How many sheets on the way go into frames.fold, evenly spread over the points
    #[arg(long, value_name = "N", default_value_t = 50)]
    pub(crate) frames: usize,

    /// A film of the sheets in frames.fold: a file of kind .apng or .gif, or .png for one file for each picture
    #[arg(long, value_name = "OUT")]
    pub(crate) animate: Option<PathBuf>,
}

/// Find the states without load on a path, and the barriers between them.
///
/// Follows the path of the job and writes equilibria.json (energy, negative directions, and the barrier to the next stable
/// state where a saddle lies between) and equilibria.fold (a frame for each).
#[derive(Args)]
#[command(after_help = "Example:\n  origami analyse equilibria kresling.fold press.json -o out")]
pub(crate) struct EquilibriaArgs {
    /// What is analysed.
    #[command(flatten)]
    pub(crate) subject: SubjectArgs,
}

/// Find how the sheet as drawn answers to the first bit of its load.
///
/// Writes stiffness.json: displacements, reactions and compliance (the work of the load) for a load factor of 1 by linear
/// analysis. Where the job has a `cell`, by which the sheet repeats itself, it also has the moduli of the whole sheet.
#[derive(Args)]
#[command(after_help = "Example:\n  origami analyse stiffness kresling.fold press.json -o out")]
pub(crate) struct StiffnessArgs {
    /// What is analysed.
    #[command(flatten)]
    pub(crate) subject: SubjectArgs,
}

/// Find how the sheet vibrates, as drawn or in a state of a path.
///
/// Writes modes.json (eigenvalues, frequencies where the job has masses, and whether a mode folds creases, bends facets or
/// stretches bars) and modes.fold (a frame for each mode, with the sheet moved by it). Supports hold; on the sheet as drawn no
/// loads act.
#[derive(Args)]
#[command(after_help = MODES_EXAMPLES)]
pub(crate) struct ModesArgs {
    /// What is analysed.
    #[command(flatten)]
    pub(crate) subject: SubjectArgs,

    /// How many, the lowest first
    #[arg(short = 'n', long, value_name = "N", default_value_t = 12)]
    pub(crate) count: usize,

    /// How far the node that moves farthest is moved in modes.fold, in radii of the sheet
    #[arg(long, value_name = "RADII", default_value_t = 0.1)]
    pub(crate) amplitude: f64,

    /// Of a state under load: a frames.fold of `origami analyse path`, or another file of the same sheet
    #[arg(long, value_name = "FILE")]
    pub(crate) at: Option<PathBuf>,

    /// Which frame of --at: 0 is the key frame, the sheet as drawn [default: the last]
    #[arg(long, value_name = "N", value_parser = index, requires = "at")]
    pub(crate) at_frame: Option<usize>,

    /// A film of the modes, one after the other: a file of kind .apng or .gif, or .png for one file for each picture
    #[arg(long, value_name = "OUT")]
    pub(crate) animate: Option<PathBuf>,
}

/// Find at which load the sheet buckles, by linear analysis.
///
/// Writes buckling.json (critical load factors) and buckling.fold (a frame for each, with the sheet moved by its shape). It
/// takes the sheet to answer to all of its load as to the first bit: where it deforms much before it buckles, or snaps, only
/// `origami analyse path` tells.
#[derive(Args)]
#[command(after_help = "Example:\n  origami analyse buckling column.fold press.json -n 3 -o out")]
pub(crate) struct BucklingArgs {
    /// What is analysed.
    #[command(flatten)]
    pub(crate) subject: SubjectArgs,

    /// How many critical loads, the smallest first
    #[arg(short = 'n', long, value_name = "N", default_value_t = 3)]
    pub(crate) count: usize,

    /// How far the node that moves farthest is moved in buckling.fold, in radii of the sheet
    #[arg(long, value_name = "RADII", default_value_t = 0.1)]
    pub(crate) amplitude: f64,
}
