//! A ball under way: one line of the cache for what prediction reads of it, and the rest beside that.

use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::run::Track;
use crate::scalar::Scalar;

/// What prediction reads of a ball. In `f64` it fills a line of the cache, in this order.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Ball<S> {
    /// When its flight began.
    pub(super) start: S,
    /// Where.
    pub(super) position: Vec2<S>,
    /// The velocity at that time.
    pub(super) velocity: Vec2<S>,
    pub(super) radius: S,
    /// Changes of course so far; only whether it is still the same matters, so it may go round.
    pub(super) changes: u32,
    /// The column and the row of its cell, where there is a grid.
    pub(super) cell: [u16; 2],
    /// Its place among the balls.
    pub(super) number: u32,
    /// How often it has gone round each periodic axis on this flight.
    pub(super) rounds: [i16; 2],
}

/// What is read of a ball only when something unusual happens to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rest<S> {
    pub(super) acceleration: Vec2<S>,
    /// Along which axes it has left a cell of the grid the way it is pulled on this flight.
    pub(super) is_falling: [bool; 2],
    /// All of it but the changes of course, which are in the line, and the last contact where nobody asks for it and it is
    /// where the flight began.
    pub(super) track: Track<S>,
}

impl<S: Scalar> Rest<S> {
    /// Of a ball on a flight that has just begun, as far as a grid is concerned.
    pub(super) fn new(flight: &Flight<S>, track: Track<S>) -> Self {
        Self { acceleration: flight.acceleration, is_falling: [false; 2], track }
    }
}

impl<S: Scalar> Ball<S> {
    /// A ball at the start of a flight.
    pub(super) fn new(number: usize, radius: S, flight: &Flight<S>, changes: u32) -> Self {
        let Flight { start, position, velocity, .. } = *flight;
        Self {
            start,
            position,
            velocity,
            radius,
            changes,
            cell: [0; 2],
            number: number as u32,
            rounds: [0; 2],
        }
    }

    /// Its flight, if it has no acceleration.
    #[inline(always)]
    pub(super) fn straight_flight(&self) -> Flight<S> {
        let Self { start, position, velocity, .. } = *self;
        Flight { start, position, velocity, acceleration: Vec2::ZERO }
    }

    /// How often the table lies between where another ball's flight says that it is, and where this one sees it, in a cell that
    /// is `round` times round.
    #[inline(always)]
    pub(super) fn rounds_to(&self, other: &Self, round: [i16; 2]) -> [i32; 2] {
        let [own, their, round] = [self.rounds, other.rounds, round].map(|rounds| rounds.map(i32::from));
        [round[0] + own[0] - their[0], round[1] + own[1] - their[1]]
    }
}
