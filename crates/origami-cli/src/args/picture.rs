//! How pictures look: shared by `origami fold` and `origami render`.

use clap::{Args, ValueEnum};

use super::look::{Ground, LineSet};
use super::values::{finite, line_width, positive, size};

/// Options of pictures. What is not given is the library's default.
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(next_help_heading = "Picture")]
pub(crate) struct PictureArgs {
    /// Pixels across and down [default: 1000x800; 480x384 for each part of --sheet and for --animate]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub(crate) size: Option<[u32; 2]>,

    /// Samples of each pixel: 1, 4, 8 or 16; more are smoother and slower [default: 16]
    #[arg(long, value_name = "N", value_parser = samples)]
    pub(crate) samples: Option<u32>,

    /// From where [default: auto, or default if an angle is given]
    #[arg(long, value_enum, value_name = "VIEW")]
    pub(crate) camera: Option<CameraName>,

    /// Where the viewer stands: degrees from x towards y, in place of the camera's own
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    pub(crate) azimuth: Option<f64>,

    /// How high the viewer stands: 90 looks straight down, in place of the camera's own
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    pub(crate) elevation: Option<f64>,

    /// Turn the picture counterclockwise
    #[arg(long, value_name = "DEG", value_parser = finite, allow_negative_numbers = true)]
    pub(crate) roll: Option<f64>,

    /// Magnify; 1 shows everything
    #[arg(long, value_name = "X", value_parser = positive)]
    pub(crate) zoom: Option<f64>,

    /// What is far looks smaller: the angle of view, 5 to 120 [default: parallel lines stay parallel]
    #[arg(long, value_name = "DEG", value_parser = positive)]
    pub(crate) perspective: Option<f64>,

    /// Colours of paper, ground and lines
    #[arg(long, value_enum, value_name = "THEME")]
    pub(crate) theme: Option<ThemeName>,

    /// Light on the paper [default: soft]
    #[arg(long, value_enum, value_name = "SHADING")]
    pub(crate) shading: Option<ShadingName>,

    /// Behind the sheet: `transparent`, `white`, `black` or `#rrggbb`
    #[arg(long, value_name = "COLOUR", value_parser = Ground::parse)]
    pub(crate) background: Option<Ground>,

    /// Lines to draw: letters of MVBFCU, `all` or `none` [default: MVBCU; all in a crease pattern]
    ///
    /// Mountains, valleys, boundaries, flat creases and diagonals of faces, cuts, undriven creases.
    #[arg(long, value_name = "MVBFCU|all|none", value_parser = edges)]
    pub(crate) edges: Option<LineSet>,

    /// Make lines wider or thinner, 0.05 to 50; 1 is as the theme has them
    #[arg(long, value_name = "X", value_parser = line_width)]
    pub(crate) line_width: Option<f64>,

    /// Show strain as colours: the same as --map strain
    #[arg(long, conflicts_with = "map")]
    pub(crate) strain: bool,

    /// Show a quantity as colours, with a colour bar
    #[arg(long, value_enum, value_name = "QUANTITY")]
    pub(crate) map: Option<MapName>,

    /// Which colours a map has
    #[arg(long, value_enum, value_name = "COLOURS")]
    pub(crate) colours: Option<ColoursName>,

    /// The value that a map's last colour stands for, in the unit shown [default: the largest, rounded up]
    #[arg(long, value_name = "X", value_parser = positive)]
    pub(crate) clip: Option<f64>,

    /// Leave out the colour bar; where it would take more than two fifths of the width it is left out anyway
    #[arg(long)]
    pub(crate) no_legend: bool,

    /// A line of text below the sheet
    #[arg(long, value_name = "TEXT")]
    pub(crate) caption: Option<String>,
}

impl PictureArgs {
    /// What is to be mapped.
    pub(crate) fn quantity(&self) -> Option<MapName> {
        self.map.or(self.strain.then_some(MapName::Strain))
    }

    /// All options that are given.
    pub(crate) fn given(&self) -> impl Iterator<Item = &'static str> {
        let given = [
            ("--size", self.size.is_some()),
            ("--samples", self.samples.is_some()),
            ("--camera", self.camera.is_some()),
            ("--azimuth", self.azimuth.is_some()),
            ("--elevation", self.elevation.is_some()),
            ("--roll", self.roll.is_some()),
            ("--zoom", self.zoom.is_some()),
            ("--perspective", self.perspective.is_some()),
            ("--theme", self.theme.is_some()),
            ("--background", self.background.is_some()),
            ("--edges", self.edges.is_some()),
            ("--line-width", self.line_width.is_some()),
            ("--shading", self.shading.is_some()),
            ("--strain", self.strain),
            ("--map", self.map.is_some()),
            ("--colours", self.colours.is_some()),
            ("--clip", self.clip.is_some()),
            ("--no-legend", self.no_legend),
            ("--caption", self.caption.is_some()),
        ];
        given.into_iter().filter(|(_, given)| *given).map(|(name, _)| name)
    }

    /// Options of maps that are given without a map.
    pub(crate) fn idle_of_maps(&self) -> impl Iterator<Item = &'static str> {
        let given =
            [("--colours", self.colours.is_some()), ("--clip", self.clip.is_some()), ("--no-legend", self.no_legend)];
        let idle = self.quantity().is_none();
        given.into_iter().filter(move |(_, given)| *given && idle).map(|(name, _)| name)
    }
}

/// From where.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CameraName {
    /// A flat sheet from its face, any other from the left in front, above
    Auto,
    /// From the left in front, above
    Default,
    /// Straight down, as crease patterns are drawn
    Top,
    /// Along the sheet's plane
    Front,
    /// All three axes equally long
    Isometric,
}

/// Light on the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ShadingName {
    /// Valleys and what lies under a flap are darker
    Soft,
    /// Each face by the way that it is turned alone
    Flat,
    /// None: the colours of the theme
    None,
}

/// Colours of paper, ground and lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ThemeName {
    /// Dyed paper on white, the default
    Paper,
    /// White paper on white
    White,
    /// Greys; in patterns dashes tell mountain from valley
    Mono,
    /// For slides
    Dark,
}

/// What can be mapped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MapName {
    /// Mean strain of the beams at each vertex, in percent
    Strain,
    /// Mean strain of each triangle's sides, in percent
    FaceStrain,
    /// Fold angles reached against those asked for, in degrees
    AngleError,
    /// Energy over area
    Energy,
}

/// Colours of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColoursName {
    /// Even to the eye, the default
    Viridis,
    /// The same to those who confuse colours
    Cividis,
    /// From black over red to yellow
    Inferno,
    /// From blue to red by hue alone, as Origami Simulator has it
    Hue,
}

fn samples(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(n @ (1 | 4 | 8 | 16)) => Ok(n),
        _ => Err("expected 1, 4, 8 or 16".to_owned()),
    }
}

fn edges(text: &str) -> Result<LineSet, String> {
    text.parse().map_err(|_| "expected letters of MVBFCU, `all` or `none`".to_owned())
}
