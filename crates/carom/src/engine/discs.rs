//! The state of the discs, and the one primitive: make the earliest event happen.
//!
//! One event is pending for each disc. The only thing that makes it stale is a change of its partner's course, which the
//! partner's counter tells; nobody hunts for third parties.

use super::grid::Grid;
use super::interface::{Engine, Fault};
use super::queue::{Pending, Queue, Target};
use super::simulation::Coming;
use crate::detect::cushion_gap;
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::law::{ball_ball, ball_cushion};
use crate::model::Disc;
use crate::run::{Diagnostics, Event, Kind, Observer, Plane, Run, Track};
use crate::scalar::Scalar;
use crate::scenario::System;
use std::sync::Arc;

/// Events on one ball within the collapse time after which a run is given up.
const BURST_LIMIT: u32 = 1000;

/// The energy is summed at 2^k events, but not below sixteen: so short a run is summed at its end.
const AUDIT_MASK: u64 = 15;

/// A ball under way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball<S> {
    pub(super) flight: Flight<S>,
    pub(super) disc: Disc<S>,
    pub(super) track: Track<S>,
}

/// Where balls are, and for each what it meets next if that comes before it leaves its cell.
#[derive(Clone, Debug)]
pub(super) struct Neighbourhood<S> {
    pub(super) grid: Grid<S>,
    pub(super) meetings: Vec<Pending<S>>,
}

/// The state of the discs: everything that changes during a run.
#[derive(Clone, Debug)]
pub struct Discs<S> {
    pub(super) system: Arc<System<S>>,
    pub(super) balls: Vec<Ball<S>>,
    pub(super) queue: Queue<S>,
    /// Who is near whom, where there are many.
    pub(super) grid: Option<Neighbourhood<S>>,
    pub(super) diagnostics: Diagnostics,
    /// All events so far.
    pub(super) events: u64,
    energy_at_start: f64,
    pub(super) has_field: bool,
    /// Neither a field nor thin walls: prediction takes a shorter way.
    pub(super) is_plain: bool,
    pub(super) fault: Option<Fault>,
}

impl<S: Scalar> Engine<S> for Discs<S> {
    type Dynamics = Plane;

    fn new(system: Arc<System<S>>, observer: &mut impl Observer<S>) -> Self {
        let start: Vec<_> = system.flights.iter().map(|&flight| (flight, Track::new())).collect();
        let mut discs = Self::with(system, &start, S::ZERO);
        discs.energy_at_start = discs.energy_at(S::ZERO);
        discs.begin(observer);
        discs
    }

    fn resume(run: &Run<S>) -> Self {
        let mut discs = Self::with(run.system.clone(), &run.balls, run.end_time);
        discs.diagnostics = run.diagnostics.clone();
        discs.events = run.diagnostics.total_events();
        discs.energy_at_start = run.diagnostics.initial_energy;
        discs.predict_all();
        discs
    }

    fn reset(&mut self, observer: &mut impl Observer<S>) {
        for (ball, flight) in self.balls.iter_mut().zip(&self.system.flights) {
            (ball.flight, ball.track) = (*flight, Track::new());
        }
        if let Some(Neighbourhood { grid, .. }) = &mut self.grid {
            let places: Vec<_> = self.system.flights.iter().map(|flight| flight.position).collect();
            grid.fill(&places);
        }
        self.begin(observer);
    }

    #[inline(always)]
    fn step(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        if self.grid.is_some() {
            self.step_among_many(limit, observer)
        } else {
            self.step_with::<false>(limit, observer)
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
        (self.balls[ball].flight, self.balls[ball].track)
    }

    fn is_at_rest(&self) -> bool {
        self.balls.iter().all(|ball| ball.flight.is_rest())
    }

    fn is_slower_than(&self, latest: S) -> bool {
        let size = self.system.tolerance.table_size();
        self.balls.iter().all(|ball| ball.flight.is_rest_within(size, latest))
    }

    fn moving_ball(&self) -> Option<usize> {
        self.balls.iter().position(|ball| !ball.flight.is_rest())
    }

    fn audit(&mut self, time: S) {
        self.sum_energy(time);
    }

    fn comings(&mut self, time: S) -> Vec<Coming<S>> {
        // Each ball is asked anew, without the grid: what comes after its cell only a look at all others tells, and what
        // was predicted for the other ball of a pair is not pending for this one.
        let grid = self.grid.take();
        self.predict_all();
        let comings = (0..self.balls.len()).map(|ball| self.coming(ball, time)).collect();
        if grid.is_some() {
            self.grid = grid;
            self.predict_all();
        }
        comings
    }
}

impl<S: Scalar> Discs<S> {
    #[inline(never)]
    fn step_among_many(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        self.step_with::<true>(limit, observer)
    }

    /// A step; with a grid or without one, so that a few balls pay nothing for what many need.
    #[inline(always)]
    fn step_with<const GRID: bool>(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        loop {
            let (ball, Pending { time, offset, target }) = self.queue.first();
            if time > limit {
                return None;
            }
            match target {
                Target::Cushion(cushion) => {
                    self.strike_cushion::<GRID>(ball, cushion, time, offset, observer)
                }
                Target::Ball(other, changes) => {
                    if self.balls[other as usize].track.changes != changes {
                        self.diagnostics.stale += 1;
                        self.predict(ball);
                        continue;
                    }
                    self.strike_ball::<GRID>(ball, other as usize, time, offset, observer);
                }
                Target::Release(cushion) => self.release(ball, cushion, time, offset, observer),
                Target::Cell(side) if GRID => {
                    self.cross(ball, side);
                    continue;
                }
                Target::Nothing | Target::Cell(_) => return None,
            }
            return Some(time);
        }
    }

    fn with(system: Arc<System<S>>, balls: &[(Flight<S>, Track<S>)], time: S) -> Self {
        let ball = |(&(flight, track), &disc)| Ball { flight, disc, track };
        let is_plain = system.field == Vec2::ZERO && !system.has_backs;
        let is_grid_worth_it = is_plain && balls.len() >= system.grid_from;
        Self {
            grid: is_grid_worth_it.then(|| Neighbourhood::new(&system, balls, time)).flatten(),
            balls: balls.iter().zip(&system.discs).map(ball).collect(),
            queue: Queue::new(balls.len()),
            diagnostics: Diagnostics::default(),
            events: 0,
            energy_at_start: 0.0,
            has_field: system.field != Vec2::ZERO,
            is_plain,
            fault: None,
            system,
        }
    }

    fn begin(&mut self, observer: &mut impl Observer<S>) {
        let (initial_energy, final_energy) = (self.energy_at_start, self.energy_at_start);
        self.diagnostics = Diagnostics { initial_energy, final_energy, ..Diagnostics::default() };
        (self.events, self.fault) = (0, None);
        self.predict_all();
        for (place, ball) in self.balls.iter().enumerate() {
            observer.flight(place, &ball.flight);
        }
    }

    /// What a ball's pending event is.
    fn coming(&self, ball: usize, now: S) -> Coming<S> {
        let pending = self.queue.pending(ball);
        let position = self.state_at(ball, now).position;
        let radius = self.balls[ball].disc.radius;
        let (kind, other, cushion, gap) = match pending.target {
            Target::Nothing | Target::Cell(_) => (None, None, None, None),
            Target::Ball(other, _) => {
                let distance = (self.state_at(other as usize, now).position - position).norm();
                let gap = distance - radius - self.balls[other as usize].disc.radius;
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

    /// The flight from a state on, free of any cushion.
    #[inline(always)]
    pub(super) fn free_flight(&self, start: S, State { position, velocity }: State<S>) -> Flight<S> {
        Flight { start, position, velocity, acceleration: self.system.field }
    }

    /// Starts a ball's new flight, free of any cushion that held it.
    #[inline(always)]
    pub(super) fn begin_flight(&mut self, ball: usize, flight: Flight<S>) {
        let ball = &mut self.balls[ball];
        ball.flight = flight;
        ball.track.changes += 1;
        ball.track.held_by = [None; 2];
    }

    /// Notes that a ball had an event, which for a ball whose events follow each other too fast is a fault.
    #[inline(always)]
    pub(super) fn note_contact(&mut self, ball: usize, time: S) {
        let track = &mut self.balls[ball].track;
        track.last_contact = time;
        track.burst += 1;
        if track.burst > BURST_LIMIT {
            self.end_burst(ball, time);
        }
    }

    /// Begins to count a ball's events anew: so many within the collapse time were too many.
    #[cold]
    fn end_burst(&mut self, ball: usize, time: S) {
        let track = &mut self.balls[ball].track;
        if time - track.burst_start <= self.system.collapse_times[ball] {
            self.fault = Some(Fault::Collapse(ball as u32));
        }
        (track.burst_start, track.burst) = (time, 0);
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
            && time - self.balls[ball].track.last_contact < self.system.collapse_times[ball]
    }
}

impl<S: Scalar> Neighbourhood<S> {
    fn new(system: &System<S>, balls: &[(Flight<S>, Track<S>)], time: S) -> Option<Self> {
        let bounds = system.faces.bounds();
        let diameter = system
            .discs
            .iter()
            .fold(S::ZERO, |most, disc| if disc.radius > most { disc.radius } else { most });
        let places: Vec<_> =
            balls.iter().map(|(flight, _)| flight.position_after(time - flight.start)).collect();
        let grid = Grid::new(&bounds, diameter + diameter, &places)?;
        Some(Self { grid, meetings: vec![Pending::NEVER; balls.len()] })
    }
}
