//! `origami sweep`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;
use origami::measure::attitude::Hold;
use origami::model::{Material, MaterialGrid};
use origami::solve::{Relax, Sweep};

use super::hold::hold;
use super::list::List;
use super::shard::{Shard, shard};
use super::values::{at_least_zero, finite, index, positive, share, threads, whole};
use super::{ReadingArgs, SolverName, SolvingArgs};
use crate::files::Format;
use crate::numbers::grouped;

/// Instances of one sweep.
const MOST: usize = 1_000_000;

const EXAMPLES: &str = "\
Examples:
  origami sweep crane.fold --percent 0:100:5 --k-fold 0.1,0.7,7 -o out  63 sheets
  origami sweep crane.fold --percent 100:-100:-20 --folded obj -o out   Each as a file too
  origami sweep crane.fold --perturbation 0.003,0.03 --seeds 50 -o out  Where chance leads
  origami sweep crane.fold --percent 0:100:0.01 -o out --resume         On, after Ctrl-C
  origami sweep crane.fold --percent 0:100:0.01 -o out --shard 2/8      On the second machine of 8

Every combination is folded from the sheet as the file has it. Rows come in this order, the last
varying fastest: ea, k-fold, k-facet, k-face, zeta, perturbation, seed, percent.

Exit codes:
  0  all done and converged, or the asked number of steps done
  1  bad input or usage
  2  a state diverged; the tables say which, and have all the others
  3  the step limit came before convergence; the tables say where
  The most severe counts, in the order 1, 2, 3, 0; none stops the others.";

/// Fold one crease pattern in many ways.
///
/// Every combination of percentages, materials and perturbations, many at once. sweep.csv and sweep.json in the folder
/// have a row for each: how far it converged, strain, energy, angles. Rows are written as they come: what is done is kept
/// where a sweep ends early, and --resume goes on from there.
///
/// A LIST is numbers and ranges FROM:TO:STEP, separated by commas: `0.1,0.7,7`, `0:100:5`, `100:0:-10,-50`. A range has
/// its end where a step leads there.
#[derive(Args)]
#[command(
    after_help = EXAMPLES,
    override_usage = "origami sweep [OPTIONS] <INPUT> -o <DIR>",
    mut_arg("max_steps", |arg| arg.help("Steps after which to give up; all attempts together")),
    mut_arg("steps", |arg| arg.help("Run exactly N steps, converged or not")),
    mut_arg("ramp", |arg| {
        let defaults = "[default: dynamics 0; relax 400, more above 300 vertices]";
        arg.help(format!("Steps over which the fold angles rise; 0 is a jump {defaults}"))
    })
)]
pub(crate) struct SweepArgs {
    /// A crease pattern: FOLD, CP, OPX, ORI, SVG, OBJ or another; `-` is standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: PathBuf,

    /// The folder for sweep.csv and sweep.json, made where it is missing; docs/REPORT.md has the keys
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,

    /// Write each folded sheet too, as DIR/0000.EXT and so on, numbered as the rows
    #[arg(long, value_name = "FORMAT", value_delimiter = ',')]
    pub(crate) folded: Vec<Format>,

    /// How far to fold: 100 is all the way, 0 flat, -100 the other way
    #[arg(long, value_name = "LIST", value_parser = |text: &str| List::parse(text, finite),
        default_value_t = List::of(100.0), allow_hyphen_values = true)]
    percent: List,

    /// Take each perturbation in N different directions
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1..=MOST as u64), default_value_t = 1)]
    seeds: u64,

    /// Which frame of the input to fold: 0 is the key frame [default: the first with vertex positions]
    #[arg(long, value_name = "N", value_parser = index)]
    pub(crate) frame: Option<usize>,

    /// What keeps its place: `sheet`, `none` or the number of a face [default: sheet]
    ///
    /// Folding does not say how the folded sheet lies. With `sheet` it lies as near as can be to where it lay before, by
    /// rotation and translation alone, and flat where it is folded flat; a face stays where it lay itself; with `none` the
    /// sheet lies where the solver left it. Sheets with fixed vertices are not turned, unless by a face that is named here.
    #[arg(long, value_name = "FACE", value_parser = hold)]
    pub(crate) hold: Option<Hold>,

    /// How many sheets to fold at once [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = threads)]
    pub(crate) threads: Option<NonZeroUsize>,

    /// Go on where a sweep into the same folder ended early
    ///
    /// The rows that are there are taken; all settings and the pattern must be those they were made with. Without it they
    /// are replaced.
    #[arg(long)]
    pub(crate) resume: bool,

    /// Fold only part I of N, for many machines: `2/8`, or `slurm`, `pbs/N`, `kubernetes/N` in a job array
    ///
    /// Parts are as equal as can be and may all go to one folder; `origami merge` makes the tables of the whole sweep of
    /// theirs. In an array of jobs the environment tells I: slurm also tells N, pbs counts from 1, kubernetes from 0.
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub(crate) shard: Option<Shard>,

    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// How the input is read.
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,

    /// The way of solving.
    #[command(flatten)]
    pub(crate) solving: SolvingArgs,

    /// How far each vertex is moved at the start, as a share of its shortest beam; 0 is not at all [default: relax
    /// and newton 0.01, dynamics 0]
    ///
    /// Nothing is moved where nothing is to be folded.
    #[arg(long, value_name = "LIST", value_parser = |text: &str| List::parse(text, share), help_heading = "Solver")]
    perturbation: Option<List>,

    /// The paper.
    #[command(flatten)]
    material: MaterialLists,
}

/// Options that make a [`MaterialGrid`].
#[derive(Args)]
#[command(next_help_heading = "Material (all numbers hold for a sheet scaled to radius 1)")]
struct MaterialLists {
    /// Axial rigidity of the paper; higher: less strain, slower
    #[arg(long, value_name = "LIST", value_parser = |text: &str| List::parse(text, positive),
        default_value_t = List::of(Material::default().ea))]
    ea: List,
    /// Stiffness of mountain and valley creases; higher: nearer to their angles, more strain
    #[arg(long, value_name = "LIST", value_parser = |text: &str| List::parse(text, at_least_zero),
        default_value_t = List::of(Material::default().k_fold))]
    k_fold: List,
    /// Stiffness of flat creases inside faces; higher: flatter faces
    #[arg(long, value_name = "LIST", value_parser = |text: &str| List::parse(text, at_least_zero),
        default_value_t = List::of(Material::default().k_facet))]
    k_facet: List,
    /// Stiffness of the corner angles of triangles; higher: less shear
    #[arg(long, value_name = "LIST", value_parser = |text: &str| List::parse(text, at_least_zero),
        default_value_t = List::of(Material::default().k_face))]
    k_face: List,
    /// Damping ratio, for `--solver dynamics` only [default: 0.45]
    #[arg(long, value_name = "LIST", value_parser = |text: &str| List::parse(text, at_least_zero))]
    zeta: Option<List>,
}

impl SweepArgs {
    /// What is to be folded, and how many sheets that are.
    ///
    /// # Errors
    /// That there are too many.
    pub(crate) fn sweep(&self) -> Result<(Sweep, usize), String> {
        let List(percents) = self.percent.clone();
        let perturbations = self.perturbation.clone().map_or_else(|| vec![self.default_perturbation()], |list| list.0);
        let grid = self.grid();
        let seeds = usize::try_from(self.seeds).ok();
        let counts = [grid.count(), Some(percents.len()), Some(perturbations.len()), seeds];
        let count = counts.into_iter().try_fold(1_usize, |product, count| product.checked_mul(count?));
        match count {
            Some(count) if count <= MOST => {
                let mut materials = grid.materials();
                if self.solving.solver == SolverName::Dynamics {
                    // The paper's motion has the paper's springs.
                    materials.iter_mut().for_each(|material| material.collapse = Material::paper().collapse);
                }
                Ok((Sweep { percents, materials, perturbations, seeds: self.seeds }, count))
            }
            _ => {
                let number = count.map_or_else(|| "more than can be counted".to_owned(), |n| grouped(n as u64));
                let most = grouped(MOST as u64);
                Err(format!("the lists combine to too many sheets, {number}; expected at most {most}"))
            }
        }
    }

    /// The numbers that materials are made of.
    pub(crate) fn grid(&self) -> MaterialGrid {
        let material = &self.material;
        MaterialGrid {
            ea: material.ea.0.clone(),
            k_fold: material.k_fold.0.clone(),
            k_facet: material.k_facet.0.clone(),
            k_face: material.k_face.0.clone(),
            zeta: material.zeta.clone().map_or_else(|| vec![Material::default().zeta], |list| list.0),
        }
    }

    /// That of `origami fold`.
    fn default_perturbation(&self) -> f64 {
        match self.solving.solver {
            SolverName::Relax | SolverName::Newton => Relax::default().perturbation,
            SolverName::Dynamics | SolverName::Reflect => 0.0,
        }
    }

    /// All numbers of the materials with their options.
    pub(crate) fn named_material(&self) -> Vec<(&'static str, f64)> {
        let MaterialLists { ea, k_fold, k_facet, k_face, zeta } = &self.material;
        let lists = [("--ea", ea), ("--k-fold", k_fold), ("--k-facet", k_facet), ("--k-face", k_face)];
        let lists = lists.into_iter().chain(zeta.as_ref().map(|zeta| ("--zeta", zeta)));
        lists.flat_map(|(name, list)| list.0.iter().map(move |x| (name, *x))).collect()
    }

    /// Whether other directions are asked for of what is not moved.
    pub(crate) fn has_idle_seeds(&self, sweep: &Sweep) -> bool {
        self.seeds > 1 && sweep.perturbations.iter().all(|x| *x == 0.0)
    }

    /// Whether damping is asked for.
    pub(crate) fn has_zeta(&self) -> bool {
        self.material.zeta.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_texts_tell_the_defaults() {
        let definition = SweepArgs::augment_args(clap::Command::new("test"));
        for (name, default) in [
            ("zeta", format!("[default: {}]", Material::default().zeta)),
            ("perturbation", format!("[default: relax and newton {}, dynamics 0]", Relax::default().perturbation)),
        ] {
            let help = definition.get_arguments().find(|a| a.get_id() == name).and_then(|a| a.get_help());
            assert!(help.expect("a help text").to_string().ends_with(&default), "{name}");
        }
    }
}
