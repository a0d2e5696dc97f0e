//! What a dynamics has to offer for the event loop to run it.

use super::simulation::Coming;
use crate::run::{Diagnostics, Dynamics, Observer, Run};
use crate::scalar::Scalar;
use std::sync::Arc;

/// What no run survives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The events of this ball follow each other without end.
    Collapse(u32),
    /// This ball is deeper in another than the contact tolerance.
    Overlap(u32),
    /// A number of the state is infinite, or none at all.
    NotFinite,
    /// The cue slipped off the ball.
    Miscue,
}

/// The state of all balls during a run, and the one primitive: make the earliest event happen.
pub trait Engine<S: Scalar>: Clone {
    /// The dynamics that it computes.
    type Dynamics: Dynamics<S>;

    /// The balls of a system at time zero.
    fn new(
        system: Arc<<Self::Dynamics as Dynamics<S>>::System>,
        observer: &mut impl Observer<S, Self::Dynamics>,
    ) -> Self;

    /// The balls at the end of a run.
    fn resume(run: &Run<S, Self::Dynamics>) -> Self;

    /// Back to time zero, without giving up any memory.
    fn reset(&mut self, observer: &mut impl Observer<S, Self::Dynamics>);

    /// Back to time zero in a system in which `change` has changed velocities, the stroke or laws of collision, without giving
    /// up any memory.
    fn restart(
        &mut self,
        change: impl FnOnce(&mut <Self::Dynamics as Dynamics<S>>::System),
        observer: &mut impl Observer<S, Self::Dynamics>,
    );

    /// Makes the earliest event happen, if it comes no later than `limit`; gives its time.
    fn step(&mut self, limit: S, observer: &mut impl Observer<S, Self::Dynamics>) -> Option<S>;

    /// The time of the next event.
    fn next_time(&mut self) -> S;

    /// Events so far.
    fn events(&self) -> u64;

    /// What went wrong, if anything did.
    fn fault(&self) -> Option<Fault>;

    /// What the run found out about itself so far.
    fn diagnostics(&self) -> &Diagnostics;

    /// What is computed.
    fn system(&self) -> &Arc<<Self::Dynamics as Dynamics<S>>::System>;

    /// The number of balls.
    fn ball_count(&self) -> usize;

    /// The flight of a ball, and what goes with it.
    fn ball(
        &self,
        ball: usize,
    ) -> (<Self::Dynamics as Dynamics<S>>::Flight, <Self::Dynamics as Dynamics<S>>::Track);

    /// Whether no ball moves, now or later.
    fn is_at_rest(&self) -> bool;

    /// Whether all balls that move would not cross the table by a time, however late.
    fn is_slower_than(&self, latest: S) -> bool;

    /// A ball that moves.
    fn moving_ball(&self) -> Option<usize>;

    /// Sums the energy and notes how far it is from what the laws account for.
    fn audit(&mut self, time: S);

    /// What each ball's pending event is, after those that are stale have been predicted anew.
    fn comings(&mut self, time: S) -> Vec<Coming<S>>;
}
