//! The discs dynamics: predicts a disc's next event, and makes an event happen.
//!
//! One event is pending for each disc. The only thing that makes it stale is a change of its partner's course, which the
//! partner's counter tells; nobody hunts for third parties.

use super::queue::Queue;
use crate::detect::{
    Surroundings, cushion_gap, detect_ball_ball, detect_ball_cushion, detect_first_cushion,
    detect_from_behind, detect_release,
};
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::law::ball_ball::Pair;
use crate::law::{ball_ball, ball_cushion};
use crate::model::{Face, closing_threshold};
use crate::run::{Diagnostics, Event, Kind, Observer, Run, Track};
use crate::scalar::Scalar;
use crate::scenario::System;
use std::sync::Arc;

/// Events on one ball within the collapse time after which a run is given up.
const BURST_LIMIT: u32 = 1000;

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

/// What binds a ball to a cushion from before.
enum Past {
    None,
    /// The cushion holds it.
    Held,
    /// It is a point on the other face of the thin wall.
    Behind,
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
    /// The ball whose events follow each other without end.
    pub(super) collapsed: Option<u32>,
    /// A pair found deeper in each other than the tolerance.
    pub(super) broken: Option<u32>,
}

impl<S: Scalar> Pending<S> {
    const NEVER: Self = Self { time: S::INFINITY, offset: S::INFINITY, target: Target::Nothing };

    #[inline(always)]
    fn earlier(self, start: S, offset: Option<S>, target: Target) -> Self {
        match offset {
            Some(offset) if start + offset < self.time => Self { time: start + offset, offset, target },
            _ => self,
        }
    }
}

impl<S: Scalar> Discs<S> {
    /// The discs of a system at time zero.
    pub fn new(system: Arc<System<S>>) -> Self {
        let balls = system.discs.len();
        let mut discs = Self {
            flights: system.flights.clone(),
            tracks: vec![Track::new(); balls],
            pending: vec![Pending::NEVER; balls],
            queue: Queue::new(balls),
            diagnostics: Diagnostics::default(),
            has_field: system.field != Vec2::ZERO,
            collapsed: None,
            broken: None,
            system,
        };
        discs.begin();
        discs
    }

    /// The discs at the end of a run.
    pub fn resume(run: &Run<S>) -> Self {
        let balls = run.balls.len();
        let mut discs = Self {
            flights: run.balls.iter().map(|ball| ball.0).collect(),
            tracks: run.balls.iter().map(|ball| ball.1).collect(),
            pending: vec![Pending::NEVER; balls],
            queue: Queue::new(balls),
            diagnostics: run.diagnostics.clone(),
            has_field: run.system.field != Vec2::ZERO,
            collapsed: None,
            broken: None,
            system: run.system.clone(),
        };
        discs.predict_all();
        discs
    }

    /// Back to time zero, without giving up any memory.
    pub fn reset(&mut self) {
        self.flights.copy_from_slice(&self.system.flights);
        self.tracks.fill(Track::new());
        self.diagnostics = Diagnostics::default();
        (self.collapsed, self.broken) = (None, None);
        self.begin();
    }

    fn begin(&mut self) {
        self.diagnostics.initial_energy = self.energy_at(S::ZERO);
        self.diagnostics.final_energy = self.diagnostics.initial_energy;
        self.predict_all();
    }

    /// Predicts every ball's next event from the flights as they are.
    pub(super) fn predict_all(&mut self) {
        for ball in 0..self.flights.len() {
            self.predict(ball, Target::Nothing);
        }
    }

    /// Finds a ball's next event. `struck` is what it has just been in contact with, and does not count as touching.
    #[inline]
    pub(super) fn predict(&mut self, ball: usize, struck: Target) -> Surroundings<S> {
        let mut seen = [Surroundings::CLEAR; 2];
        let next = self.next_cushion(ball, struck, &mut seen);
        let next = self.next_ball(ball, struck, next, &mut seen);
        let next = if self.tracks[ball].is_held() { self.earlier_release(ball, next) } else { next };
        self.pending[ball] = next;
        self.queue.set(ball, next.time);
        self.diagnostics.predictions += 1;
        if seen[0].overlap > S::ZERO || seen[1].overlap > S::ZERO {
            self.note_overlap(ball, &seen);
        }
        seen[0]
    }

    /// The first cushion that a ball meets. `seen` is what it sees of others and, second, of the one just struck.
    #[inline(always)]
    fn next_cushion(&self, ball: usize, struck: Target, seen: &mut [Surroundings<S>; 2]) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        if system.has_backs || !flight.is_straight() {
            return self.next_cushion_in_field(ball, struck, seen);
        }
        let radius = system.discs[ball].radius;
        let struck = if let Target::Cushion(cushion) = struck { cushion as usize } else { usize::MAX };
        let tolerance = system.tolerance.of(radius);
        match detect_first_cushion(flight, radius, &system.faces, tolerance, struck, seen) {
            Some((cushion, offset)) => {
                Pending { time: flight.start + offset, offset, target: Target::Cushion(cushion as u32) }
            }
            None => Pending::NEVER,
        }
    }

    /// The same for a ball in a field, where a cushion may hold it, or on a table with thin walls.
    fn next_cushion_in_field(
        &self,
        ball: usize,
        struck: Target,
        seen: &mut [Surroundings<S>; 2],
    ) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        let radius = system.discs[ball].radius;
        let tolerance = system.tolerance.of(radius);
        let mut next = Pending::NEVER;
        for (number, face) in system.faces.iter().enumerate() {
            let target = Target::Cushion(number as u32);
            let note = &mut seen[usize::from(target == struck)];
            let offset = match self.past(ball, number as u32) {
                Past::Held => None,
                Past::Behind => self.detect_round_the_wall(ball, face),
                Past::None => detect_ball_cushion(flight, radius, face, tolerance, note),
            };
            next = next.earlier(flight.start, offset, target);
        }
        next
    }

    /// The first ball that a ball meets, if it does so before its event `next`.
    #[inline(always)]
    fn next_ball(
        &self,
        ball: usize,
        struck: Target,
        next: Pending<S>,
        seen: &mut [Surroundings<S>; 2],
    ) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        let radius = system.discs[ball].radius;
        let struck = if let Target::Ball(other, _) = struck { other as usize } else { usize::MAX };
        let mut next = next;
        for (other, (their, disc)) in self.flights.iter().zip(&system.discs).enumerate() {
            let radii = radius + disc.radius;
            if other == ball || radii == S::ZERO {
                continue;
            }
            let note = &mut seen[usize::from(other == struck)];
            if let Some(offset) = detect_ball_ball(flight, their, radii, &system.tolerance, note) {
                let start = if flight.start > their.start { flight.start } else { their.start };
                if start + offset < next.time {
                    let target = Target::Ball(other as u32, self.tracks[other].changes);
                    next = Pending { time: start + offset, offset, target };
                }
            }
        }
        next
    }

    #[cold]
    fn note_overlap(&mut self, ball: usize, seen: &[Surroundings<S>; 2]) {
        for surroundings in seen {
            let deepest = &mut self.diagnostics.deepest_overlap;
            *deepest = deepest.max(surroundings.overlap.to_f64());
            if surroundings.broken {
                self.broken = Some(ball as u32);
            }
        }
    }

    fn past(&self, ball: usize, cushion: u32) -> Past {
        if self.tracks[ball].held_by.contains(&Some(cushion)) {
            Past::Held
        } else if self.is_behind(ball, cushion) {
            Past::Behind
        } else {
            Past::None
        }
    }

    /// Whether a ball is a point on the other face of the thin wall that a cushion is one face of.
    pub(super) fn is_behind(&self, ball: usize, cushion: u32) -> bool {
        let last = self.tracks[ball].last_cushion;
        last.is_some()
            && self.system.backs[cushion as usize] == last
            && self.system.discs[ball].radius == S::ZERO
    }

    fn detect_round_the_wall(&self, ball: usize, cushion: &Face<S>) -> Option<S> {
        match cushion {
            Face::Line(line) => {
                detect_from_behind(&self.flights[ball], line, self.system.tolerance.of(S::ZERO))
            }
            Face::Round(_) => None,
        }
    }

    fn earlier_release(&self, ball: usize, next: Pending<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        let tolerance = system.tolerance.of(system.discs[ball].radius);
        let mut next = next;
        for cushion in self.tracks[ball].held_by.into_iter().flatten() {
            if let Face::Line(line) = &system.faces[cushion as usize] {
                // Twice the tolerance: where it is let go, the ball's foot must no longer count as on the cushion.
                let offset = detect_release(flight, line, tolerance * S::from_f64(2.0));
                next = next.earlier(flight.start, offset, Target::Release(cushion));
            }
        }
        next
    }

    /// Makes the earliest event happen, if it comes no later than `limit`; gives its time.
    #[inline]
    pub fn step(&mut self, limit: S, observer: &mut impl Observer<S>) -> Option<S> {
        loop {
            let (ball, time) = self.queue.first();
            if !(time <= limit) || time == S::INFINITY {
                return None;
            }
            let pending = self.pending[ball];
            match pending.target {
                Target::Ball(other, changes) if self.tracks[other as usize].changes != changes => {
                    self.diagnostics.stale += 1;
                    self.predict(ball, Target::Nothing);
                    continue;
                }
                Target::Ball(other, _) => self.strike_ball(ball, other as usize, &pending, observer),
                Target::Cushion(cushion) => self.strike_cushion(ball, cushion, &pending, observer),
                Target::Release(cushion) => self.release(ball, cushion, &pending, observer),
                Target::Nothing => return None,
            }
            return Some(time);
        }
    }

    /// Predicts anew where a pending event is stale.
    pub(super) fn refresh(&mut self) {
        for ball in 0..self.pending.len() {
            while let Target::Ball(other, changes) = self.pending[ball].target {
                if self.tracks[other as usize].changes == changes {
                    break;
                }
                self.predict(ball, Target::Nothing);
            }
        }
    }

    #[inline]
    fn strike_cushion(
        &mut self,
        ball: usize,
        cushion: u32,
        pending: &Pending<S>,
        observer: &mut impl Observer<S>,
    ) {
        let before = self.flights[ball];
        let (position, velocity) =
            (before.position_after(pending.offset), before.velocity_after(pending.offset));
        let disc = self.system.discs[ball];
        let (normal, scale) = self.system.faces[cushion as usize].normal_at(position);
        let rebound = self.cushion_law(ball, cushion, pending.time).rebound(velocity, normal, scale);
        let track = self.tracks[ball];
        self.begin_flight(ball, pending.time, position, rebound.velocity);
        self.tracks[ball].last_cushion = Some(cushion);
        if self.predict(ball, Target::Cushion(cushion)).touching || track.is_held() {
            self.flights[ball] = before;
            self.tracks[ball] = track;
            self.strike_cluster(&[(ball, position, velocity)], pending.time, observer);
            return;
        }
        let half_mass = S::from_f64(0.5) * disc.mass;
        let change = half_mass * (rebound.velocity.norm_squared() - velocity.norm_squared());
        self.diagnostics.account(change.to_f64(), (disc.mass * rebound.energy_loss).to_f64());
        let event = Event {
            time: pending.time,
            kind: Kind::BallCushion,
            ball_a: ball as u32,
            ball_b: None,
            cushion: Some(cushion),
            point: position - normal * disc.radius,
            normal,
            closing_speed: -rebound.normal_velocity,
            impulse: (rebound.velocity - velocity).dot(normal) * scale * disc.mass,
            cluster: None,
        };
        if event.closing_speed > closing_threshold(velocity, Vec2::ZERO) {
            self.emit(&event, observer);
        }
        if self.has_field && self.settle(ball, &[cushion], observer) {
            self.predict(ball, Target::Cushion(cushion));
        }
        observer.flight(ball, &self.flights[ball]);
    }

    fn strike_ball(
        &mut self,
        ball: usize,
        other: usize,
        pending: &Pending<S>,
        observer: &mut impl Observer<S>,
    ) {
        let (a, b) = if ball < other { (ball, other) } else { (other, ball) };
        let before = [self.flights[a], self.flights[b]];
        let tracks = [self.tracks[a], self.tracks[b]];
        let start = if before[0].start > before[1].start { before[0].start } else { before[1].start };
        let [(position_a, velocity_a), (position_b, velocity_b)] =
            before.map(|f| state_after(&f, start, pending.offset));
        let discs = [self.system.discs[a], self.system.discs[b]];
        let pair = Pair::new([&discs[0], &discs[1]], position_b - position_a, [velocity_a, velocity_b]);
        let law = self.ball_law(a, b, pending.time);
        let impulse = law.impulse(&pair);
        let after_a = velocity_a - pair.normal * (impulse * discs[0].inverse_mass);
        let after_b = velocity_b + pair.normal * (impulse * discs[1].inverse_mass);
        self.begin_flight(a, pending.time, position_a, after_a);
        self.begin_flight(b, pending.time, position_b, after_b);
        self.forget_left_cushion(a);
        self.forget_left_cushion(b);
        let touching_a = self.predict(a, Target::Ball(b as u32, 0)).touching;
        let touching_b = self.predict(b, Target::Ball(a as u32, 0)).touching;
        if touching_a || touching_b || tracks[0].is_held() || tracks[1].is_held() {
            (self.flights[a], self.flights[b]) = (before[0], before[1]);
            (self.tracks[a], self.tracks[b]) = (tracks[0], tracks[1]);
            let struck = [(a, position_a, velocity_a), (b, position_b, velocity_b)];
            self.strike_cluster(&struck, pending.time, observer);
            return;
        }
        self.account_pair(
            &discs.map(|d| d.mass),
            [velocity_a, velocity_b],
            [after_a, after_b],
            law.energy_loss(&pair),
        );
        let event = Event {
            time: pending.time,
            kind: Kind::BallBall,
            ball_a: a as u32,
            ball_b: Some(b as u32),
            cushion: None,
            point: position_a + pair.normal * discs[0].radius,
            normal: pair.normal,
            closing_speed: pair.closing_speed,
            impulse,
            cluster: None,
        };
        self.emit(&event, observer);
        observer.flight(a, &self.flights[a]);
        observer.flight(b, &self.flights[b]);
    }

    /// Forgets the cushion that a point touched last, once it has left it.
    fn forget_left_cushion(&mut self, ball: usize) {
        let radius = self.system.discs[ball].radius;
        if radius > S::ZERO || !self.system.has_backs {
            return;
        }
        if let Some(cushion) = self.tracks[ball].last_cushion {
            let tolerance = &self.system.tolerance;
            let cushion = &self.system.faces[cushion as usize];
            let gap = cushion_gap(self.flights[ball].position, radius, cushion, tolerance);
            if !gap.is_some_and(|gap| gap.abs() <= tolerance.of(radius)) {
                self.tracks[ball].last_cushion = None;
            }
        }
    }

    fn account_pair(&mut self, masses: &[S; 2], before: [Vec2<S>; 2], after: [Vec2<S>; 2], loss: S) {
        let mut change = S::ZERO;
        let mut momentum = Vec2::ZERO;
        for k in 0..2 {
            change += masses[k] * (after[k].norm_squared() - before[k].norm_squared());
            momentum = momentum + (after[k] - before[k]) * masses[k];
        }
        self.diagnostics.account((change * S::from_f64(0.5)).to_f64(), loss.to_f64());
        let error = momentum.x.abs() + momentum.y.abs();
        self.diagnostics.momentum_error = self.diagnostics.momentum_error.max(error.to_f64());
    }

    /// Starts a ball's new flight, free of any cushion that held it.
    #[inline(always)]
    pub(super) fn begin_flight(&mut self, ball: usize, time: S, position: Vec2<S>, velocity: Vec2<S>) {
        self.flights[ball] = Flight { start: time, position, velocity, acceleration: self.system.field };
        let burst_time = self.system.collapse_times[ball];
        let track = &mut self.tracks[ball];
        track.changes += 1;
        track.held_by = [None; 2];
        track.last_contact = time;
        if !(time - track.burst_start <= burst_time) {
            (track.burst_start, track.burst) = (time, 0);
        }
        track.burst += 1;
        if track.burst > BURST_LIMIT {
            self.collapsed = Some(ball as u32);
        }
    }

    #[inline(always)]
    pub(super) fn emit(&mut self, event: &Event<S>, observer: &mut impl Observer<S>) {
        self.diagnostics.count(event.kind);
        observer.event(event);
        if self.diagnostics.total_events().is_power_of_two() {
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

/// Position and velocity an `offset` after `start`, which is not before the flight's own start.
#[inline(always)]
fn state_after<S: Scalar>(flight: &Flight<S>, start: S, offset: S) -> (Vec2<S>, Vec2<S>) {
    let elapsed = start - flight.start;
    let from_start = Flight {
        start,
        position: flight.position_after(elapsed),
        velocity: flight.velocity_after(elapsed),
        acceleration: flight.acceleration,
    };
    (from_start.position_after(offset), from_start.velocity_after(offset))
}
