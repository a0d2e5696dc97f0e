//! Who looks on while a run goes its way.

use super::dynamics::{Dynamics, Plane};
use super::event::Event;
use crate::scalar::Scalar;
use std::collections::VecDeque;

/// Is told what happens. Nothing it does can change the run.
pub trait Observer<S: Scalar, D: Dynamics<S> = Plane> {
    /// An event happened.
    fn event(&mut self, event: &Event<S>);

    /// A ball began a new flight.
    fn flight(&mut self, ball: usize, flight: &D::Flight);
}

/// Keeps nothing.
pub struct Nothing;

impl<S: Scalar, D: Dynamics<S>> Observer<S, D> for Nothing {
    #[inline(always)]
    fn event(&mut self, _: &Event<S>) {}

    #[inline(always)]
    fn flight(&mut self, _: usize, _: &D::Flight) {}
}

/// Events that are to be handed out, in order.
impl<S: Scalar, D: Dynamics<S>> Observer<S, D> for VecDeque<Event<S>> {
    fn event(&mut self, event: &Event<S>) {
        self.push_back(*event);
    }

    fn flight(&mut self, _: usize, _: &D::Flight) {}
}

/// Two that look on.
impl<S: Scalar, D: Dynamics<S>, A: Observer<S, D>, B: Observer<S, D>> Observer<S, D> for (&mut A, &mut B) {
    fn event(&mut self, event: &Event<S>) {
        self.0.event(event);
        self.1.event(event);
    }

    fn flight(&mut self, ball: usize, flight: &D::Flight) {
        self.0.flight(ball, flight);
        self.1.flight(ball, flight);
    }
}

/// What a run keeps of its course: events, and flights in the order in which they began.
#[derive(Clone, Debug, PartialEq)]
pub struct Log<S: Scalar, D: Dynamics<S> = Plane> {
    /// Whether events are kept.
    pub keeps_events: bool,
    /// Whether flights are kept, or the steps of a run that has steps instead.
    pub keeps_flights: bool,
    /// The events.
    pub events: Vec<Event<S>>,
    /// The flights, each with its ball.
    pub flights: Vec<(u32, D::Flight)>,
}

impl<S: Scalar, D: Dynamics<S>> Log<S, D> {
    /// An empty log.
    pub fn new(keeps_events: bool, keeps_flights: bool) -> Self {
        Self { keeps_events, keeps_flights, events: Vec::new(), flights: Vec::new() }
    }
}

impl<S: Scalar, D: Dynamics<S>> Observer<S, D> for Log<S, D> {
    #[inline(always)]
    fn event(&mut self, event: &Event<S>) {
        if self.keeps_events {
            self.events.push(*event);
        }
    }

    #[inline(always)]
    fn flight(&mut self, ball: usize, flight: &D::Flight) {
        if self.keeps_flights {
            self.flights.push((ball as u32, *flight));
        }
    }
}
