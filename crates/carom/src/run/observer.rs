//! Who looks on while a run goes its way.

use super::event::Event;
use crate::flight::Flight;

/// Is told what happens. Nothing it does can change the run.
pub trait Observer<S> {
    /// An event happened.
    fn event(&mut self, event: &Event<S>);

    /// A ball began a new flight.
    fn flight(&mut self, ball: usize, flight: &Flight<S>);
}

/// Keeps nothing.
pub struct Nothing;

impl<S> Observer<S> for Nothing {
    #[inline(always)]
    fn event(&mut self, _: &Event<S>) {}

    #[inline(always)]
    fn flight(&mut self, _: usize, _: &Flight<S>) {}
}

/// What a run keeps of its course: events, and flights in the order in which they began.
#[derive(Clone, Debug, PartialEq)]
pub struct Log<S> {
    /// Whether events are kept.
    pub keeps_events: bool,
    /// Whether flights are kept, or the steps of a run that has steps instead.
    pub keeps_flights: bool,
    /// The events.
    pub events: Vec<Event<S>>,
    /// The flights, each with its ball.
    pub flights: Vec<(u32, Flight<S>)>,
}

impl<S> Log<S> {
    /// An empty log.
    pub fn new(keeps_events: bool, keeps_flights: bool) -> Self {
        Self { keeps_events, keeps_flights, events: Vec::new(), flights: Vec::new() }
    }
}

impl<S: Copy> Observer<S> for Log<S> {
    #[inline(always)]
    fn event(&mut self, event: &Event<S>) {
        if self.keeps_events {
            self.events.push(*event);
        }
    }

    #[inline(always)]
    fn flight(&mut self, ball: usize, flight: &Flight<S>) {
        if self.keeps_flights {
            self.flights.push((ball as u32, *flight));
        }
    }
}
