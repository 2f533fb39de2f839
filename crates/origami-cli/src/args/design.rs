//! `origami design`.

use clap::Args;

use super::analyse::SubjectArgs;

const EXAMPLES: &str = "\
Examples:
  origami design kresling.fold height.json -o out    Its second state is to be at a certain height
  origami design miura.fold saddle.json -o out       Its creases' angles are to make it a saddle
  origami analyse equilibria out/design.fold height.json -o again

A job is JSON as for `origami analyse path`, with a `design`:
  {\"supports\": [{\"on\": {\"box\": [[null, null, null], [null, null, 0.01]]}, \"fixed\": true}],
   \"loads\": [{\"on\": {\"vertices\": [6, 7, 8]}, \"force\": [0, 0, -1]}],
   \"path\": {\"to\": null, \"ends\": [[6, \"z\", -0.5]]},
   \"design\": {\"state\": 2,
              \"goals\": [{\"height\": {\"of\": {\"vertices\": [6, 7, 8]}, \"above\": {\"vertices\": [0, 1, 2]},
                                  \"wanted\": 0.9}}],
              \"variables\": [{\"move\": {\"vertices\": [6, 7, 8]}, \"along\": [0, 0, 1], \"bounds\": [-0.3, 0.3]}]}}

Exit codes:
  0  every goal is reached, to a thousandth of what is wanted or of the sheet's size; shapes to a hundredth
  1  bad input or usage, or a state that is singular
  3  a goal is not reached: between these bounds, or in as many evaluations, nothing better was found

docs/ANALYSIS.md has two examples worked out.";

/// Find of what a sheet must be made so that it does what is wanted.
///
/// Changes rest angles, rest lengths, stiffnesses or the drawing itself between bounds, along gradients of exact equilibria, until
/// a state has a shape, a height, a fold angle, a barrier or a small compliance. Writes design.fold (the sheet with its new
/// numbers, and its states as frames) and design.json (goals and variables before and after, and how the value fell).
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct DesignArgs {
    /// What is designed.
    #[command(flatten)]
    pub(crate) subject: SubjectArgs,
}
