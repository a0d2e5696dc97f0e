//! A run, and the state it gives at any time.

use super::PHYSICS_VERSION;
use super::diagnostics::Diagnostics;
use super::digest::{Digest, digest};
use super::dynamics::{Dynamics, Plane};
use super::event::Kind;
use super::observer::Log;
use super::status::Status;
use crate::geometry::Vec2;
use crate::scalar::Scalar;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::sync::{Arc, OnceLock};
use thiserror::Error;

/// What a ball carries from event to event beside its flight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Track<S> {
    /// Changes of course so far, of which a contact in a cluster may make two; after 2³² of them counted anew.
    pub changes: u32,
    /// How often it has gone round each periodic axis, up to the start of its flight.
    pub image: [i32; 2],
    /// Straight cushions that hold the ball.
    pub held_by: [Option<u32>; 2],
    /// The cushion it touched last, where there are thin walls or a field; tells a point on which side of a wall it is.
    pub last_cushion: Option<u32>,
    /// The velocity with which a point came to it, where there are thin walls; tells the same where several meet.
    pub arrival: Vec2<S>,
    /// Time of its last event.
    pub last_contact: S,
    /// Since when its events are counted, to see whether they follow each other too fast.
    pub burst_start: S,
}

/// What came out of a computation.
#[derive(Clone, Debug)]
pub struct Run<S: Scalar, D: Dynamics<S> = Plane> {
    /// The version of the physics that it was made with.
    pub physics_version: u32,
    /// What was computed.
    pub system: Arc<D::System>,
    /// Why it ended.
    pub status: Status,
    /// When it ended.
    pub end_time: S,
    /// What it found out about itself.
    pub diagnostics: Diagnostics,
    /// What was kept of its course.
    pub log: Log<S, D>,
    /// The last flight of each ball and what goes with it: all that is needed to go on.
    pub balls: Vec<(D::Flight, D::Track)>,
    /// The steps of the fixed-step method, whose states are not those of flights.
    pub steps: Option<D::Steps>,
    /// The digest in the file that it was read from; `None` for a run computed here.
    pub saved_digest: Option<Digest>,
    flights_of_balls: OnceLock<Vec<Vec<u32>>>,
}

/// Why the state at a time cannot be told.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum QueryError {
    /// The time is before the start, after the end, or not a number.
    #[error("time {time} is outside the run, which goes from 0 to {end}")]
    OutsideRun {
        /// The time asked for.
        time: f64,
        /// The end of the run.
        end: f64,
    },
    /// The run kept neither flights nor steps.
    #[error(
        "the run kept no flights or steps, so only the state at its end, {end}, is known; run with record = \"all\""
    )]
    NotKept {
        /// The end of the run.
        end: f64,
    },
}

impl<S: Scalar> Track<S> {
    /// A ball that nothing has happened to.
    pub fn new() -> Self {
        Self {
            changes: 0,
            image: [0; 2],
            held_by: [None; 2],
            last_cushion: None,
            arrival: Vec2::ZERO,
            last_contact: -S::INFINITY,
            burst_start: S::ZERO,
        }
    }

    /// Whether a cushion holds the ball.
    #[inline(always)]
    pub fn is_held(&self) -> bool {
        self.held_by[0].is_some()
    }
}

impl<S: Scalar> Default for Track<S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, D: Dynamics<S>> Run<S, D> {
    /// A run of this version of the physics, put together from its parts.
    pub fn new(
        system: Arc<D::System>,
        (status, end_time): (Status, S),
        diagnostics: Diagnostics,
        log: Log<S, D>,
        balls: Vec<(D::Flight, D::Track)>,
    ) -> Self {
        Self {
            physics_version: PHYSICS_VERSION,
            system,
            status,
            end_time,
            diagnostics,
            log,
            balls,
            steps: None,
            saved_digest: None,
            flights_of_balls: OnceLock::new(),
        }
    }

    /// The state of each ball at a time from 0 to the end (or later, when everything rests).
    pub fn state(&self, time: S) -> Result<Vec<D::State>, QueryError> {
        self.check_time(time)?;
        if let Some(steps) = &self.steps {
            return Ok(D::state_in_steps(steps, time));
        }
        Ok((0..self.balls.len()).map(|ball| D::state_at(&self.flight(ball, time), time)).collect())
    }

    /// The state of each ball at the end.
    pub fn final_state(&self) -> Vec<D::State> {
        match &self.steps {
            Some(steps) => D::state_in_steps(steps, self.end_time),
            None => {
                let state = |ball| D::state_at(&D::last_flight(&self.system, ball), self.end_time);
                self.balls.iter().map(state).collect()
            }
        }
    }

    /// Kinetic energy of all balls at a time; with [`Self::potential_energy`] it is the energy that diagnostics speak of.
    pub fn energy(&self, time: S) -> Result<S, QueryError> {
        Ok(D::kinetic_energy(&self.system, &self.state(time)?))
    }

    /// Potential energy of all balls at a time.
    pub fn potential_energy(&self, time: S) -> Result<S, QueryError> {
        Ok(D::potential_energy(&self.system, &self.state(time)?))
    }

    /// Momentum of all balls at a time.
    pub fn momentum(&self, time: S) -> Result<D::Vector, QueryError> {
        Ok(D::momentum(&self.system, &self.state(time)?))
    }

    /// The digest of the run's end; `None` if any number in it is NaN.
    pub fn digest(&self) -> Option<Digest> {
        let states = self.final_state();
        digest(self.diagnostics.total_events(), self.end_time.to_f64(), states.iter().flat_map(D::numbers))
    }

    /// The diagnostics as a JSON value, events by the names of those kinds that can happen.
    pub fn findings(&self) -> Result<Value, serde_json::Error> {
        let mut found = serde_json::to_value(&self.diagnostics)?;
        let counts = Kind::ALL.iter().zip(self.diagnostics.events);
        let counts = counts.filter(|(kind, _)| kind.happens(D::IS_ON_CLOTH));
        found["events"] = counts.map(|(kind, count)| (kind.name().to_owned(), json!(count))).collect();
        if let Some(steps) = &self.steps {
            found["lost_time"] = json!(D::as_steps(steps).lost_time);
        }
        Ok(found)
    }

    fn check_time(&self, time: S) -> Result<(), QueryError> {
        let end = self.end_time.to_f64();
        let is_inside = time >= S::ZERO && (time <= self.end_time || self.status == Status::AtRest);
        if !is_inside || !time.is_finite() {
            return Err(QueryError::OutsideRun { time: time.to_f64(), end });
        }
        if !self.log.keeps_flights && time < self.end_time {
            return Err(QueryError::NotKept { end });
        }
        Ok(())
    }

    /// The flight a ball is on at a time; at an event's own time, the one that begins there.
    fn flight(&self, ball: usize, time: S) -> D::Flight {
        if !self.log.keeps_flights {
            return D::last_flight(&self.system, &self.balls[ball]);
        }
        let flights = &self.flights_by_ball()[ball];
        let later = flights.partition_point(|&k| D::start(&self.log.flights[k as usize].1) <= time);
        self.log.flights[flights[later.max(1) - 1] as usize].1
    }

    /// The flights of a ball that were kept, in order of time.
    pub(super) fn flights(&self, ball: usize) -> impl Iterator<Item = D::Flight> {
        self.flights_by_ball()[ball].iter().map(|&k| self.log.flights[k as usize].1)
    }

    fn flights_by_ball(&self) -> &[Vec<u32>] {
        self.flights_of_balls.get_or_init(|| {
            let mut by_ball = vec![Vec::new(); self.balls.len()];
            for (k, (ball, _)) in self.log.flights.iter().enumerate() {
                by_ball[*ball as usize].push(k as u32);
            }
            by_ball
        })
    }
}
