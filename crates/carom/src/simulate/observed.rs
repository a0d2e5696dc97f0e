//! A run of a gas of discs that is measured while it goes on.
//!
//! The gas first comes to equilibrium, for so many collisions of each disc; then it is shown to its [`Observables`] at
//! equal intervals, up to the limits of the scenario. The run has the bits that it has when nobody looks.

use super::{SLICE, SimulationOf, start_watched};
use crate::geometry::Vec2;
use crate::observe::{Observables, ObserveError, Snapshot};
use crate::run::{Kind, Log, Plane, Run, SimulationError, Status};
use crate::scenario::schema::{Method, Table};
use crate::scenario::{Problem, Scenario, System};
use thiserror::Error;

/// Collisions of each disc from one sample to the next, where no interval is given.
pub const COLLISIONS_PER_SAMPLE: f64 = 10.0;

/// Fewer samples than these make no interval.
const FEWEST_SAMPLES: u64 = 2;

/// When the gas is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sampling {
    /// Collisions of each disc with others that come before the first sample.
    pub equilibrate: f64,
    /// The time between samples; `None`: that of [`COLLISIONS_PER_SAMPLE`] collisions of each disc, at the rate seen in
    /// equilibrating, or up to the second sample.
    pub interval: Option<f64>,
}

/// How far an observed run has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The time.
    pub time: f64,
    /// Ball-ball and ball-cushion events so far, as the limits of a run count them.
    pub collisions: u64,
    /// Samples so far.
    pub samples: u64,
}

/// Why an observed run gives nothing.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ObservedError {
    /// The scenario or the sampling is not one that can be observed.
    #[error("{}: {}", .0.place, .0.message)]
    Unfit(Problem),
    /// What was asked for cannot be observed.
    #[error(transparent)]
    Observe(#[from] ObserveError),
    /// The run broke one of its invariants.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// The run ended before anything was measured.
    #[error("the run ended by {} at time {time} with {samples} samples, and {FEWEST_SAMPLES} are the fewest: let it go on \
        for longer, or shorten equilibrate or the interval between samples", status.name())]
    TooShort {
        /// How it ended.
        status: Status,
        /// When.
        time: f64,
        /// How often it was looked at.
        samples: u64,
    },
}

/// Runs a checked scenario to its end, to the first event of a kind, or until `interrupted` says so; it is asked now and
/// then. What is found is in the observables: what there is so far also when the run was interrupted.
///
/// # Errors
///
/// A scenario that is no gas in a rectangle, what [`Observables::sample`] refuses, a run that ends before there are two
/// samples, and those of any run.
pub fn simulate_observed(
    scenario: &Scenario,
    until: Option<Kind>,
    observables: &mut Observables,
    sampling: &Sampling,
    interrupted: &mut dyn FnMut(&Progress) -> bool,
) -> Result<Run<f64>, ObservedError> {
    check(scenario, sampling).map_err(ObservedError::Unfit)?;
    let (simulation, log) = start_watched(scenario, until, observables);
    let camera = Camera::new(simulation.system());
    let mut observed = Observed { simulation, log, observables, camera, interrupted, next_asked: SLICE };
    observed.course(sampling)?;
    let Observed { simulation, log, observables, .. } = observed;
    let run = simulation.finish(log);
    let samples = observables.samples();
    if samples < FEWEST_SAMPLES && run.status != Status::Interrupted {
        return Err(ObservedError::TooShort { status: run.status, time: run.end_time, samples });
    }
    Ok(run)
}

fn check(scenario: &Scenario, sampling: &Sampling) -> Result<(), Problem> {
    let problem =
        |place: &str, message: &str| Err(Problem { place: place.to_owned(), message: message.to_owned() });
    let expanded = scenario.expanded();
    let is_plain = matches!(&expanded.table, Table::Rectangle { obstacles, .. } if obstacles.is_empty());
    if expanded.physics.has_cloth() {
        problem("physics.flight", "a gas is one of discs: balls on a cloth cannot be observed")
    } else if !is_plain {
        problem("table", "a gas is observed in a rectangle without obstacles, whose area and walls are known")
    } else if scenario.method != Method::Exact {
        problem("method", "only runs with the exact method can be observed")
    } else if !(sampling.equilibrate >= 0.0 && sampling.equilibrate.is_finite()) {
        problem("equilibrate", "must be a number of collisions of each disc, from zero on")
    } else if sampling.interval.is_some_and(|interval| !(interval > 0.0 && interval.is_finite())) {
        problem("sample_interval", "must be a positive time")
    } else {
        Ok(())
    }
}

/// A run under way, with those who look at it.
struct Observed<'a> {
    simulation: SimulationOf<Plane>,
    log: Log<f64, Plane>,
    observables: &'a mut Observables,
    camera: Camera,
    interrupted: &'a mut dyn FnMut(&Progress) -> bool,
    /// The work after which it is next asked whether to break off.
    next_asked: u64,
}

impl Observed<'_> {
    /// All of the run. Where it has ended, each part of this does nothing.
    fn course(&mut self, sampling: &Sampling) -> Result<(), ObservedError> {
        self.advance_to(sampling.equilibrate)?;
        let start = self.simulation.time();
        self.sample(start)?;
        let interval = match sampling.interval {
            Some(interval) => interval,
            None => self.choose_interval(start)?,
        };
        while self.goes_on() {
            self.sample(start + interval * self.observables.samples() as f64)?;
        }
        Ok(())
    }

    fn goes_on(&self) -> bool {
        self.simulation.status().is_none()
    }

    /// The time of so many collisions: at the rate seen so far if that says enough, or else the time that they take.
    fn choose_interval(&mut self, start: f64) -> Result<f64, ObservedError> {
        let seen = self.collisions_per_disc();
        if seen >= COLLISIONS_PER_SAMPLE && start > 0.0 {
            return Ok(start * (COLLISIONS_PER_SAMPLE / seen));
        }
        let mut due = seen;
        while self.goes_on() && (due == seen || self.simulation.time() <= start) {
            due += COLLISIONS_PER_SAMPLE;
            self.advance_to(due)?;
        }
        Ok(self.simulation.time() - start)
    }

    /// How often a disc has met another.
    fn collisions_per_disc(&self) -> f64 {
        let collisions = self.simulation.diagnostics().events[Kind::BallBall as usize];
        2.0 * collisions as f64 / self.camera.count()
    }

    /// Goes on until each disc has met so many others, in the mean.
    fn advance_to(&mut self, collisions_per_disc: f64) -> Result<(), ObservedError> {
        while self.goes_on() {
            let missing = 0.5 * self.camera.count() * (collisions_per_disc - self.collisions_per_disc());
            if missing <= 0.0 {
                break;
            }
            // No more steps than collisions that are missing, so that none comes too many.
            let steps = (missing.ceil() as u64).min(SLICE);
            self.simulation.advance(steps, &mut (&mut self.log, &mut *self.observables))?;
            self.ask();
        }
        Ok(())
    }

    /// Goes on to a time and shows the gas there, unless the run ends before.
    fn sample(&mut self, time: f64) -> Result<(), ObservedError> {
        if !self.goes_on() {
            return Ok(());
        }
        while self.simulation.advance_until(time, SLICE, &mut (&mut self.log, &mut *self.observables))? {
            self.ask();
        }
        self.simulation.run_until(time, &mut (&mut self.log, &mut *self.observables))?;
        let ends_there =
            self.simulation.status() == Some(Status::TimeLimit) && self.simulation.time() == time;
        if self.goes_on() || ends_there {
            self.observables.sample(&self.camera.look(&self.simulation, time))?;
            self.ask();
        }
        Ok(())
    }

    /// Asks now and then whether to break off: to look at a disc counts as much as an event.
    fn ask(&mut self) {
        let (diagnostics, samples) = (self.simulation.diagnostics(), self.observables.samples());
        let work = diagnostics.total_events() + samples * self.camera.radii.len() as u64;
        if work < self.next_asked {
            return;
        }
        self.next_asked = work + SLICE;
        let time = self.simulation.time();
        let progress = Progress { time, collisions: diagnostics.collisions(), samples };
        if (self.interrupted)(&progress) {
            self.simulation.stop(Status::Interrupted);
        }
    }
}

/// What takes snapshots, and the memory they need.
struct Camera {
    size: [f64; 2],
    periods: [bool; 2],
    /// The corner of the table that is the origin of a snapshot.
    corner: Vec2<f64>,
    positions: Vec<Vec2<f64>>,
    velocities: Vec<Vec2<f64>>,
    radii: Vec<f64>,
    masses: Vec<f64>,
}

impl Camera {
    fn new(system: &System<f64>) -> Self {
        let (corner, extent) = (system.bounds.min, system.bounds.max - system.bounds.min);
        let count = system.discs.len();
        Self {
            size: [extent.x, extent.y],
            periods: system.periodic,
            corner,
            positions: Vec::with_capacity(count),
            velocities: Vec::with_capacity(count),
            radii: system.discs.iter().map(|disc| disc.radius).collect(),
            masses: system.discs.iter().map(|disc| disc.mass).collect(),
        }
    }

    /// The number of discs.
    fn count(&self) -> f64 {
        self.radii.len() as f64
    }

    fn look(&mut self, simulation: &SimulationOf<Plane>, time: f64) -> Snapshot<'_> {
        let system = simulation.system();
        self.positions.clear();
        self.velocities.clear();
        simulation.each_ball(|flight, track| {
            let state = system.unwrapped(&flight, track.image).state_after(time - flight.start);
            self.positions.push(state.position - self.corner);
            self.velocities.push(state.velocity);
        });
        Snapshot {
            time,
            size: self.size,
            periods: self.periods,
            positions: &self.positions,
            velocities: &self.velocities,
            radii: &self.radii,
            masses: &self.masses,
        }
    }
}
