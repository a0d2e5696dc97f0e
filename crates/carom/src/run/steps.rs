//! The steps of the fixed-step method, and the state between them.

use super::event::Kind;
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::law::Reference;
use crate::scalar::Scalar;

/// A ball's hit in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<S> {
    /// Time from the start of the step to the hit; from then on the ball waits for the end of the step.
    pub after: S,
    /// With what.
    pub kind: Kind,
}

/// The moment at which a step begins, and what happens in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Step<S> {
    /// When it begins.
    pub time: S,
    /// Position and velocity of each ball then.
    pub balls: Vec<State<S>>,
    /// Each ball's hit in the step.
    pub hits: Vec<Option<Hit<S>>>,
}

/// The steps of a run; the last entry is its end, in which nothing happens.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps<S> {
    /// The steps in order of time; only the end where the run did not keep them.
    pub steps: Vec<Step<S>>,
    /// How many steps were made.
    pub count: u64,
    /// Time lost by balls that waited for the end of a step, summed over balls.
    pub lost_time: f64,
}

impl<S: Scalar> Steps<S> {
    /// The source of the method.
    pub const REFERENCES: &[Reference] = &[Reference {
        law: "method.stepped",
        text: "The two-ball exercise of first programming courses: time steps, each shortened to a contact",
        doi: None,
    }];

    /// Position and velocity of each ball at a time within the run; at a hit's own time, those after it.
    pub fn state(&self, time: S) -> Vec<State<S>> {
        let later = self.steps.partition_point(|step| step.time <= time).max(1);
        let step = &self.steps[later - 1];
        let next = self.steps.get(later);
        let elapsed = time - step.time;
        let state = |ball: usize| {
            let State { position, velocity } = step.balls[ball];
            match (step.hits[ball], next) {
                (Some(hit), Some(next)) if time >= step.time + hit.after => next.balls[ball],
                _ => State { position: position + velocity * elapsed, velocity },
            }
        };
        (0..step.balls.len()).map(state).collect()
    }

    /// The flights of a ball: in each step it goes straight, and from its hit on it waits for the end of the step.
    pub(super) fn flights(&self, ball: usize) -> Vec<Flight<S>> {
        let mut flights = Vec::new();
        let mut begin = |start, State { position, velocity }: State<S>, moves| {
            let velocity = if moves { velocity } else { Vec2::ZERO };
            flights.push(Flight { start, position, velocity, acceleration: Vec2::ZERO });
        };
        for (step, next) in self.steps.iter().zip(self.steps.iter().skip(1)) {
            begin(step.time, step.balls[ball], true);
            if let Some(hit) = step.hits[ball] {
                begin(step.time + hit.after, next.balls[ball], false);
            }
        }
        if let Some(last) = self.steps.last() {
            begin(last.time, last.balls[ball], true);
        }
        flights
    }
}
