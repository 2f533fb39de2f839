//! Options of the order in which creases fold, and of paper that goes through paper.

use std::path::PathBuf;

use clap::Args;

use super::values::positive;

/// Where a folding sequence is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum SequenceSource {
    /// In the file of the pattern itself.
    Own,
    /// In its frames: each is a step.
    Frames,
    /// In a file beside it.
    File(PathBuf),
}

impl ContactArgs {
    /// Whether paper is to be kept from going through paper.
    pub(crate) fn keeps_apart(&self) -> bool {
        let asked = self.contact_gap.or(self.contact_stiffness).or(self.thickness);
        self.contact || asked.is_some() || self.backwards
    }
}

impl SequenceSource {
    #[expect(clippy::unnecessary_wraps, reason = "as clap has it")]
    fn parse(text: &str) -> Result<Self, String> {
        Ok(match text {
            "own" => Self::Own,
            "frames" => Self::Frames,
            path => Self::File(path.into()),
        })
    }
}

/// Options of order and contact.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Order and contact")]
pub(crate) struct ContactArgs {
    /// Fold step by step: `own`, `frames` or a file of JSON [default: all creases at once]
    ///
    /// `own` is the sequence in the input (`origami:sequence`, or in short `edges_origami:timeline`, which goes to
    /// --percent); `frames` takes each frame after the pattern's as a step, to the fold angles that it has; a file beside
    /// the input has the same as `origami:sequence`. Each step comes to rest and is a frame of the output, under its name;
    /// with --frames N each is shown in N parts. docs/SEQUENCES.md has the format. With --solver relax, on the processor.
    #[arg(long, value_name = "own|frames|FILE", value_parser = SequenceSource::parse, conflicts_with = "from_flat")]
    pub(crate) sequence: Option<SequenceSource>,

    /// Keep paper from going through paper
    ///
    /// Layers push each other away from a small gap on, and no move takes anything through anything: a sheet that begins
    /// without crossings has none at the end. Friction is left out. A sheet that contact keeps from its angles ends blocked,
    /// with exit code 3: the faces that press and the crease that is farthest from its angle are told, and another order
    /// (--sequence) may help. With --solver relax, newton, which goes on from there to the equilibrium itself, or dynamics,
    /// whose steps become as short as contact asks for; on the processor or, relax where --backend gpu asks for it, on a GPU.
    /// Every state is tested as by --check. docs/CONTACT.md says more.
    #[arg(long, conflicts_with = "from_flat")]
    pub(crate) contact: bool,

    /// The gap from which layers push each other away, in units of the sheet's radius [default: 0.001]
    ///
    /// Smaller: layers lie closer and creases come nearer to their angles, for more steps. Implies --contact.
    #[arg(long, value_name = "X", value_parser = positive, conflicts_with = "from_flat")]
    pub(crate) contact_gap: Option<f64>,

    /// How stiff that push is, in the model's unit of force per radius [default: 50]
    ///
    /// Larger: layers under pressure keep more of the gap, for more steps; what is tucked deep into narrow folds may need it, with
    /// a smaller gap. Nothing goes through in either case. A beam has about 100. Implies --contact.
    #[arg(long, value_name = "K", value_parser = positive, conflicts_with = "from_flat")]
    pub(crate) contact_stiffness: Option<f64>,

    /// How thick the paper is, in the file's unit [default: 0]
    ///
    /// Layers come to lie so far from each other, measured between their middle planes; two faces that share a crease are a
    /// wedge, which is as thick at their centroids and closes at the crease. The gap is a tenth of it unless another is asked
    /// for. STL files have each face as a plate so thick.
    /// Implies --contact.
    #[arg(long, value_name = "T", value_parser = positive, conflicts_with = "from_flat")]
    pub(crate) thickness: Option<f64>,

    /// Find a motion to the flat-folded state by opening the sheet from there, and write it forwards
    ///
    /// For patterns that fold flat. An order of the layers is found that lets no paper go through paper, the layers are moved apart
    /// as little as can be, and contact keeps them so on the way to the open sheet: --frames N of the output (10 by default) show
    /// that way, those after them the layers closing up, the last one is exactly flat and has `faceOrders`. Not every pattern
    /// can be embedded so; the faces that cross are told. docs/CONTACT.md says how far it goes.
    #[arg(long, conflicts_with_all = ["from_flat", "sequence", "percent", "sheet", "thickness"])]
    pub(crate) backwards: bool,

    /// Tell where the folded sheet goes through itself, and which of its faces cross
    ///
    /// The test is exact, on every state that is settled. What touches does not cross: a sheet that lies flat with all its
    /// layers in one plane has no crossing. Layers that a solver brought to one plane but for its tolerance may cross as
    /// deep as that; the depth of the deepest crossing is told. docs/REPORT.md has the keys of --report.
    #[arg(long)]
    pub(crate) check: bool,
}
