//! The fixed-step method: the classic scheme of programming courses, kept so that people can see what a time step costs.
//!
//! Every ball moves by `v h` in a step of length h. A ball that would leave the box, or two that would overlap, are taken
//! to their contact by a shortened step and get their new velocities there; what is left of their step is lost. The time
//! to contact of two balls is the course's `(|x_a − x_b| − r_a − r_b) / |v_a − v_b|`, which is right for head-on hits
//! only and too early for all others. As h → 0 the scheme converges to the exact motion at first order.
//!
//! Source: the course exercise; the readings that its text leaves open are the fields of [`Readings`].

mod candidate;

use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::law::ball_ball::{self, Pair};
use crate::model::Disc;
use crate::run::{Diagnostics, Event, Hit, Kind, Log, Observer, Run, Status, Step, Steps, Track};
use crate::scalar::Scalar;
use crate::scenario::System;
use crate::scenario::schema::{AfterHit, LastStep, NormalTaken};
use candidate::{Candidate, Contact, Walls, candidates};
use std::sync::Arc;

/// A remainder of the duration smaller than this part of a step is round-off, not a step of its own.
const ROUND_OFF: f64 = 1e-9;

/// The length of the step, and which reading of the course text to follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readings<S> {
    /// Length h of a step.
    pub dt: S,
    /// What the other balls do in a step in which something is hit.
    pub after_hit: AfterHit,
    /// When the normal of a ball-ball contact is taken.
    pub normal: NormalTaken,
    /// What the last step does where the duration is no multiple of `dt`.
    pub last_step: LastStep,
}

/// Steps between two looks at whether a run should be broken off.
const SLICE: u64 = 4096;

/// When a stepped run ends: at the first of these.
pub struct Ends<'a, S> {
    /// Duration; infinity for none.
    pub duration: S,
    /// Number of steps.
    pub steps: u64,
    /// Number of collisions.
    pub collisions: u64,
    /// Number of events.
    pub events: u64,
    /// The kind of event to stop at.
    pub until: Option<Kind>,
    /// Says, when asked now and then, whether the run is to be broken off.
    pub interrupted: &'a mut dyn FnMut() -> bool,
}

/// Runs a system on a `width` x `length` rectangle.
pub fn run<S: Scalar>(
    system: Arc<System<S>>,
    [width, length]: [S; 2],
    readings: &Readings<S>,
    ends: &mut Ends<'_, S>,
    log: Log<S>,
) -> Run<S> {
    let mut scheme = Scheme::new(system, [width, length], *readings, log);
    let status = loop {
        if let Some(status) = scheme.ending(ends) {
            break status;
        }
        scheme.step(ends.duration);
    };
    scheme.finish(status)
}

struct Scheme<S: Scalar> {
    system: Arc<System<S>>,
    walls: Walls<S>,
    readings: Readings<S>,
    /// Time at which the present sequence of full steps began, and steps made since.
    clock: (S, u64),
    time: S,
    balls: Vec<State<S>>,
    steps: Steps<S>,
    log: Log<S>,
    diagnostics: Diagnostics,
}

impl<S: Scalar> Scheme<S> {
    fn new(system: Arc<System<S>>, size: [S; 2], readings: Readings<S>, log: Log<S>) -> Self {
        let mut scheme = Self {
            walls: Walls { size, laws: core::array::from_fn(|k| system.cushion_laws[k]) },
            balls: system
                .flights
                .iter()
                .map(|flight| State { position: flight.position, velocity: flight.velocity })
                .collect(),
            system,
            readings,
            clock: (S::ZERO, 0),
            time: S::ZERO,
            steps: Steps { steps: Vec::new(), count: 0, lost_time: 0.0 },
            log,
            diagnostics: Diagnostics::default(),
        };
        scheme.diagnostics.initial_energy = scheme.energy();
        scheme.note_overlap(&[], S::ZERO);
        scheme
    }

    fn ending(&self, ends: &mut Ends<'_, S>) -> Option<Status> {
        let stopped = ends.until.is_some_and(|kind| self.diagnostics.events[kind as usize] > 0);
        let round_off = self.readings.dt * S::from_f64(ROUND_OFF);
        if stopped {
            Some(Status::Stopped)
        } else if self.diagnostics.collisions() >= ends.collisions {
            Some(Status::CollisionLimit)
        } else if ends.duration - self.time <= round_off || self.steps.count >= ends.steps {
            Some(Status::TimeLimit)
        } else if self.diagnostics.total_events() >= ends.events {
            Some(Status::EventLimit)
        } else if self.steps.count % SLICE == SLICE - 1 && (ends.interrupted)() {
            Some(Status::Interrupted)
        } else {
            None
        }
    }

    /// One step of the scheme.
    fn step(&mut self, duration: S) {
        let full = self.readings.dt;
        let remaining = duration - self.time;
        let is_last = remaining <= full * S::from_f64(1.0 + ROUND_OFF);
        let length = if is_last && self.readings.last_step == LastStep::Short { remaining } else { full };
        let taken = self.choose(candidates(&self.balls, &self.system.discs, &self.walls, length));
        let restarts = self.readings.after_hit == AfterHit::Restart && !taken.is_empty();
        let length = if restarts { taken[0].after } else { length };
        self.note_overlap(&taken, length);
        self.steps.count += 1;
        if self.log.keeps_flights {
            let hits = self.hits(&taken);
            self.steps.steps.push(Step { time: self.time, balls: self.balls.clone(), hits });
        }
        for (ball, state) in self.balls.iter_mut().enumerate() {
            if !taken.iter().any(|candidate| candidate.involves(ball)) {
                state.position = state.position + state.velocity * length;
            }
        }
        for candidate in &taken {
            self.hit(candidate);
            let lost = (length - candidate.after).to_f64();
            self.steps.lost_time +=
                lost * if matches!(candidate.contact, Contact::Balls(..)) { 2.0 } else { 1.0 };
        }
        self.advance_clock(length, restarts, is_last, duration);
    }

    /// The candidates that happen: in order of time, each ball in one at most; only the first when the step restarts.
    fn choose(&self, candidates: Vec<Candidate<S>>) -> Vec<Candidate<S>> {
        let mut taken: Vec<Candidate<S>> = Vec::new();
        for candidate in candidates {
            let is_free = !taken.iter().any(|other| other.shares_ball_with(&candidate));
            if is_free && (taken.is_empty() || self.readings.after_hit == AfterHit::Wait) {
                taken.push(candidate);
            }
        }
        taken
    }

    fn hits(&self, taken: &[Candidate<S>]) -> Vec<Option<Hit<S>>> {
        let hit = |ball| {
            let candidate = taken.iter().find(|candidate| candidate.involves(ball))?;
            Some(Hit { after: candidate.after, kind: candidate.contact.kind() })
        };
        (0..self.balls.len()).map(hit).collect()
    }

    fn hit(&mut self, candidate: &Candidate<S>) {
        let event = match candidate.contact {
            Contact::Wall { ball, wall } => self.hit_wall(ball, wall, candidate.after),
            Contact::Balls(a, b) => self.hit_ball(a, b, candidate.after),
        };
        self.diagnostics.count(event.kind);
        self.log.event(&event);
    }

    fn hit_wall(&mut self, ball: usize, wall: usize, after: S) -> Event<S> {
        let disc = self.system.discs[ball];
        let State { position, velocity } = self.balls[ball];
        let position = position + velocity * after;
        let normal = self.walls.normal(wall);
        let law = self.walls.laws[wall];
        let restitution = law.restitution(-velocity.dot(normal));
        let rebound = law.rebound(velocity, (normal, S::ONE), restitution);
        self.balls[ball] = State { position, velocity: rebound.velocity };
        self.diagnostics.energy_loss += (disc.mass * rebound.energy_loss).to_f64();
        Event {
            time: self.time + after,
            kind: Kind::BallCushion,
            ball_a: ball as u32,
            ball_b: None,
            cushion: Some(wall as u32),
            point: self.walls.foot(wall, position),
            normal,
            closing_speed: -rebound.normal_velocity,
            impulse: (rebound.velocity - velocity).dot(normal) * disc.mass,
            cluster: None,
        }
    }

    fn hit_ball(&mut self, a: usize, b: usize, after: S) -> Event<S> {
        let discs = [self.system.discs[a], self.system.discs[b]];
        let before = [self.balls[a], self.balls[b]];
        let velocities = before.map(|state| state.velocity);
        let contact = before.map(|state| state.position + state.velocity * after);
        let separation = match self.readings.normal {
            NormalTaken::Before => before[1].position - before[0].position,
            NormalTaken::Contact => contact[1] - contact[0],
        };
        let pair = Pair::new([&discs[0], &discs[1]], separation, velocities);
        let impulse = ball_ball::Law::ELASTIC.impact(&pair, S::ONE).impulse;
        let change = |k: usize| pair.normal * (impulse * discs[k].inverse_mass);
        self.balls[a] = State { position: contact[0], velocity: velocities[0] - change(0) };
        self.balls[b] = State { position: contact[1], velocity: velocities[1] + change(1) };
        Event {
            time: self.time + after,
            kind: Kind::BallBall,
            ball_a: a as u32,
            ball_b: Some(b as u32),
            cushion: None,
            point: contact[0] + pair.normal * discs[0].radius,
            normal: pair.normal,
            closing_speed: pair.closing_speed,
            impulse,
            cluster: None,
        }
    }

    /// Times of full steps are multiples of dt, so that they do not pick up round-off from step to step.
    fn advance_clock(&mut self, length: S, restarts: bool, is_last: bool, duration: S) {
        if restarts {
            self.clock = (self.time + length, 0);
            self.time = self.clock.0;
        } else if is_last && self.readings.last_step == LastStep::Short {
            self.time = duration;
        } else {
            self.clock.1 += 1;
            self.time = self.clock.0 + self.readings.dt * S::from_f64(self.clock.1 as f64);
        }
    }

    /// Notes how deep balls will be in each other at any time of a step that begins now.
    fn note_overlap(&mut self, taken: &[Candidate<S>], length: S) {
        let moves_for = |ball| taken.iter().find(|c| c.involves(ball)).map_or(length, |c| c.after);
        let moving: Vec<S> = (0..self.balls.len()).map(moves_for).collect();
        for a in 0..self.balls.len() {
            for b in a + 1..self.balls.len() {
                let radii = self.system.discs[a].radius + self.system.discs[b].radius;
                let apart = closest_approach([self.balls[a], self.balls[b]], [moving[a], moving[b]]);
                let overlap = (radii - apart).to_f64();
                self.diagnostics.deepest_overlap = self.diagnostics.deepest_overlap.max(overlap);
            }
        }
    }

    fn energy(&self) -> f64 {
        let mut sum = S::ZERO;
        for (state, Disc { mass, .. }) in self.balls.iter().zip(&self.system.discs) {
            sum += *mass * state.velocity.norm_squared();
        }
        sum.to_f64() / 2.0
    }

    fn finish(mut self, status: Status) -> Run<S> {
        let hits = vec![None; self.balls.len()];
        self.steps.steps.push(Step { time: self.time, balls: self.balls.clone(), hits });
        self.diagnostics.final_energy = self.energy();
        self.diagnostics.lost_time = self.steps.lost_time;
        let drift =
            self.diagnostics.final_energy - self.diagnostics.initial_energy + self.diagnostics.energy_loss;
        self.diagnostics.energy_drift = drift.abs();
        let flight = |State { position, velocity }| Flight {
            start: self.time,
            position,
            velocity,
            acceleration: Vec2::ZERO,
        };
        let balls = self.balls.iter().map(|&ball| (flight(ball), Track::new())).collect();
        let mut run = Run::new(self.system, (status, self.time), self.diagnostics, self.log, balls);
        run.steps = Some(self.steps);
        run
    }
}

/// The least distance of two balls of which each moves for a time of its own, and then waits.
fn closest_approach<S: Scalar>([a, b]: [State<S>; 2], [moves_a, moves_b]: [S; 2]) -> S {
    let (separation, relative) = (b.position - a.position, b.velocity - a.velocity);
    let (both, more, alone) = if moves_a < moves_b {
        (moves_a, moves_b - moves_a, b.velocity)
    } else {
        (moves_b, moves_a - moves_b, -a.velocity)
    };
    let first = closest_to_origin(separation, relative, both);
    let second = closest_to_origin(separation + relative * both, alone, more);
    if second < first { second } else { first }
}

/// The least distance from the origin of a point that moves in a straight line for a time.
fn closest_to_origin<S: Scalar>(place: Vec2<S>, velocity: Vec2<S>, duration: S) -> S {
    let (approach, speed_squared) = (-place.dot(velocity), velocity.norm_squared());
    let time = if approach <= S::ZERO {
        S::ZERO
    } else if approach >= speed_squared * duration {
        duration
    } else {
        approach / speed_squared
    };
    (place + velocity * time).norm()
}
