//! The state of balls on a cloth, and the one primitive: make the earliest event happen.
//!
//! As for discs one event is pending for each ball, and a change of its partner's course makes it stale. A flight ends by
//! itself too: where a ball stops slipping, stops, or lands.

mod audit;
mod cluster;
mod contact;
mod cushion;
mod ending;
mod hop;
mod pocket;
mod predict;
mod shot;

use super::interface::{Engine, Fault};
use super::queue::{Aim, Pending, Queue};
use super::simulation::Coming;
use crate::flight::{Motion, SphereFlight};
use crate::model::Sphere;
use crate::run::{Diagnostics, Event, Observer, OnCloth, Run, SphereTrack};
use crate::scalar::Scalar;
use crate::scenario::ClothSystem;
use cluster::Gathering;
use std::sync::Arc;

/// The energy is summed at 2^k events, but not below sixteen: so short a run is summed at its end.
const AUDIT_MASK: u64 = 15;

/// What a ball's next event is with.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Ahead {
    /// Nothing.
    Nothing,
    /// Another ball, with the number of changes of course it had when this was predicted.
    Ball(u32, u64),
    /// A cushion's nose.
    Cushion(u32),
    /// A cushion that the ball flies over.
    Over(u32),
    /// A pocket.
    Pocket(u32),
    /// The end of its own flight.
    End,
}

impl Aim for Ahead {
    const NOTHING: Self = Self::Nothing;

    /// At one time balls are met before cushions, those before pockets, and a flight ends last; so it does not matter how
    /// balls are numbered.
    fn rank(&self, ball: usize) -> (u8, usize) {
        match self {
            Self::Ball(other, _) => (0, ball.min(*other as usize)),
            Self::Cushion(_) => (1, ball),
            Self::Pocket(_) => (2, ball),
            Self::Over(_) => (3, ball),
            Self::End => (4, ball),
            Self::Nothing => (5, ball),
        }
    }
}

/// A ball under way.
#[derive(Clone, Copy, Debug)]
struct Ball<S> {
    flight: SphereFlight<S>,
    sphere: Sphere<S>,
    track: SphereTrack<S>,
}

/// The balls on a cloth: everything that changes during a run.
#[derive(Clone, Debug)]
pub struct Spheres<S> {
    system: Arc<ClothSystem<S>>,
    balls: Vec<Ball<S>>,
    queue: Queue<S, Ahead>,
    diagnostics: Diagnostics,
    /// All events so far.
    events: u64,
    fault: Option<Fault>,
    gathering: Gathering<S>,
}

impl<S: Scalar> Engine<S> for Spheres<S> {
    type Dynamics = OnCloth;

    fn new(system: Arc<ClothSystem<S>>, observer: &mut impl Observer<S, OnCloth>) -> Self {
        let still = |(start, sphere)| Self::placed(&system, sphere, start);
        let balls: Vec<_> = system.starts.iter().zip(&system.spheres).map(still).collect();
        let mut spheres = Self {
            queue: Queue::new(balls.len()),
            balls,
            diagnostics: Diagnostics::default(),
            events: 0,
            fault: None,
            gathering: Gathering::default(),
            system,
        };
        spheres.begin(observer);
        spheres
    }

    fn resume(run: &Run<S, OnCloth>) -> Self {
        let system = run.system.clone();
        let ball = |(&(flight, track), &sphere)| Ball { flight, sphere, track };
        let mut spheres = Self {
            balls: run.balls.iter().zip(&system.spheres).map(ball).collect(),
            queue: Queue::new(run.balls.len()),
            diagnostics: run.diagnostics.clone(),
            events: run.diagnostics.total_events(),
            fault: None,
            gathering: Gathering::default(),
            system,
        };
        spheres.predict_all();
        spheres
    }

    fn reset(&mut self, observer: &mut impl Observer<S, OnCloth>) {
        let starts = self.system.starts.iter().zip(&self.system.spheres);
        for (ball, (start, sphere)) in self.balls.iter_mut().zip(starts) {
            *ball = Self::placed(&self.system, sphere, start);
        }
        self.begin(observer);
    }

    fn restart(
        &mut self,
        change: impl FnOnce(&mut ClothSystem<S>),
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        change(Arc::make_mut(&mut self.system));
        self.reset(observer);
    }

    fn step(&mut self, limit: S, observer: &mut impl Observer<S, OnCloth>) -> Option<S> {
        loop {
            let (ball, Pending { time, offset, target }) = self.queue.first();
            if time > limit {
                return None;
            }
            match target {
                Ahead::Ball(..) => {
                    if !self.strike_first(time, observer) {
                        continue;
                    }
                }
                Ahead::Cushion(_) => self.strike_first_cushion(time, observer),
                Ahead::Over(cushion) => self.leave_table(ball, cushion, time, offset, observer),
                Ahead::Pocket(pocket) => self.drop_into(ball, pocket, time, offset, observer),
                Ahead::End => self.end_flight(ball, time, observer),
                Ahead::Nothing => return None,
            }
            return Some(time);
        }
    }

    fn next_time(&mut self) -> S {
        loop {
            let (ball, Pending { time, target, .. }) = self.queue.first();
            match target {
                Ahead::Ball(other, changes) if self.balls[other as usize].track.changes != changes => {
                    self.diagnostics.stale += 1;
                    self.predict(ball);
                }
                _ => return time,
            }
        }
    }

    fn events(&self) -> u64 {
        self.events
    }

    fn fault(&self) -> Option<Fault> {
        self.fault
    }

    fn diagnostics(&self) -> &Diagnostics {
        &self.diagnostics
    }

    fn system(&self) -> &Arc<ClothSystem<S>> {
        &self.system
    }

    fn ball_count(&self) -> usize {
        self.balls.len()
    }

    fn ball(&self, ball: usize) -> (SphereFlight<S>, SphereTrack<S>) {
        (self.balls[ball].flight, self.balls[ball].track)
    }

    fn is_at_rest(&self) -> bool {
        self.balls.iter().all(|ball| !Self::moves(&ball.flight))
    }

    /// Where there is friction every ball comes to rest by itself.
    fn is_slower_than(&self, _latest: S) -> bool {
        self.is_at_rest()
    }

    fn moving_ball(&self) -> Option<usize> {
        self.balls.iter().position(|ball| Self::moves(&ball.flight))
    }

    fn audit(&mut self, time: S) {
        self.sum_energy(time);
    }

    fn comings(&mut self, time: S) -> Vec<Coming<S>> {
        for ball in 0..self.balls.len() {
            while let Ahead::Ball(other, changes) = self.queue.pending(ball).target {
                if self.balls[other as usize].track.changes == changes {
                    break;
                }
                self.predict(ball);
            }
        }
        (0..self.balls.len()).map(|ball| self.coming(ball, time)).collect()
    }
}

impl<S: Scalar> Spheres<S> {
    /// Whether a ball moves, or spins in place.
    fn moves(flight: &SphereFlight<S>) -> bool {
        !(flight.motion == Motion::Resting || flight.motion.is_out())
    }

    fn begin(&mut self, observer: &mut impl Observer<S, OnCloth>) {
        self.diagnostics = Diagnostics::default();
        (self.events, self.fault) = (0, None);
        self.shoot(observer);
        let energy = self.energy_at(S::ZERO);
        (self.diagnostics.initial_energy, self.diagnostics.final_energy) = (energy, energy);
        self.predict_all();
        for (place, ball) in self.balls.iter().enumerate() {
            observer.flight(place, &ball.flight);
        }
    }

    fn emit(&mut self, event: &Event<S>, observer: &mut impl Observer<S, OnCloth>) {
        self.diagnostics.count(event.kind);
        observer.event(event);
        self.events += 1;
        if self.events & AUDIT_MASK == 0 && self.events.is_power_of_two() {
            self.sum_energy(event.time);
        }
    }
}
