//! From the command line to what the library draws.

use origami::Error;
use origami::picture::{
    Camera, ColourMap, Figure, Frame, LineSet, Map, Picture, Projection, Quantity, Rgb, Theme, View, legend,
    map::round_up, text,
};

use super::Subject;
use crate::args::{CameraName, ColoursName, Ground, MapName, PictureArgs, ShadingName, ThemeName};

/// How pictures look.
#[derive(Clone, Default)]
pub(crate) struct Style {
    picture: Picture,
    size: Option<[u32; 2]>,
    edges: Option<LineSet>,
    mapping: Option<Mapping>,
    /// Whether flat sheets are seen from their faces.
    auto: bool,
    /// Whether valleys and what lies under a flap are darker.
    soft: bool,
}

/// The least value that a map's last colour stands for unless one is asked for: percent of strain, degrees.
const LEAST: f64 = 1e-3;
/// The same of energy over area.
const LEAST_ENERGY: f64 = 1e-9;

/// What is shown as colours.
#[derive(Clone, Copy)]
struct Mapping {
    quantity: Quantity,
    colours: ColourMap,
    clip: Option<f64>,
}

impl Style {
    /// The style that the arguments ask for.
    ///
    /// # Errors
    /// A text that names what is out of range.
    pub(crate) fn new(args: &PictureArgs) -> Result<Self, String> {
        let mut picture = Picture { camera: camera(args)?, theme: theme(args), ..Picture::default() };
        picture.samples = args.samples.unwrap_or(picture.samples);
        picture.line_width = args.line_width.map_or(picture.line_width, |width| width as f32);
        picture.legend = !args.no_legend;
        picture.caption = args.caption.clone().unwrap_or_default();
        picture.edges = args.edges.unwrap_or(picture.edges);
        let mapping = args.quantity().map(|quantity| Mapping {
            quantity: quantity.into(),
            colours: args.colours.map_or(ColourMap::default(), ColourMap::from),
            clip: args.clip,
        });
        if args.shading == Some(ShadingName::None) {
            picture.theme.shading = 0.0;
        }
        let auto = match args.camera {
            None => args.azimuth.or(args.elevation).or(args.roll).is_none(),
            Some(name) => name == CameraName::Auto,
        };
        let soft = matches!(args.shading, None | Some(ShadingName::Soft));
        Ok(Self { picture, size: args.size, edges: args.edges, mapping, auto, soft })
    }

    /// The sheet in a state, with its shading and its map.
    pub(super) fn figure(&self, subject: Subject<'_>, state: &origami::State, clip: Option<f64>) -> Figure {
        let mut figure = Figure::of_state(subject.pattern, subject.model, state);
        if self.soft {
            figure.shade();
        }
        self.mapped(&mut figure, subject, state, clip);
        figure
    }

    /// The figure in another state.
    pub(super) fn move_to(&self, figure: &mut Figure, subject: Subject<'_>, state: &origami::State, clip: Option<f64>) {
        figure.move_to_state(subject.model, state);
        self.mapped(figure, subject, state, clip);
    }

    /// The picture with the camera that suits the sheet, if none was asked for.
    pub(super) fn facing(&self, picture: &Picture, suits: impl FnOnce() -> Camera) -> Picture {
        let Camera { zoom, projection, .. } = picture.camera;
        let camera = if self.auto { Camera { zoom, projection, ..suits() } } else { picture.camera };
        Picture { camera, ..picture.clone() }
    }

    /// The view in which the figure fills the picture.
    ///
    /// # Errors
    /// As for [`Picture::view`].
    pub(super) fn view(&self, picture: &Picture, figure: &Figure) -> Result<View, Error> {
        self.facing(picture, || figure.camera()).view(figure, figure.positions.iter().copied())
    }

    /// How wide a colour bar beside several pictures of this size is, in pixels; `None` without one.
    pub(super) fn bar_width(&self, size: [u32; 2]) -> Option<u32> {
        let Picture { width, height, legend, .. } = self.picture(size);
        let label = self.mapping?.quantity.label();
        (legend && legend::fits(label, width, height)).then(|| legend::bar_width(label, width, height))
    }

    /// A picture of the sheet; `size` holds where none was asked for.
    pub(super) fn picture(&self, size: [u32; 2]) -> Picture {
        let [width, height] = self.size.unwrap_or(size);
        Picture { width, height, ..self.picture.clone() }
    }

    /// A picture of the flat pattern.
    pub(super) fn pattern(&self, size: [u32; 2]) -> Picture {
        let picture = self.picture(size).for_pattern();
        Picture { edges: self.edges.unwrap_or(picture.edges), ..picture }
    }

    /// The map's scale for all states alike; `None` without a map.
    pub(super) fn clip(&self, subject: Subject<'_>) -> Option<f64> {
        let Mapping { quantity, colours, clip } = self.mapping?;
        let largest = |(_, state): &(f64, &origami::State)| {
            Map::new(quantity, subject.model, state, colours, None).values.largest()
        };
        // A scale of rounding errors would show them as if they were something.
        let least = match quantity {
            Quantity::EnergyDensity => LEAST_ENERGY,
            Quantity::Strain | Quantity::FaceStrain | Quantity::AngleError => LEAST,
        };
        Some(clip.unwrap_or_else(|| round_up(subject.states.iter().map(largest).fold(least, f64::max))))
    }

    /// The figure with its map, if there is one.
    pub(super) fn mapped(&self, figure: &mut Figure, subject: Subject<'_>, state: &origami::State, clip: Option<f64>) {
        let map = |m: Mapping| Map::new(m.quantity, subject.model, state, m.colours, clip);
        figure.map = self.mapping.map(map);
    }

    /// Whether nothing lies behind the sheet.
    pub(super) fn is_transparent(&self) -> bool {
        self.picture.theme.background.is_none()
    }
}

/// What is odd about pictures that are asked for: what is left out of them or cannot be written in them.
pub(crate) fn oddities(args: &PictureArgs) -> Vec<String> {
    let mut oddities = Vec::new();
    let missing = args.caption.as_deref().map(text::missing).unwrap_or_default();
    if !missing.is_empty() {
        oddities.push(format!("--caption: the font has no {}; drawn as boxes", quoted(&missing)));
    }
    if let (Some(quantity), Some([width, height]), false) = (args.quantity(), args.size, args.no_legend)
        && !legend::fits(Quantity::from(quantity).label(), width, height)
    {
        oddities.push(format!("--size {width}x{height}: no room for a colour bar beside the sheet, it is left out"));
    }
    oddities
}

/// Each character by itself, with its number: not every terminal has them either.
fn quoted(letters: &str) -> String {
    const MOST: usize = 8;
    let mut all: Vec<String> = letters
        .chars()
        .take(MOST)
        .map(|letter| format!("{} (U+{:04X})", letter.escape_debug(), u32::from(letter)))
        .collect();
    let more = letters.chars().count().saturating_sub(MOST);
    if more > 0 {
        all.push(format!("{more} more"));
    }
    all.join(", ")
}

fn camera(args: &PictureArgs) -> Result<Camera, String> {
    let mut camera = match args.camera {
        None | Some(CameraName::Auto | CameraName::Default) => Camera::default(),
        Some(CameraName::Top) => Camera::top(),
        Some(CameraName::Front) => Camera::front(),
        Some(CameraName::Isometric) => Camera::isometric(),
    };
    camera.azimuth = args.azimuth.unwrap_or(camera.azimuth);
    camera.elevation = args.elevation.unwrap_or(camera.elevation);
    camera.roll = args.roll.unwrap_or(camera.roll);
    camera.zoom = args.zoom.unwrap_or(camera.zoom);
    camera.projection = args.perspective.map_or(camera.projection, Projection::Perspective);
    // Tried on a point, so that nothing is folded for a camera that cannot be.
    let frame = Frame { width: 100, height: 100, margins: [0.0; 4] };
    let tried = camera.view([[0.0; 3], [1.0; 3]].into_iter(), &frame);
    tried.map(|_| camera).map_err(|error| error.to_string())
}

fn theme(args: &PictureArgs) -> Theme {
    let mut theme = match args.theme {
        None | Some(ThemeName::Paper) => Theme::paper(),
        Some(ThemeName::White) => Theme::white(),
        Some(ThemeName::Mono) => Theme::mono(),
        Some(ThemeName::Dark) => Theme::dark(),
    };
    match &args.background {
        None => {}
        Some(Ground::Transparent) => theme.background = None,
        Some(Ground::Plain(ground)) => {
            theme.background = Some(*ground);
            if theme.text.is_light() == ground.is_light() {
                theme.text = if ground.is_light() { Rgb::BLACK } else { Rgb::WHITE };
            }
        }
    }
    theme
}

impl From<MapName> for Quantity {
    fn from(name: MapName) -> Self {
        match name {
            MapName::Strain => Self::Strain,
            MapName::FaceStrain => Self::FaceStrain,
            MapName::AngleError => Self::AngleError,
            MapName::Energy => Self::EnergyDensity,
        }
    }
}

impl From<ColoursName> for ColourMap {
    fn from(name: ColoursName) -> Self {
        match name {
            ColoursName::Viridis => Self::Viridis,
            ColoursName::Cividis => Self::Cividis,
            ColoursName::Inferno => Self::Inferno,
            ColoursName::Hue => Self::Hue,
        }
    }
}
