//! The course of a run as plain numbers: all that is needed to draw it at any time.

use super::dynamics::Dynamics;
use super::state::{QueryError, Run};
use crate::scalar::Scalar;

/// The flights of each ball, in order of time.
///
/// A flight is a row: when it begins; place, velocity and acceleration, with two components of discs and three of balls on
/// a cloth; of the latter also the spin, its rate of change, and the code of the motion. So the place a time s later is
/// `x + (v + a (s / 2)) s`, with the bits of [`Run::state`]; that of a ball out of play is not a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// How many numbers a row has.
    pub width: usize,
    /// The first row of each ball, and after the last ball the number of rows.
    pub first_rows: Vec<u32>,
    /// The rows, one after the other.
    pub numbers: Vec<f64>,
}

impl<S: Scalar, D: Dynamics<S>> Run<S, D> {
    /// The course of the run.
    ///
    /// # Errors
    ///
    /// Where the run kept neither flights nor steps.
    pub fn film(&self) -> Result<Film, QueryError> {
        if !self.log.keeps_flights {
            return Err(QueryError::NotKept { end: self.end_time.to_f64() });
        }
        let count = self.balls.len();
        let mut film =
            Film { width: D::WIDTH, first_rows: Vec::with_capacity(count + 1), numbers: Vec::new() };
        for ball in 0..count {
            film.first_rows.push((film.numbers.len() / film.width) as u32);
            let mut add = |flight: D::Flight| film.numbers.extend(D::row(&flight).take(D::WIDTH));
            match &self.steps {
                Some(steps) => D::flights_of_steps(steps, ball).into_iter().for_each(&mut add),
                None => self.flights(ball).for_each(&mut add),
            }
        }
        film.first_rows.push((film.numbers.len() / film.width) as u32);
        Ok(film)
    }
}
