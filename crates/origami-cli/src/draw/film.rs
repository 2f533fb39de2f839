//! Moving pictures. Each is drawn, written and forgotten, so that memory does not grow with their number.

use std::path::Path;

use origami::Error;
use origami::export::write_whole;
use origami::picture::animation::numbered;
use origami::picture::camera::swept;
use origami::picture::{Animation, Camera, Figure, Format, Image, Picture, View};

use super::{Artist, Film, Subject, contact};

/// Pictures in a second, where nothing is asked for.
const FPS: u16 = 20;
/// How long a folded sheet that does not turn is shown before the film begins again, in milliseconds.
const PAUSE: u16 = 1000;

/// Draws picture after picture.
struct Reel<'a> {
    artist: &'a Artist,
    subject: Subject<'a>,
    picture: Picture,
    turntable: Option<u32>,
    count: usize,
    clip: Option<f64>,
    /// Points that the camera is fitted to.
    points: Vec<[f32; 3]>,
    figure: Figure,
}

/// Writes the film and says which files it is.
///
/// # Errors
/// As for drawing; [`Error::Io`] where the system refuses.
pub(crate) fn film(
    artist: &Artist,
    subject: Subject<'_>,
    film: Film,
    path: &Path,
    drawn: &mut dyn FnMut(usize, usize),
) -> Result<Vec<String>, Error> {
    let Some(mut reel) = Reel::new(artist, subject, film) else { return Ok(Vec::new()) };
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let frames = u32::try_from(reel.count).unwrap_or(u32::MAX);
    if extension == "png" {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let stem = stem.strip_suffix('-').unwrap_or(&stem);
        let mut files = Vec::new();
        for (i, number) in (0..frames).enumerate() {
            let file = path.with_file_name(numbered(stem, number, frames));
            let image = reel.draw(i)?;
            write_whole(&file, |writer| image.write_png(writer))?;
            files.push(file.display().to_string());
            drawn(i + 1, reel.count);
        }
        return Ok(files);
    }
    let format = Format::of_extension(&extension).unwrap_or(Format::Apng);
    let Picture { width, height, .. } = reel.picture;
    let animation = Animation { format, width, height, frames, transparent: artist.style.is_transparent() };
    let each = 1000 / film.fps.unwrap_or(FPS).max(1);
    write_whole(path, |writer| {
        let mut film = animation.write(writer)?;
        for i in 0..reel.count {
            let rests = reel.turntable.is_none() && i + 1 == reel.count;
            film.push(&reel.draw(i)?, if rests { PAUSE.max(each) } else { each })?;
            drawn(i + 1, reel.count);
        }
        film.finish()
    })?;
    Ok(vec![path.display().to_string()])
}

impl<'a> Reel<'a> {
    fn new(artist: &'a Artist, subject: Subject<'a>, film: Film) -> Option<Self> {
        let (_, first) = subject.states.first()?;
        let positions = subject.states.iter().flat_map(|(_, state)| &state.positions);
        let positions = positions.map(|p| p.to_array().map(|x| x as f32));
        let points = if film.turntable.is_some() { swept(positions) } else { positions.collect() };
        let clip = artist.style.clip(subject);
        let figure = artist.style.figure(subject, first, clip);
        // One camera for the whole film: from the face of a sheet that lies in one plane all the time.
        let mut picture = artist.style.picture(contact::SIZE);
        if film.turntable.is_none() {
            picture = artist.style.facing(&picture, || Camera::facing(points.iter().copied()));
        }
        let count = subject.states.len().max(film.turntable.unwrap_or(0) as usize);
        Some(Self { artist, subject, picture, turntable: film.turntable, count, clip, points, figure })
    }

    /// Picture `i`: a state, the last one for all that come after it, seen from where the turntable has come to.
    fn draw(&mut self, i: usize) -> Result<Image, Error> {
        let states = self.subject.states;
        if let Some((_, state)) = states.get(i) {
            self.artist.style.move_to(&mut self.figure, self.subject, state, self.clip);
        }
        // The step of the sequence that it shows.
        let step = self.subject.steps.get(i.min(states.len().saturating_sub(1)));
        let caption = |step: &String| contact::caption(&self.picture, step);
        let caption = step.map_or_else(|| self.picture.caption.clone(), caption);
        let picture = Picture { caption, ..self.picture.clone() };
        self.artist.draw(&picture, &self.figure, &self.view(&picture, i)?)
    }

    fn view(&self, picture: &Picture, i: usize) -> Result<View, Error> {
        let camera = picture.camera;
        let turned = |round: u32| 360.0 * (i % round as usize) as f64 / f64::from(round);
        let azimuth = camera.azimuth + self.turntable.map_or(0.0, |round| turned(round.max(1)));
        let picture = Picture { camera: Camera { azimuth, ..camera }, ..picture.clone() };
        picture.view(&self.figure, self.points.iter().copied())
    }
}
