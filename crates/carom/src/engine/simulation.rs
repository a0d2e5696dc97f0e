//! A run in progress.

use super::discs::Discs;
use super::interface::{Engine, Fault};
use crate::run::{Diagnostics, Dynamics, Kind, Log, Observer, Run, SimulationError, Status};
use crate::scalar::Scalar;
use crate::scenario::LARGEST;
use std::sync::Arc;

/// The time after which nothing happens, even in a run without a duration: later, what is left of the speeds of balls that
/// always lose some has squares too small for a number.
const LATEST: f64 = LARGEST;

/// Passes over clusters after which a caller who looks in from time to time gets his turn.
const PASSES_AT_ONCE: u64 = 64;

/// When a run ends: at the first of these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits<S> {
    /// The time; events at this very time still happen.
    pub duration: Option<S>,
    /// The number of ball-ball and ball-cushion events. A cluster is not broken off, so there may be more.
    pub collisions: Option<u64>,
    /// The number of events of any kind.
    pub max_events: u64,
    /// The first event of this kind.
    pub until: Option<Kind>,
}

/// What a ball is about to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coming<S> {
    /// The ball.
    pub ball: usize,
    /// What will happen; `None` for nothing.
    pub kind: Option<Kind>,
    /// The other ball.
    pub other: Option<u32>,
    /// The cushion.
    pub cushion: Option<u32>,
    /// When; infinite for never.
    pub time: S,
    /// The present gap to what it will meet.
    pub gap: Option<S>,
}

/// A run in progress: goes on by single events, by slices, or to its end, with the same bits.
#[derive(Clone, Debug)]
pub struct Simulation<S, E = Discs<S>> {
    engine: E,
    limits: Limits<S>,
    time: S,
    status: Option<Status>,
    /// Events of the kind waited for that had happened when these limits were set.
    seen: u64,
    /// The number of events below which no limit but the time can be reached.
    no_limit_before: u64,
}

impl<S: Scalar> Limits<S> {
    /// No end but the duration and a budget of events.
    pub fn duration(duration: S) -> Self {
        Self { duration: Some(duration), collisions: None, max_events: u64::MAX, until: None }
    }

    /// The number of events below which none but the time can be reached.
    fn fewest_events(&self) -> u64 {
        let until = self.until.map_or(u64::MAX, |_| 1);
        self.max_events.min(self.collisions.unwrap_or(u64::MAX)).min(until)
    }
}

type SystemOf<S, E> = <<E as Engine<S>>::Dynamics as Dynamics<S>>::System;
type FlightOf<S, E> = <<E as Engine<S>>::Dynamics as Dynamics<S>>::Flight;
type TrackOf<S, E> = <<E as Engine<S>>::Dynamics as Dynamics<S>>::Track;
type StateOf<S, E> = <<E as Engine<S>>::Dynamics as Dynamics<S>>::State;

impl<S: Scalar, E: Engine<S>> Simulation<S, E> {
    /// A run of a system from time zero.
    pub fn new(
        system: Arc<SystemOf<S, E>>,
        limits: Limits<S>,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Self {
        let engine = E::new(system, observer);
        let no_limit_before = limits.fewest_events();
        Self { engine, limits, time: S::ZERO, status: None, seen: 0, no_limit_before }
    }

    /// Back to time zero, without giving up any memory.
    pub fn reset(&mut self, observer: &mut impl Observer<S, E::Dynamics>) {
        self.engine.reset(observer);
        (self.time, self.status, self.seen) = (S::ZERO, None, 0);
    }

    /// Back to time zero in a system in which `change` has changed velocities, the stroke or laws of collision: the run is then
    /// that of a new system, but no memory is asked for.
    pub fn restart(
        &mut self,
        change: impl FnOnce(&mut SystemOf<S, E>),
        observer: &mut impl Observer<S, E::Dynamics>,
    ) {
        self.engine.restart(change, observer);
        (self.time, self.status, self.seen) = (S::ZERO, None, 0);
    }

    /// Goes on from the end of a run, up to new limits.
    pub fn resume(run: &Run<S, E::Dynamics>, limits: Limits<S>) -> Self {
        let engine = E::resume(run);
        let seen = limits.until.map_or(0, |kind| run.diagnostics.events[kind as usize]);
        // A run that collapsed has nowhere to go, nor has one in which the cue slipped off.
        let is_over = |status: &Status| matches!(status, Status::Collapsed | Status::Miscue);
        let status = Some(run.status).filter(is_over);
        Self { engine, limits, time: run.end_time, status, seen, no_limit_before: limits.fewest_events() }
    }

    /// The present time: that of the last event, or of the end.
    pub fn time(&self) -> S {
        self.time
    }

    /// Why the run ended; `None` while it goes on.
    pub fn status(&self) -> Option<Status> {
        self.status
    }

    /// What is computed.
    pub fn system(&self) -> &Arc<SystemOf<S, E>> {
        self.engine.system()
    }

    /// Makes the next event happen (or the next cluster of them); says whether the run goes on.
    pub fn step(&mut self, observer: &mut impl Observer<S, E::Dynamics>) -> Result<bool, SimulationError> {
        self.step_before(self.latest(), observer)
    }

    /// Goes on for up to `steps` steps, fewer where clusters make them long; says whether the run goes on.
    pub fn advance(
        &mut self,
        steps: u64,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Result<bool, SimulationError> {
        let limit = self.latest();
        let passes = self.engine.diagnostics().cluster_passes;
        for _ in 0..steps {
            if !self.step_before(limit, observer)? {
                return Ok(false);
            }
            if self.engine.diagnostics().cluster_passes > passes + PASSES_AT_ONCE {
                break;
            }
        }
        Ok(self.status.is_none())
    }

    /// The time up to which events happen.
    fn latest(&self) -> S {
        self.limits.duration.unwrap_or(S::from_f64(LATEST))
    }

    /// Goes on to the end.
    pub fn run(&mut self, observer: &mut impl Observer<S, E::Dynamics>) -> Result<Status, SimulationError> {
        let limit = self.latest();
        while self.step_before(limit, observer)? {}
        Ok(self.status.unwrap_or(Status::Stopped))
    }

    /// Lets everything up to `time` happen, if the run goes on for so long, and moves the present there.
    pub fn run_until(
        &mut self,
        time: S,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Result<(), SimulationError> {
        while self.advance_until(time, u64::MAX, observer)? {}
        if self.status.is_none() && self.is_over(time) {
            self.step(observer)?;
        }
        if self.status.is_none() && time > self.time {
            self.time = time;
        }
        Ok(())
    }

    /// Whether the run, with no more events up to `time`, ends before that.
    fn is_over(&self, time: S) -> bool {
        let is_late = self.limits.duration.is_some_and(|end| time >= end);
        is_late || self.reached_limit().is_some() || self.engine.is_at_rest()
    }

    /// Goes on for up to `steps` steps, no further than `time`; says whether more are due up to then.
    pub fn advance_until(
        &mut self,
        time: S,
        steps: u64,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Result<bool, SimulationError> {
        for _ in 0..steps {
            if !self.step_up_to(time, observer)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Makes the next event happen if it is due up to `time`; says whether one was.
    #[inline]
    fn step_up_to(
        &mut self,
        time: S,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Result<bool, SimulationError> {
        if self.status.is_none() && self.reached_limit().is_none() && time <= self.latest() {
            let happened = self.engine.step(time, observer);
            self.time = happened.unwrap_or(self.time);
            if let Some(fault) = self.engine.fault() {
                self.end_by_fault(fault)?;
            }
            return Ok(happened.is_some());
        }
        // Here the run ends, should anything be due.
        let is_due = self.status.is_none() && self.engine.next_time() <= time;
        if is_due {
            self.step(observer)?;
        }
        Ok(is_due)
    }

    /// The same, but no further than a step after which it is enough: so where that is does not depend on the steps.
    pub fn advance_while(
        &mut self,
        is_missing: impl Fn(&Diagnostics) -> bool,
        time: S,
        steps: u64,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Result<bool, SimulationError> {
        for _ in 0..steps {
            if !is_missing(self.engine.diagnostics()) {
                return Ok(true);
            }
            if !self.step_up_to(time, observer)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Makes the events before `time` happen, but none at that very time, and ends the run there.
    pub fn stop_at(
        &mut self,
        status: Status,
        time: S,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Result<(), SimulationError> {
        while self.status.is_none() && self.engine.next_time() < time {
            self.step(observer)?;
        }
        if self.status.is_none() {
            self.end(status, if time > self.time { time } else { self.time });
        }
        Ok(())
    }

    /// Ends the run here.
    pub fn stop(&mut self, status: Status) {
        if self.status.is_none() {
            self.end(status, self.time);
        }
    }

    #[inline]
    fn step_before(
        &mut self,
        limit: S,
        observer: &mut impl Observer<S, E::Dynamics>,
    ) -> Result<bool, SimulationError> {
        if self.status.is_some() {
            return Ok(false);
        }
        if let Some(status) = self.reached_limit() {
            self.end(status, self.time);
        } else {
            match self.engine.step(limit, observer) {
                Some(time) => self.time = time,
                None => self.end_without_event(limit)?,
            }
        }
        if let Some(fault) = self.engine.fault() {
            self.end_by_fault(fault)?;
        }
        Ok(self.status.is_none())
    }

    #[inline(always)]
    fn reached_limit(&self) -> Option<Status> {
        if self.engine.events() < self.no_limit_before {
            return None;
        }
        let diagnostics = self.engine.diagnostics();
        if self.limits.until.is_some_and(|kind| diagnostics.events[kind as usize] > self.seen) {
            Some(Status::Stopped)
        } else if self.limits.collisions.is_some_and(|most| diagnostics.collisions() >= most) {
            Some(Status::CollisionLimit)
        } else if self.engine.events() >= self.limits.max_events {
            Some(Status::EventLimit)
        } else {
            None
        }
    }

    fn end_without_event(&mut self, limit: S) -> Result<(), SimulationError> {
        let is_endless = self.limits.duration.is_none();
        if self.engine.is_at_rest() || (is_endless && self.engine.is_slower_than(limit)) {
            self.end(Status::AtRest, self.time);
        } else if is_endless {
            let ball = self.ball_id(self.engine.moving_ball().unwrap_or(0));
            return Err(SimulationError::Escape { ball, time: self.time.to_f64() });
        } else {
            self.end(Status::TimeLimit, if limit > self.time { limit } else { self.time });
        }
        Ok(())
    }

    #[cold]
    fn end_by_fault(&mut self, fault: Fault) -> Result<(), SimulationError> {
        match fault {
            Fault::Overlap(ball) => Err(SimulationError::Overlap {
                ball: self.ball_id(ball as usize),
                time: self.time.to_f64(),
                depth: self.engine.diagnostics().deepest_overlap,
            }),
            Fault::NotFinite => Err(SimulationError::NotFinite { time: self.time.to_f64() }),
            Fault::Collapse(_) => {
                self.end(Status::Collapsed, self.time);
                Ok(())
            }
            Fault::Miscue => {
                self.end(Status::Miscue, self.time);
                Ok(())
            }
        }
    }

    fn end(&mut self, status: Status, time: S) {
        self.time = time;
        self.status = Some(status);
        self.engine.audit(time);
    }

    fn ball_id(&self, ball: usize) -> String {
        E::Dynamics::ball_ids(self.engine.system())[ball].clone()
    }

    /// The state of each ball at the present time.
    pub fn state(&self) -> Vec<StateOf<S, E>> {
        self.states().collect()
    }

    /// The same, one by one.
    pub fn states(&self) -> impl Iterator<Item = StateOf<S, E>> {
        let flight = |ball| E::Dynamics::last_flight(self.engine.system(), &self.engine.ball(ball));
        (0..self.engine.ball_count()).map(move |ball| E::Dynamics::state_at(&flight(ball), self.time))
    }

    /// Hands over the flight of each ball, and what goes with it, in the order of the balls.
    pub fn each_ball(&self, mut hand_over: impl FnMut(FlightOf<S, E>, TrackOf<S, E>)) {
        for ball in 0..self.engine.ball_count() {
            let (flight, track) = self.engine.ball(ball);
            hand_over(flight, track);
        }
    }

    /// What each ball is about to do, in the order of the balls.
    pub fn candidates(&mut self) -> Vec<Coming<S>> {
        let own = self.engine.comings(self.time);
        let mut all = own.clone();
        // An event of two balls is pending for one of them only.
        for coming in own {
            if let Some(other) = coming.other
                && coming.time < all[other as usize].time
            {
                let (ball, other) = (other as usize, Some(coming.ball as u32));
                all[ball] = Coming { ball, other, ..coming };
            }
        }
        all
    }

    /// The run so far, with what `log` kept of it; one that has not ended counts as stopped.
    pub fn finish(mut self, log: Log<S, E::Dynamics>) -> Run<S, E::Dynamics> {
        self.stop(Status::Stopped);
        let status = self.status.unwrap_or(Status::Stopped);
        let balls = (0..self.engine.ball_count()).map(|ball| self.engine.ball(ball)).collect();
        let diagnostics = self.engine.diagnostics().clone();
        Run::new(self.engine.system().clone(), (status, self.time), diagnostics, log, balls)
    }

    /// What the run found out about itself so far.
    pub fn diagnostics(&self) -> &Diagnostics {
        self.engine.diagnostics()
    }
}
