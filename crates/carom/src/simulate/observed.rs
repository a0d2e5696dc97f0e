//! A run of a gas of discs that is looked at while it goes on.
//!
//! The gas first comes to equilibrium, for so many collisions of each disc; then it is shown to its [`Observables`] at
//! equal intervals, up to the limits of the scenario. On the way it hands out snapshots and events, and it can be written
//! down at any pause, as a [`checkpoint`](ObservedRun::checkpoint), to go on from there. The run has the bits that it has
//! when nobody looks.

mod camera;
mod checkpoint;
mod plan;
mod stream;

use super::{SLICE, SimulationOf, start_watched};
use crate::observe::{Observables, ObserveError, Snapshot};
use crate::run::{Diagnostics, Event, Kind, Log, Plane, Run, SimulationError, Status};
use crate::scenario::{Problem, Scenario};
use camera::Camera;
pub use checkpoint::{Checkpoint, CheckpointError};
use plan::Due;
pub use plan::{Plan, Sampling, Snapshots, Window};
use serde::{Deserialize, Serialize};
use stream::Stream;
use thiserror::Error;

/// Collisions of each disc from one sample to the next, where no interval is given.
pub const COLLISIONS_PER_SAMPLE: f64 = 10.0;

/// Fewer samples than these make no interval.
const FEWEST_SAMPLES: u64 = 2;

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
    /// The scenario or the plan is not one that can be observed.
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

/// Where an observed run pauses. What it hands out counts as handed out when the run goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pause {
    /// Some work was done.
    Progress,
    /// A snapshot is due: [`ObservedRun::snapshot`] takes it.
    Snapshot,
    /// A piece of the events is full, or is the last: [`ObservedRun::events`] has it.
    Events,
    /// The run has ended.
    Ended,
}

/// What is done between looks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Phase {
    /// Nothing is observed.
    Unwatched,
    /// The gas comes to equilibrium.
    Equilibrating,
    /// The first sample is due at `start`.
    Starting { start: f64 },
    /// The second sample is due when each disc has met `meetings` others, which makes the interval.
    Choosing { start: f64, meetings: f64 },
    /// Samples come at equal intervals.
    Sampling { start: f64, interval: f64 },
}

/// A run under way, with those who look at it.
pub struct ObservedRun {
    scenario: Scenario,
    until: Option<Kind>,
    simulation: SimulationOf<Plane>,
    log: Log<f64, Plane>,
    observables: Observables,
    plan: Plan,
    phase: Phase,
    stream: Stream,
    /// Snapshots that were handed out.
    snapshots: u64,
    camera: Camera,
    /// Where the run pauses now, if it does.
    pause: Option<Pause>,
    /// A time up to which everything has happened, in a run that goes on from there or ends there.
    reached: f64,
    /// The work after which the run next pauses for itself.
    next_pause: u64,
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
    observables: Observables,
    sampling: &Sampling,
    interrupted: &mut dyn FnMut(&Progress) -> bool,
) -> Result<(Run<f64>, Observables), ObservedError> {
    let plan = Plan { sampling: *sampling, ..Plan::default() };
    let mut run = ObservedRun::new(scenario, until, observables, plan)?;
    while run.advance()? != Pause::Ended {
        if interrupted(&run.progress()) {
            run.stop();
        }
    }
    run.finish()
}

impl ObservedRun {
    /// A run of a checked scenario from time zero, to its end or to the first event of a kind.
    ///
    /// # Errors
    ///
    /// A scenario that is no gas in a rectangle, a plan with a number out of its range, and collisions that are too few to
    /// measure anything.
    pub fn new(
        scenario: &Scenario,
        until: Option<Kind>,
        mut observables: Observables,
        plan: Plan,
    ) -> Result<Self, ObservedError> {
        plan::check(scenario, &plan).map_err(ObservedError::Unfit)?;
        let mut stream = Stream::new(plan.window);
        let (simulation, log) = start_watched(scenario, until, &mut (&mut observables, &mut stream));
        let camera = Camera::new(simulation.system());
        if !observables.is_empty() {
            plan::check_length(scenario, &plan, camera.count()).map_err(ObservedError::Unfit)?;
        }
        let phase = if observables.is_empty() { Phase::Unwatched } else { Phase::Equilibrating };
        Ok(Self {
            scenario: scenario.clone(),
            until,
            camera,
            simulation,
            log,
            observables,
            plan,
            phase,
            stream,
            snapshots: 0,
            pause: None,
            reached: f64::NEG_INFINITY,
            next_pause: SLICE,
        })
    }

    /// Goes on to the next pause. After the end that is the end again.
    ///
    /// # Errors
    ///
    /// What [`Observables::sample`] refuses, and those of any run.
    pub fn advance(&mut self) -> Result<Pause, ObservedError> {
        match self.pause.take() {
            Some(Pause::Snapshot) => self.snapshots += 1,
            Some(Pause::Events) => self.stream.clear(),
            Some(Pause::Progress | Pause::Ended) | None => {}
        }
        loop {
            if let Some(pause) = self.due_pause() {
                self.pause = Some(pause);
                return Ok(pause);
            }
            if !self.look()? {
                self.go_on()?;
            }
        }
    }

    /// The scenario that is run.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The run itself, as it is now.
    pub fn simulation(&self) -> &SimulationOf<Plane> {
        &self.simulation
    }

    /// How far the run has come.
    pub fn progress(&self) -> Progress {
        Progress {
            time: self.simulation.time(),
            collisions: self.simulation.diagnostics().collisions(),
            samples: self.observables.samples(),
        }
    }

    /// The discs now.
    pub fn snapshot(&mut self) -> Snapshot<'_> {
        let time = match self.plan.snapshots.due(self.snapshots) {
            Due::Time(time) if self.pause == Some(Pause::Snapshot) => time,
            Due::Time(_) | Due::Collisions(_) | Due::Never => self.simulation.time(),
        };
        self.camera.look(&self.simulation, time)
    }

    /// The events that are to be handed out next, and the number of the first in the run, counted from 0.
    pub fn events(&self) -> (&[Event<f64>], u64) {
        self.stream.piece()
    }

    /// How many snapshots and how many events were handed out.
    pub fn handed_out(&self) -> (u64, u64) {
        (self.snapshots, self.stream.handed_out())
    }

    /// Breaks the run off here.
    pub fn stop(&mut self) {
        self.simulation.stop(Status::Interrupted);
    }

    /// The run so far, and what was observed of it.
    ///
    /// # Errors
    ///
    /// A run that ended by itself before there were two samples.
    pub fn finish(self) -> Result<(Run<f64>, Observables), ObservedError> {
        let samples = self.observables.samples();
        let run = self.simulation.finish(self.log);
        let is_measured = self.observables.is_empty() || samples >= FEWEST_SAMPLES;
        if !is_measured && run.status != Status::Interrupted {
            return Err(ObservedError::TooShort { status: run.status, time: run.end_time, samples });
        }
        Ok((run, self.observables))
    }

    /// Why to pause now, if at all.
    fn due_pause(&mut self) -> Option<Pause> {
        let is_over = !self.goes_on();
        if self.stream.is_due(self.simulation.time(), is_over) {
            Some(Pause::Events)
        } else if self.is_snapshot_due() {
            Some(Pause::Snapshot)
        } else if is_over && !self.is_sample_due() {
            Some(Pause::Ended)
        } else if self.work() >= self.next_pause {
            self.next_pause = self.work() + SLICE;
            Some(Pause::Progress)
        } else {
            None
        }
    }

    /// To look at a disc counts as much as an event.
    fn work(&self) -> u64 {
        let looks = self.observables.samples() + self.snapshots;
        self.simulation.diagnostics().total_events() + looks * self.camera.count() as u64
    }

    fn goes_on(&self) -> bool {
        self.simulation.status().is_none()
    }

    fn is_snapshot_due(&self) -> bool {
        match self.plan.snapshots.due(self.snapshots) {
            Due::Time(time) => self.reached >= time,
            Due::Collisions(due) => self.simulation.diagnostics().collisions() >= due,
            Due::Never => false,
        }
    }

    fn is_sample_due(&self) -> bool {
        self.sample_time().is_some_and(|time| self.reached >= time)
    }

    /// When the next sample is due, if that is known.
    fn sample_time(&self) -> Option<f64> {
        match self.phase {
            Phase::Starting { start } => Some(start),
            Phase::Sampling { start, interval } => Some(start + interval * self.observables.samples() as f64),
            Phase::Unwatched | Phase::Equilibrating | Phase::Choosing { .. } => None,
        }
    }

    /// Takes the sample that is due, or enters the next phase; says whether it did either.
    fn look(&mut self) -> Result<bool, ObservedError> {
        let time = self.simulation.time();
        match self.phase {
            Phase::Equilibrating if self.has_met(self.plan.sampling.equilibrate) => {
                self.phase = Phase::Starting { start: time };
            }
            Phase::Choosing { start, meetings } if self.has_met(meetings) => {
                self.phase = if time > start {
                    Phase::Sampling { start, interval: time - start }
                } else {
                    Phase::Choosing { start, meetings: meetings + COLLISIONS_PER_SAMPLE }
                };
            }
            Phase::Starting { start } if self.reached >= start => {
                self.observables.sample(&self.camera.look(&self.simulation, start))?;
                self.phase = self.after_first(start);
            }
            Phase::Sampling { .. } => match self.sample_time().filter(|due| self.reached >= *due) {
                Some(due) => self.observables.sample(&self.camera.look(&self.simulation, due))?,
                None => return Ok(false),
            },
            Phase::Unwatched | Phase::Equilibrating | Phase::Starting { .. } | Phase::Choosing { .. } => {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The phase after the first sample: with the interval that is given, or with that of so many collisions at the rate
    /// seen so far if that says enough.
    fn after_first(&self, start: f64) -> Phase {
        let seen = meetings(self.simulation.diagnostics(), self.camera.count() as f64);
        match self.plan.sampling.interval {
            Some(interval) => Phase::Sampling { start, interval },
            None if seen >= COLLISIONS_PER_SAMPLE && start > 0.0 => {
                Phase::Sampling { start, interval: start * (COLLISIONS_PER_SAMPLE / seen) }
            }
            None => Phase::Choosing { start, meetings: seen + COLLISIONS_PER_SAMPLE },
        }
    }

    /// Whether each disc has met so many others, in the mean.
    fn has_met(&self, others: f64) -> bool {
        meetings(self.simulation.diagnostics(), self.camera.count() as f64) >= others
    }

    /// Goes on for a slice, but not past anything that is due.
    fn go_on(&mut self) -> Result<(), ObservedError> {
        let (count, phase) = (self.camera.count() as f64, self.phase);
        let due = self.plan.snapshots.due(self.snapshots);
        let equilibrate = self.plan.sampling.equilibrate;
        let is_missing = |found: &Diagnostics| {
            let is_early = match phase {
                Phase::Equilibrating => meetings(found, count) < equilibrate,
                Phase::Choosing { meetings: wanted, .. } => meetings(found, count) < wanted,
                Phase::Unwatched | Phase::Starting { .. } | Phase::Sampling { .. } => true,
            };
            is_early && !matches!(due, Due::Collisions(due) if found.collisions() >= due)
        };
        let mut time = self.sample_time().unwrap_or(f64::INFINITY);
        if let Due::Time(due) = due
            && due < time
        {
            time = due;
        }
        let watchers = &mut (&mut self.log, &mut (&mut self.observables, &mut self.stream));
        if self.simulation.advance_while(is_missing, time, SLICE, watchers)? {
            return Ok(());
        }
        self.simulation.run_until(time, watchers)?;
        let status = self.simulation.status();
        let ends_there = status == Some(Status::TimeLimit) && self.simulation.time() == time;
        if status.is_none() || ends_there {
            self.reached = time;
        }
        Ok(())
    }
}

/// How often a disc has met another, in the mean.
fn meetings(found: &Diagnostics, discs: f64) -> f64 {
    2.0 * found.events[Kind::BallBall as usize] as f64 / discs
}
