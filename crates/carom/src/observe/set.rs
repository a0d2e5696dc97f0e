//! What is observed of a run, all together.

use super::error::ObserveError;
use super::events::EventSums;
use super::observable::Observable;
use super::request::Request;
use super::results::Results;
use super::snapshot::{Gas, Heat, Interval, Moment, Snapshot};
use crate::run::{Dynamics, Event, Observer};
use serde::{Deserialize, Serialize};

/// By how much an interval between samples may differ from the others, as a part of it.
const INTERVAL_TOLERANCE: f64 = 1e-6;

/// The observables of a run, with all that they have seen of it as sums.
///
/// It is an [`Observer`] of the run's events, and is shown a [`Snapshot`] at equal intervals. Observing begins with the
/// first of them: what happened before does not count, so that a gas may come to equilibrium first. All of it can be
/// written and read with serde; what is read goes on with the same bits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observables {
    all: Vec<Observable>,
    events: EventSums,
    course: Option<Course>,
}

/// Where observing is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Course {
    gas: Gas,
    start: f64,
    samples: u64,
    /// Between the first two samples, and so between all.
    interval: Option<f64>,
    /// The time and kT of the last sample.
    last: (f64, f64),
}

impl Observables {
    /// The observables that are asked for, each with options of its own; one may be asked for more than once.
    ///
    /// # Errors
    ///
    /// A name or an option that is not known, and an option out of its range.
    pub fn new(requests: &[Request]) -> Result<Self, ObserveError> {
        let all = requests.iter().map(Observable::new).collect::<Result<_, _>>()?;
        Ok(Self { all, events: EventSums::default(), course: None })
    }

    /// Whether nothing is observed.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Whether any of them lives on events; if not, the run need not be watched.
    pub fn needs_events(&self) -> bool {
        self.all.iter().any(Observable::needs_events)
    }

    /// How many samples there were.
    pub fn samples(&self) -> u64 {
        self.course.as_ref().map_or(0, |course| course.samples)
    }

    /// Takes in the state of the gas, after all events up to its time. What it refuses leaves no trace.
    ///
    /// # Errors
    ///
    /// A snapshot that contradicts itself or is of another gas, one that does not come in time, and at the first one a
    /// gas of which something cannot be observed.
    pub fn sample(&mut self, snapshot: &Snapshot) -> Result<(), ObserveError> {
        snapshot.check()?;
        let due = match &self.course {
            None => return self.begin(snapshot),
            Some(course) => course,
        };
        due.gas.check(snapshot)?;
        due.check_time(snapshot.time)?;
        self.go_on(snapshot);
        Ok(())
    }

    fn begin(&mut self, snapshot: &Snapshot) -> Result<(), ObserveError> {
        let gas = Gas::new(snapshot)?;
        let mut all = self.all.clone();
        for observable in &mut all {
            observable.measure_mut().begin(snapshot, &gas)?;
        }
        self.all = all;
        if self.needs_events() {
            let wants_free_times = self.all.iter().any(|this| matches!(this, Observable::FreePath(_)));
            self.events.watch(snapshot.radii, wants_free_times);
        }
        let heat = Heat::new(snapshot, &gas);
        self.show(&Moment { snapshot, gas: &gas, heat, interval: None });
        let (start, last) = (snapshot.time, (snapshot.time, heat.temperature));
        self.course = Some(Course { gas, start, samples: 1, interval: None, last });
        Ok(())
    }

    fn go_on(&mut self, snapshot: &Snapshot) {
        let Some(mut course) = self.course.take() else { return };
        let heat = Heat::new(snapshot, &course.gas);
        let [collisions, virial, wall_impulse] = self.events.take();
        let duration = snapshot.time - course.last.0;
        let temperature = 0.5 * (course.last.1 + heat.temperature);
        let interval = Some(Interval { duration, temperature, collisions, virial, wall_impulse });
        self.show(&Moment { snapshot, gas: &course.gas, heat, interval });
        course.interval.get_or_insert(duration);
        course.samples += 1;
        course.last = (snapshot.time, heat.temperature);
        self.course = Some(course);
    }

    fn show(&mut self, moment: &Moment) {
        for observable in &mut self.all {
            observable.measure_mut().sample(moment);
        }
    }

    /// What was found so far, in the order in which it was asked for; empty before the first sample.
    pub fn results(&self) -> Vec<Results> {
        let Some(course) = &self.course else { return Vec::new() };
        self.all.iter().map(|observable| observable.measure().results(&course.gas, &self.events)).collect()
    }
}

impl Course {
    fn check_time(&self, time: f64) -> Result<(), ObserveError> {
        let due = self.interval.map_or(self.last.0, |interval| self.start + interval * self.samples as f64);
        let is_in_time = match self.interval {
            None => time > self.last.0,
            // Late times have round-off of their own.
            Some(interval) => {
                (time - due).abs() <= INTERVAL_TOLERANCE * interval + 8.0 * f64::EPSILON * time.abs()
            }
        };
        if is_in_time { Ok(()) } else { Err(ObserveError::UnequalInterval { time, due }) }
    }
}

impl<D: Dynamics<f64>> Observer<f64, D> for Observables {
    #[inline(always)]
    fn event(&mut self, event: &Event<f64>) {
        self.events.event(event);
    }

    #[inline(always)]
    fn flight(&mut self, _: usize, _: &D::Flight) {}
}
