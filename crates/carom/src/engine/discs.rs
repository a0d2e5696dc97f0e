//! The state of the discs, and the one primitive: make the earliest event happen.
//!
//! One event is pending for each disc. The only thing that makes it stale is a change of its partner's course, which the
//! partner's counter tells; nobody hunts for third parties. A few discs are asked one by one and play a tournament for who
//! is first; many have a grid and a calendar. Neither changes a bit of a run.

use super::ball::{Ball, Rest};
use super::interface::{Engine, Fault};
use super::many::Many;
use super::queue::{Pending, Queue, Target};
use super::simulation::Coming;
use crate::detect::cushion_gap;
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::law::{ball_ball, ball_cushion};
use crate::memory::room_for;
use crate::model::Disc;
use crate::run::{Diagnostics, Event, Kind, Observer, Plane, Run, Track};
use crate::scalar::Scalar;
use crate::scenario::System;
use std::sync::Arc;

/// Changes of course of one ball within the collapse time after which a run is given up: a power of two.
const BURST_LIMIT: u32 = 1024;

/// The energy is summed at 2^k events, but not below sixteen: so short a run is summed at its end.
const AUDIT_MASK: u64 = 15;

/// The state of the discs: everything that changes during a run.
#[derive(Clone, Debug)]
pub struct Discs<S> {
    pub(super) system: Arc<System<S>>,
    pub(super) balls: Vec<Ball<S>>,
    pub(super) rest: Vec<Rest<S>>,
    /// What comes first, of a few balls.
    pub(super) queue: Queue<S>,
    /// What comes first of many, and who is near whom.
    pub(super) many: Option<Many<S>>,
    pub(super) diagnostics: Diagnostics,
    /// All events so far.
    pub(super) events: u64,
    energy_at_start: f64,
    pub(super) has_field: bool,
    /// All balls are of one size and mass.
    pub(super) are_alike: bool,
    /// Neither a field nor thin walls: prediction takes a shorter way.
    pub(super) is_plain: bool,
    /// And no walls at all.
    pub(super) is_open: bool,
    /// A ball's last contact is kept beside its flight: that is not just where it began, or the laws ask for it.
    notes_contacts: bool,
    pub(super) fault: Option<Fault>,
}

impl<S: Scalar> Engine<S> for Discs<S> {
    type Dynamics = Plane;

    fn new(system: Arc<System<S>>, observer: &mut impl Observer<S>) -> Self {
        let flights = Arc::clone(&system);
        let start = flights.flights.iter().map(|&flight| (flight, Track::new()));
        let mut discs = Self::with(system, start, S::ZERO);
        discs.energy_at_start = discs.energy_at(S::ZERO);
        discs.begin(observer);
        discs
    }

    fn resume(run: &Run<S>) -> Self {
        let mut discs = Self::with(run.system.clone(), run.balls.iter().copied(), run.end_time);
        discs.diagnostics = run.diagnostics.clone();
        discs.events = run.diagnostics.total_events();
        discs.energy_at_start = run.diagnostics.initial_energy;
        discs.predict_all();
        discs
    }

    fn reset(&mut self, observer: &mut impl Observer<S>) {
        self.put_at_start();
        self.begin(observer);
    }

    fn restart(&mut self, change: impl FnOnce(&mut System<S>), observer: &mut impl Observer<S>) {
        change(Arc::make_mut(&mut self.system));
        self.put_at_start();
        self.energy_at_start = self.energy_at(S::ZERO);
        self.begin(observer);
    }

    #[inline(always)]
    fn step(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        if self.many.is_some() {
            self.step_among_many(limit, observer)
        } else {
            self.step_among_few(limit, observer)
        }
    }

    fn next_time(&mut self) -> S {
        self.time_of_next()
    }

    #[inline(always)]
    fn events(&self) -> u64 {
        self.events
    }

    #[inline(always)]
    fn fault(&self) -> Option<Fault> {
        self.fault
    }

    #[inline(always)]
    fn diagnostics(&self) -> &Diagnostics {
        &self.diagnostics
    }

    fn system(&self) -> &Arc<System<S>> {
        &self.system
    }

    fn ball_count(&self) -> usize {
        self.balls.len()
    }

    fn ball(&self, ball: usize) -> (Flight<S>, Track<S>) {
        let (line, mut track) = (&self.balls[ball], self.rest[ball].track);
        track.changes = line.changes;
        if !self.notes_contacts && line.changes > 0 {
            track.last_contact = line.start;
        }
        (self.flight(ball), track)
    }

    fn is_at_rest(&self) -> bool {
        (0..self.balls.len()).all(|ball| self.flight(ball).is_rest())
    }

    fn is_slower_than(&self, latest: S) -> bool {
        let size = self.system.tolerance.table_size();
        (0..self.balls.len()).all(|ball| self.flight(ball).is_rest_within(size, latest))
    }

    fn moving_ball(&self) -> Option<usize> {
        (0..self.balls.len()).position(|ball| !self.flight(ball).is_rest())
    }

    fn audit(&mut self, time: S) {
        self.sum_energy(time);
    }

    fn comings(&mut self, time: S) -> Vec<Coming<S>> {
        // Each ball is asked anew, without the grid: what comes after its cell only a look at all others tells, and what
        // was predicted for the other ball of a pair is not pending for this one.
        let coming = |ball| self.coming(ball, self.next_of_all(ball), time);
        (0..self.balls.len()).map(coming).collect()
    }
}

impl<S: Scalar> Discs<S> {
    #[inline(always)]
    fn step_among_few(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        loop {
            let (ball, pending) = self.queue.first();
            if pending.time > limit || matches!(pending.target, Target::Nothing) {
                return None;
            }
            if self.strike::<false>(ball, pending, observer) {
                return Some(pending.time);
            }
        }
    }

    #[inline(never)]
    fn step_among_many(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        loop {
            let (ball, pending) = self.first_of_many(limit)?;
            if self.strike::<true>(ball, pending, observer) {
                return Some(pending.time);
            }
        }
    }

    /// Makes what is pending for a ball happen, unless its partner has changed its course meanwhile: then the ball's next
    /// event is found anew.
    #[inline(always)]
    fn strike<const MANY: bool>(
        &mut self,
        ball: usize,
        Pending { time, offset, target }: Pending<S>,
        observer: &mut impl Observer<S>,
    ) -> bool {
        match target {
            Target::Cushion(cushion) => self.strike_cushion::<MANY>(ball, cushion, time, offset, observer),
            Target::Ball(other, changes) => {
                if self.balls[other as usize].changes != changes {
                    self.diagnostics.stale += 1;
                    self.predict(ball);
                    return false;
                }
                self.strike_ball::<MANY>(ball, other as usize, time, offset, observer);
            }
            Target::Release(cushion) => self.release(ball, cushion, time, offset, observer),
            Target::Nothing => return false,
        }
        true
    }

    fn with(
        system: Arc<System<S>>,
        balls: impl ExactSizeIterator<Item = (Flight<S>, Track<S>)>,
        time: S,
    ) -> Self {
        let is_plain = system.field == Vec2::ZERO && !system.has_backs;
        let has_grid = balls.len() >= system.grid_from || system.is_periodic();
        let mut discs = Self {
            many: if has_grid { Many::new(&system) } else { None },
            balls: room_for(balls.len()),
            rest: room_for(balls.len()),
            queue: Queue::new(0),
            diagnostics: Diagnostics::default(),
            events: 0,
            energy_at_start: 0.0,
            has_field: system.field != Vec2::ZERO,
            are_alike: system.discs.windows(2).all(|two| two[0] == two[1]),
            is_plain,
            is_open: is_plain && system.faces.is_open,
            notes_contacts: !is_plain || system.collapse_is_elastic,
            fault: None,
            system,
        };
        if discs.many.is_none() {
            discs.queue = Queue::new(balls.len());
        }
        discs.put(balls, time);
        discs
    }

    fn put_at_start(&mut self) {
        for (ball, flight) in self.system.flights.iter().enumerate() {
            self.balls[ball] = Ball::new(ball, self.balls[ball].radius, flight, 0);
            self.rest[ball] = Rest::new(flight, Track::new());
        }
        if let Some(many) = &mut self.many {
            many.put(&mut self.balls, &mut self.rest, S::ZERO);
        }
    }

    /// Puts the balls where their flights have brought them by a time.
    fn put(&mut self, balls: impl Iterator<Item = (Flight<S>, Track<S>)>, time: S) {
        self.balls.clear();
        self.rest.clear();
        for (number, ((flight, track), disc)) in balls.zip(&self.system.discs).enumerate() {
            self.balls.push(Ball::new(number, disc.radius, &flight, track.changes));
            self.rest.push(Rest::new(&flight, track));
        }
        if let Some(many) = &mut self.many {
            many.put(&mut self.balls, &mut self.rest, time);
        }
    }

    fn begin(&mut self, observer: &mut impl Observer<S>) {
        let (initial_energy, final_energy) = (self.energy_at_start, self.energy_at_start);
        self.diagnostics = Diagnostics { initial_energy, final_energy, ..Diagnostics::default() };
        (self.events, self.fault) = (0, None);
        self.predict_all();
        for ball in 0..self.balls.len() {
            observer.flight(ball, &self.seen_flight(ball));
        }
    }

    /// What a ball's next event is.
    fn coming(&self, ball: usize, pending: Pending<S>, now: S) -> Coming<S> {
        let position = self.state_at(ball, now).position;
        let radius = self.balls[ball].radius;
        let (kind, other, cushion, gap) = match pending.target {
            Target::Nothing => (None, None, None, None),
            Target::Ball(other, _) => {
                let away = self.state_at(other as usize, now).position - position;
                let distance = self.system.shortest(away).norm();
                let gap = distance - radius - self.balls[other as usize].radius;
                (Some(Kind::BallBall), Some(other), None, Some(gap))
            }
            Target::Cushion(cushion) => {
                let (face, tolerance) = (&self.system.faces.all[cushion as usize], &self.system.tolerance);
                (Some(Kind::BallCushion), None, Some(cushion), cushion_gap(position, radius, face, tolerance))
            }
            Target::Release(cushion) => (Some(Kind::Release), None, Some(cushion), None),
        };
        Coming { ball, kind, other, cushion, time: pending.time, gap }
    }

    /// What stays the same about a ball. Where all are alike it is read of the first: of a great many, each in a place of its
    /// own is far away.
    #[inline(always)]
    pub(super) fn disc(&self, ball: usize) -> &Disc<S> {
        &self.system.discs[if self.are_alike { 0 } else { ball }]
    }

    /// The flight from a state on, free of any cushion.
    #[inline(always)]
    pub(super) fn free_flight(&self, start: S, State { position, velocity }: State<S>) -> Flight<S> {
        Flight { start, position, velocity, acceleration: self.system.field }
    }

    /// A ball's flight; on a periodic table its place is that in the first image of the table at its start.
    #[inline(always)]
    pub(super) fn flight(&self, ball: usize) -> Flight<S> {
        let flight = self.balls[ball].straight_flight();
        if self.is_plain { flight } else { Flight { acceleration: self.rest[ball].acceleration, ..flight } }
    }

    /// The same as an observer sees it: on a periodic table with all the way that the ball has gone.
    #[inline(always)]
    pub(super) fn seen_flight(&self, ball: usize) -> Flight<S> {
        let flight = self.flight(ball);
        if self.many.is_none() { flight } else { self.system.unwrapped(&flight, self.rest[ball].track.image) }
    }

    /// Starts a ball's new flight, free of any cushion that held it.
    #[inline(always)]
    pub(super) fn begin_flight(&mut self, ball: usize, flight: Flight<S>) {
        self.begin_flight_of::<true>(ball, flight);
    }

    /// The same where it is known whether there are many balls: of a few none goes round a table.
    #[inline(always)]
    pub(super) fn begin_flight_of<const MANY: bool>(&mut self, ball: usize, flight: Flight<S>) {
        let line = &mut self.balls[ball];
        (line.start, line.position, line.velocity) = (flight.start, flight.position, flight.velocity);
        line.changes = line.changes.wrapping_add(1);
        let (changes, rounds) = (line.changes, line.rounds);
        if changes & (BURST_LIMIT - 1) == 0 {
            self.end_burst(ball, flight.start);
        }
        if MANY && rounds != [0; 2] {
            self.keep_rounds(ball);
        }
        if !self.is_plain {
            let rest = &mut self.rest[ball];
            (rest.acceleration, rest.is_falling) = (flight.acceleration, [false; 2]);
            rest.track.held_by = [None; 2];
        }
    }

    /// Keeps how often a ball has gone round the table on the flight that ends: it begins the next one in the first image.
    #[cold]
    fn keep_rounds(&mut self, ball: usize) {
        let (line, track) = (&mut self.balls[ball], &mut self.rest[ball].track);
        for (image, rounds) in track.image.iter_mut().zip(&mut line.rounds) {
            *image = image.wrapping_add(i32::from(core::mem::take(rounds)));
        }
    }

    /// Lays a ball's flight on a cushion: the flight that has just begun is not the one it goes on with.
    pub(super) fn lay_flight(&mut self, ball: usize, flight: &Flight<S>) {
        let line = &mut self.balls[ball];
        (line.start, line.position, line.velocity) = (flight.start, flight.position, flight.velocity);
        let rest = &mut self.rest[ball];
        (rest.acceleration, rest.is_falling) = (flight.acceleration, [false; 2]);
    }

    /// Notes that a ball had a contact, where that is not just where its flight began, or the laws ask for it.
    #[inline(always)]
    pub(super) fn note_contact(&mut self, ball: usize, time: S) {
        if self.notes_contacts {
            self.rest[ball].track.last_contact = time;
        }
    }

    /// Begins to count a ball's changes of course anew: so many within the collapse time were too many, which is a fault.
    #[cold]
    fn end_burst(&mut self, ball: usize, time: S) {
        let track = &mut self.rest[ball].track;
        if time - track.burst_start <= self.system.collapse_times[ball] {
            self.fault = Some(Fault::Collapse(ball as u32));
        }
        track.burst_start = time;
    }

    #[inline(always)]
    pub(super) fn emit(&mut self, event: &Event<S>, observer: &mut impl Observer<S>) {
        self.diagnostics.count(event.kind);
        observer.event(event);
        self.events += 1;
        if self.events & AUDIT_MASK == 0 && self.events.is_power_of_two() {
            self.sum_energy(event.time);
        }
    }

    /// The law of a cushion for a ball now: without loss in a burst of contacts, if the scenario says so.
    #[inline(always)]
    pub(super) fn cushion_law(&self, ball: usize, cushion: u32, time: S) -> ball_cushion::Law<S> {
        if self.is_in_burst(ball, time) {
            ball_cushion::Law::ELASTIC
        } else {
            self.system.cushion_laws[cushion as usize]
        }
    }

    /// The law between two balls now.
    #[inline(always)]
    pub(super) fn ball_law(&self, a: usize, b: usize, time: S) -> ball_ball::Law<S> {
        if self.is_in_burst(a, time) || self.is_in_burst(b, time) {
            ball_ball::Law::ELASTIC
        } else {
            self.system.ball_ball
        }
    }

    /// The speed with which a ball in a field parts from another or from a cushion at least, for a hop of about t_c; zero
    /// unless the scenario has balls hop on.
    #[inline(always)]
    pub(super) fn kept_speed(&self, ball: usize, other: Option<usize>) -> S {
        if !self.system.collapse_is_elastic {
            return S::ZERO;
        }
        let times = &self.system.collapse_times;
        let other = times[other.unwrap_or(ball)];
        let time = if other < times[ball] { other } else { times[ball] };
        time * self.system.field.norm() * S::from_f64(0.5)
    }

    #[inline(always)]
    fn is_in_burst(&self, ball: usize, time: S) -> bool {
        self.system.collapse_is_elastic
            && time - self.rest[ball].track.last_contact < self.system.collapse_times[ball]
    }
}
