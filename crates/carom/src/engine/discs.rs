//! The state of the discs, and the one primitive: make the earliest event happen.
//!
//! One event is pending for each disc. The only thing that makes it stale is a change of its partner's course, which the
//! partner's counter tells; nobody hunts for third parties.

use super::queue::Queue;
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::law::{ball_ball, ball_cushion};
use crate::run::{Diagnostics, Event, Observer, Run, Track};
use crate::scalar::Scalar;
use crate::scenario::System;
use std::sync::Arc;

/// Events on one ball within the collapse time after which a run is given up.
const BURST_LIMIT: u32 = 1000;

/// The energy is summed at 2^k events, but not below sixteen: so short a run is summed at its end.
const AUDIT_MASK: u64 = 15;

/// What a ball's next event is with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// No event.
    Nothing,
    /// Another ball, with the number of changes of course it had when this was predicted.
    Ball(u32, u64),
    /// A cushion.
    Cushion(u32),
    /// The end of the cushion that holds the ball.
    Release(u32),
}

/// A ball's next event.
#[derive(Clone, Copy, Debug)]
pub struct Pending<S> {
    /// When.
    pub time: S,
    /// The same, as offset from the later start of the flights involved, unrounded.
    pub offset: S,
    /// With what.
    pub target: Target,
}

/// What no run survives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The events of this ball follow each other without end.
    Collapse(u32),
    /// This ball is deeper in another than the contact tolerance.
    Overlap(u32),
}

/// The state of the discs: everything that changes during a run.
#[derive(Clone, Debug)]
pub struct Discs<S> {
    pub(super) system: Arc<System<S>>,
    pub(super) flights: Vec<Flight<S>>,
    pub(super) tracks: Vec<Track<S>>,
    pub(super) pending: Vec<Pending<S>>,
    pub(super) queue: Queue<S>,
    pub(super) diagnostics: Diagnostics,
    pub(super) has_field: bool,
    /// Neither a field nor thin walls: prediction takes a shorter way.
    pub(super) is_plain: bool,
    pub(super) fault: Option<Fault>,
}

impl<S: Scalar> Pending<S> {
    pub(super) const NEVER: Self = Self { time: S::INFINITY, offset: S::INFINITY, target: Target::Nothing };

    #[inline(always)]
    pub(super) fn earlier(self, start: S, offset: Option<S>, target: Target) -> Self {
        match offset {
            Some(offset) if start + offset < self.time => Self { time: start + offset, offset, target },
            _ => self,
        }
    }
}

impl<S: Scalar> Discs<S> {
    /// The discs of a system at time zero.
    pub fn new(system: Arc<System<S>>) -> Self {
        let tracks = vec![Track::new(); system.discs.len()];
        let mut discs = Self::with(system.clone(), system.flights.clone(), tracks);
        discs.begin();
        discs
    }

    /// The discs at the end of a run.
    pub fn resume(run: &Run<S>) -> Self {
        let (flights, tracks) = run.balls.iter().copied().unzip();
        let mut discs = Self::with(run.system.clone(), flights, tracks);
        discs.diagnostics = run.diagnostics.clone();
        discs.predict_all();
        discs
    }

    fn with(system: Arc<System<S>>, flights: Vec<Flight<S>>, tracks: Vec<Track<S>>) -> Self {
        Self {
            pending: vec![Pending::NEVER; flights.len()],
            queue: Queue::new(flights.len()),
            diagnostics: Diagnostics::default(),
            has_field: system.field != Vec2::ZERO,
            is_plain: system.field == Vec2::ZERO && !system.has_backs,
            fault: None,
            system,
            flights,
            tracks,
        }
    }

    /// Back to time zero, without giving up any memory.
    pub fn reset(&mut self) {
        self.flights.copy_from_slice(&self.system.flights);
        self.tracks.fill(Track::new());
        self.diagnostics = Diagnostics::default();
        self.fault = None;
        self.begin();
    }

    fn begin(&mut self) {
        self.diagnostics.initial_energy = self.energy_at(S::ZERO);
        self.diagnostics.final_energy = self.diagnostics.initial_energy;
        self.predict_all();
    }

    /// Makes the earliest event happen, if it comes no later than `limit`; gives its time.
    #[inline(always)]
    pub fn step(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        loop {
            let (ball, time) = self.queue.first();
            if time > limit || time == S::INFINITY {
                return None;
            }
            let Pending { offset, target, .. } = self.pending[ball];
            match target {
                Target::Cushion(cushion) => self.strike_cushion(ball, cushion, time, offset, observer),
                Target::Ball(other, changes) => {
                    if self.tracks[other as usize].changes != changes {
                        self.diagnostics.stale += 1;
                        self.predict(ball, Target::Nothing);
                        continue;
                    }
                    self.strike_ball(ball, other as usize, time, offset, observer);
                }
                Target::Release(cushion) => self.release(ball, cushion, time, offset, observer),
                Target::Nothing => return None,
            }
            return Some(time);
        }
    }

    /// Starts a ball's new flight, free of any cushion that held it.
    #[inline(always)]
    pub(super) fn begin_flight(&mut self, ball: usize, time: S, position: Vec2<S>, velocity: Vec2<S>) {
        self.flights[ball] = Flight { start: time, position, velocity, acceleration: self.system.field };
        let track = &mut self.tracks[ball];
        track.changes += 1;
        track.held_by = [None; 2];
    }

    /// Notes that a ball had an event, which for a ball whose events follow each other too fast is a fault.
    #[inline(always)]
    pub(super) fn note_contact(&mut self, ball: usize, time: S) {
        let burst_time = self.system.collapse_times[ball];
        let track = &mut self.tracks[ball];
        track.last_contact = time;
        if time - track.burst_start > burst_time {
            (track.burst_start, track.burst) = (time, 0);
        }
        track.burst += 1;
        if track.burst > BURST_LIMIT {
            self.fault = Some(Fault::Collapse(ball as u32));
        }
    }

    #[inline(always)]
    pub(super) fn emit(&mut self, event: &Event<S>, observer: &mut impl Observer<S>) {
        self.diagnostics.count(event.kind);
        observer.event(event);
        let events = self.diagnostics.total_events();
        if events & AUDIT_MASK == 0 && events.is_power_of_two() {
            self.audit(event.time);
        }
    }

    /// The law of a cushion for a ball now: without normal loss in a burst of contacts, if the scenario says so.
    #[inline(always)]
    pub(super) fn cushion_law(&self, ball: usize, cushion: u32, time: S) -> ball_cushion::Restitution<S> {
        let law = self.system.cushion_laws[cushion as usize];
        if self.is_in_burst(ball, time) { ball_cushion::Restitution { normal: S::ONE, ..law } } else { law }
    }

    /// The law between two balls now.
    #[inline(always)]
    pub(super) fn ball_law(&self, a: usize, b: usize, time: S) -> ball_ball::Restitution<S> {
        if self.is_in_burst(a, time) || self.is_in_burst(b, time) {
            ball_ball::Restitution::ELASTIC
        } else {
            self.system.ball_ball
        }
    }

    #[inline(always)]
    fn is_in_burst(&self, ball: usize, time: S) -> bool {
        self.system.collapse_is_elastic
            && time - self.tracks[ball].last_contact < self.system.collapse_times[ball]
    }
}
