//! What a run knows of the dynamics that it is a run of.

use crate::flight::{Flight, SphereFlight, SphereState, State};
use crate::geometry::{Vec2, Vec3};
use crate::run::{Steps, Track};
use crate::scalar::Scalar;
use crate::scenario::{ClothSystem, Scenario, System};
use core::fmt::Debug;

/// A dynamics as a run sees it: its system, a ball's flight, and the state that this gives at any time.
pub trait Dynamics<S: Scalar>: Clone + Debug + PartialEq + Send + Sync + 'static {
    /// A checked scenario made ready to compute.
    type System: Clone + Debug + Send + Sync;
    /// A ball's closed-form motion since its own last event.
    type Flight: Clone + Copy + Debug + PartialEq + Send + Sync;
    /// What a flight tells of a ball at a moment.
    type State: Clone + Copy + Debug + PartialEq + Send + Sync;
    /// What a ball carries from event to event beside its flight.
    type Track: Clone + Copy + Debug + PartialEq + Send + Sync;
    /// A place or a velocity.
    type Vector: Clone + Copy + Debug + PartialEq + Send;
    /// The steps of the fixed-step method, where the dynamics has one.
    type Steps: Clone + Debug + PartialEq + Send + Sync;

    /// Whether the balls roll and spin on a cloth.
    const IS_ON_CLOTH: bool;

    /// How many numbers a flight is in a [`Film`](super::Film).
    const WIDTH: usize;

    /// The system of a checked scenario.
    fn system(scenario: &Scenario) -> Self::System;

    /// The names of the balls.
    fn ball_ids(system: &Self::System) -> &[String];

    /// The names of the cushions, and of the corners after them.
    fn cushion_ids(system: &Self::System) -> &[String];

    /// When a flight begins.
    fn start(flight: &Self::Flight) -> S;

    /// Place, velocity and acceleration at the start of a flight, in space; a place that is none where the ball is out of play.
    fn course(flight: &Self::Flight) -> [Vec3<S>; 3];

    /// The numbers of a flight, for a [`Film`](super::Film).
    fn row(flight: &Self::Flight) -> impl Iterator<Item = f64>;

    /// The flights of a ball in a run that has steps: in each it goes straight, and waits from its hit on.
    fn flights_of_steps(steps: &Self::Steps, ball: usize) -> Vec<Self::Flight>;

    /// A ball's last flight with all the way that led to it, which on a periodic table is kept beside it.
    fn last_flight(_: &Self::System, (flight, _): &(Self::Flight, Self::Track)) -> Self::Flight {
        *flight
    }

    /// The state that a flight gives at a time.
    fn state_at(flight: &Self::Flight, time: S) -> Self::State;

    /// The states of all balls at a time of a run that has steps.
    fn state_in_steps(steps: &Self::Steps, time: S) -> Vec<Self::State>;

    /// The steps themselves.
    fn as_steps(steps: &Self::Steps) -> &Steps<S>;

    /// The kinetic energy of all balls.
    fn kinetic_energy(system: &Self::System, states: &[Self::State]) -> S;

    /// The potential energy of all balls.
    fn potential_energy(system: &Self::System, states: &[Self::State]) -> S;

    /// The momentum of all balls.
    fn momentum(system: &Self::System, states: &[Self::State]) -> Self::Vector;

    /// The numbers of a state, for the digest.
    fn numbers(state: &Self::State) -> impl Iterator<Item = f64>;
}

/// Discs in the plane, without spin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plane;

impl<S: Scalar> Dynamics<S> for Plane {
    type System = System<S>;
    type Flight = Flight<S>;
    type State = State<S>;
    type Track = Track<S>;
    type Vector = Vec2<S>;
    type Steps = Steps<S>;

    const IS_ON_CLOTH: bool = false;
    const WIDTH: usize = 7;

    fn system(scenario: &Scenario) -> System<S> {
        System::new(scenario)
    }

    fn ball_ids(system: &System<S>) -> &[String] {
        &system.ball_ids
    }

    fn cushion_ids(system: &System<S>) -> &[String] {
        &system.cushion_ids
    }

    fn start(flight: &Flight<S>) -> S {
        flight.start
    }

    fn course(flight: &Flight<S>) -> [Vec3<S>; 3] {
        [flight.position, flight.velocity, flight.acceleration].map(|vector| Vec3::above(vector, S::ZERO))
    }

    fn row(flight: &Flight<S>) -> impl Iterator<Item = f64> {
        let Flight { start, position, velocity, acceleration } = flight;
        let vectors = [position, velocity, acceleration].map(|vector| vector.to_f64());
        core::iter::once(start.to_f64()).chain(vectors.into_iter().flatten())
    }

    fn flights_of_steps(steps: &Steps<S>, ball: usize) -> Vec<Flight<S>> {
        steps.flights(ball)
    }

    fn last_flight(system: &System<S>, (flight, track): &(Flight<S>, Track<S>)) -> Flight<S> {
        system.unwrapped(flight, track.image)
    }

    fn state_at(flight: &Flight<S>, time: S) -> State<S> {
        flight.state_after(time - flight.start)
    }

    fn state_in_steps(steps: &Steps<S>, time: S) -> Vec<State<S>> {
        steps.state(time)
    }

    fn as_steps(steps: &Steps<S>) -> &Steps<S> {
        steps
    }

    fn kinetic_energy(system: &System<S>, states: &[State<S>]) -> S {
        let mut sum = S::ZERO;
        for (state, disc) in states.iter().zip(&system.discs) {
            sum += disc.mass * state.velocity.norm_squared();
        }
        sum * S::from_f64(0.5)
    }

    /// In the field, zero at the origin: −Σ m a·x.
    fn potential_energy(system: &System<S>, states: &[State<S>]) -> S {
        let mut sum = S::ZERO;
        for (state, disc) in states.iter().zip(&system.discs) {
            sum -= disc.mass * system.field.dot(state.position);
        }
        sum
    }

    fn momentum(system: &System<S>, states: &[State<S>]) -> Vec2<S> {
        let mut sum = Vec2::ZERO;
        for (state, disc) in states.iter().zip(&system.discs) {
            sum = sum + state.velocity * disc.mass;
        }
        sum
    }

    fn numbers(State { position, velocity }: &State<S>) -> impl Iterator<Item = f64> {
        [position.x, position.y, velocity.x, velocity.y].into_iter().map(S::to_f64)
    }
}

/// Balls that roll and spin on a cloth, and fly above it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OnCloth;

/// What a ball on a cloth carries from event to event beside its flight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereTrack<S> {
    /// Changes of course so far.
    pub changes: u64,
    /// Time of its last contact.
    pub last_contact: S,
    /// Since when its contacts are counted, to see whether they follow each other too fast.
    pub burst_start: S,
    /// Contacts since then.
    pub burst: u32,
}

impl<S: Scalar> SphereTrack<S> {
    /// A ball that nothing has happened to.
    pub fn new() -> Self {
        Self { changes: 0, last_contact: -S::INFINITY, burst_start: S::ZERO, burst: 0 }
    }
}

impl<S: Scalar> Default for SphereTrack<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// The steps of a dynamics that has no fixed-step method: there are none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoSteps {}

impl<S: Scalar> Dynamics<S> for OnCloth {
    type System = ClothSystem<S>;
    type Flight = SphereFlight<S>;
    type State = SphereState<S>;
    type Track = SphereTrack<S>;
    type Vector = Vec3<S>;
    type Steps = NoSteps;

    const IS_ON_CLOTH: bool = true;
    const WIDTH: usize = 17;

    fn system(scenario: &Scenario) -> ClothSystem<S> {
        ClothSystem::new(scenario)
    }

    fn ball_ids(system: &ClothSystem<S>) -> &[String] {
        &system.ball_ids
    }

    fn cushion_ids(system: &ClothSystem<S>) -> &[String] {
        &system.cushion_ids
    }

    fn start(flight: &SphereFlight<S>) -> S {
        flight.start()
    }

    fn course(flight: &SphereFlight<S>) -> [Vec3<S>; 3] {
        let position = flight.position_after(S::ZERO);
        let nowhere = position * S::from_f64(f64::NAN);
        let position = if flight.motion.is_out() { nowhere } else { position };
        [position, flight.velocity_after(S::ZERO), flight.acceleration()]
    }

    fn row(flight: &SphereFlight<S>) -> impl Iterator<Item = f64> {
        let [position, velocity, acceleration] = Self::course(flight);
        let vectors = [position, velocity, acceleration, flight.spin, flight.spin_rate].map(Vec3::to_f64);
        let numbers = core::iter::once(flight.start().to_f64()).chain(vectors.into_iter().flatten());
        numbers.chain(core::iter::once(f64::from(flight.motion as u8)))
    }

    fn flights_of_steps(steps: &NoSteps, _: usize) -> Vec<SphereFlight<S>> {
        match *steps {}
    }

    fn state_at(flight: &SphereFlight<S>, time: S) -> SphereState<S> {
        flight.state_after(time - flight.start())
    }

    fn state_in_steps(steps: &NoSteps, _: S) -> Vec<SphereState<S>> {
        match *steps {}
    }

    fn as_steps(steps: &NoSteps) -> &Steps<S> {
        match *steps {}
    }

    /// Of translation and spin, of the balls in play.
    fn kinetic_energy(system: &ClothSystem<S>, states: &[SphereState<S>]) -> S {
        let mut sum = S::ZERO;
        for (state, sphere) in states.iter().zip(&system.spheres) {
            sum += sphere.kinetic_energy(&state.twist);
        }
        sum
    }

    /// Of the height of the balls in play above the cloth.
    fn potential_energy(system: &ClothSystem<S>, states: &[SphereState<S>]) -> S {
        let mut sum = S::ZERO;
        for (state, sphere) in states.iter().zip(&system.spheres) {
            if !state.motion.is_out() {
                sum += system.height_energy(sphere, state.position);
            }
        }
        sum
    }

    fn momentum(system: &ClothSystem<S>, states: &[SphereState<S>]) -> Vec3<S> {
        let mut sum = Vec3::ZERO;
        for (state, sphere) in states.iter().zip(&system.spheres) {
            sum = sum + state.twist.velocity * sphere.mass;
        }
        sum
    }

    /// Its motion's code, place, velocity and spin.
    fn numbers(SphereState { motion, position, twist }: &SphereState<S>) -> impl Iterator<Item = f64> {
        let code = f64::from(*motion as u8);
        let vectors = [*position, twist.velocity, twist.spin].map(Vec3::to_f64);
        core::iter::once(code).chain(vectors.into_iter().flatten())
    }
}
