//! Paths of equilibria as a load grows, through limit points where it turns back.
//!
//! The arc-length method: from each state along the tangent of the path, then to the path by Newton's method within the
//! plane across it. The way on is that which makes an acute angle with the way so far, which also holds where load and
//! displacement turn back both; programs that go by the sign of a stiffness have turned around on a folded sheet without a
//! word. E. Riks, An incremental approach to the solution of snapping and buckling problems, Int. J. Solids Structures 15
//! (1979).

mod events;
mod point;
mod settings;
mod walker;

pub use point::{Event, Onward, Point};
pub use settings::{Control, Path, Until};

use std::ops::ControlFlow;

use events::Step;
use walker::{Direction, Stand, Walker};

use super::{Configuration, Refused, Structure};

/// No crease turns farther in one step, in radians.
const LONGEST_TURN: f64 = 0.3;
/// The cosine of the largest angle between the directions of two points: of 30 degrees.
const STRAIGHT: f64 = 0.866;
/// Iterations that a point should take: the next step is longer or shorter accordingly.
const AIM: f64 = 4.0;
/// Steps shorter than this share of the longest are given up: at a bifurcation, where the way on is not unique, many that are
/// still shorter could turn a path around.
const SHORTEST: f64 = 1e-5;

/// Where a path begins.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Start {
    /// The state; none: as the structure is drawn.
    pub configuration: Option<Configuration>,
    /// The load factor there.
    pub load_factor: f64,
    /// The way on; none: towards a rising load factor, or as [`Path::backwards`] says.
    pub onward: Option<Onward>,
}

impl Start {
    /// Takes a path up where `point` left it.
    #[must_use]
    pub fn again(point: &Point) -> Self {
        Self {
            configuration: Some(point.configuration.clone()),
            load_factor: point.load_factor,
            onward: Some(point.onward.clone()),
        }
    }

    /// Leaves a path at a bifurcation along one of its null vectors, to the side of `side`'s sign. None where `point` has
    /// no such vector.
    #[must_use]
    pub fn branch(point: &Point, mode: usize, side: f64) -> Option<Self> {
        let Event::Bifurcation { modes, .. } = &point.event else { return None };
        let moves = modes.get(mode)?.iter().map(|m| *m * side.signum()).collect();
        let onward = Some(Onward { moves, load_factor: 0.0 });
        Some(Self { configuration: Some(point.configuration.clone()), load_factor: point.load_factor, onward })
    }
}

/// Why a path ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Ended {
    /// It is where it was to end.
    Reached,
    /// It has as many points as were asked for.
    Steps,
    /// No step leads on, however short: what is controlled turns back here, or facets have met.
    Stuck,
    /// Who watched it broke it off.
    Cancelled,
}

/// The points of a path in order, and why it ended.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Trace {
    /// The first is where it began.
    pub points: Vec<Point>,
    /// Why it ended.
    pub ended: Ended,
    /// Steps that were tried and found too long.
    pub rejected: u32,
}

impl Trace {
    /// The limit points, bifurcations and states without load, in order.
    pub fn events(&self) -> impl Iterator<Item = &Point> {
        self.points.iter().filter(|point| !matches!(point.event, Event::Step | Event::End))
    }
}

impl Structure {
    /// Follows the path from `start`; each point is shown to `each`, which may break it off.
    ///
    /// # Errors
    /// [`Refused`] where the structure or the path's settings are wrong, a rigid motion is left free, nothing acts, or no
    /// equilibrium is found at the start.
    pub fn trace(
        &self,
        start: &Start,
        path: &Path,
        each: &mut dyn FnMut(&Point) -> ControlFlow<()>,
    ) -> Result<Trace, Refused> {
        self.check()?;
        path.check(self)?;
        match self.free_rigid_motions() {
            0 => {}
            free => return Err(Refused::RigidMotions { free }),
        }
        let mut walker = Walker::new(self, path)?;
        let first = begin(&mut walker, start)?;
        let first = walker.turn(path, first);
        let mut trace = Trace { points: Vec::new(), ended: Ended::Steps, rejected: 0 };
        let point = Point::new(&mut walker, &first, None, Event::Step);
        let broken_off = each(&point).is_break();
        trace.points.push(point);
        if broken_off {
            trace.ended = Ended::Cancelled;
            return Ok(trace);
        }
        trace.follow(&mut walker, path, first, each);
        Ok(trace)
    }
}

impl Structure {
    /// The equilibrium under `load_factor` times the loads that is found from `from` by Newton's method: stable or not, the one
    /// nearby as a rule.
    ///
    /// # Errors
    /// [`Refused`] where the structure is wrong or free to move, or none is found.
    pub fn equilibrium(&self, from: &Configuration, load_factor: f64) -> Result<Configuration, Refused> {
        self.check()?;
        self.check_configuration(from)?;
        match self.free_rigid_motions() {
            0 => {}
            free => return Err(Refused::RigidMotions { free }),
        }
        let mut walker = Walker::new(self, &Path::default())?;
        let by_load = walker.by_load();
        let at = format!("load factor {load_factor}");
        let here = walker.stand(from.clone(), load_factor, &by_load, 0);
        let here = here.ok_or_else(|| Refused::Singular { at: at.clone() })?;
        let guess = (here.at.clone(), load_factor);
        let found = walker.correct(&here, &by_load, 0.0, guess);
        found.map(|stand| stand.at).ok_or(Refused::NotFound { at, iterations: walker::MOST })
    }
}

/// The equilibrium at the start.
fn begin(walker: &mut Walker<'_>, start: &Start) -> Result<Stand, Refused> {
    let structure = walker.structure();
    let mut at = start.configuration.clone().unwrap_or_else(|| structure.as_drawn());
    structure.check_configuration(&at)?;
    walker.tangent.equations.place(&mut at, start.load_factor);
    walker.tangent.set(&at, start.load_factor);
    let by_load = walker.by_load();
    let Some(onward) = &start.onward else {
        let neutral = walker.tangent.inertia().neutral;
        if neutral > 0 {
            return Err(Refused::Mechanisms { count: neutral });
        }
        // Supports that are moved lead on even where nothing else follows them.
        let is_moved = !structure.supports.moved.is_empty();
        if !is_moved && walker.tangent.equations.load(&at).iter().all(|x| *x == 0.0) {
            return Err(Refused::Unloaded);
        }
        let at_load = format!("load factor {}", start.load_factor);
        let here = walker.stand(at, start.load_factor, &by_load, 0);
        let here = here.ok_or_else(|| Refused::Singular { at: at_load.clone() })?;
        let guess = (here.at.clone(), here.load_factor);
        let found = walker.correct(&here, &by_load, 0.0, guess);
        return found.ok_or(Refused::NotFound { at: at_load, iterations: walker::MOST });
    };
    // Where a path is taken up it may be singular: the given direction leads on.
    let direction = onward.direction(walker);
    let length = walker.product(&direction, &direction).sqrt();
    if !(length.is_finite() && length > 0.0) {
        return Err(Refused::at("start.onward", format!("its length is {length}"), "a direction"));
    }
    let scaled = direction.rows.iter().map(|x| x / length).collect();
    let direction = Direction { rows: scaled, load_factor: direction.load_factor / length };
    let measure = walker.measure(&direction);
    let here = walker.stand(at, start.load_factor, &measure, 0);
    let here = here.ok_or_else(|| Refused::Singular { at: "start.onward".to_owned() })?;
    Ok(Stand { direction, ..here })
}

impl Trace {
    fn follow(
        &mut self,
        walker: &mut Walker<'_>,
        path: &Path,
        first: Stand,
        each: &mut dyn FnMut(&Point) -> ControlFlow<()>,
    ) {
        let mut from = first;
        let mut share = path.step.min(path.longest);
        while self.points.len() < path.steps {
            let measure = walker.measure(&from.direction);
            let farthest = walker.farthest(&from.direction) / walker.size();
            let length = share / farthest * measure.of(&from.direction);
            let guess = walker.predict(&from, &measure, length);
            let to = walker.correct(&from, &measure, length, guess);
            let Some(to) = to.filter(|to| is_short(walker, &from, to)) else {
                self.rejected += 1;
                share *= 0.5;
                if share < SHORTEST * path.longest {
                    self.ended = Ended::Stuck;
                    return;
                }
                continue;
            };
            share = (share * (AIM / f64::from(to.iterations)).sqrt().clamp(0.5, 2.0)).min(path.longest);
            let step = Step { from: &from, to: &to, measure: &measure, length };
            let mut last = &from;
            let events = step.events(walker, path);
            for (stand, event) in &events {
                let before = self.points.last().map(|point| (point, last));
                let point = Point::new(walker, stand, before, event.clone());
                let broken_off = each(&point).is_break();
                self.points.push(point);
                last = stand;
                if *event == Event::End || broken_off {
                    self.ended = if *event == Event::End { Ended::Reached } else { Ended::Cancelled };
                    return;
                }
            }
            // Not from the last event: at a bifurcation the way on is not unique.
            from = to;
        }
    }
}

/// Whether a step stayed on its branch, as far as can be told: no crease turned far, and the path goes on much as before.
fn is_short(walker: &Walker<'_>, from: &Stand, to: &Stand) -> bool {
    let turns = from.at.fold_angles.iter().zip(&to.at.fold_angles).map(|(a, b)| (a - b).abs());
    turns.fold(0.0, f64::max) <= LONGEST_TURN && walker.product(&from.direction, &to.direction) >= STRAIGHT
}
