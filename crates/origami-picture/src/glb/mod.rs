//! Binary glTF 2.0: the sheet as it folds, for viewers and for the web.
//!
//! Every state but the first is a morph target, and an animation goes from one to the next. Triangles share no vertices,
//! so that facets stay flat; paper is seen from both sides. Lines are lines, which viewers draw a pixel wide.
//!
//! Lengths are those of the file that the pattern came from. glTF knows 32 bits only: vertices lie about the middle of the
//! sheet, and the node that holds them has the middle's own place.

mod buffer;
mod document;

use std::io::Write;

use origami_core::Error;
use origami_core::export::texture_coordinates;
use origami_core::glam::{DVec3, Vec3};
use origami_core::model::{Model, Normalisation};

use crate::figure::{Figure, LineSet};
use crate::map::Values;
use crate::theme::Theme;
use buffer::Buffer;
use document::Document;

/// Bytes that JSON has of a state, at most.
const STATE: u64 = 1000;
/// Viewers fill in a table of the square of the number of states: 1 GB.
const MOST_STATES: u64 = 16_000;

/// What goes into a glTF file.
#[derive(Clone, Debug, PartialEq)]
pub struct Glb {
    /// Colour of the paper (that of its front: glTF knows one for both sides) and of the lines.
    pub theme: Theme,
    /// Which lines. Default: all but facets.
    pub edges: LineSet,
    /// How long the folding takes, in seconds. Default 4.
    pub seconds: f32,
    /// How long a radius of the figure is in the file, and where its origin lies: that of the model. Default: 1, at 0.
    pub placement: Normalisation,
    /// By node, where a picture on the front of the paper lies, in the unit square with y upwards: `TEXCOORD_0`, where there
    /// is one. Default: none.
    pub texture: Option<Vec<[f64; 2]>>,
}

impl Default for Glb {
    fn default() -> Self {
        let placement = Normalisation { centre: DVec3::ZERO, radius: 1.0 };
        Self { theme: Theme::default(), edges: LineSet::default(), seconds: 4.0, placement, texture: None }
    }
}

/// Radii that 32 bits can hold, with the squares of lengths that viewers compute.
const RADII: std::ops::RangeInclusive<f64> = 1e-15..=1e15;

impl Glb {
    /// The default for the sheets of `model`: in the unit of its file, at their place there, with texture coordinates from
    /// the sheet before it is folded, where that is flat.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        Self { placement: model.normalisation, texture: texture_coordinates(&model.rest), ..Self::default() }
    }

    /// Writes `figure` going through `states`, each the positions of all nodes in radii; without any it is shown as it is.
    /// A map colours all states alike.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a figure that makes no sense, a state or a texture of another sheet, a sheet without triangles,
    /// a radius that 32 bits cannot hold (1e-15 to 1e15), or a file beyond 4 GB, as [`Glb::check`] tells before;
    /// [`Error::Io`] with path `-` if writing fails.
    pub fn write(&self, figure: &Figure, states: &[Vec<[f32; 3]>], mut writer: impl Write) -> Result<(), Error> {
        self.check(figure, states.len())?;
        let own = [figure.positions.clone()];
        let states = if states.is_empty() { &own[..] } else { states };
        for (i, state) in states.iter().enumerate() {
            if state.len() != figure.positions.len() || !state.iter().flatten().all(|x| x.is_finite()) {
                let expected = format!("{} finite ones", figure.positions.len());
                return Err(Error::invalid(format!("state {i}"), format!("{} positions", state.len()), expected));
            }
        }
        let file = self.file(figure, states)?;
        writer.write_all(&file).and_then(|()| writer.flush()).map_err(|source| Error::Io { path: "-".into(), source })
    }

    /// Whether a file can hold `figure` going through so many states, whatever they are.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a figure that makes no sense, a sheet without triangles, a placement or a texture that makes
    /// none, and for more states than the 4 GB of a file, or the numbers of a table of weights that viewers fill in, have
    /// room for.
    pub fn check(&self, figure: &Figure, states: usize) -> Result<(), Error> {
        figure.check()?;
        if figure.triangles.is_empty() {
            return Err(Error::invalid("glTF", "the sheet has no faces", "at least one triangle"));
        }
        self.check_placement(figure)?;
        let lines = figure.lines.iter().filter(|line| self.edges.has(line.kind)).count();
        // A place and a normal for each corner, a place for each end of a line, and what JSON says of both.
        let state = 24 * 3 * figure.triangles.len() as u64 + 12 * 2 * lines as u64 + STATE;
        let most = (u64::from(u32::MAX) / state).min(MOST_STATES);
        if states as u64 <= most.max(1) {
            return Ok(());
        }
        Err(Error::invalid("glTF", format!("{states} states are more than a file holds"), format!("at most {most}")))
    }

    /// Whether placement and texture make sense.
    fn check_placement(&self, figure: &Figure) -> Result<(), Error> {
        let Normalisation { centre, radius } = self.placement;
        if !RADII.contains(&radius) || !centre.as_vec3().is_finite() {
            let problem = format!("a sheet of radius {radius:e} at {centre}");
            let expected = "a radius from 1e-15 to 1e15, at places that 32 bits can hold";
            return Err(Error::invalid("glTF", problem, expected));
        }
        let texture = self.texture.as_ref().filter(|texture| texture.len() != figure.positions.len());
        if let Some(texture) = texture {
            let expected = format!("{}, one for each node", figure.positions.len());
            return Err(Error::invalid("texture", format!("{} places", texture.len()), expected));
        }
        Ok(())
    }

    fn file(&self, figure: &Figure, states: &[Vec<[f32; 3]>]) -> Result<Vec<u8>, Error> {
        let mut document = Document::new(Buffer::default(), self.placement.radius as f32);
        let corners: Vec<u32> = figure.triangles.iter().flatten().copied().collect();
        let texture = self.texture.as_ref().map(|texture| places(&corners, texture));
        document.faces(&corners, states, texture.as_deref(), self.colours(figure), self.theme.front.linear());
        let lines: Vec<_> = figure.lines.iter().filter(|line| self.edges.has(line.kind)).collect();
        if !lines.is_empty() {
            let ends: Vec<u32> = lines.iter().flat_map(|line| line.nodes).collect();
            let colours = lines.iter().flat_map(|line| [self.theme.line(line.kind).colour.linear(); 2]).collect();
            document.lines(&ends, states, colours);
        }
        document.animate(states.len(), if self.seconds > 0.0 && self.seconds.is_finite() { self.seconds } else { 4.0 });
        document.into_bytes(self.placement.centre)
    }

    /// The map's colour of each corner of each triangle, as light.
    fn colours(&self, figure: &Figure) -> Option<Vec<[f32; 3]>> {
        let map = figure.map.as_ref()?;
        let colour = |value: f32| map.scale.colours.colour(f64::from(map.scale.share(value))).linear();
        Some(match &map.values {
            Values::Nodes(values) => figure.triangles.iter().flatten().map(|n| colour(values[*n as usize])).collect(),
            Values::Triangles(values) => values.iter().flat_map(|value| [colour(*value); 3]).collect(),
        })
    }
}

/// Positions of these nodes, with so many units to a radius. glTF's y points up, the sheet's z does.
fn positions_of(nodes: &[u32], state: &[[f32; 3]], radius: f32) -> Vec<Vec3> {
    nodes.iter().map(|n| state[*n as usize]).map(|[x, y, z]| Vec3::new(x, z, -y) * radius).collect()
}

/// Places of these nodes on a picture. glTF's pictures begin at their upper left corner.
fn places(nodes: &[u32], texture: &[[f64; 2]]) -> Vec<[f32; 2]> {
    nodes.iter().map(|n| texture[*n as usize]).map(|[x, y]| [x as f32, (1.0 - y) as f32]).collect()
}

/// The normal of each corner's triangle; upwards where it has none.
fn normals(positions: &[Vec3]) -> Vec<Vec3> {
    let of = |t: &[Vec3]| (t[1] - t[0]).cross(t[2] - t[0]).try_normalize().unwrap_or(Vec3::Y);
    positions.chunks_exact(3).flat_map(|triangle| [of(triangle); 3]).collect()
}
